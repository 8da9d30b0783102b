// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads an array in a Zarr folder of version 2 or 3, and the JSON metadata of such folders.
 */
#ifndef ZarrArray_h
#define ZarrArray_h

#include "VTK/Regions/Formats/ChunkedVolume.h"

#include "vtk_jsoncpp_fwd.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_set>
#include <vector>

namespace VolumeHaptics
{

/**
 * Reads a file. Returns false if it does not exist.
 * @throws std::runtime_error if the file contains no JSON object
 */
bool ReadZarrHead(const std::string& file, Json::Value& head);

class OpenedFile;

/** Metadata of an array: see Zarr's published specifications. */
struct ZarrArray
{
  enum CodecType
  {
    Zlib, ///< zlib or gzip
    Lz4,
    Blosc,
    Zstd,
    Sum ///< CRC-32C
  };

  std::string Folder;
  std::vector<std::uint64_t> Shape;
  std::vector<std::uint64_t> ChunkShape;
  /**
   * Index along each dimension except the last three; 0 for dimensions beyond the end of this list.
   */
  std::vector<std::size_t> Before;
  std::size_t ChunkBytes = 0; ///< bytes of the samples in a chunk
  int ScalarType = 0;
  std::size_t SampleSize = 0;
  bool IsBig = false;
  std::vector<char> FillValue;   ///< in the byte order of the array
  std::string Prefix;            ///< prefix of the file names of chunks
  char Separator = '.';          ///< between the indices in the file name of a chunk
  std::vector<CodecType> Codecs; ///< in the order of decoding
  /** Chunks per file along each dimension; empty if each chunk is a separate file. */
  std::vector<std::uint64_t> ShardShape;
  bool IsIndexFirst = false; ///< whether the index of a shard is at its beginning
  std::size_t IndexTail = 0; ///< bytes of the checksum that follows the index

  /** Returns the file name of a chunk, or of the shard that contains it. */
  std::string GetChunkFile(const ChunkPlace& place) const;
  /** Loads the part of a chunk that belongs to the volume at `Before`; a ChunkedVolume::Loader. */
  bool LoadChunk(const ChunkPlace& place, std::vector<char>& bytes) const;

private:
  /** Returns the index of a chunk along a dimension. */
  std::uint64_t GetChunkNumber(const ChunkPlace& place, std::size_t dimension) const;
  /**
   * Finds the offset and the size of a chunk in its shard. Returns false if the chunk was never
   * written.
   */
  bool LocateInShard(const std::string& name, const OpenedFile& file, const ChunkPlace& place,
    std::uint64_t range[2]) const;

  /** Shards whose index was checked, shared by several threads. */
  struct CheckedShards
  {
    std::mutex Access;
    std::unordered_set<std::string> Shards;
  };
  std::shared_ptr<CheckedShards> Checked = std::make_shared<CheckedShards>();
};

/** Returns whether a folder is a Zarr array. */
bool IsZarrArray(const std::string& folder);

/** Reads the metadata of an array. Throws std::runtime_error, with the cure. */
ZarrArray OpenZarrArray(const std::string& folder);

} // namespace VolumeHaptics

#endif

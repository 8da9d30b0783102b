// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads an array in a Zarr folder of version 2 or 3, and the JSON files of such folders.
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

/** The head of an array, as in Zarr's published specifications. */
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
  /** Index along each dimension but the last three; beyond the end of this list, 0. */
  std::vector<std::size_t> Before;
  std::size_t ChunkBytes = 0; ///< size of the samples of a chunk
  int ScalarType = 0;
  std::size_t SampleSize = 0;
  bool IsBig = false;
  std::vector<char> FillValue;   ///< bytes in the byte order of the array
  std::string Prefix;            ///< prefix of the file names of chunks
  char Separator = '.';          ///< separates the numbers in the file name of a chunk
  std::vector<CodecType> Codecs; ///< in the order of decoding
  /** Number of chunks in a file along each dimension; empty if each chunk has a file of its own. */
  std::vector<std::uint64_t> ShardShape;
  bool IsIndexFirst = false; ///< whether the index of a shard is at its beginning
  std::size_t IndexTail = 0; ///< bytes of the checksum after the index

  /** Returns the file name of a chunk, or of the shard that contains it. */
  std::string GetChunkFile(const ChunkPlace& place) const;
  /**
   * Loads the part of a chunk that belongs to the volume at `Before`, as a ChunkedVolume::Loader
   * does.
   */
  bool LoadChunk(const ChunkPlace& place, std::vector<char>& bytes) const;

private:
  /** Returns the number of a chunk along a dimension. */
  std::uint64_t GetChunkNumber(const ChunkPlace& place, std::size_t dimension) const;
  /**
   * Finds the first byte and the size of a chunk in its shard. Returns false if it was never
   * written.
   */
  bool LocateInShard(const std::string& name, const OpenedFile& file, const ChunkPlace& place,
    std::uint64_t range[2]) const;

  /** The shards whose index was checked, which several threads read. */
  struct CheckedShards
  {
    std::mutex Access;
    std::unordered_set<std::string> Shards;
  };
  std::shared_ptr<CheckedShards> Checked = std::make_shared<CheckedShards>();
};

/** Returns whether a folder contains an array. */
bool IsZarrArray(const std::string& folder);

/** Reads the head. Throws std::runtime_error, with the cure. */
ZarrArray OpenZarrArray(const std::string& folder);

} // namespace VolumeHaptics

#endif

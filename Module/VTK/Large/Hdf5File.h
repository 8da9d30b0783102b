// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The structure of an HDF5 file: groups, attributes, and where the samples of datasets lie.
 */
#ifndef Hdf5File_h
#define Hdf5File_h

#include "VTK/Large/Hdf5Block.h"
#include "VTK/Large/Hdf5Types.h"
#include "VTK/Large/OpenedFile.h"

#include <cstdint>
#include <map>
#include <string>
#include <unordered_map>
#include <vector>

namespace VolumeHaptics
{

/** Where the bytes of a chunk lie in the file. */
struct Hdf5Chunk
{
  std::uint64_t Address = 0;
  std::uint64_t Size = 0;    ///< bytes
  std::uint64_t Skipped = 0; ///< a bit for each filter that was not applied
};

/** An object of the file: a group or a dataset. */
struct Hdf5Object
{
  enum LayoutType
  {
    NoData, ///< a group
    Contiguous,
    Chunked,
    Elsewhere ///< within the header, or in other files
  };

  std::map<std::string, Hdf5Attribute> Attributes;
  std::map<std::string, std::uint64_t> Links; ///< headers of what is in a group
  bool HasOtherLinks = false;                 ///< that are stored in a way which is not read here

  LayoutType Layout = NoData;
  Hdf5Type Type;
  std::vector<std::uint64_t> Shape;
  std::vector<char> FillValue; ///< the bytes of a sample that was never written; may be empty
  bool IsAllocated = true;     ///< Contiguous
  std::uint64_t Address = 0;   ///< Contiguous: in the file, in bytes from its beginning
  std::vector<std::uint64_t> ChunkShape;
  std::vector<Hdf5Filter> Filters; ///< in the order in which they were applied
  /**
   * By the chunk's number among all those of the last three dimensions, the last one fastest; only
   * those that are the first along the dimensions before.
   */
  std::unordered_map<std::uint64_t, Hdf5Chunk> Chunks;
};

/**
 * Reads what the published specification "HDF5 File Format Specification Version 3.0" describes, as
 * far as image files need it, without HDF5's library, which is not made for threads. Every fault is
 * a std::runtime_error with its cure.
 */
class Hdf5File
{
public:
  explicit Hdf5File(const std::string& name);

  Hdf5Object ReadRoot() { return this->ReadObject(this->Root); }
  Hdf5Object ReadObject(std::uint64_t address);

private:
  struct Message
  {
    int Type;
    int Flags;
    Hdf5Block Body;
  };
  struct ChunkIndex
  {
    int Type = 0; ///< 0: a B-tree of version 1; others as in messages of version 4
    std::uint64_t Address = 0;
    Hdf5Chunk Single;
  };

  bool ReadSuperblock(std::uint64_t at);
  Hdf5Block ReadBlock(std::uint64_t address, std::uint64_t size);
  std::uint64_t Offset(Hdf5Block& block) const { return block.Number(this->OffsetSize); }
  std::uint64_t Length(Hdf5Block& block) const { return block.Number(this->LengthSize); }
  bool IsAddress(std::uint64_t address) const;

  std::vector<Message> ReadMessages(std::uint64_t address);
  std::vector<Message> ReadOldMessages(std::uint64_t address);
  std::vector<Message> ReadNewMessages(std::uint64_t address);
  void AddMessage(Message message, std::vector<Hdf5Block>& rest, std::vector<Message>& messages);

  std::vector<std::uint64_t> ParseSpace(Hdf5Block& body) const;
  void ParseAttribute(Hdf5Block& body, Hdf5Object& object) const;
  void ParseLink(Hdf5Block& body, Hdf5Object& object) const;
  void ParseLayout(Hdf5Block& body, Hdf5Object& object, ChunkIndex& index) const;
  void ReadLinks(std::uint64_t tree, std::uint64_t heap, Hdf5Object& object);
  void ReadLinkNode(std::uint64_t address, int level, Hdf5Block& names, Hdf5Object& object);
  void ReadChunks(const ChunkIndex& index, Hdf5Object& object);
  void ReadChunkNode(std::uint64_t address, int level, Hdf5Object& object);
  void AddChunk(const std::vector<std::uint64_t>& first, Hdf5Chunk chunk, Hdf5Object& object) const;

  const OpenedFile File;
  const std::uint64_t FileSize;
  std::uint64_t BytesInAll = 0; ///< read so far
  std::uint64_t Base = 0;       ///< addresses count from here
  std::size_t OffsetSize = 8;
  std::size_t LengthSize = 8;
  std::uint64_t Root = 0;
};

} // namespace VolumeHaptics

#endif

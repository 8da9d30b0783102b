// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the structure of an HDF5 file: groups, attributes, and where the samples of datasets lie.
 */
#ifndef Hdf5File_h
#define Hdf5File_h

#include "VTK/Regions/Formats/Hdf5Block.h"
#include "VTK/Regions/Formats/Hdf5Object.h"
#include "VTK/Regions/Formats/Hdf5Storage.h"

#include <cstdint>
#include <string>
#include <vector>

namespace VolumeHaptics
{

struct Hdf5ChunkIndex;

/**
 * Reads HDF5 files by the published "HDF5 File Format Specification Version 3.0", as far as image
 * files need it. HDF5's own library is not used, because it is not made for threads. Every fault is
 * a std::runtime_error with its cure.
 */
class Hdf5File
{
public:
  explicit Hdf5File(const std::string& name)
    : Storage(name)
  {
  }

  Hdf5Object ReadRoot() { return this->ReadObject(this->Storage.GetRoot()); }
  Hdf5Object ReadObject(std::uint64_t address);

private:
  struct Message
  {
    int Type;
    int Flags;
    Hdf5Block Body;
  };

  std::vector<Message> ReadMessages(std::uint64_t address);
  std::vector<Message> ReadOldMessages(std::uint64_t address);
  std::vector<Message> ReadNewMessages(std::uint64_t address);
  void AddMessage(Message message, std::vector<Hdf5Block>& rest, std::vector<Message>& messages);

  /** Parses a dataspace. `most` gets the shape to which it may grow. */
  std::vector<std::uint64_t> ParseSpace(
    Hdf5Block& body, std::vector<std::uint64_t>* most = nullptr) const;
  void ParseAttribute(Hdf5Block& body, Hdf5Object& object) const;
  void ParseLink(Hdf5Block& body, Hdf5Object& object) const;
  void ParseLayout(Hdf5Block& body, Hdf5Object& object, Hdf5ChunkIndex& index) const;

  Hdf5Storage Storage;
};

} // namespace VolumeHaptics

#endif

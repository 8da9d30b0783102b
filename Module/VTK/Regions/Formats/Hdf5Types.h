// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Parses the messages of an HDF5 file that describe types, filters, attributes and values.
 */
#ifndef Hdf5Types_h
#define Hdf5Types_h

#include "VTK/Regions/Formats/Hdf5Block.h"

#include <cstddef>
#include <string>
#include <vector>

namespace VolumeHaptics
{

struct Hdf5Type
{
  enum KindType
  {
    Integer,
    Float,
    Text,
    Other
  };
  KindType Kind = Other;
  std::size_t Size = 0; ///< bytes
  bool IsSigned = false;
  bool IsBig = false; ///< the most significant byte comes first
};

/** An attribute of a group or a dataset. */
struct Hdf5Attribute
{
  Hdf5Type Type;
  std::vector<char> Bytes;

  /** Returns the numbers; empty if the values are neither integers nor floating-point numbers. */
  std::vector<double> GetNumbers() const;
  /** Returns the text; empty if the value is not a text of fixed length. */
  std::string GetText() const;
};

struct Hdf5Filter
{
  static constexpr int Deflate = 1;
  static constexpr int Shuffle = 2;
  static constexpr int Checksum = 3;

  int Id = 0;
  std::size_t SampleSize = 0; ///< for Shuffle
};

///@{
/** Parse the body of a message. A type is Other if this computer has no such numbers. */
Hdf5Type ParseHdf5Type(Hdf5Block& body);
std::vector<char> ParseHdf5FillValue(Hdf5Block& body);
std::vector<Hdf5Filter> ParseHdf5Filters(Hdf5Block& body);
///@}

} // namespace VolumeHaptics

#endif

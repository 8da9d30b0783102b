// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomMessage_h
#define Explore_DicomMessage_h

#include <cstdint>

namespace Explore
{
/// The module's request to volumehaptics-dicom, through a socket. Both programs are of one build
/// and run on one computer, so numbers are sent as they are in memory. The path follows.
struct DicomRequest
{
  enum Kind : std::uint32_t
  {
    Values,   // elements, without the pixels
    Stored,   // pixels as the data set has them
    Unpacked, // pixels of a compressed image
  };
  std::uint32_t What = Values;
  std::uint32_t PathLength = 0;
  std::uint64_t MostBytes = 0; // largest number of pixel bytes; a larger file is refused
};

/// The answer. Bytes follow: pixels, or DicomElement with the value behind each.
struct DicomAnswer
{
  std::uint32_t IsRead = 0;
  std::uint32_t IsBig = 0;    // whether pixels have the most significant byte first
  std::uint32_t PixelTag = 0; // 0: there are no pixels
  std::uint32_t AreItems = 0; // whether pixels are compressed, in items
  std::uint32_t AreItemsWhole = 0;
  std::uint32_t IsDeflated = 0;
  std::uint64_t PixelPlace = 0;  // where the pixels begin in the file
  std::uint64_t PixelLength = 0; // bytes from there on
  ///@{
  /// Describes unpacked pixels.
  std::uint32_t Bits = 0, StoredBits = 0, Samples = 0, ArePlanes = 0, IsYbr = 0;
  ///@}
  std::uint64_t ByteCount = 0;
};

struct DicomElement
{
  std::uint32_t Tag = 0;
  std::uint32_t Sequence = 0; // tag of the outermost sequence that it lies in; 0: none
  std::int32_t Item = -1;     // number of the item in that sequence
  std::uint32_t Length = 0;   // bytes of the value, least significant byte first
};
} // namespace Explore

#endif

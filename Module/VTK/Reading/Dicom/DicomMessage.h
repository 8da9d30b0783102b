// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomMessage_h
#define Explore_DicomMessage_h

#include <cstdint>

namespace Explore
{
/// Request of the module to the process volumehaptics-dicom, through a socket. Both programs are
/// from the same build on the same computer, so numbers are sent as they are in memory. The path
/// follows.
struct DicomRequest
{
  enum Kind : std::uint32_t
  {
    Values,   // elements without the pixels
    Stored,   // pixels as stored in the file
    Unpacked, // decompressed pixels of an image
  };
  std::uint32_t What = Values;
  std::uint32_t PathLength = 0;
  std::uint64_t MostBytes = 0; // largest accepted number of pixel bytes
};

/// Answer to a request. Bytes follow: pixels, or a sequence of DicomElements, each followed by its
/// value.
struct DicomAnswer
{
  std::uint32_t IsRead = 0;
  std::uint32_t IsBig = 0;    // whether pixels are big-endian
  std::uint32_t PixelTag = 0; // 0: the file has no pixels
  std::uint32_t AreItems = 0; // whether the pixels are compressed, in items
  std::uint32_t AreItemsWhole = 0;
  std::uint32_t IsDeflated = 0;
  std::uint64_t PixelPlace = 0;  // offset (bytes) of the pixels in the file
  std::uint64_t PixelLength = 0; // bytes from that offset on
  ///@{
  /// Layout of decompressed pixels, as in DicomHeader.
  std::uint32_t Bits = 0, StoredBits = 0, Samples = 0, ArePlanes = 0, IsYbr = 0;
  ///@}
  std::uint64_t ByteCount = 0;
};

struct DicomElement
{
  std::uint32_t Tag = 0;
  std::uint32_t Sequence = 0; // tag of the outermost sequence that contains the element; 0: none
  std::int32_t Item = -1;     // index of the item in that sequence
  std::uint32_t Length = 0;   // number of bytes of the value, which is little-endian
};
} // namespace Explore

#endif

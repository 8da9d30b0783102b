// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_DicomMessage_h
#define Explore_DicomMessage_h

#include <cerrno>
#include <cstddef>
#include <cstdint>

#if !defined(_WIN32)
#include <sys/socket.h>
#endif

namespace Explore
{
/// What the module asks of volumehaptics-dicom, through a socket. Both are of one build and run
/// on one computer, so numbers are sent as they are in memory. The path follows.
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
  std::uint64_t MostBytes = 0; // of pixels; if there are more, the file is refused
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
  /// What unpacked pixels are.
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

#if !defined(_WIN32)
/// Sends all bytes through a socket, also if signals interrupt it. Returns false if the other side
/// is gone.
inline bool SendAll(int link, const void* from, std::size_t size)
{
  const char* at = static_cast<const char*>(from);
  while (size > 0)
  {
    const ssize_t sent = send(link, at, size, MSG_NOSIGNAL);
    if (sent <= 0 && errno != EINTR)
    {
      return false;
    }
    at += sent > 0 ? sent : 0;
    size -= static_cast<std::size_t>(sent > 0 ? sent : 0);
  }
  return true;
}

/// Receives `size` bytes from a socket, also if signals interrupt it. Returns false if the other
/// side is gone.
inline bool ReceiveAll(int link, void* to, std::size_t size)
{
  char* at = static_cast<char*>(to);
  while (size > 0)
  {
    const ssize_t got = recv(link, at, size, MSG_WAITALL);
    if (got == 0 || (got < 0 && errno != EINTR))
    {
      return false;
    }
    at += got > 0 ? got : 0;
    size -= static_cast<std::size_t>(got > 0 ? got : 0);
  }
  return true;
}
#endif
} // namespace Explore

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sends bytes to a reader process through a socket, and receives its answers.
 */
#ifndef SocketBytes_h
#define SocketBytes_h

#if !defined(_WIN32)
#include <cerrno>
#include <cstddef>

#include <sys/socket.h>
#include <sys/types.h>

namespace VolumeHaptics
{

#if !defined(MSG_NOSIGNAL)
#define MSG_NOSIGNAL 0 // macOS: the socket has SO_NOSIGPIPE
#endif

/**
 * Sends all bytes through a socket, even if signals interrupt. Returns false if the other side has
 * closed the socket.
 */
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

/**
 * Receives `size` bytes from a socket, even if signals interrupt. Returns false if the other side
 * has closed the socket.
 */
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

} // namespace VolumeHaptics
#endif

#endif

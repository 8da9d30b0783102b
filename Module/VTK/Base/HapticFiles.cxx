// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/HapticFiles.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <memory>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

constexpr std::size_t ChunkSize = 1 << 16;

/**
 * Returns the size (bytes) of the UTF-8 character that begins here, or 0 if none begins (RFC 3629,
 * table in section 4).
 */
std::size_t CharacterSize(const unsigned char* text, std::size_t left)
{
  const unsigned char first = text[0];
  if (first < 0x80)
  {
    return 1;
  }
  const std::size_t size = first >= 0xF0 && first <= 0xF4 ? 4
    : first >= 0xE0 && first <= 0xEF                      ? 3
    : first >= 0xC2 && first <= 0xDF                      ? 2
                                                          : 0;
  if (size == 0 || size > left)
  {
    return 0;
  }
  const unsigned char least = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
  const unsigned char most = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
  if (text[1] < least || text[1] > most)
  {
    return 0;
  }
  for (std::size_t i = 2; i < size; ++i)
  {
    if (text[i] < 0x80 || text[i] > 0xBF)
    {
      return 0;
    }
  }
  return size;
}

const char* WhatElse(const struct stat& status)
{
  return S_ISDIR(status.st_mode) ? "is a folder"
    : S_ISFIFO(status.st_mode)   ? "is a pipe"
                                 : "is a device or a socket";
}

} // namespace

std::string DescribeError(int number)
{
  return Printable(std::generic_category().message(number));
}

int OpenFile(const std::string& file, int flags, mode_t mode)
{
  int descriptor = -1;
  do
  {
    descriptor = open(file.c_str(), flags | O_CLOEXEC, mode);
  } while (descriptor < 0 && errno == EINTR);
  return descriptor;
}

int OpenToRead(const std::string& file)
{
  return OpenFile(file, O_RDONLY | O_NONBLOCK);
}

int SyncFile(int descriptor)
{
  int failure = 0;
  do
  {
    failure = fsync(descriptor) == 0 || errno == EINVAL ? 0 : errno;
  } while (failure == EINTR);
  return failure;
}

int SyncFolder(const std::string& file)
{
  const int descriptor = OpenFile(GetFolder(file), O_RDONLY | O_DIRECTORY);
  if (descriptor < 0)
  {
    // A folder that can't be read can still allow new files.
    return errno == EACCES ? 0 : errno;
  }
  const int failure = SyncFile(descriptor);
  close(descriptor);
  return failure;
}

std::string ResolveLinks(const std::string& file)
{
  std::string name = file;
  constexpr int most = 40; // limit of Linux on the number of links
  for (int i = 0; i < most; ++i)
  {
    const std::unique_ptr<char, void (*)(void*)> real(realpath(name.c_str(), nullptr), std::free);
    if (real)
    {
      return real.get();
    }
    // The file does not exist, but a link to it may.
    char target[4096];
    const ssize_t size = readlink(name.c_str(), target, sizeof(target));
    if (size <= 0)
    {
      return name;
    }
    const std::string next(target, static_cast<std::size_t>(size));
    name = next[0] == '/' ? next : GetFolder(name) + "/" + next;
  }
  return file;
}

bool IsSameFile(int descriptor, const std::string& file)
{
  struct stat here;
  struct stat there;
  return fstat(descriptor, &here) == 0 && stat(file.c_str(), &there) == 0 &&
    here.st_dev == there.st_dev && here.st_ino == there.st_ino;
}

bool CopyPermissions(int descriptor, const struct stat& other)
{
  struct stat status;
  const bool isKept = fchown(descriptor, other.st_uid, other.st_gid) == 0 ||
    fchown(descriptor, static_cast<uid_t>(-1), other.st_gid) == 0 ||
    (fstat(descriptor, &status) == 0 && status.st_gid == other.st_gid);
  // Set-user-ID and similar bits must not be copied to a file with another owner.
  (void)!fchmod(descriptor, isKept ? other.st_mode & 0777 : (other.st_mode & 0700) | 0600);
  return isKept;
}

std::string Printable(const std::string& text)
{
  const auto* const bytes = reinterpret_cast<const unsigned char*>(text.data());
  std::string result;
  for (std::size_t i = 0; i < text.size();)
  {
    const std::size_t size = CharacterSize(bytes + i, text.size() - i);
    if (size > 0)
    {
      result.append(text, i, size);
      i += size;
      continue;
    }
    char escape[5];
    std::snprintf(escape, sizeof(escape), "\\x%02X", bytes[i]);
    result += escape;
    ++i;
  }
  return result;
}

std::string MakeAbsolute(const std::string& file)
{
  const std::unique_ptr<char, void (*)(void*)> here(getcwd(nullptr, 0), std::free);
  return file.empty() || file[0] == '/' || !here ? file : std::string(here.get()) + "/" + file;
}

std::string GetFolder(const std::string& file)
{
  const std::size_t slash = file.rfind('/');
  return slash == std::string::npos ? "." : slash == 0 ? "/" : file.substr(0, slash);
}

std::string ExplainWriteError(int number, const std::string& file)
{
  const std::string folder = Printable(GetFolder(file));
  switch (number)
  {
    case ENOENT:
    case ENOTDIR:
      return "there is no folder " + folder +
        ". Check that the folder exists, or choose another one.";
    case EACCES:
    case EPERM:
    case EROFS:
      return "you may not write to the folder " + folder + " (" + DescribeError(number) +
        "). Choose another one, or change its permissions.";
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return "there is no room for it in the folder " + folder + " (" + DescribeError(number) +
        "). Make room, or choose a folder on another disk.";
    default:
      return "the system says: " + DescribeError(number) + ". Choose another file.";
  }
}

bool CheckWritable(const std::string& file, std::string& error)
{
  struct stat status;
  const std::string target = ResolveLinks(file);
  if (stat(target.c_str(), &status) == 0)
  {
    if (!S_ISREG(status.st_mode))
    {
      error = std::string("it ") + WhatElse(status) + ". Give the name of a file.";
      return false;
    }
    if (faccessat(AT_FDCWD, target.c_str(), W_OK, AT_EACCESS) != 0)
    {
      error = "the file is there and may not be written (" + DescribeError(errno) +
        "). Change its permissions, or give another name.";
      return false;
    }
  }
  if (faccessat(AT_FDCWD, GetFolder(target).c_str(), W_OK | X_OK, AT_EACCESS) != 0)
  {
    error = ExplainWriteError(errno, target);
    return false;
  }
  return true;
}

bool CheckRegular(const std::string& file, std::string& error)
{
  struct stat status;
  if (stat(file.c_str(), &status) != 0)
  {
    error = errno == ENOENT || errno == ENOTDIR ? "does not exist"
                                                : "can't be read (" + DescribeError(errno) + ")";
    return false;
  }
  if (!S_ISREG(status.st_mode))
  {
    error = std::string(WhatElse(status)) + ", not a file";
    return false;
  }
  return true;
}

std::string DetectHoles(const std::string& file)
{
  constexpr std::int64_t smallest = std::int64_t{ 64 } << 20;
  constexpr std::int64_t largestCompression =
    1032; // of zeros by deflate (zlib's technical details)
  struct stat status;
  const int descriptor = OpenToRead(file);
  if (descriptor < 0)
  {
    return {};
  }
  const std::int64_t size =
    fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) ? std::int64_t{ status.st_size } : 0;
  std::int64_t stored = 0;
  bool hasMore = size > smallest;
  for (off_t at = 0; hasMore && stored < size / largestCompression;)
  {
    const off_t data = lseek(descriptor, at, SEEK_DATA);
    at = data < 0 ? data : lseek(descriptor, data, SEEK_HOLE);
    hasMore = at >= 0;
    // ENXIO: no data follow. Another error: the file system tells nothing.
    stored = hasMore ? stored + (at - data) : errno == ENXIO ? stored : size;
  }
  close(descriptor);
  return size > smallest && stored < size / largestCompression ? "has " + std::to_string(stored) +
      " of its " + std::to_string(size) + " bytes on the disk, and holes for the rest"
                                                               : std::string();
}

std::ifstream OpenStream(const std::string& file)
{
  std::string error;
  std::ifstream stream;
  if (CheckRegular(file, error))
  {
    stream.open(file, std::ios::binary);
  }
  else
  {
    stream.setstate(std::ios::failbit);
  }
  return stream;
}

bool ReadSmallFile(const std::string& file, std::size_t most, std::string& text, std::string& error)
{
  text.clear();
  if (!CheckRegular(file, error))
  {
    return false;
  }
  const int descriptor = OpenToRead(file);
  if (descriptor < 0)
  {
    error = "can't be read (" + DescribeError(errno) + ")";
    return false;
  }
  struct stat status;
  int failure = fstat(descriptor, &status) == 0 ? 0 : errno;
  // The file may have been replaced after the check.
  bool isGood = failure == 0 && S_ISREG(status.st_mode);
  char buffer[ChunkSize];
  while (isGood && text.size() <= most)
  {
    const ssize_t got = read(descriptor, buffer, sizeof(buffer));
    if (got == 0)
    {
      break;
    }
    if (got > 0)
    {
      text.append(buffer, static_cast<std::size_t>(got));
    }
    else if (errno != EINTR)
    {
      failure = errno;
      isGood = false;
    }
  }
  close(descriptor);
  if (!isGood)
  {
    error = failure ? "can't be read (" + DescribeError(failure) + ")" : "is not a file";
  }
  else if (text.size() > most)
  {
    error = "is larger than " + std::to_string(most >> 20) + " MiB";
  }
  return isGood && text.size() <= most;
}

int WriteAll(int descriptor, const void* data, std::size_t size)
{
  const char* from = static_cast<const char*>(data);
  while (size > 0)
  {
    const ssize_t written = write(descriptor, from, size);
    if (written < 0 && errno != EINTR)
    {
      return errno;
    }
    if (written > 0)
    {
      from += written;
      size -= static_cast<std::size_t>(written);
    }
  }
  return 0;
}

} // namespace VolumeHaptics

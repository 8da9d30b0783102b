// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Platform/HapticFiles.h"

#include "Core/Platform/Files.h"

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <system_error>

namespace VolumeHaptics
{
namespace
{

constexpr std::size_t ChunkSize = 1 << 16;

/**
 * Returns the size (bytes) of the UTF-8 character at the beginning of a text, or 0 if there is none
 * (RFC 3629, table in section 4).
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

const char* WhatElse(const Files::Status& status)
{
  return Files::IsFolder(status) ? "is a folder"
    : Files::IsPipe(status)      ? "is a pipe"
                                 : "is a device or a socket";
}

} // namespace

std::string DescribeError(int number)
{
  return Printable(std::generic_category().message(number));
}

int SyncFolder(const std::string& file)
{
  const int descriptor = Files::Open(GetFolder(file), Files::For::ReadingFolder);
  if (descriptor < 0)
  {
    // New files may be possible even in a folder that can't be read.
    return errno == EACCES ? 0 : errno;
  }
  const int failure = Files::Sync(descriptor);
  Files::Close(descriptor);
  return failure;
}

std::string Printable(const std::string& text)
{
  const auto* const bytes = reinterpret_cast<const unsigned char*>(text.data());
  std::string result;
  for (std::size_t i = 0; i < text.size();)
  {
    const std::size_t size = CharacterSize(bytes + i, text.size() - i);
    if (size > 0 && bytes[i] != 0)
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

bool IsUtf8(const std::string& text)
{
  const auto* const bytes = reinterpret_cast<const unsigned char*>(text.data());
  std::size_t size = 1;
  for (std::size_t i = 0; i < text.size() && size > 0; i += size)
  {
    size = CharacterSize(bytes + i, text.size() - i);
  }
  return size > 0;
}

std::string MakeAbsolute(const std::string& file)
{
  const std::string here = Files::GetWorkingFolder();
  return file.empty() || Files::IsAbsolute(file) || here.empty() ? file : here + "/" + file;
}

std::string GetFolder(const std::string& file)
{
  return Files::GetFolder(file);
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
#if defined(EDQUOT)
    case EDQUOT:
#endif
    case EFBIG:
      return "there is no room for it in the folder " + folder + " (" + DescribeError(number) +
        "). Make room, or choose a folder on another disk.";
    default:
      return "the system says: " + DescribeError(number) + ". Choose another file.";
  }
}

bool CheckWritable(const std::string& file, std::string& error)
{
  Files::Status status;
  const std::string target = Files::ResolveLinks(file);
  if (Files::GetStatus(target, status))
  {
    if (!Files::IsRegular(status))
    {
      error = std::string("it ") + WhatElse(status) + ". Give the name of a file.";
      return false;
    }
    if (!Files::MayWrite(target))
    {
      error = "the file is there and may not be written (" + DescribeError(errno) +
        "). Change its permissions, or give another name.";
      return false;
    }
  }
  if (!Files::MayWriteFolder(GetFolder(target)))
  {
    error = ExplainWriteError(errno, target);
    return false;
  }
  return true;
}

bool CheckRegular(const std::string& file, std::string& error)
{
  Files::Status status;
  if (!Files::GetStatus(file, status))
  {
    error = errno == ENOENT || errno == ENOTDIR ? "does not exist"
                                                : "can't be read (" + DescribeError(errno) + ")";
    return false;
  }
  if (!Files::IsRegular(status))
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
    1032; // largest ratio of deflate, for zeros (zlib's technical details)
  Files::Status status;
  const int descriptor = Files::Open(file, Files::For::Reading);
  if (descriptor < 0)
  {
    return {};
  }
  const std::int64_t size = Files::GetStatus(descriptor, status) && Files::IsRegular(status)
    ? std::int64_t{ status.st_size }
    : 0;
  const std::int64_t stored =
    size > smallest ? Files::CountStored(descriptor, size / largestCompression) : size;
  Files::Close(descriptor);
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
    stream.open(Files::ToPath(file), std::ios::binary);
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
  const int descriptor = Files::Open(file, Files::For::Reading);
  if (descriptor < 0)
  {
    error = "can't be read (" + DescribeError(errno) + ")";
    return false;
  }
  Files::Status status;
  int failure = Files::GetStatus(descriptor, status) ? 0 : errno;
  // Check again, because the file may have been replaced meanwhile.
  bool isGood = failure == 0 && Files::IsRegular(status);
  char buffer[ChunkSize];
  while (isGood && text.size() <= most)
  {
    const std::int64_t got = Files::Read(descriptor, buffer, sizeof(buffer));
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
  Files::Close(descriptor);
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
    const std::int64_t written = Files::Write(descriptor, from, size);
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

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Platform/SmallFile.h"

#include "Core/Platform/Files.h"

#include <cerrno>
#include <cstdint>
#include <system_error>

namespace VolumeHaptics
{
namespace
{

std::string DescribeFailure(int number)
{
  return "can't be read (" + std::generic_category().message(number) + ")";
}

std::string Read(int descriptor, std::size_t most, std::string& bytes)
{
  Files::Status status;
  if (!Files::GetStatus(descriptor, status))
  {
    return DescribeFailure(errno);
  }
  if (!Files::IsRegular(status))
  {
    return Files::IsFolder(status) ? "is a folder" : "is no regular file";
  }
  const auto size = static_cast<std::uint64_t>(status.st_size);
  if (size > most)
  {
    return "has " + std::to_string(size) + " bytes";
  }
  bytes.resize(static_cast<std::size_t>(size));
  std::size_t done = 0;
  for (std::int64_t part = 1; part > 0 && done < bytes.size();)
  {
    part = Files::Read(descriptor, &bytes[done], bytes.size() - done);
    done += static_cast<std::size_t>(part > 0 ? part : 0);
  }
  return done == bytes.size() ? std::string() : DescribeFailure(errno == 0 ? EIO : errno);
}

} // namespace

std::string ReadSmallFile(const std::string& file, std::size_t most, std::string& bytes)
{
  bytes.clear();
  errno = 0;
  Files::Status status;
  const int descriptor = Files::Open(file, Files::For::Reading);
  if (descriptor < 0)
  {
    const int failure = errno;
    if (failure == ENOENT || failure == ENOTDIR)
    {
      return NoSuchFile;
    }
    // The open call fails for folders on Windows, and for sockets on all systems.
    return !Files::GetStatus(file, status) || Files::IsRegular(status) ? DescribeFailure(failure)
      : Files::IsFolder(status)                                        ? "is a folder"
                                                                       : "is no regular file";
  }
  std::string fault = Read(descriptor, most, bytes);
  Files::Close(descriptor);
  bytes.resize(fault.empty() ? bytes.size() : 0);
  return fault;
}

} // namespace VolumeHaptics

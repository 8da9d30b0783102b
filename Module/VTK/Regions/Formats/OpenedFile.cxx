// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/OpenedFile.h"

#include "VTK/Base/HapticFiles.h"

#include <algorithm>
#include <cerrno>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace VolumeHaptics
{

OpenedFile::OpenedFile(const std::string& name)
  : Descriptor(OpenToRead(name))
{
  if (this->Descriptor < 0)
  {
    throw std::runtime_error(DescribeError(errno) + ". Check its name and permissions.");
  }
  struct stat status;
  if (fstat(this->Descriptor, &status) != 0 || !S_ISREG(status.st_mode))
  {
    close(this->Descriptor);
    throw std::runtime_error("it is no regular file. Give the name of the file of samples.");
  }
}

OpenedFile::~OpenedFile()
{
  close(this->Descriptor);
}

void OpenedFile::Read(void* samples, std::size_t size, std::int64_t from) const
{
  char* to = static_cast<char*>(samples);
  while (size > 0)
  {
    const ssize_t count = pread(this->Descriptor, to, size, static_cast<off_t>(from));
    if (count == 0)
    {
      throw std::runtime_error("it ends before byte " + std::to_string(from + 1) +
        ". Check the extent of the volume, its scalar type and the size of the header, and "
        "whether the file is complete.");
    }
    if (count < 0 && errno != EINTR)
    {
      throw std::runtime_error(DescribeError(errno) + " at byte " + std::to_string(from) + ".");
    }
    const auto done = static_cast<std::size_t>(std::max<ssize_t>(count, 0));
    to += done;
    from += static_cast<std::int64_t>(done);
    size -= done;
  }
}

std::int64_t OpenedFile::GetSize() const
{
  struct stat status;
  return fstat(this->Descriptor, &status) == 0 ? std::int64_t{ status.st_size } : 0;
}

} // namespace VolumeHaptics

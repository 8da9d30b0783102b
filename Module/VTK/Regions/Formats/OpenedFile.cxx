// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/OpenedFile.h"

#include "Core/Platform/Files.h"
#include "Core/Platform/HapticFiles.h"

#include <algorithm>
#include <cerrno>
#include <stdexcept>

namespace VolumeHaptics
{

OpenedFile::OpenedFile(const std::string& name)
  : Descriptor(Files::Open(name, Files::For::Reading))
{
  if (this->Descriptor < 0)
  {
    throw std::runtime_error(DescribeError(errno) + ". Check its name and permissions.");
  }
  Files::Status status;
  if (!Files::GetStatus(this->Descriptor, status) || !Files::IsRegular(status))
  {
    Files::Close(this->Descriptor);
    throw std::runtime_error(
      Printable(name) + " is no regular file. Give the name of the file of samples.");
  }
}

OpenedFile::~OpenedFile()
{
  Files::Close(this->Descriptor);
}

void OpenedFile::Read(void* samples, std::size_t size, std::int64_t from) const
{
  char* to = static_cast<char*>(samples);
  while (size > 0)
  {
    const std::int64_t count = Files::ReadAt(this->Descriptor, to, size, from);
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
    const auto done = static_cast<std::size_t>(std::max<std::int64_t>(count, 0));
    to += done;
    from += static_cast<std::int64_t>(done);
    size -= done;
  }
}

std::int64_t OpenedFile::GetSize() const
{
  Files::Status status;
  return Files::GetStatus(this->Descriptor, status) ? std::int64_t{ status.st_size } : 0;
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Large/RawVolumeFile.h"

#include "VTK/Files/HapticFiles.h"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

/** An open file, which is closed at the end. */
class OpenedFile
{
public:
  explicit OpenedFile(const std::string& name)
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
  ~OpenedFile() { close(this->Descriptor); }
  OpenedFile(const OpenedFile&) = delete;
  OpenedFile& operator=(const OpenedFile&) = delete;

  void Read(char* to, std::size_t size, std::int64_t from) const
  {
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

private:
  const int Descriptor;
};

void SwapBytes(char* samples, std::size_t size, std::size_t sampleSize)
{
  for (char* sample = samples; sample < samples + size; sample += sampleSize)
  {
    std::reverse(sample, sample + sampleSize);
  }
}

} // namespace

void RawVolumeFile::Read(const int box[6], void* samples) const
{
  const OpenedFile file(this->Name);
  const auto sampleSize = static_cast<std::int64_t>(this->SampleSize);
  const std::int64_t nx = std::int64_t{ this->Extent[1] } - this->Extent[0] + 1;
  const std::int64_t ny = std::int64_t{ this->Extent[3] } - this->Extent[2] + 1;
  const auto row =
    static_cast<std::size_t>((std::int64_t{ box[1] } - box[0] + 1) * sampleSize); // bytes
  char* to = static_cast<char*>(samples);
  for (std::int64_t k = box[4]; k <= box[5]; ++k)
  {
    for (std::int64_t j = box[2]; j <= box[3]; ++j)
    {
      const std::int64_t first = std::int64_t{ box[0] } - this->Extent[0] +
        nx * (j - this->Extent[2] + ny * (k - this->Extent[4]));
      file.Read(to, row, this->HeaderSize + first * sampleSize);
      to += row;
    }
  }
  if (this->IsSwapped)
  {
    char* const begin = static_cast<char*>(samples);
    SwapBytes(begin, static_cast<std::size_t>(to - begin), this->SampleSize);
  }
}

} // namespace VolumeHaptics

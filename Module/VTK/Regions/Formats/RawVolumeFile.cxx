// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/RawVolumeFile.h"

#include "VTK/Regions/Formats/OpenedFile.h"

#include <algorithm>
#include <cstdint>

namespace VolumeHaptics
{

void SwapBytes(char* samples, std::size_t size, std::size_t sampleSize)
{
  for (char* sample = samples; sample < samples + size; sample += sampleSize)
  {
    std::reverse(sample, sample + sampleSize);
  }
}

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

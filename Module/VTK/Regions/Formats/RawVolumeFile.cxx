// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/RawVolumeFile.h"

#include "VTK/Regions/Formats/OpenedFile.h"

#include <algorithm>
#include <cstdint>
#include <vector>

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
  this->ReadWith([&](void* to, std::size_t size, std::int64_t from)
    { file.Read(to, size, this->HeaderSize + from); },
    box, samples);
}

void RawVolumeFile::ReadWith(const ByteReader& read, const int box[6], void* samples) const
{
  const auto sampleSize = static_cast<std::int64_t>(this->SampleSize);
  const std::int64_t nx = std::int64_t{ this->Extent[1] } - this->Extent[0] + 1;
  const std::int64_t ny = std::int64_t{ this->Extent[3] } - this->Extent[2] + 1;
  const auto steps =
    this->Steps[0] > 0 ? this->Steps : std::array<std::int64_t, 3>{ 1, nx, nx * ny };
  const std::int64_t count = std::int64_t{ box[1] } - box[0] + 1;
  const auto row = static_cast<std::size_t>(count * sampleSize); // bytes
  std::vector<char> apart; // a row of the file, including samples of other volumes
  char* to = static_cast<char*>(samples);
  for (std::int64_t k = box[4]; k <= box[5]; ++k)
  {
    for (std::int64_t j = box[2]; j <= box[3]; ++j)
    {
      const std::int64_t first = this->First +
        (std::int64_t{ box[0] } - this->Extent[0]) * steps[0] + (j - this->Extent[2]) * steps[1] +
        (k - this->Extent[4]) * steps[2];
      if (steps[0] == 1)
      {
        read(to, row, first * sampleSize);
        to += row;
        continue;
      }
      apart.resize(static_cast<std::size_t>(((count - 1) * steps[0] + 1) * sampleSize));
      read(apart.data(), apart.size(), first * sampleSize);
      for (std::int64_t i = 0; i < count; ++i, to += sampleSize)
      {
        std::copy_n(apart.data() + i * steps[0] * sampleSize, sampleSize, to);
      }
    }
  }
  if (this->IsSwapped)
  {
    char* const begin = static_cast<char*>(samples);
    SwapBytes(begin, static_cast<std::size_t>(to - begin), this->SampleSize);
  }
}

} // namespace VolumeHaptics

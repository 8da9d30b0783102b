// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/ChunkedVolume.h"

#include "VTK/Regions/Formats/RawVolumeFile.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace VolumeHaptics
{

void ChunkedVolume::CopyRows(
  const int box[6], const ChunkPlace& place, const char* chunk, char* samples) const
{
  // Intersection of box and chunk, in sample indices relative to the volume's first sample.
  std::int64_t from[3];
  std::int64_t to[3];
  std::int64_t boxFirst[3];
  std::int64_t boxSize[3];
  for (int a = 0; a < 3; ++a)
  {
    boxFirst[a] = std::int64_t{ box[2 * a] } - this->Extent[2 * a];
    boxSize[a] = std::int64_t{ box[2 * a + 1] } - box[2 * a] + 1;
    const std::int64_t first = place[a] * this->ChunkSize[a];
    from[a] = std::max(boxFirst[a], first);
    to[a] = std::min(boxFirst[a] + boxSize[a], first + this->ChunkSize[a]);
  }
  const auto row = static_cast<std::size_t>(to[0] - from[0]) * this->SampleSize;
  for (std::int64_t k = from[2]; k < to[2]; ++k)
  {
    for (std::int64_t j = from[1]; j < to[1]; ++j)
    {
      char* const target = samples +
        this->SampleSize *
          static_cast<std::size_t>(from[0] - boxFirst[0] +
            boxSize[0] * (j - boxFirst[1] + boxSize[1] * (k - boxFirst[2])));
      if (chunk)
      {
        const std::int64_t at = from[0] - place[0] * this->ChunkSize[0] +
          this->ChunkSize[0] *
            (j - place[1] * this->ChunkSize[1] +
              this->ChunkSize[1] * (k - place[2] * this->ChunkSize[2]));
        std::memcpy(target, chunk + this->SampleSize * static_cast<std::size_t>(at), row);
        continue;
      }
      for (std::size_t byte = 0; byte < row; byte += this->SampleSize)
      {
        std::copy(this->FillValue.begin(), this->FillValue.end(), target + byte);
      }
    }
  }
}

void ChunkedVolume::Read(const int box[6], void* samples) const
{
  ChunkPlace first;
  ChunkPlace last;
  for (int a = 0; a < 3; ++a)
  {
    first[a] = (std::int64_t{ box[2 * a] } - this->Extent[2 * a]) / this->ChunkSize[a];
    last[a] = (std::int64_t{ box[2 * a + 1] } - this->Extent[2 * a]) / this->ChunkSize[a];
  }
  char* const begin = static_cast<char*>(samples);
  const auto size = this->SampleSize *
    static_cast<std::size_t>(this->ChunkSize[0] * this->ChunkSize[1] * this->ChunkSize[2]);
  std::vector<char> bytes;
  for (std::int64_t k = first[2]; k <= last[2]; ++k)
  {
    for (std::int64_t j = first[1]; j <= last[1]; ++j)
    {
      for (std::int64_t i = first[0]; i <= last[0]; ++i)
      {
        const bool isThere = this->Load({ i, j, k }, bytes);
        if (isThere && bytes.size() < size)
        {
          throw std::runtime_error("a chunk of it has " + std::to_string(bytes.size()) +
            " bytes instead of " + std::to_string(size) + ". Check whether it is complete.");
        }
        this->CopyRows(box, { i, j, k }, isThere ? bytes.data() : nullptr, begin);
      }
    }
  }
  if (this->IsSwapped)
  {
    const std::size_t all = this->SampleSize *
      static_cast<std::size_t>(CountSamples({ box[0], box[1], box[2], box[3], box[4], box[5] }));
    SwapBytes(begin, all, this->SampleSize);
  }
}

} // namespace VolumeHaptics

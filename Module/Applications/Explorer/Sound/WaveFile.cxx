// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Sound/WaveFile.h"

#include "VTK/Reading/InputError.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <fstream>

namespace
{
/// Appends a number in little-endian order, whatever the computer's byte order.
void Append(std::string& bytes, std::uint32_t number, int count)
{
  for (int i = 0; i < count; ++i, number >>= 8)
  {
    bytes += static_cast<char>(number & 0xff);
  }
}
} // namespace

namespace Explore
{
void WriteWave(const std::vector<float>& samples, int samplesPerSecond, const std::string& file)
{
  constexpr std::uint32_t sampleSize = 2;
  constexpr std::uint32_t restOfHead = 36;
  const auto rate = static_cast<std::uint32_t>(samplesPerSecond);
  const auto size = static_cast<std::uint32_t>(samples.size()) * sampleSize;
  std::string bytes = "RIFF";
  Append(bytes, restOfHead + size, 4);
  bytes += "WAVEfmt ";
  Append(bytes, 16, 4); // size of the format chunk (bytes)
  Append(bytes, 1, 2);  // PCM
  Append(bytes, 1, 2);  // one channel
  Append(bytes, rate, 4);
  Append(bytes, rate * sampleSize, 4);
  Append(bytes, sampleSize, 2);
  Append(bytes, 8 * sampleSize, 2); // bits per sample
  bytes += "data";
  Append(bytes, size, 4);
  for (const float sample : samples)
  {
    const long level = std::lround(32767.0f * std::clamp(sample, -1.0f, 1.0f));
    Append(bytes, static_cast<std::uint32_t>(level), 2);
  }
  std::ofstream stream(file, std::ios::binary);
  stream << bytes;
  stream.close();
  if (!stream)
  {
    throw InputError("--sound " + file, "cannot be written",
      "check that the disk is not full, the folder exists, and you may write to it");
  }
}
} // namespace Explore

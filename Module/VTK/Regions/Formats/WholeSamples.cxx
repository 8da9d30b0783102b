// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/WholeSamples.h"

#include "Core/Math/NumberText.h"
#include "VTK/Regions/Formats/ChunkCodecs.h"
#include "VTK/Regions/Formats/OpenedFile.h"

#include "vtkAbstractArray.h"
#include "vtkSetGet.h"
#include "vtkType.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <type_traits>

namespace VolumeHaptics
{
namespace
{

/** Largest compression ratio of deflate, reached for zeros (zlib's technical details). */
constexpr double LargestCompression = 1032.0;

template <typename T>
std::optional<T> ParseSample(std::string_view word)
{
  if constexpr (std::is_integral<T>::value)
  {
    T number{};
    word.remove_prefix(word.front() == '+' ? 1 : 0);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool isWhole = error == std::errc() && end == word.data() + word.size();
    return isWhole ? std::optional<T>(number) : std::nullopt;
  }
  else
  {
    const std::optional<double> number = ParseNumber(word);
    return number ? std::optional<T>(static_cast<T>(*number)) : std::nullopt;
  }
}

/**
 * Parses numbers until the memory is full. Throws if the text has too few numbers or anything else.
 */
template <typename T>
void ParseSamples(std::string_view text, const std::string& file, char* to, std::size_t size)
{
  constexpr std::string_view separators = " \t\v\f\r\n,";
  for (char* const end = to + size; to < end; to += sizeof(T))
  {
    text.remove_prefix(std::min(text.find_first_not_of(separators), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(separators));
    if (word.empty())
    {
      throw std::runtime_error(DescribeMissingSamples(file));
    }
    const std::optional<T> number = ParseSample<T>(word);
    if (!number)
    {
      throw std::runtime_error("the text " + file + " has \"" + std::string(word.substr(0, 20)) +
        "\", which is no sample of its type. Write it again, with the encoding gzip or raw.");
    }
    std::memcpy(to, &*number, sizeof(T));
    text.remove_prefix(word.size());
  }
}

} // namespace

std::string DescribeMissingSamples(const std::string& file)
{
  return "it speaks of more samples than " + file +
    " has: its header announces more voxels than the file has, which ends before the last voxel. "
    "Check that the copy of that file is complete.";
}

void WholeSamples::Check() const
{
  const double bytes = vtkAbstractArray::GetDataTypeSize(this->ScalarType) * this->Count /
    static_cast<double>(this->Files.size());
  for (const std::string& name : this->Files)
  {
    const auto size = static_cast<double>(OpenedFile(name).GetSize());
    const double most = this->Encoding == Packed ? LargestCompression * size
      : this->Encoding == Raw
      ? size
      // In text, each number takes at least a digit and, except for the last one, a separator.
      : 0.5 * (size + 1.0) * vtkAbstractArray::GetDataTypeSize(this->ScalarType);
    if (!(bytes <= most))
    {
      throw std::runtime_error(DescribeMissingSamples(name));
    }
  }
}

/** Receives the samples of all files part by part, and copies those of the volume. */
class WholeSamples::Volume
{
public:
  explicit Volume(const WholeSamples& samples)
    : Samples(samples)
    , SampleSize(static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(samples.ScalarType)))
    , RunLength(samples.Steps[0] == 1 ? samples.Size[0] : 1)
    , Bytes(samples.Size[0] * samples.Size[1] * samples.Size[2] * this->SampleSize)
  {
  }

  void Take(const char* part, std::size_t size)
  {
    const std::size_t run = this->RunLength * this->SampleSize; // bytes
    while (this->Done < this->Bytes.size())
    {
      const std::size_t inRun = this->Done % run;
      const std::size_t from = this->FindRun(this->Done / run) + inRun;
      if (from >= this->At + size)
      {
        break;
      }
      const std::size_t count = std::min(run - inRun, this->At + size - from);
      std::memcpy(this->Bytes.data() + this->Done, part + (from - this->At), count);
      this->Done += count;
    }
    this->At += size;
  }

  std::vector<char> MoveBytes() { return std::move(this->Bytes); }

private:
  /** Returns the offset (bytes) of a run of samples that are contiguous in the files, too. */
  std::size_t FindRun(std::size_t number) const
  {
    const std::size_t sample = number * this->RunLength;
    const std::size_t x = sample % this->Samples.Size[0];
    const std::size_t y = sample / this->Samples.Size[0] % this->Samples.Size[1];
    const std::size_t z = sample / this->Samples.Size[0] / this->Samples.Size[1];
    const std::array<std::size_t, 3>& steps = this->Samples.Steps;
    return (this->Samples.First + x * steps[0] + y * steps[1] + z * steps[2]) * this->SampleSize;
  }

  const WholeSamples& Samples;
  const std::size_t SampleSize;
  const std::size_t RunLength; ///< samples
  std::vector<char> Bytes;
  std::size_t Done = 0; ///< bytes copied so far
  std::size_t At = 0;   ///< offset (bytes) of the next part
};

void WholeSamples::LoadFile(const std::string& name, std::size_t size, Volume& volume) const
{
  const OpenedFile file(name);
  const auto length = static_cast<std::size_t>(file.GetSize());
  const bool isAtEnd = this->Offset == static_cast<std::size_t>(-1);
  if (length < (isAtEnd ? size : this->Offset))
  {
    throw std::runtime_error(DescribeMissingSamples(name));
  }
  const std::size_t offset = isAtEnd ? length - size : this->Offset;
  if (this->Encoding == Packed)
  {
    const auto take = [&volume](const char* part, std::size_t count) { volume.Take(part, count); };
    if (InflateFile(file, offset, size, take) < size)
    {
      throw std::runtime_error(DescribeMissingSamples(name));
    }
    return;
  }
  if (this->Encoding == Raw)
  {
    constexpr std::size_t partSize = std::size_t{ 1 } << 20;
    std::vector<char> part(std::min(size, partSize));
    for (std::size_t at = 0; at < size; at += part.size())
    {
      part.resize(std::min(size - at, partSize));
      file.Read(part.data(), part.size(), static_cast<std::int64_t>(offset + at));
      volume.Take(part.data(), part.size());
    }
    return;
  }
  std::string text(length - offset, '\0');
  file.Read(text.data(), text.size(), static_cast<std::int64_t>(offset));
  std::vector<char> samples(size);
  switch (this->ScalarType)
  {
    vtkTemplateMacro(ParseSamples<VTK_TT>(text, name, samples.data(), size));
  }
  volume.Take(samples.data(), size);
}

void WholeSamples::Load()
{
  const auto each = static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(this->ScalarType) *
    this->Count / static_cast<double>(this->Files.size()));
  Volume volume(*this);
  for (const std::string& name : this->Files)
  {
    this->LoadFile(name, each, volume);
  }
  this->Bytes = volume.MoveBytes();
}

void WholeSamples::Copy(void* to, std::size_t size, std::size_t from)
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Bytes.empty())
    {
      this->Load();
    }
  }
  std::memcpy(to, this->Bytes.data() + from, size);
}

} // namespace VolumeHaptics

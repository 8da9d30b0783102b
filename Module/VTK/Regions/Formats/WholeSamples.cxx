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

/** Largest compression ratio of deflate, reached with zeros (zlib's technical details). */
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
 * Parses numbers until the memory is full. Throws if the text has too few numbers, or other words.
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
    " has: its header promises voxels that are not in the file, which ends before the last voxel. "
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
      // Each number needs at least a digit and, except for the last one, a separator.
      : 0.5 * (size + 1.0) * vtkAbstractArray::GetDataTypeSize(this->ScalarType);
    if (!(bytes <= most))
    {
      throw std::runtime_error(DescribeMissingSamples(name));
    }
  }
}

void WholeSamples::LoadFile(const std::string& name, char* to, std::size_t size) const
{
  const OpenedFile file(name);
  const auto length = static_cast<std::size_t>(file.GetSize());
  const bool isAtEnd = this->Offset == static_cast<std::size_t>(-1);
  if (length < (isAtEnd ? size : this->Offset))
  {
    throw std::runtime_error(DescribeMissingSamples(name));
  }
  const std::size_t offset = isAtEnd ? length - size : this->Offset;
  if (this->Encoding == Raw)
  {
    file.Read(to, size, static_cast<std::int64_t>(offset));
    return;
  }
  if (this->Encoding == Packed)
  {
    if (InflateFile(file, offset, to, size) < size)
    {
      throw std::runtime_error(DescribeMissingSamples(name));
    }
    return;
  }
  std::string text(length - offset, '\0');
  file.Read(text.data(), text.size(), static_cast<std::int64_t>(offset));
  switch (this->ScalarType)
  {
    vtkTemplateMacro(ParseSamples<VTK_TT>(text, name, to, size));
  }
}

void WholeSamples::Load()
{
  const auto each = static_cast<std::size_t>(vtkAbstractArray::GetDataTypeSize(this->ScalarType) *
    this->Count / static_cast<double>(this->Files.size()));
  std::vector<char> bytes(each * this->Files.size());
  char* to = bytes.data();
  for (const std::string& name : this->Files)
  {
    this->LoadFile(name, to, each);
    to += each;
  }
  this->Bytes = std::move(bytes);
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

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/Formats/Hdf5Types.h"

#include "VTK/Base/ByteOrder.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>

namespace VolumeHaptics
{
namespace
{

template <typename T>
double NumberAt(const char* bytes)
{
  T number;
  std::memcpy(&number, bytes, sizeof(T));
  return static_cast<double>(number);
}

/** Reads a number, least significant byte first as on this computer; NaN if that is impossible. */
double NumberOf(const Hdf5Type& type, const char* bytes)
{
  if (type.Kind == Hdf5Type::Float)
  {
    return type.Size == 4 ? NumberAt<float>(bytes) : NumberAt<double>(bytes);
  }
  switch (type.Size)
  {
    case 1:
      return type.IsSigned ? NumberAt<std::int8_t>(bytes) : NumberAt<std::uint8_t>(bytes);
    case 2:
      return type.IsSigned ? NumberAt<std::int16_t>(bytes) : NumberAt<std::uint16_t>(bytes);
    case 4:
      return type.IsSigned ? NumberAt<std::int32_t>(bytes) : NumberAt<std::uint32_t>(bytes);
    case 8:
      return type.IsSigned ? NumberAt<std::int64_t>(bytes) : NumberAt<std::uint64_t>(bytes);
    default:
      return std::numeric_limits<double>::quiet_NaN();
  }
}

} // namespace

std::vector<double> Hdf5Attribute::GetNumbers() const
{
  std::vector<double> numbers;
  const bool isNumber = this->Type.Kind == Hdf5Type::Integer || this->Type.Kind == Hdf5Type::Float;
  if (!isNumber)
  {
    return numbers;
  }
  const bool isOther = IsOtherByteOrder(this->Type.IsBig);
  std::vector<char> number(this->Type.Size);
  for (std::size_t at = 0; at + this->Type.Size <= this->Bytes.size(); at += this->Type.Size)
  {
    std::copy_n(
      this->Bytes.begin() + static_cast<std::ptrdiff_t>(at), number.size(), number.begin());
    if (isOther)
    {
      std::reverse(number.begin(), number.end());
    }
    numbers.push_back(NumberOf(this->Type, number.data()));
  }
  return numbers;
}

std::string Hdf5Attribute::GetText() const
{
  if (this->Type.Kind != Hdf5Type::Text)
  {
    return {};
  }
  const std::string text(this->Bytes.begin(), this->Bytes.end());
  return text.substr(0, text.find('\0'));
}

Hdf5Type ParseHdf5Type(Hdf5Block& body)
{
  Hdf5Type type;
  const int kind = body.Byte() & 15;
  const auto bits = static_cast<unsigned int>(body.Number(3));
  type.Size = static_cast<std::size_t>(body.Number(4));
  const bool hasUsualSize = type.Size == 1 || type.Size == 2 || type.Size == 4 || type.Size == 8;
  type.IsBig = (bits & 1U) != 0;
  if (kind == 3)
  {
    type.Kind = Hdf5Type::Text;
  }
  else if (kind == 0 && hasUsualSize)
  {
    const std::uint64_t first = body.Number(2);
    const std::uint64_t precision = body.Number(2);
    type.IsSigned = (bits & 8U) != 0;
    type.Kind = first == 0 && precision == 8 * type.Size ? Hdf5Type::Integer : Hdf5Type::Other;
  }
  else if (kind == 1 && (type.Size == 4 || type.Size == 8))
  {
    body.Skip(4);
    const int exponentAt = body.Byte();
    const int exponentSize = body.Byte();
    const bool isIeee = (bits & 64U) == 0 &&
      (type.Size == 4 ? exponentAt == 23 && exponentSize == 8
                      : exponentAt == 52 && exponentSize == 11);
    type.Kind = isIeee ? Hdf5Type::Float : Hdf5Type::Other;
    type.IsSigned = true;
  }
  return type;
}

std::vector<char> ParseHdf5FillValue(Hdf5Block& body)
{
  const int version = body.Byte();
  bool isDefined = false;
  if (version >= 3)
  {
    isDefined = (body.Byte() & 32) != 0;
  }
  else
  {
    body.Skip(2);
    isDefined = body.Byte() != 0 || version < 2;
  }
  return isDefined ? body.Take(static_cast<std::size_t>(body.Number(4))) : std::vector<char>();
}

std::vector<Hdf5Filter> ParseHdf5Filters(Hdf5Block& body)
{
  const int version = body.Byte();
  const int count = body.Byte();
  body.Skip(version == 1 ? 6 : 0);
  std::vector<Hdf5Filter> filters;
  for (int i = 0; i < count; ++i)
  {
    Hdf5Filter filter;
    filter.Id = static_cast<int>(body.Number(2));
    const bool hasName = version == 1 || filter.Id >= 256;
    const auto name = static_cast<std::size_t>(hasName ? body.Number(2) : 0);
    body.Skip(2);
    const auto values = static_cast<std::size_t>(body.Number(2));
    body.Skip(version == 1 ? (name + 7) / 8 * 8 : name);
    for (std::size_t v = 0; v < values; ++v)
    {
      const auto value = static_cast<std::size_t>(body.Number(4));
      filter.SampleSize = v == 0 ? value : filter.SampleSize;
    }
    body.Skip(version == 1 && values % 2 == 1 ? 4 : 0);
    filters.push_back(filter);
  }
  return filters;
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The samples of a label image as labels.
 */
#ifndef LabelSamples_h
#define LabelSamples_h

#include "Core/Field/LabelView.h"

#include <cstdint>
#include <limits>
#include <type_traits>

namespace VolumeHaptics
{

template <typename T>
constexpr std::int64_t ToLabel(T sample) noexcept
{
  if constexpr (std::is_same_v<T, std::uint64_t>)
  {
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
    return sample <= most ? static_cast<std::int64_t>(sample) : NoLabel;
  }
  else
  {
    return static_cast<std::int64_t>(sample);
  }
}

/** Calls f with a value of the C++ type that a scalar type stands for. */
template <typename F>
auto WithSampleType(ScalarType type, F&& f)
{
  switch (type)
  {
    case ScalarType::Int8:
      return f(std::int8_t{});
    case ScalarType::UInt8:
      return f(std::uint8_t{});
    case ScalarType::Int16:
      return f(std::int16_t{});
    case ScalarType::UInt16:
      return f(std::uint16_t{});
    case ScalarType::Int32:
      return f(std::int32_t{});
    case ScalarType::UInt32:
      return f(std::uint32_t{});
    case ScalarType::Int64:
      return f(std::int64_t{});
    case ScalarType::UInt64:
      return f(std::uint64_t{});
    case ScalarType::Float32:
      return f(float{});
    case ScalarType::Float64:
      break;
  }
  return f(double{});
}

} // namespace VolumeHaptics

#endif

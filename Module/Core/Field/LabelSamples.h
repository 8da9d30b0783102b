// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts the samples of a label image to labels.
 */
#ifndef LabelSamples_h
#define LabelSamples_h

#include "Core/Field/LabelView.h"
#include "Core/Math/KernelInline.h"

#include <cstdint>
#include <limits>
#include <type_traits>

namespace VolumeHaptics
{

// The namespace is unnamed, because the kernels must not call functions with external linkage
// (FieldKernels.h).
namespace
{

template <typename T>
VOLUME_HAPTICS_INLINE constexpr std::int64_t ToLabel(T sample) noexcept
{
  if constexpr (std::is_same_v<T, std::uint64_t>)
  {
    constexpr std::uint64_t most = std::numeric_limits<std::int64_t>::max();
    return sample <= most ? static_cast<std::int64_t>(sample) : NoLabel;
  }
  else if constexpr (std::is_floating_point_v<T>)
  {
    // Converting NaN, or a number beyond these limits, would be undefined behaviour.
    constexpr T end = T(9223372036854775808.0);
    return sample >= -end && sample < end ? static_cast<std::int64_t>(sample) : NoLabel;
  }
  else
  {
    return static_cast<std::int64_t>(sample);
  }
}

} // namespace
} // namespace VolumeHaptics

#endif

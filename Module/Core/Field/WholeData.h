// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the address of a whole volume's first sample from a view of a region.
 */
#ifndef WholeData_h
#define WholeData_h

#include "Core/Field/VolumeView.h"

namespace VolumeHaptics
{

inline std::int64_t SizeOf(ScalarType type) noexcept
{
  return WithSampleType(
    type, [](auto sample) { return static_cast<std::int64_t>(sizeof(sample)); });
}

/**
 * Returns the address of the whole volume's first sample. It is computed as a number, because there
 * may be no memory at it.
 */
inline const void* WholeData(const VolumeView& view) noexcept
{
  std::int64_t elements = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    elements += view.First[axis] * view.Stride[axis];
  }
  const auto bytes = static_cast<std::uintptr_t>(elements * SizeOf(view.Type));
  return reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(view.Data) - bytes);
}

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A view of a scalar array of any type. It copies and owns nothing.
 */
#ifndef VolumeView_h
#define VolumeView_h

#include <cstdint>

namespace VolumeHaptics
{

/** The scalar types of volumes. Each VTK scalar type is one of them. */
enum class ScalarType : std::uint8_t
{
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Int64,
  UInt64,
  Float32,
  Float64
};

/** Calls f with a value of the C++ type of a scalar type. */
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

/**
 * One component of a structured point array. The sample with index (i, j, k) is i*Stride[0] +
 * j*Stride[1] + k*Stride[2] elements of `Type` after `Data`. Indices run from 0 to Dimensions - 1,
 * whatever the image's extent is, because the maps from index to space account for the extent.
 *
 * A view may show a region of a larger volume. Then its indices are those of the volume, and `Data`
 * points to the sample with the index First. Reading in a region therefore returns the same values
 * as reading in the whole volume, to the bit.
 */
struct VolumeView
{
  const void* Data = nullptr;
  ScalarType Type = ScalarType::Float64;
  std::int64_t Dimensions[3] = { 0, 0, 0 };
  std::int64_t Stride[3] = { 0, 0, 0 };
  std::int64_t First[3] = { 0, 0, 0 };
  /** Dimensions of the whole volume if the view shows a region, otherwise 0. */
  std::int64_t Whole[3] = { 0, 0, 0 };
  /** Value that replaces a sample that is NaN or infinite (Documentation/method.md). */
  double BorderValue = 0.0;

  /**
   * Last() returns the largest index of a resident sample along an axis, Border() the largest index
   * of the whole volume.
   */
  std::int64_t Last(int axis) const noexcept
  {
    return this->First[axis] + this->Dimensions[axis] - 1;
  }
  std::int64_t Border(int axis) const noexcept
  {
    return this->Whole[axis] > 0 ? this->Whole[axis] - 1 : this->Last(axis);
  }
};

} // namespace VolumeHaptics

#endif

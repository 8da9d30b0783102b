// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The scalar types and the estimators, to go through them.
 */
#ifndef AllScalarTypes_h
#define AllScalarTypes_h

#include "Core/Field/FieldSampler.h"

namespace coretest
{
using namespace VolumeHaptics;

inline constexpr ScalarType AllScalarTypes[] = { ScalarType::Int8, ScalarType::UInt8,
  ScalarType::Int16, ScalarType::UInt16, ScalarType::Int32, ScalarType::UInt32, ScalarType::Int64,
  ScalarType::UInt64, ScalarType::Float32, ScalarType::Float64 };

inline constexpr GradientEstimator AllEstimators[] = { GradientEstimator::CentralDifference,
  GradientEstimator::Gaussian, GradientEstimator::CubicBSpline };

/// Calls f with a value of the C++ type that a scalar type stands for.
template <typename F>
auto WithType(ScalarType type, F&& f)
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
} // namespace coretest

#endif

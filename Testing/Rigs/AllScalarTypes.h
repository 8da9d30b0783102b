// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Lists the scalar types and the gradient estimators for parameterized tests. */
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
} // namespace coretest

#endif

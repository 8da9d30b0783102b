// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/VectorSampler.h"

#include "Core/Field/WholeData.h"

namespace VolumeHaptics
{

VectorFunctions SelectBaselineVectorFunctions(ScalarType, int components);
#ifdef VOLUME_HAPTICS_HAS_AVX2
VectorFunctions SelectAVX2VectorFunctions(ScalarType, int components);
#endif

VectorSampler::VectorSampler(const VectorView& view, InstructionSet instructions)
  : Components(view.Components)
{
  this->View.View.Volume = view.Volume;
  this->View.View.Volume.Data = WholeData(view.Volume);
  this->View.ComponentStride = view.Stride;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->View.View.First[axis] = static_cast<double>(view.Volume.First[axis]);
    this->View.View.Last[axis] = static_cast<double>(view.Volume.Last(axis));
    this->Border[axis] = static_cast<double>(view.Volume.Border(axis));
  }
#ifdef VOLUME_HAPTICS_HAS_AVX2
  if (instructions == InstructionSet::AVX2)
  {
    this->Functions = SelectAVX2VectorFunctions(view.Volume.Type, view.Components);
    return;
  }
#else
  static_cast<void>(instructions);
#endif
  this->Functions = SelectBaselineVectorFunctions(view.Volume.Type, view.Components);
}

double VectorSampler::DistanceToBorder(const Vector3& index) const noexcept
{
  const double* const last = this->Border;
  const double x = std::min(index.X, last[0] - index.X);
  const double y = std::min(index.Y, last[1] - index.Y);
  const double z = std::min(index.Z, last[2] - index.Z);
  const double distance = std::min(std::min(x, y), z);
  return IsFinite(index) ? distance : -1.0;
}

} // namespace VolumeHaptics

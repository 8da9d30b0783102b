// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/VectorField.h"

namespace VolumeHaptics
{
namespace
{

constexpr Matrix3 ZeroMatrix = { { {}, {}, {} } };

double SumOfSquares(const Matrix3& m) noexcept
{
  return Dot(m.Row[0], m.Row[0]) + Dot(m.Row[1], m.Row[1]) + Dot(m.Row[2], m.Row[2]);
}

/** Returns the matrix whose columns are the unit vectors along the index axes. */
Matrix3 DirectionOf(const Affine3& indexToWorld) noexcept
{
  const Matrix3 columns = Transpose(indexToWorld.Linear);
  const auto unit = [](const Vector3& v) { return (1.0 / Norm(v)) * v; };
  return Matrix3::FromColumns(unit(columns.Row[0]), unit(columns.Row[1]), unit(columns.Row[2]));
}

} // namespace

VectorField::VectorField(
  const VectorView& view, const Affine3& indexToWorld, VectorAxes axes, InstructionSet instructions)
  : Sampler(view, instructions)
  , IsOfImage(axes == VectorAxes::Image)
  , ToWorld(this->IsOfImage ? DirectionOf(indexToWorld) : Matrix3{})
  , WorldToIndex(Inverse(indexToWorld.Linear))
  , SquaredVoxel(SumOfSquares(indexToWorld.Linear))
{
}

bool VectorField::Read(const Vector3& index, Vector3& vector) const noexcept
{
  vector = {};
  VectorSample sample;
  if (!this->HasVectors() || !this->Sampler.IsInside(index) ||
    !this->Sampler.SampleValue(index, sample))
  {
    return false;
  }
  vector = { sample.Value[0], sample.Value[1], sample.Value[2] };
  if (this->IsOfImage)
  {
    vector = this->ToWorld * vector;
  }
  return true;
}

bool VectorField::Read(const Vector3& index, Vector3& vector, Matrix3& jacobian) const noexcept
{
  vector = {};
  jacobian = ZeroMatrix;
  VectorSample sample;
  if (!this->HasVectors() || !this->Sampler.IsInside(index) || !this->Sampler.Sample(index, sample))
  {
    return false;
  }
  vector = { sample.Value[0], sample.Value[1], sample.Value[2] };
  const Matrix3 slopes = { { sample.Gradient[0], sample.Gradient[1], sample.Gradient[2] } };
  jacobian = slopes * this->WorldToIndex;
  if (this->IsOfImage)
  {
    vector = this->ToWorld * vector;
    jacobian = this->ToWorld * jacobian;
  }
  return true;
}

bool VectorField::ReadTensor(const Vector3& index, Matrix3& tensor) const noexcept
{
  tensor = ZeroMatrix;
  VectorSample sample;
  if (!this->HasTensors() || !this->Sampler.IsInside(index) ||
    !this->Sampler.SampleValue(index, sample))
  {
    return false;
  }
  const double* const v = sample.Value;
  Matrix3 given = { { { v[0], v[3], v[5] }, { v[3], v[1], v[4] }, { v[5], v[4], v[2] } } };
  if (this->Sampler.GetComponents() == VectorView::MostComponents)
  {
    const Matrix3 whole = { { { v[0], v[1], v[2] }, { v[3], v[4], v[5] }, { v[6], v[7], v[8] } } };
    const Matrix3 turned = Transpose(whole);
    given = { { 0.5 * (whole.Row[0] + turned.Row[0]), 0.5 * (whole.Row[1] + turned.Row[1]),
      0.5 * (whole.Row[2] + turned.Row[2]) } };
  }
  tensor = this->ToWorld * (given * Transpose(this->ToWorld));
  return true;
}

} // namespace VolumeHaptics

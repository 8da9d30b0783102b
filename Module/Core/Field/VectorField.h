// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the vectors and tensors of a volume in world axes.
 *
 *   VectorField field(view, indexToWorld);
 *   Vector3 v;
 *   Matrix3 jacobian;
 *   field.Read(index, v, jacobian);
 *
 * Results are along the world's axes, and derivatives are per world unit. The components of the
 * array are along the world's axes, as in ParaView, or along the image's (VectorAxes::Image). In
 * the second case, a vector is multiplied by the image's direction matrix D, and a tensor T becomes
 * D T D^T.
 */
#ifndef VectorField_h
#define VectorField_h

#include "Core/Field/VectorSampler.h"

namespace VolumeHaptics
{

/** The axes to which the components of an array refer. */
enum class VectorAxes : std::uint8_t
{
  World,
  Image
};

/** Does not own the samples. */
class VectorField
{
public:
  VectorField() = default;
  VectorField(const VectorView& view, const Affine3& indexToWorld,
    VectorAxes axes = VectorAxes::World, InstructionSet instructions = DetectInstructionSet());

  /** Return whether the field has vectors (3 components), or tensors (6 or 9). */
  bool HasVectors() const noexcept { return this->Sampler.GetComponents() == 3; }
  bool HasTensors() const noexcept { return this->Sampler.IsValid() && !this->HasVectors(); }

  ///@{
  /**
   * Reads the vector at a continuous index, and its Jacobian, whose row c is the gradient of
   * component c. Returns false and sets both to 0 outside the volume, where samples are not finite,
   * and if the field has no vectors.
   */
  bool Read(const Vector3& index, Vector3& vector) const noexcept;
  bool Read(const Vector3& index, Vector3& vector, Matrix3& jacobian) const noexcept;
  ///@}

  /**
   * Reads the tensor at a continuous index, from 6 components (XX YY ZZ XY YZ XZ, as in VTK), or
   * from the symmetric part of 9 components (row by row). Returns false and sets the tensor to 0 in
   * the same cases as Read().
   */
  bool ReadTensor(const Vector3& index, Matrix3& tensor) const noexcept;

  const VectorSampler& GetSampler() const noexcept { return this->Sampler; }

  /**
   * Returns the sum of the squares of a voxel's edges (world units). It limits the squared length
   * of a displacement by one voxel.
   */
  double GetSquaredVoxel() const noexcept { return this->SquaredVoxel; }

private:
  VectorSampler Sampler;
  bool IsOfImage = false; ///< whether the components are along the axes of the image
  Matrix3 ToWorld;        ///< maps components to the world's axes
  Matrix3 WorldToIndex;   ///< maps displacements in the world to displacements in index steps
  double SquaredVoxel = 0.0;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A mode: a way to feel the vectors or tensors of a volume.
 *
 * With v the vector, J its Jacobian, omega its curl, and l_1 >= l_2 >= l_3 the eigenvalues of a
 * tensor, negative ones as 0:
 *
 * | kind          | feel                                        | first strength | second     |
 * | ------------- | ------------------------------------------- | -------------- | ---------- |
 * | VectorFollow  | free along v, held across it; pushed        | hold, of |v|   | push, same |
 * | VectorFront   | a wall across v, free to where v points     | wall, of |v|   |            |
 * | TwoSidedFront | held along v, free across it                | hold, of |v|   |            |
 * | VortexTube    | held in around a vortex; and along its axis | tube, of omega | axis, same |
 * | Shear         | free in the direction that stretches most   | hold, of rate  |            |
 * | TensorFollow  | free along fibres; or within sheets         | fibre, of c_l  | sheet, c_p |
 *
 * with c_l = (l_1 - l_2)/l_1 and c_p = (l_2 - l_3)/l_1. Strengths are in newtons.
 */
#ifndef BakedMode_h
#define BakedMode_h

#include "Core/Field/VectorField.h"
#include "Core/Math/PiecewiseTable.h"

#include <memory>

namespace VolumeHaptics
{

enum class ModeKind : std::uint8_t
{
  VectorFollow,
  VectorFront,
  TwoSidedFront,
  VortexTube,
  Shear,
  TensorFollow
};

/** Everything that a mode is baked from. */
struct ModeDescription
{
  ModeKind Kind = ModeKind::VectorFollow;
  VectorView View;
  std::shared_ptr<const void> Samples; ///< keeps View.Volume.Data alive
  VectorAxes Axes = VectorAxes::World;
  Polyline First = ConstantPolyline(2.0);  ///< N
  Polyline Second = ConstantPolyline(0.0); ///< N
};

/** A mode as a tick reads it. Immutable. */
struct BakedMode
{
  BakedMode(const ModeDescription& description, const Affine3& indexToWorld)
    : Kind(description.Kind)
    , Field(description.View, indexToWorld, description.Axes)
    , Strengths({ description.First, description.Second })
    , Samples(description.Samples)
  {
  }

  /** Whether the array has the components that the mode is about. */
  bool IsValid() const noexcept
  {
    return this->Kind == ModeKind::TensorFollow ? this->Field.HasTensors()
                                                : this->Field.HasVectors();
  }

  const ModeKind Kind;
  const VectorField Field;
  const PiecewiseTable<2> Strengths;
  const std::shared_ptr<const void> Samples; ///< keeps the memory of Field alive
};

} // namespace VolumeHaptics

#endif

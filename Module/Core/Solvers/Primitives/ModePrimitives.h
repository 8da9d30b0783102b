// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The modes of a volume as a field of primitives, which a proxy follows (PrimitiveFollower.h).
 *
 * | mode          | primitives, anchored where they are read     |
 * | ------------- | -------------------------------------------- |
 * | VectorFollow  | LINE v, FORCE v                              |
 * | VectorFront   | PLANE v                                      |
 * | TwoSidedFront | PLANE v, PLANE -v                            |
 * | VortexTube    | PLANE n, LINE omega; n = omega x v; the core |
 * | Shear         | LINE along the first eigenvector of J + J^T  |
 * | TensorFollow  | LINE e_1, PLANE e_3, PLANE -e_3              |
 * | Ridge         | LINE e_1 of the Hessian, through the ridge   |
 * | Guide         | LINE through the nearest place; PLANE at ends|
 * | GuideSurface  | PLANE n, PLANE -n through the nearest place  |
 * | Surface       | PLANE, LINE, POINT of MaterialPrimitives.h   |
 *
 * ## The core of a vortex
 *
 * v has no direction on the core line, and n turns over there. With J' and v' the parts of Jacobian
 * and vector across omega, the core is at -J'^-1 v' from a place nearby (Newton's step). Within
 * CoreReach of it, a LINE through it along omega stands in for the plane, so that the hand comes to
 * rest on the core itself.
 *
 * ## Ridges
 *
 * H is the Hessian of the scalars, of differences of gradients half a voxel to either side, and g
 * their gradient. A ridge goes along e_1, whose eigenvalue has the smallest magnitude; across it,
 * the scalars fall to all sides (rise, if it is dark), with eigenvalues h_2 and h_3. The ridge is
 * at -(e_2 (e_2.g)/h_2 + e_3 (e_3.g)/h_3) from the place. Its hold fades between once and twice
 * SnapDistance.
 *
 * ## All modes
 *
 * Strengths fade to 0 over FadeDistance at the border of the volume, so that nothing pops there.
 * Where there is no vector, no direction, or a sample that is not finite, nothing is felt. The sign
 * of an eigenvector does not matter: tensors are interpolated, never their eigenvectors.
 */
#ifndef ModePrimitives_h
#define ModePrimitives_h

#include "Core/Model/BakedMode.h"
#include "Core/Model/LabelMemory.h"
#include "Core/Solvers/Primitives/PrimitiveFollower.h"

namespace VolumeHaptics
{
class HapticModel;

/** A volume's modes, in the order in which their primitives are added; borrows the modes. */
class ModeField
{
public:
  static constexpr int Most = PrimitiveSet::Most;
  /** Distance (voxels) from the border of the volume over which strengths fade. */
  static constexpr double FadeDistance = 2.0;
  /** Distance (voxels) from the core of a vortex within which a line stands in for the plane. */
  static constexpr double CoreReach = 0.1;
  /** Distance (voxels) up to which the core is searched. */
  static constexpr double CoreSight = 4.0;

  /**
   * Makes an empty field for a device that is placed in the world by a similarity, world units per
   * metre. The field is without ridges and surfaces, which need the scalars of a model.
   */
  ModeField(const Affine3& indexToWorld, const Affine3& deviceToWorld) noexcept;
  /**
   * Makes a field of the modes of a model, in their order. Friction and drag of a surface depend on
   * a spring of stiffness k to a tip (m). Borrows the model and the memory.
   */
  ModeField(const HapticModel& model, double k, const Vector3& tip, LabelMemory& memory) noexcept;

  /**
   * Adds a mode. Returns false if there are too many primitives or the mode is not valid; the mode
   * is then not felt. A mode that is not active always fits.
   */
  bool Add(const BakedMode& mode) noexcept;

  /** Returns the field of all modes, which borrows this object. */
  PrimitiveField GetField() const noexcept { return { &ModeField::Collect, this }; }

  int GetCount() const noexcept { return this->Count; }
  /** Adds the primitives of one mode at a place (m); none if the mode is not felt. */
  void Read(int mode, const Vector3& place, PrimitiveSet& set) const noexcept;
  /** Returns the force of one mode (N, on the hand), given the forces of all primitives. */
  Vector3 ForceOf(int mode, const PrimitiveForces& forces) const noexcept;

private:
  friend class ModeReader;

  static void Collect(const void* context, const Vector3& place, PrimitiveSet& set) noexcept;

  const BakedMode* Modes[Most] = {};
  int First[Most + 1] = {}; ///< the number of the first primitive of a mode
  int Count = 0;
  Affine3 DeviceToIndex;
  Affine3 DeviceToWorld;
  Affine3 WorldToDevice;
  Matrix3 Turn; ///< turns directions from the world to the device
  ///@{
  /** Needed for ridges and surfaces; null without a model. */
  const HapticModel* Model = nullptr;
  LabelMemory* Memory = nullptr;
  double Stiffness = 0.0;
  Vector3 Tip;
  ///@}
};

} // namespace VolumeHaptics

#endif

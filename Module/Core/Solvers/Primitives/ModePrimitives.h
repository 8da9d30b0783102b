// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Computes the primitives of a volume's modes at a place. A proxy follows them
 * (PrimitiveFollower.h).
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
 * v has no direction on the core line, and n reverses there. Let J' and v' be the components of
 * Jacobian and vector perpendicular to omega. Then Newton's step from a place nearby to the core is
 * -J'^-1 v'. Within CoreReach of the core, a LINE through it along omega replaces the plane, so
 * that the hand comes to rest on the core itself.
 *
 * ## Ridges
 *
 * H is the Hessian of the scalars, computed from gradients half a voxel to both sides, and g is
 * their gradient. A ridge is along e_1, whose eigenvalue has the smallest magnitude. Perpendicular
 * to it, the scalars fall to all sides (or rise, if the ridge is dark), with eigenvalues h_2 and
 * h_3. The displacement from the place to the ridge is -(e_2 (e_2.g)/h_2 + e_3 (e_3.g)/h_3). The
 * hold fades between once and twice SnapDistance.
 *
 * ## All modes
 *
 * Strengths fade to 0 over FadeDistance at the border of the volume, so that no force jumps there.
 * Nothing is felt where there is no vector, no direction, or a sample that is not finite. The sign
 * of an eigenvector has no effect, because tensors are interpolated, and never their eigenvectors.
 */
#ifndef ModePrimitives_h
#define ModePrimitives_h

#include "Core/Model/BakedMode.h"
#include "Core/Model/LabelMemory.h"
#include "Core/Solvers/Primitives/PrimitiveFollower.h"

namespace VolumeHaptics
{
class HapticModel;

/**
 * The modes of a volume, in the order in which their primitives are added. The modes must outlive
 * this object.
 */
class ModeField
{
public:
  static constexpr int Most = PrimitiveSet::Most;
  /** Distance (voxels) from the volume's border over which strengths fade. */
  static constexpr double FadeDistance = 2.0;
  /** Distance (voxels) from the core of a vortex within which a line replaces the plane. */
  static constexpr double CoreReach = 0.1;
  /** Distance (voxels) within which the core is searched. */
  static constexpr double CoreSight = 4.0;

  /**
   * Makes an empty field. deviceToWorld must be a similarity (rotation, translation and uniform
   * scale); its scale is the number of world units per metre. This field has no ridges and
   * surfaces, because they need the scalars of a model.
   */
  ModeField(const Affine3& indexToWorld, const Affine3& deviceToWorld) noexcept;
  /**
   * Makes a field of a model's modes, in their order. Friction and drag of a surface are computed
   * for a spring of stiffness k (N/m) to a tip (m). Model and memory must outlive this object.
   */
  ModeField(const HapticModel& model, double k, const Vector3& tip, LabelMemory& memory) noexcept;

  /**
   * Adds a mode. Returns false if an active mode is not valid, needs scalars that this field lacks,
   * or would exceed the number of primitives; the mode then keeps its number, but is not felt. Also
   * returns false, and adds nothing, if there are already `Most` modes. Inactive modes count, too,
   * but are not felt.
   */
  bool Add(const BakedMode& mode) noexcept;

  /** Returns the field of all modes. This object must outlive it. */
  PrimitiveField GetField() const noexcept { return { &ModeField::Collect, this }; }

  int GetCount() const noexcept { return this->Count; }
  /** Adds the primitives of one mode at a place (m). Adds none if the mode is not felt. */
  void Read(int mode, const Vector3& place, PrimitiveSet& set) const noexcept;
  /**
   * Returns the force (N, on the hand) of one mode. `forces` contains the forces of all primitives.
   */
  Vector3 ForceOf(int mode, const PrimitiveForces& forces) const noexcept;

private:
  friend class ModeReader;

  static void Collect(const void* context, const Vector3& place, PrimitiveSet& set) noexcept;

  const BakedMode* Modes[Most] = {};
  int First[Most + 1] = {}; ///< number of the first primitive of each mode
  int Count = 0;
  Affine3 DeviceToIndex;
  Affine3 DeviceToWorld;
  Affine3 WorldToDevice;
  Matrix3 Turn; ///< rotates directions from the world to the device
  ///@{
  /** Model of ridges and surfaces; null if there is no model. */
  const HapticModel* Model = nullptr;
  LabelMemory* Memory = nullptr;
  double Stiffness = 0.0;
  Vector3 Tip;
  ///@}
};

} // namespace VolumeHaptics

#endif

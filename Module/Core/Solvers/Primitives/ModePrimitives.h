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
 * | VortexTube    | PLANE n, LINE omega; n = omega x v           |
 * | Shear         | LINE along the first eigenvector of J + J^T  |
 * | TensorFollow  | LINE e_1, PLANE e_3, PLANE -e_3              |
 *
 * Strengths fade to 0 over FadeDistance at the border of the volume, so that nothing pops there.
 * Where there is no vector, no direction, or a sample that is not finite, nothing is felt. The
 * sign of an eigenvector matters to none of these: tensors are interpolated, and never their
 * eigenvectors.
 */
#ifndef ModePrimitives_h
#define ModePrimitives_h

#include "Core/Model/BakedMode.h"
#include "Core/Solvers/Primitives/PrimitiveFollower.h"

namespace VolumeHaptics
{

/** The number of primitives that a mode adds, wherever it is read. */
int CountPrimitives(ModeKind kind) noexcept;

/** Modes in the order in which their primitives are added; borrows them. */
class ModeField
{
public:
  static constexpr int Most = PrimitiveSet::Most;
  /** Voxels from the border of the volume. */
  static constexpr double FadeDistance = 2.0;

  /** For a device that is placed in the world: a similarity, world units per metre. */
  ModeField(const Affine3& indexToWorld, const Affine3& deviceToWorld) noexcept;

  /** False, without any effect, if its primitives are too many or the mode is not valid. */
  bool Add(const BakedMode& mode) noexcept;

  /** Borrows this. */
  PrimitiveField GetField() const noexcept { return { &ModeField::Find, this }; }

  int GetCount() const noexcept { return this->Count; }
  /** The force of one mode (N, on the hand), of those of all primitives. */
  Vector3 ForceOf(int mode, const PrimitiveForces& forces) const noexcept;

private:
  static void Find(const void* context, const Vector3& place, PrimitiveSet& set) noexcept;

  const BakedMode* Modes[Most] = {};
  int Count = 0;
  int Primitives = 0;
  Affine3 DeviceToIndex;
  Matrix3 WorldToDevice; ///< of directions
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The interface of a method for ticks, regions and the safety stage. Methods/Methods.cxx has one
 * row a method.
 */
#ifndef Method_h
#define Method_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{
class HapticModel;
struct LocalSurfaceResult;
struct ServoState;
struct TickMemory;
struct TickRecord;

/**
 * Spare voxels: for the taps of a kernel beyond its radius, for motions off the line between tip
 * and proxy, and one voxel more.
 */
constexpr double ResidencySpare = 3.0;

/**
 * The samples that a tick can read: the samples between two corners (index steps), and a margin.
 */
struct ReadBox
{
  Vector3 Low;
  Vector3 High;
  Vector3 Margin; ///< margin along each axis, on either side

  void Include(const Vector3& index) noexcept
  {
    this->Low = Least(this->Low, index);
    this->High = Most(this->High, index);
  }
};

/** Further input of a method, beside model, state and record. */
struct MethodInput
{
  const LocalSurfaceResult& Result; ///< result of the slow loop
  TickMemory* Memory;               ///< saves time; may be null
};

/** A method, or one of the solvers of PROXY. All functions run in the servo's tick. */
struct Method
{
  /** Computes the force at record.Tip; writes all of the record that Tick() has not written. */
  void (*Step)(const HapticModel&, ServoState&, TickRecord&, const MethodInput&) noexcept;
  /** Returns the reach (index steps along each axis) of the samples read around tip and proxy. */
  Vector3 (*Reach)(const HapticModel&) noexcept;
  /**
   * Adds to a box the samples that a tick reads beside the path between tip and proxy; null: none.
   */
  void (*Include)(const HapticModel&, const ServoState&, ReadBox&) noexcept = nullptr;
  /**
   * Returns the dissipative part (N) of a tick's force, against the hand's motion; null: there is
   * none. The state is the one before the tick.
   */
  Vector3 (*Drag)(const HapticModel&, const ServoState&, const TickRecord&) noexcept = nullptr;
  bool HasProxy = true; ///< if false, samples are read at the tip alone
};

///@{
/**
 * Return reaches that several methods have: ResidencySpare plus the radius of the kernel; and a
 * distance in metres, but at least the samples around a place.
 */
Vector3 GetKernelReach(const HapticModel& model) noexcept;
Vector3 FindValueReach(const HapticModel& model, double aside, const Vector3& around) noexcept;
///@}
/**
 * Returns the distance (m) from a proxy at which materials are read; at a wall between labels, at
 * least a voxel of the label image.
 */
double FindMaterialReach(const HapticModel& model) noexcept;

} // namespace VolumeHaptics

#endif

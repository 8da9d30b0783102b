// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The interface through which ticks, regions and the safety stage use a method. Methods/Methods.cxx
 * lists the methods, one per row.
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
 * Number of voxels added to each reach: for the taps of a kernel beyond its radius, for motions off
 * the line between tip and proxy, and one spare voxel.
 */
constexpr double ResidencySpare = 3.0;

/** The box of the samples that a tick may read: from Low to High (index), extended by a margin. */
struct ReadBox
{
  Vector3 Low;
  Vector3 High;
  Vector3 Margin; ///< additional width on both sides along each axis

  void Include(const Vector3& index) noexcept
  {
    this->Low = Least(this->Low, index);
    this->High = Most(this->High, index);
  }
};

/** Input of a method, besides model, state and record. */
struct MethodInput
{
  const LocalSurfaceResult& Result; ///< result of the slow loop
  TickMemory* Memory;               ///< samples of the last tick, which save time; may be null
};

/** A method, or a solver of the method Proxy. All functions run in the servo's tick. */
struct Method
{
  /**
   * Computes the force at record.Tip, and writes all members of the record that Tick() has not
   * written.
   */
  void (*Step)(const HapticModel&, ServoState&, TickRecord&, const MethodInput&) noexcept;
  /** Returns how far (index steps along each axis) around tip and proxy a tick reads samples. */
  Vector3 (*Reach)(const HapticModel&) noexcept;
  /**
   * Extends a box by the samples that a tick reads away from the path between tip and proxy. Null
   * if there are none.
   */
  void (*Include)(const HapticModel&, const ServoState&, ReadBox&) noexcept = nullptr;
  /**
   * Returns the dissipative part (N) of a tick's force, which opposes the hand's motion. Null if
   * there is none. The state is the one before the tick.
   */
  Vector3 (*Drag)(const HapticModel&, const ServoState&, const TickRecord&) noexcept = nullptr;
  /** Whether the method has a proxy. If not, it reads samples only at the tip. */
  bool HasProxy = true;
};

///@{
/**
 * Return reaches that several methods use. GetKernelReach() returns the kernel's radius plus
 * ResidencySpare. FindValueReach() returns the reach of values at a distance `aside` (m), but at
 * least `around`.
 */
Vector3 GetKernelReach(const HapticModel& model) noexcept;
Vector3 FindValueReach(const HapticModel& model, double aside, const Vector3& around) noexcept;
///@}
/**
 * Returns the largest distance (m) from a proxy at which materials are read: KernelLength or, if
 * labels are felt, the larger of KernelLength and LabelReach.
 */
double FindMaterialReach(const HapticModel& model) noexcept;

} // namespace VolumeHaptics

#endif

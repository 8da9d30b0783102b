// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of a tool with a shape from tick to tick. See Core/Tools/PointShell/ShellCoupling.h.
 */
#ifndef ShellState_h
#define ShellState_h

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"

#include <cstdint>

namespace VolumeHaptics
{

/** The pose of a tool: where its frame is in the device's space. */
struct ShellPose
{
  Vector3 Position;       ///< origin of the frame (m)
  Quaternion Orientation; ///< a unit quaternion
};

/**
 * Sums over all contacts at a pose. Its six directions are the translations along the device's
 * axes, followed by the rotations about them.
 */
struct ShellSum
{
  double Energy = 0.0;       ///< energy of all contacts (J)
  double Gradient[6] = {};   ///< the gradient of the energy, in N and N m
  double Curvature[21] = {}; ///< second derivatives of the energy: the lower triangle, row by row
  std::uint32_t Contacts = 0;
  std::uint32_t Yielding = 0; ///< number of contacts that have reached the limit of their material
};

/** The state from which the next tick starts, together with ShellMemory. */
struct ShellState
{
  bool Enabled = false;   ///< if false, the next tick puts the tool into the hand, without a force
  bool IsCarried = false; ///< whether the model has changed, so that Sum does not belong to Tool
  ShellPose Tool;
  ShellPose Hand;      ///< pose of the hand in the last tick
  double Budget = 0.0; ///< energy budget S (J)
  ShellSum Sum;        ///< sum over the contacts at Tool
};

} // namespace VolumeHaptics

#endif

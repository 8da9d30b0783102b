// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The results of one tick, in device space (metres and newtons).
 */
#ifndef TickRecord_h
#define TickRecord_h

#include "Core/Carving/TissueRemoval.h"
#include "Core/Law/MaterialPoint.h"
#include "Core/Math/Quaternion.h"

#include <array>
#include <cstdint>

namespace VolumeHaptics
{

enum class ContactState : std::uint8_t
{
  Free = 0,       ///< no surface holds the proxy
  Sticking = 1,   ///< a surface and friction hold the proxy
  Sliding = 2,    ///< the proxy slides over a surface
  Penetrating = 3 ///< the proxy is pushed through a surface
};

/** The record of one tick, including the material that it used. */
struct TickRecord : MaterialPoint
{
  double DataTime = 0.0; ///< data time of the tick if the volume moves
  Vector3 Tip;
  Vector3 Proxy;  ///< position of the proxy after the tick
  Vector3 Force;  ///< force on the hand (N)
  Vector3 Torque; ///< torque on the hand about the tip (N m), for a tool with a shape
  /// The rotation from the frame of a tool with a shape to the device's axes. The frame's origin is
  /// the proxy. NoOrientation for any other tool.
  Quaternion ToolOrientation = NoOrientation;
  /// The rotation from the frame of the hand that has the tool to the device's axes. NoOrientation
  /// if the tool has no shape.
  Quaternion HandOrientation = NoOrientation;
  double NormalForce = 0.0;   ///< magnitude in N before the drag step
  double FrictionForce = 0.0; ///< magnitude in N before the drag step
  /// Stiffness times the distance by which the drag step moved the proxy back (N).
  double DragForce = 0.0;
  ///@{
  /** Members for ProxyRelease.h. The solver Precise sets them. */
  bool MayLeap = false; ///< whether the force of a leap in this tick is spread over time
  Vector3 ForceBefore;  ///< the law's force in the last tick (N)
  Vector3 Leap;         ///< change of Force by a leap of the proxy (N)
  /** Stiffness (N/m) of the stiffer of the springs before and after the leap. */
  double LeapStiffness = 0.0;
  ///@}
  double Depth = 0.0;      ///< depth of a needle's insertion (m); 0 if it is not inserted
  double ShaftForce = 0.0; ///< largest force (N) that the needle's shaft can carry
  /** Volume (mm^3 in the hand's space) that a burr removed in this tick. */
  double RemovedVolume = 0.0;
  /**
   * Numbers that the tool defines, and that BakedTool::GetColumns() reads for its columns. 0
   * without a tool.
   */
  std::array<double, 4> ToolNumbers{};
  double Value = 0.0; ///< V at the proxy; set only if tissue of the volume may be removed
  ContactState Contact = ContactState::Free;
  /**
   * Stiffness (N/m) with which Force grows if the hand presses on, if it is more than Stiffness,
   * which happens if the spring has slack (PassiveSpring.h). Not recorded.
   */
  double Slope = 0.0;
  /// Work (J) of a moving surface in this tick on the spring that pulls the hand.
  double WallWork = 0.0;
  /** Whether the solver Precise used up its budget, so that the force belongs to an earlier tip. */
  bool IsUnfinished = false;
  bool IsRenewed = false; ///< whether the method LocalSurface received a surface from the slow loop
  ///@{
  /**
   * Whether the tick served a request to the removal, and therefore computed no force. Request is
   * the request that the tick began, or None.
   */
  bool IsServed = false;
  RemovalRequest Request = RemovalRequest::None;
  ///@}
};

} // namespace VolumeHaptics

#endif

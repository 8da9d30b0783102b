// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The results of one tick. In device space: metres, newtons.
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

/** The record of one tick, with the material that it used. */
struct TickRecord : MaterialPoint
{
  double DataTime = 0.0; ///< data time, if the volume moves
  Vector3 Tip;
  Vector3 Proxy;  ///< the proxy after the tick
  Vector3 Force;  ///< N, on the hand
  Vector3 Torque; ///< N m, on the hand about the tip; for a tool with a shape
  /// The rotation of a tool with a shape, whose origin is the proxy, to the device's axes; else
  /// NoOrientation.
  Quaternion ToolOrientation = NoOrientation;
  /// The rotation of the hand that holds the tool, to the device's axes; else NoOrientation.
  Quaternion HandOrientation = NoOrientation;
  double NormalForce = 0.0;   ///< N, magnitude before the drag step
  double FrictionForce = 0.0; ///< N, magnitude before the drag step
  /// N, stiffness times the distance by which the drag step moved the proxy back
  double DragForce = 0.0;
  ///@{
  /** PRECISE sets these members for ProxyRelease.h. */
  bool MayLeap = false;       ///< whether leaps in this tick take time
  Vector3 ForceBefore;        ///< N, the law's force in the last tick
  Vector3 Leap;               ///< N, the change of Force by a leap of the proxy
  double LeapStiffness = 0.0; ///< N/m, the stiffer of the springs before and after the leap
  ///@}
  double Depth = 0.0;         ///< m, insertion of a needle; 0: not inserted
  double ShaftForce = 0.0;    ///< N, the most that the tissue along the needle's shaft holds
  double RemovedVolume = 0.0; ///< mm^3 in the hand's space that a burr removed in this tick
  /** The tool's own numbers, which its columns read (BakedTool::GetColumns); else 0. */
  std::array<double, 4> ToolNumbers{};
  double Value = 0.0; ///< V at the proxy, only if the volume's tissue may be removed
  ContactState Contact = ContactState::Free;
  /// J, in this tick: the work of a moving surface on the spring that pulls the hand
  double WallWork = 0.0;
  bool IsUnfinished = false; ///< PRECISE spent its budget: the force belongs to an earlier tip
  bool IsRenewed = false;    ///< whether LOCAL_SURFACE got a surface from the slow loop
  ///@{
  /**
   * Whether the tick carried out a request to the removal instead of feeling; and the request that
   * it began.
   */
  bool IsServed = false;
  RemovalRequest Request = RemovalRequest::None;
  ///@}
};

} // namespace VolumeHaptics

#endif

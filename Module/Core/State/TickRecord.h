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

#include <cstdint>

namespace VolumeHaptics
{

enum class ContactState : std::uint8_t
{
  Free = 0,       ///< no surface holds the proxy
  Sticking = 1,   ///< a surface holds it, friction too
  Sliding = 2,    ///< it slides over a surface
  Penetrating = 3 ///< it is pushed through a surface
};

/** The record of one tick, with the material that it used. */
struct TickRecord : MaterialPoint
{
  double DataTime = 0.0; ///< of a volume that moves
  Vector3 Tip;
  Vector3 Proxy;  ///< after the tick
  Vector3 Force;  ///< N, on the hand
  Vector3 Torque; ///< N m, on the hand about the tip; of a tool with a shape
  /// of a tool with a shape, whose origin is the proxy: to the device's axes; else NoOrientation
  Quaternion ToolOrientation = NoOrientation;
  /// of the hand that holds it, to the device's axes; else NoOrientation
  Quaternion HandOrientation = NoOrientation;
  double NormalForce = 0.0;   ///< N, magnitude before the drag step
  double FrictionForce = 0.0; ///< N, magnitude before the drag step
  /// N, stiffness times the distance by which the drag step moved the proxy back
  double DragForce = 0.0;
  ///@{
  /** Of PRECISE, for ProxyRelease.h. */
  bool MayLeap = false;       ///< whether it is a tick whose leaps take time
  Vector3 ForceBefore;        ///< N, the force of the law in the last tick
  Vector3 Leap;               ///< N, the change of Force by a leap of the proxy
  double LeapStiffness = 0.0; ///< N/m, the stiffer one of the springs before and after it
  ///@}
  double Depth = 0.0;         ///< m, of a needle that is inserted; 0: it is not
  double ShaftForce = 0.0;    ///< N, the most that the tissue along a needle's shaft holds
  double RemovedVolume = 0.0; ///< mm^3 of the hand's space, by a burr in this tick
  double Value = 0.0;         ///< V at the proxy, only of a volume whose tissue may be removed
  ContactState Contact = ContactState::Free;
  /// J, in this tick: of a surface that moves, on the spring that pulls the hand
  double WallWork = 0.0;
  bool IsUnfinished = false; ///< PRECISE spent its budget: the force is that of an earlier tip
  bool IsRenewed = false;    ///< LOCAL_SURFACE got a surface from the slow loop
  ///@{
  /** A request to the removal was carried out, instead of feeling; and the one that began then. */
  bool IsServed = false;
  RemovalRequest Request = RemovalRequest::None;
  ///@}
};

} // namespace VolumeHaptics

#endif

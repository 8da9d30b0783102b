// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Describes the status of a device in a text, with the cure after a fault.
 */
#ifndef DeviceStatus_h
#define DeviceStatus_h

#include "Core/Safety/DeviceBackend.h"
#include "Core/Servo/ServoLoop.h"

#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/** Facts about a device and its servo, from which the status text is made. */
struct DeviceStatus
{
  bool IsOpen = false;
  std::string Id;            ///< id that was passed to Open
  bool Vibrates = false;     ///< whether the device renders forces as vibration: see DeviceLimits
  DeviceCondition Condition; ///< condition that the open device reported last

  bool IsArmOrdered = false;      ///< see ServoLoop::IsArmOrdered
  bool NeedsConfirmation = false; ///< whether the user must confirm the axes' signs before anything
                                  ///< is felt
  /** Work that keeps the force off, such as "a surface is meshed"; empty if nothing does. */
  std::string LongWork;
  /** A sentence on background work that blocks nothing; empty if there is none. */
  std::string BackgroundWork;

  std::uint32_t Orders = 0; ///< see ServoLoop::GetOrders
  /**
   * The latest state. It is null while the servo is stopped; the members below are then invalid.
   */
  const ServoSnapshot* State = nullptr;
  RealTimeGrant RealTimePriority = RealTimeGrant::Unknown;
  ServoLoop::Privilege LockedMemory = ServoLoop::Privilege::Unknown;
  ServoLoop::Privilege LockedSamples = ServoLoop::Privilege::Unknown;
  double ReportPeriod = 0.0; ///< s, as measured; 0 if unknown
  double RoundTrip = 0.0;    ///< s, as measured; 0 if unknown
  ForceCaps Caps;
  std::string RecordingTrouble; ///< why a recording failed; empty if none has

  /** Returns a vtkHapticDevice::StatusType. */
  int GetType() const;
  /** Returns the text of vtkHapticDevice::GetStatusText. */
  std::string MakeText() const;

private:
  /** Returns the fault of the state; none if Arm was ordered after it. */
  GateReason GetFault() const;
  std::string DescribeDevice() const;
  /** Returns the device's id, followed by "(vibration, not force)" if the device only vibrates. */
  std::string NameDevice() const;
  std::string DescribeCondition() const;
  std::string DescribeState() const;
  /**
   * Returns a space and the driver's text about a device that is ready; empty if there is no text.
   */
  std::string DescribeWarning() const;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Describes the status of a device in a text, with the cure if there is a fault.
 */
#ifndef DeviceStatus_h
#define DeviceStatus_h

#include "Core/Safety/DeviceBackend.h"
#include "Core/Servo/ServoLoop.h"

#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/** Facts about a device and its servo, and the status that follows from them. */
struct DeviceStatus
{
  bool IsOpen = false;
  std::string Id;            ///< the id that was opened
  bool Vibrates = false;     ///< see DeviceLimits
  DeviceCondition Condition; ///< condition of the open device

  bool IsArmOrdered = false;      ///< see ServoLoop::IsArmOrdered
  bool NeedsConfirmation = false; ///< whether the signs must be confirmed before anything is felt
  /** Work that keeps the force off, such as "a surface is meshed"; empty if there is none. */
  std::string LongWork;
  /** A sentence on work that nothing waits for; empty if there is none. */
  std::string BackgroundWork;

  std::uint32_t Orders = 0; ///< see ServoLoop::GetOrders
  /**
   * The latest state. While the servo does not run, it is null, and the members below are not
   * valid.
   */
  const ServoSnapshot* State = nullptr;
  RealTimeGrant RealTimePriority = RealTimeGrant::Unknown;
  ServoLoop::Privilege LockedMemory = ServoLoop::Privilege::Unknown;
  ServoLoop::Privilege LockedSamples = ServoLoop::Privilege::Unknown;
  double ReportPeriod = 0.0; ///< s, as measured; 0 if not known
  double RoundTrip = 0.0;    ///< s, as measured; 0 if not known
  ForceCaps Caps;
  std::string RecordingTrouble; ///< why a recording has failed; empty if none has

  /** Returns a vtkHapticDevice::StatusType. */
  int GetType() const;
  /** Returns the text of vtkHapticDevice::GetStatusText. */
  std::string MakeText() const;

private:
  /** Returns the fault of the state, unless Arm was ordered since. */
  GateReason GetFault() const;
  std::string DescribeDevice() const;
  /** Returns the id, and adds "(vibration, not force)" for a device that only vibrates. */
  std::string NameDevice() const;
  std::string DescribeCondition() const;
  std::string DescribeState() const;
  /**
   * Returns the driver's text about a device that is ready, with a space before it; empty if there
   * is none.
   */
  std::string DescribeWarning() const;
};

} // namespace VolumeHaptics

#endif

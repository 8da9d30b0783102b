// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The status of a device as a text, with the cure if there is a fault.
 */
#ifndef DeviceStatus_h
#define DeviceStatus_h

#include "Core/Safety/DeviceBackend.h"
#include "Core/Servo/ServoLoop.h"

#include <cstdint>
#include <string>

namespace VolumeHaptics
{

/** Plain facts about a device and its servo, and the status that follows from them. */
struct DeviceStatus
{
  bool IsOpen = false;
  std::string Id;            ///< the id that was opened
  bool Vibrates = false;     ///< see DeviceLimits
  DeviceCondition Condition; ///< of the open device

  bool IsArmOrdered = false;      ///< see ServoLoop::IsArmOrdered
  bool NeedsConfirmation = false; ///< before anything is felt
  std::string LongWork;           ///< keeps the force off, such as "a surface is meshed"; or empty
  std::string BackgroundWork;     ///< a sentence on what nothing waits for; or empty

  std::uint32_t Orders = 0; ///< see ServoLoop::GetOrders
  /** The latest state; null unless the servo runs; the rest then means nothing. */
  const ServoSnapshot* State = nullptr;
  RealTimeGrant RealTimePriority = RealTimeGrant::Unknown;
  ServoLoop::Privilege LockedMemory = ServoLoop::Privilege::Unknown;
  ServoLoop::Privilege LockedSamples = ServoLoop::Privilege::Unknown;
  double ReportPeriod = 0.0; ///< s, measured; 0: not known
  double RoundTrip = 0.0;    ///< s, measured; 0: not known
  ForceCaps Caps;
  std::string RecordingTrouble; ///< the reason if a recording has failed; else empty

  /** A vtkHapticDevice::StatusType. */
  int FindType() const;
  /** The text of vtkHapticDevice::GetStatusText. */
  std::string MakeText() const;

private:
  /** Of the state, unless Arm was ordered since. */
  GateReason FindFault() const;
  std::string DescribeDevice() const;
  /** The id, with the reason if it is felt in another way than force. */
  std::string NameDevice() const;
  std::string DescribeCondition() const;
  std::string DescribeState() const;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tells people how a device stands, and the cure if something is wrong.
 */
#ifndef DeviceStatus_h
#define DeviceStatus_h

#include "Core/Servo/DeviceBackend.h"
#include "Core/Servo/ServoLoop.h"

#include <string>

namespace VolumeHaptics
{

/** Plain facts about a device and its servo, and the status that follows from them. */
struct DeviceStatus
{
  bool IsOpen = false;
  std::string Id;            ///< that was opened
  DeviceCondition Condition; ///< of the open device

  bool IsArmOrdered = false; ///< the last order was to arm, be it seen by the servo or not
  std::string LongWork;      ///< that keeps the force off, such as "the volume is hashed"; or empty

  /** The latest state; null if the servo does not run, and the rest then means nothing. */
  const ServoSnapshot* State = nullptr;
  ServoLoop::Privilege RealTimePriority = ServoLoop::Privilege::Unknown;
  ServoLoop::Privilege LockedMemory = ServoLoop::Privilege::Unknown;
  std::string RecordingTrouble; ///< why a recording gets no further; empty while all is well

  /** As vtkHapticDevice::StatusType. */
  int FindType() const;
  /** For vtkHapticDevice::GetStatusText. */
  std::string MakeText() const;

private:
  std::string DescribeDevice() const;
  std::string DescribeCondition() const;
  std::string DescribeState() const;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/DeviceStatus.h"

#include "Core/Platform/HapticFiles.h"

#include "vtkHapticDevice.h"

#include <cstdio>

namespace VolumeHaptics
{
namespace
{

std::string NameAxis(const SignVerdict& signs)
{
  return std::string(1, "xyz"[signs.Axis]);
}

/**
 * Returns advice for a wheel whose second axis is a pedal without a motor, though its descriptor
 * lists two force axes.
 */
std::string SuggestOneMotor(const std::string& id, const SignVerdict& signs)
{
  return id.compare(0, 3, "pid") == 0 && signs.Axis == 1
    ? " If it has no motor, as that of a wheel's pedal, set NewtonsPerFullScale to 0 for it, as in "
      "(2.5, 0) or --newtons 2.5,0, and Open() the device again."
    : "";
}

/** Describes a device's fault, with the cure. */
std::string Explain(GateReason fault, const SignVerdict& signs, const std::string& id)
{
  switch (fault)
  {
    case GateReason::WrongSign:
      return "Force cut off: the device moves against the force on axis " + NameAxis(signs) +
        ": wrong sign. Do not use it until its wiring, or the sign of its NewtonsPerFullScale, is "
        "right; then Arm() again.";
    case GateReason::Unmoved:
      return signs.Result == SignResult::Restless
        ? "Force cut off: the tip moved by itself along axis " + NameAxis(signs) +
          ", so that it is not known whether it moves with the force. Hold the device loosely and "
          "keep the hand still, then Arm() again."
        : "Force cut off: small pushes did not move the tip along axis " + NameAxis(signs) +
          ", so that it is not known whether it moves with the force. Hold the device loosely in "
          "the middle of its workspace, then Arm() again." +
          SuggestOneMotor(id, signs);
    case GateReason::NotFinite:
      return "Force cut off: a force or a position was not a finite number. Check the image and "
             "the device, then Arm() again.";
    case GateReason::OverSpeed:
      return "Force cut off: the tip moved faster than a hand can hold the device. Take the "
             "stylus, then Arm() again.";
    case GateReason::DeviceLost:
      return "Force cut off: the device was lost, and is back. Arm() again.";
    case GateReason::Active:
      return "Force cut off: the device moves against the force: wrong sign, or unstable. Check "
             "its axes, lower the stiffness, then Arm() again.";
    case GateReason::Unattended:
      return "Force faded out: the program did not call the device for longer than AttentionTime. "
             "Arm() again. If it is often busy for that long, show less, or smaller data; a "
             "program "
             "of your own may raise AttentionTime.";
    default:
      return "";
  }
}

/** Describes why the gate passes less than the full force. */
const char* DescribeReason(GateState state, GateReason reason)
{
  switch (reason)
  {
    case GateReason::Ordered:
      return state == GateState::Fading ? "it fades out" : "not armed";
    case GateReason::Unattended:
      return "it fades out, because the program does not respond";
    case GateReason::Active:
      return "it fades out, because the device swings by itself";
    case GateReason::NotReady:
      return "the device was not ready";
    case GateReason::LongWork:
      return "long work";
    case GateReason::NoSamples:
      return "no fresh positions";
    case GateReason::NoData:
      return "data are missing";
    case GateReason::Rising:
      return "it rises";
    case GateReason::Confirming:
      return "small pushes find out whether the device moves with the force";
    case GateReason::Clutched:
      return "the clutch is held";
    default:
      return "";
  }
}

std::string DescribeShare(const ServoSnapshot& state)
{
  const std::string reason = DescribeReason(state.Gate, state.Reason);
  return " " + std::to_string(static_cast<int>(100.0 * state.Share)) + " % of the force passes" +
    (reason.empty() ? "." : " (" + reason + ").") +
    (state.IsSoft
        ? " The surface feels soft, because it was pressed before all of the force could flow: "
          "leave it, or press deeper."
        : "");
}

/** Describes the known times and force caps. */
std::string DescribeTiming(const DeviceStatus& status)
{
  std::string text;
  char part[100];
  if (status.RoundTrip > 0.0)
  {
    std::snprintf(part, sizeof(part), " It reports every %.1f ms, round trip %.1f ms.",
      1e3 * status.ReportPeriod, 1e3 * status.RoundTrip);
    text += part;
  }
  if (status.Caps.Stiffness > 0.0)
  {
    std::snprintf(part, sizeof(part), " Stiffness is at most %.0f N/m.", status.Caps.Stiffness);
    text += part;
  }
  return text;
}

const char* DescribeGrant(RealTimeGrant grant)
{
  switch (grant)
  {
    case RealTimeGrant::Kernel:
      return "granted";
    case RealTimeGrant::RealtimeKit:
      return "granted by RealtimeKit";
    case RealTimeGrant::Asked:
      return "asked for";
    case RealTimeGrant::NoService:
      return "refused (the loop may be late on a busy machine: install rtkit or raise the user's "
             "rtprio limit, see Documentation/devices.md)";
    case RealTimeGrant::Refused:
      return "refused by RealtimeKit, too (the loop may be late on a busy machine: log in at the "
             "computer itself or raise the user's rtprio limit, see Documentation/devices.md)";
    case RealTimeGrant::Unknown:
      break;
  }
  return "not yet known";
}

const char* DescribePrivilege(ServoLoop::Privilege privilege)
{
  switch (privilege)
  {
    case ServoLoop::Privilege::Granted:
      return "granted";
    case ServoLoop::Privilege::Refused:
      return "refused (the loop may be late if memory is scarce; raise the user's memlock limit)";
    case ServoLoop::Privilege::Unknown:
      break;
  }
  return "not yet known";
}

} // namespace

GateReason DeviceStatus::GetFault() const
{
  const bool isCleared = this->State && this->IsArmOrdered && this->State->Orders != this->Orders;
  return this->State && !isCleared ? this->State->GetFault() : GateReason::None;
}

int DeviceStatus::GetType() const
{
  if (!this->IsOpen)
  {
    return vtkHapticDevice::CLOSED;
  }
  switch (this->Condition.Stage)
  {
    case DeviceStage::Firmware:
      return vtkHapticDevice::FIRMWARE;
    case DeviceStage::Homing:
      return vtkHapticDevice::HOMING;
    case DeviceStage::Lost:
      return vtkHapticDevice::FAULT;
    case DeviceStage::Ready:
      break;
  }
  if (this->GetFault() != GateReason::None)
  {
    return vtkHapticDevice::FAULT;
  }
  const bool isArmed =
    this->State && this->State->IsArmed() && this->State->GetFault() == GateReason::None;
  if (!isArmed)
  {
    return this->IsArmOrdered ? vtkHapticDevice::ARMED : vtkHapticDevice::READY;
  }
  const bool isFelt =
    !this->State->Stale && this->LongWork.empty() && this->State->Gate != GateState::Confirming;
  return isFelt ? vtkHapticDevice::ACTIVE : vtkHapticDevice::ARMED;
}

std::string DeviceStatus::MakeText() const
{
  const std::string& trouble = this->RecordingTrouble;
  return Printable(
    this->DescribeDevice() + this->BackgroundWork + (trouble.empty() ? "" : " " + trouble));
}

std::string DeviceStatus::DescribeDevice() const
{
  if (!this->IsOpen)
  {
    return "Closed. Open() a device.";
  }
  if (this->Condition.Stage != DeviceStage::Ready)
  {
    return this->DescribeCondition();
  }
  if (!this->State)
  {
    return "Ready: " + this->NameDevice() + ". Start() the servo.";
  }
  if (this->GetFault() != GateReason::None)
  {
    return Explain(this->GetFault(), this->State->Signs, this->Id);
  }
  if (this->State->GetFault() != GateReason::None)
  {
    return "Armed: " + this->Id + ". The fault is cleared.";
  }
  std::string text = this->DescribeState();
  if (this->State->Awaiting)
  {
    text += this->State->Residency > 0.0
      ? " Waiting for the data around the tip: the force fades."
      : " Waiting for the data around the tip: no force until then.";
  }
  constexpr ServoLoop::Privilege refused = ServoLoop::Privilege::Refused;
  const bool isTold = this->LockedMemory == refused && this->LockedSamples == refused;
  text += DescribeShare(*this->State) + DescribeTiming(*this) + " Real-time priority " +
    DescribeGrant(this->RealTimePriority) + ", locking of the servo's own memory " +
    DescribePrivilege(this->LockedMemory) + ", of the samples around the tip " +
    (isTold ? "refused, too" : DescribePrivilege(this->LockedSamples)) + ".";
  return text;
}

std::string DeviceStatus::DescribeCondition() const
{
  const DeviceStage stage = this->Condition.Stage;
  const char* const begin = stage == DeviceStage::Firmware ? "Firmware of "
    : stage == DeviceStage::Homing                         ? "Homing of "
                                                           : "Force cut off, lost: ";
  return begin + this->Id + ": " + this->Condition.Text.data();
}

std::string DeviceStatus::NameDevice() const
{
  return this->Id + (this->Vibrates ? " (vibration, not force)" : "");
}

std::string DeviceStatus::DescribeState() const
{
  if (this->State->Device == DeviceState::Lost)
  {
    return "Lost: " + this->Id + " is gone. Plug it in, Open() and Start() it.";
  }
  if (this->State->Device == DeviceState::Finished)
  {
    return "Finished: " + this->Id + " has come to its end.";
  }
  if (!this->State->IsArmed())
  {
    return "Running: " + this->NameDevice() +
      (this->NeedsConfirmation
          ? ". Its signs were never confirmed: hold it loosely in the middle of its workspace, "
            "keep "
            "the hand still, and Arm(). For some seconds it then pushes gently along each axis."
          : ". Arm() lets force through.") +
      this->DescribeWarning();
  }
  if (this->State->Gate == GateState::Confirming)
  {
    return "Confirming the signs of " + this->Id +
      ": hold it loosely and keep the hand still. The volume is not felt yet.";
  }
  if (!this->LongWork.empty() && this->IsArmOrdered)
  {
    return "Force is off while " + this->LongWork + ", and comes back by itself.";
  }
  return this->State->Stale ? "Armed, but " + this->Id + " gives no fresh positions: no force."
                            : "Active: " + this->NameDevice() + "." + this->DescribeWarning();
}

std::string DeviceStatus::DescribeWarning() const
{
  const char* const text = this->Condition.Text.data();
  const bool isWarning = this->Condition.Stage == DeviceStage::Ready && *text != '\0';
  return isWarning ? std::string(" ") + text : "";
}

} // namespace VolumeHaptics

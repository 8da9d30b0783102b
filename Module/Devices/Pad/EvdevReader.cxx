// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pad/EvdevReader.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

constexpr std::uint32_t LeftTriggerButton = 1U << 30;
constexpr std::uint32_t RightTriggerButton = 1U << 31;

struct ButtonCode
{
  unsigned Code;
  std::uint32_t Bit;
};
constexpr ButtonCode Codes[] = { { BTN_SOUTH, PadSouth }, { BTN_EAST, PadEast },
  { BTN_WEST, PadWest }, { BTN_NORTH, PadNorth }, { BTN_TL, PadLeftShoulder },
  { BTN_TR, PadRightShoulder }, { BTN_TL2, LeftTriggerButton }, { BTN_TR2, RightTriggerButton },
  { BTN_SELECT, PadSelect }, { BTN_START, PadStart }, { BTN_THUMBL, PadLeftStick },
  { BTN_THUMBR, PadRightStick }, { BTN_MODE, PadMode } };

} // namespace

void EvdevReader::SetAxis(unsigned code, const input_absinfo& axis) noexcept
{
  if (code >= this->Axes.size())
  {
    return;
  }
  Axis& mine = this->Axes[code];
  const double range = static_cast<double>(axis.maximum) - static_cast<double>(axis.minimum);
  const double part = (static_cast<double>(axis.value) - static_cast<double>(axis.minimum)) / range;
  mine.IsCentred = mine.Exists ? mine.IsCentred : part > 0.25 && part < 0.75;
  mine.Exists = true;
  mine.Value = axis.value;
  mine.Least = axis.minimum;
  mine.Most = axis.maximum;
  mine.Flat = std::max(0, axis.flat);
}

void EvdevReader::SetButton(unsigned code, bool isHeld) noexcept
{
  for (const ButtonCode& button : Codes)
  {
    if (button.Code == code)
    {
      this->Buttons = isHeld ? this->Buttons | button.Bit : this->Buttons & ~button.Bit;
    }
  }
}

EvdevReader::News EvdevReader::Receive(const input_event& event) noexcept
{
  if (event.type == EV_SYN && event.code == SYN_DROPPED)
  {
    this->IsDropping = true;
    return News::None;
  }
  const bool isEnd = event.type == EV_SYN && event.code == SYN_REPORT;
  if (this->IsDropping)
  {
    // If a part of a report was lost, drop the rest of the report.
    this->IsDropping = !isEnd;
    return isEnd ? News::MustRead : News::None;
  }
  if (event.type == EV_ABS && event.code < this->Axes.size())
  {
    this->Axes[event.code].Value = event.value;
  }
  else if (event.type == EV_KEY)
  {
    this->SetButton(event.code, event.value != 0);
  }
  return isEnd ? News::Report : News::None;
}

double EvdevReader::Stick(unsigned code) const noexcept
{
  const Axis& axis = this->Axes[code];
  return axis.Exists ? ScaleStick(axis.Value, axis.Least, axis.Most, axis.Flat) : 0.0;
}

double EvdevReader::Trigger(unsigned code, unsigned other, std::uint32_t button) const noexcept
{
  double most = (this->Buttons & button) != 0 ? 1.0 : 0.0;
  bool hasAxis = false;
  for (const unsigned c : { code, other })
  {
    const Axis& axis = this->Axes[c];
    if (axis.Exists)
    {
      // A trigger with an axis also has a button, which closes on the way; use only the axis.
      const double part = ScaleTrigger(axis.Value, axis.Least, axis.Most, axis.Flat);
      most = hasAxis ? std::max(most, part) : part;
      hasAxis = true;
    }
  }
  return most;
}

PadState EvdevReader::Get() const noexcept
{
  const bool isNewer = this->Axes[ABS_RX].Exists && this->Axes[ABS_RY].Exists;
  const bool isOlder = !isNewer && this->Axes[ABS_Z].IsCentred && this->Axes[ABS_RZ].IsCentred;
  PadState state;
  state.LeftX = this->Stick(ABS_X);
  state.LeftY = this->Stick(ABS_Y);
  state.RightX = this->Stick(isOlder ? ABS_Z : ABS_RX);
  state.RightY = this->Stick(isOlder ? ABS_RZ : ABS_RY);
  state.LeftTrigger = this->Trigger(isOlder ? ABS_BRAKE : ABS_Z, ABS_HAT2Y, LeftTriggerButton);
  state.RightTrigger = this->Trigger(isOlder ? ABS_GAS : ABS_RZ, ABS_HAT2X, RightTriggerButton);
  state.Buttons = this->Buttons & ~(LeftTriggerButton | RightTriggerButton);
  return state;
}

} // namespace VolumeHaptics

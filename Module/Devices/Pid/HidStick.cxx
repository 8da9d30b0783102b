// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pid/HidStick.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{
constexpr HidUsage X = MakeHidUsage(0x01, 0x30);
constexpr HidUsage Y = MakeHidUsage(0x01, 0x31);
constexpr HidUsage Steering = MakeHidUsage(0x02, 0xC8);
constexpr HidUsage NoButton = MakeHidUsage(0x09, 0);
constexpr HidUsage LastButton = MakeHidUsage(0x09, 32);

// Return a field with absolute values, because the axes of a mouse are relative.
const HidField* FindAxis(const HidReportDescriptor& descriptor, HidUsage usage)
{
  for (const HidField& field : descriptor.GetFields())
  {
    if (field.Kind == HidReportKind::Input && field.Usage == usage && !field.IsArray &&
      !field.IsRelative && field.LogicalMinimum < field.LogicalMaximum)
    {
      return &field;
    }
  }
  return nullptr;
}

double Part(const HidField& field, std::int64_t value)
{
  const auto range = static_cast<double>(field.LogicalMaximum - field.LogicalMinimum);
  const auto twice = static_cast<double>(2 * value - field.LogicalMaximum - field.LogicalMinimum);
  return std::max(-1.0, std::min(twice / range, 1.0));
}
} // namespace

bool HidStick::Map(const HidReportDescriptor& descriptor, std::string& error)
{
  *this = HidStick();
  const HidField* x = FindAxis(descriptor, X);
  const HidField* y = FindAxis(descriptor, Y);
  if (x == nullptr)
  {
    x = FindAxis(descriptor, Steering);
  }
  if (x == nullptr)
  {
    error = "This HID device has neither an absolute X axis nor a steering wheel";
    return false;
  }
  this->Axes.push_back(*x);
  if (y != nullptr)
  {
    this->Axes.push_back(*y);
  }
  this->HasIds = descriptor.UsesReportIds();
  for (const HidField& field : descriptor.GetFields())
  {
    if (field.Kind == HidReportKind::Input)
    {
      this->Sizes[field.ReportId] = descriptor.GetReportSize(field.Kind, field.ReportId);
      if (!field.IsArray && field.Usage > NoButton && field.Usage <= LastButton)
      {
        this->Buttons.push_back(field);
      }
    }
  }
  return true;
}

double HidStick::GetStep() const noexcept
{
  double step = 1.0;
  for (const HidField& axis : this->Axes)
  {
    const auto range = static_cast<double>(axis.LogicalMaximum - axis.LogicalMinimum);
    step = std::min(step, 1.0 / range);
  }
  return step;
}

const char* HidStick::Decode(
  const std::uint8_t* bytes, std::size_t size, State& state) const noexcept
{
  if (size == 0)
  {
    return "an empty packet";
  }
  const std::uint8_t id = this->HasIds ? bytes[0] : 0;
  const std::uint8_t* payload = bytes + (this->HasIds ? 1 : 0);
  const std::size_t length = size - (this->HasIds ? 1 : 0);
  if (this->Sizes[id] == 0)
  {
    return nullptr;
  }
  if (length != this->Sizes[id])
  {
    return length < this->Sizes[id] ? "a report that is shorter than the device's descriptor says"
                                    : "a report that is longer than the device's descriptor says";
  }
  std::int64_t value = 0;
  for (std::size_t axis = 0; axis < this->Axes.size(); ++axis)
  {
    if (this->Axes[axis].ReportId == id && ReadRaw(this->Axes[axis], payload, length, value))
    {
      state.Axes[axis] = Part(this->Axes[axis], value);
    }
  }
  for (const HidField& button : this->Buttons)
  {
    if (button.ReportId == id && ReadRaw(button, payload, length, value))
    {
      const std::uint32_t bit = 1U << (button.Usage - NoButton - 1);
      state.Buttons = value != 0 ? state.Buttons | bit : state.Buttons & ~bit;
    }
  }
  return nullptr;
}

} // namespace VolumeHaptics

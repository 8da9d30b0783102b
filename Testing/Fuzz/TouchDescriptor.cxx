// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TouchDescriptor.h"

#include "Dealer.h"
#include "Devices/Pid/HidStick.h"
#include "Devices/Pid/PidDialogue.h"
#include "Devices/SpaceMouse/SpaceMouse.h"
#include "Devices/WoodenHaptics/WoodenHaptics.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace VolumeHaptics;

namespace
{
using Bytes = std::vector<std::uint8_t>;

double AsNumber(const Bytes& packet)
{
  std::array<std::uint8_t, sizeof(double)> bytes{};
  std::copy_n(packet.begin(), std::min(packet.size(), bytes.size()), bytes.begin());
  double number = 0.0;
  std::memcpy(&number, bytes.data(), bytes.size());
  return number;
}

void TouchFields(const HidReportDescriptor& descriptor)
{
  for (const HidField& field : descriptor.GetFields())
  {
    const std::size_t size = descriptor.GetReportSize(field.Kind, field.ReportId);
    Check(
      std::uint64_t{ field.BitOffset } + field.BitSize <= size * 8, "fields are in their report");
    Check(field.LogicalMinimum <= field.LogicalMaximum, "ranges are the right way round");
    Bytes report(size, 0xA5);
    for (const std::int64_t value :
      { INT64_MIN, std::int64_t{ -1 }, std::int64_t{ 0 }, std::int64_t{ 77 }, INT64_MAX })
    {
      std::int64_t back = 0;
      Check(WriteValue(field, report.data(), size, value), "a field can be written");
      Check(ReadRaw(field, report.data(), size, back), "a field can be read");
      Check(back == ClampToField(field, value), "what was written is read");
    }
    std::int64_t choice = 0;
    Check(!descriptor.ReadChoice(field, 0x000F0026, choice) || choice <= field.LogicalMaximum,
      "choices are in the range");
    descriptor.IsWithin(field, 0x000F0021);
  }
}

void TouchForceFeedback(const HidReportDescriptor& descriptor, const Bytes& packet)
{
  PidDevice device;
  std::string error;
  if (!device.Map(descriptor, error))
  {
    Check(!error.empty(), "a refusal has a reason");
    return;
  }
  PidSettings settings;
  settings.NewtonsPerFullScale = { AsNumber(packet), -4.0 };
  settings.Duration = AsNumber(packet);
  PidDialogue dialogue(device, settings);
  HidReport report;
  PidStep step = dialogue.GetStep(report);
  for (int i = 0; i < 2 * PidDialogue::MaximumPolls + 20 && step <= PidStep::Fetch; ++i)
  {
    Check(report.Size <= HidReport::Capacity, "reports fit");
    if (step == PidStep::Send)
    {
      dialogue.Sent(true);
    }
    else
    {
      dialogue.Fetched(packet.data(), packet.size());
    }
    step = dialogue.GetStep(report);
  }
  Check(step == PidStep::Ready || step == PidStep::Failed, "dialogues end");
  PidStream stream(device, settings, dialogue);
  for (int i = 0; i < 8; ++i)
  {
    stream.Next(0.02, { AsNumber(packet), 1.0 * i }, report);
  }
}

void TouchPackets(const HidReportDescriptor& descriptor, const Bytes& packet)
{
  HidStick stick;
  HidStick::State where;
  std::string error;
  if (stick.Map(descriptor, error))
  {
    stick.Decode(packet.data(), packet.size(), where);
  }
  Check(std::abs(where.Axes[0]) <= 1.0 && std::abs(where.Axes[1]) <= 1.0, "sticks have an end");
  SpaceMouse::State cap;
  SpaceMouse::Decode(packet.data(), packet.size(), cap);
  for (const double axis : cap.Axes)
  {
    Check(std::abs(axis) <= 1.0, "caps have an end");
  }
  const WoodenHaptics arm;
  WoodenHaptics::Input input;
  WoodenHaptics::Decode(packet.data(), packet.size(), input);
  const double newtons = AsNumber(packet);
  const std::array<double, 3> angles = arm.ComputeAngles(input.Counts);
  for (const int current : arm.ComputeCurrents(angles, { newtons, 1.0, -newtons }))
  {
    Check(std::abs(current) <= 3000, "motors get what they stand");
  }
}
} // namespace

void TouchDescriptor(const std::uint8_t* bytes, std::size_t size)
{
  const std::size_t length = size > 0 ? std::min<std::size_t>(bytes[0], size - 1) : 0;
  const std::uint8_t* rest = bytes + (size > 0 ? 1 : 0);
  const Bytes packet(rest, rest + length);
  const Bytes description(rest + length, bytes + size);
  HidReportDescriptor descriptor;
  std::string error;
  if (!descriptor.Parse(description.data(), description.size(), error))
  {
    Check(!error.empty() && descriptor.GetFields().empty(), "a refusal has a reason");
  }
  TouchFields(descriptor);
  TouchForceFeedback(descriptor, packet);
  TouchPackets(descriptor, packet);
}

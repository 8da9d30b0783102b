// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/BakedBurr.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr double FullTurn = 2.0 * 3.14159265358979323846;

double FindFrequency(double speed)
{
  double frequency = speed;
  while (frequency > BakedBurr::MostFrequency && frequency < HUGE_VAL)
  {
    frequency *= 0.5;
  }
  return frequency < HUGE_VAL ? frequency : 0.0;
}

} // namespace

BakedBurr::BakedBurr(const BurrDescription& description)
  : Settings(description.Settings)
  , SpecificEnergy({ description.SpecificEnergy, ConstantPolyline(0.0) })
  , RimSpeed(FullTurn * description.Settings.Radius * description.Settings.Speed)
  , Frequency(FindFrequency(description.Settings.Speed))
{
}

std::vector<ShellPoint> BakedBurr::MakeHead(double radius, std::size_t count)
{
  // Points along a spiral by the golden angle.
  std::vector<ShellPoint> points;
  points.reserve(count);
  const auto number = static_cast<double>(count);
  const double area = 2.0 * FullTurn * radius * radius / number;
  const double golden = 0.5 * FullTurn * (3.0 - std::sqrt(5.0));
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto n = static_cast<double>(i);
    const double z = 1.0 - (2.0 * n + 1.0) / number;
    const double r = std::sqrt(1.0 - z * z);
    points.push_back(
      { radius * Vector3{ r * std::cos(golden * n), r * std::sin(golden * n), z }, area });
  }
  return points;
}

} // namespace VolumeHaptics

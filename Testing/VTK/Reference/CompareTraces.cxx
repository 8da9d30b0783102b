// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "CompareTraces.h"

#include <algorithm>
#include <sstream>
#include <string_view>

namespace reference
{
static void Take(Difference& result, double difference, double scale, const char* name,
  std::size_t tick, double expected, double actual)
{
  const double ratio = difference / scale;
  if (!(ratio <= result.worst)) // also true for a NaN, which is the worst case
  {
    std::ostringstream text;
    text.precision(17);
    text << name << " at tick " << tick << ": expected " << expected << ", got " << actual
         << ", off by " << difference << " on a scale of " << scale;
    result = { std::isnan(ratio) ? HUGE_VAL : ratio, text.str() };
  }
}

static double Scale(const Trace& trace, double TickRecord::*member)
{
  double scale = 0.0;
  for (const TickRecord& record : trace)
  {
    scale = std::max(scale, std::abs(record.*member));
  }
  return std::max(scale, 1e-3);
}

double ForceScale(const Trace& trace)
{
  double scale = 1e-3;
  for (const TickRecord& record : trace)
  {
    scale = std::max(
      { scale, Norm(record.force), record.normalForce, record.frictionForce, record.dragForce });
  }
  return scale;
}

static void CompareVector(Difference& result, const Trace& expected, const Trace& actual,
  const char* name, Vec3 TickRecord::*member, double scale)
{
  for (std::size_t tick = 0; tick < expected.size(); ++tick)
  {
    const Vec3 a = expected[tick].*member;
    const Vec3 b = actual[tick].*member;
    Take(result, Norm(a - b), scale, name, tick, Norm(a), Norm(b));
  }
}

static void CompareScalar(
  Difference& result, const Trace& expected, const Trace& actual, const ScalarArray& entry)
{
  const std::string_view name = entry.name;
  const bool isForce = name == "NormalForce" || name == "FrictionForce" || name == "DragForce";
  const double scale = isForce ? ForceScale(expected) : Scale(expected, entry.member);
  for (std::size_t tick = 0; tick < expected.size(); ++tick)
  {
    const double a = expected[tick].*entry.member;
    const double b = actual[tick].*entry.member;
    Take(result, std::abs(a - b), scale, entry.name, tick, a, b);
  }
}

Difference CompareForces(const Trace& expected, const Trace& actual)
{
  Difference result;
  CompareVector(result, expected, actual, "Force", &TickRecord::force, ForceScale(expected));
  return result;
}

Difference CompareForceFields(const Trace& expected, const Trace& actual)
{
  Difference result = CompareForces(expected, actual);
  CompareVector(result, expected, actual, "proxy", &TickRecord::proxy, 1.0);
  CompareVector(result, expected, actual, "Tip", &TickRecord::tip, 1.0);
  for (const ScalarArray& entry : ScalarArrays)
  {
    const std::string_view name = entry.name;
    if (name == "Time" || name == "NormalForce" || name == "DragForce" || name == "Value")
    {
      CompareScalar(result, expected, actual, entry);
    }
  }
  return result;
}

Difference CompareTraces(const Trace& expected, const Trace& actual)
{
  Difference result = CompareForces(expected, actual);
  CompareVector(result, expected, actual, "proxy", &TickRecord::proxy, 1.0);
  CompareVector(result, expected, actual, "Tip", &TickRecord::tip, 1.0);
  CompareVector(result, expected, actual, "Normal", &TickRecord::normal, 1.0);
  for (const ScalarArray& entry : ScalarArrays)
  {
    CompareScalar(result, expected, actual, entry);
  }
  for (std::size_t tick = 0; tick < expected.size(); ++tick)
  {
    const int a = expected[tick].contact;
    const int b = actual[tick].contact;
    const double strength = std::max(expected[tick].surfaceStrength, actual[tick].surfaceStrength);
    const bool strengthRounds =
      strength < 1e-9 && expected[tick].surfaceStrength != actual[tick].surfaceStrength;
    if (a != b && expected[tick].margin > 1e-9 && !strengthRounds)
    {
      Take(result, 1.0, 1.0, "Contact", tick, a, b);
    }
  }
  return result;
}
} // namespace reference

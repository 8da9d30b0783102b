// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Measure/Measurement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace VolumeHaptics
{
namespace
{

constexpr const char* KindNames[MeasuredKinds] = { "Point", "Distance", "Angle", "Path", "Area" };
constexpr int KindPoints[MeasuredKinds] = { 1, 2, 3, 0, 0 };

double LengthOf(const std::vector<Vector3>& points)
{
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += Norm(points[i] - points[i - 1]);
  }
  return length;
}

/**
 * Computes an angle (degrees) with atan2, which is equally exact for flat angles and for right
 * angles.
 */
double AngleOf(const Vector3& a, const Vector3& corner, const Vector3& b)
{
  constexpr double degrees = 57.29577951308232;
  const Vector3 first = a - corner;
  const Vector3 second = b - corner;
  return degrees * std::atan2(Norm(Cross(first, second)), Dot(first, second));
}

double AreaOf(const Measurement& area)
{
  double twice = 0.0;
  for (const std::array<int, 3>& t : area.Triangles)
  {
    const Vector3& a = area.Points[static_cast<std::size_t>(t[0])];
    twice += Norm(Cross(area.Points[static_cast<std::size_t>(t[1])] - a,
      area.Points[static_cast<std::size_t>(t[2])] - a));
  }
  return 0.5 * twice;
}

char Lower(char letter)
{
  return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

} // namespace

double Measurement::Measure() const
{
  switch (this->Kind)
  {
    case MeasuredKind::Angle:
      return AngleOf(this->Points[0], this->Points[1], this->Points[2]);
    case MeasuredKind::Area:
      return AreaOf(*this);
    case MeasuredKind::Distance:
    case MeasuredKind::Path:
      return LengthOf(this->Points);
    default:
      return this->Samples.empty() ? MeasuredSample::Unknown : this->Samples[0].SurfaceValue;
  }
}

const char* GetKindName(MeasuredKind kind)
{
  return KindNames[static_cast<int>(kind)];
}

bool FindKind(std::string_view name, MeasuredKind& kind)
{
  for (int i = 0; i < MeasuredKinds; ++i)
  {
    const std::string_view known = KindNames[i];
    if (std::equal(name.begin(), name.end(), known.begin(), known.end(),
          [](char a, char b) { return Lower(a) == Lower(b); }))
    {
      kind = static_cast<MeasuredKind>(i);
      return true;
    }
  }
  return false;
}

int CountPoints(MeasuredKind kind)
{
  return KindPoints[static_cast<int>(kind)];
}

std::string DetectFault(const Measurement& measurement)
{
  const std::size_t count = measurement.Points.size();
  const auto wanted = static_cast<std::size_t>(CountPoints(measurement.Kind));
  const std::string kind = GetKindName(measurement.Kind);
  if (wanted > 0 ? count != wanted : count == 0)
  {
    return "it has " + std::to_string(count) + (count == 1 ? " point. " : " points. ") +
      (kind.front() == 'A' ? "An " : "A ") + kind + " needs " +
      (wanted > 0 ? std::to_string(wanted) : "at least 1");
  }
  if (!std::all_of(measurement.Points.begin(), measurement.Points.end(), IsFinite))
  {
    return "a coordinate is NaN or infinite. Give positions in the world that are finite";
  }
  const auto isPoint = [count](int i) { return i >= 0 && static_cast<std::size_t>(i) < count; };
  for (const std::array<int, 3>& triangle : measurement.Triangles)
  {
    if (!std::all_of(triangle.begin(), triangle.end(), isPoint))
    {
      return "a triangle has a point that does not exist. Number its points from 0 to " +
        std::to_string(count - 1);
    }
  }
  if (measurement.Kind == MeasuredKind::Area && measurement.Triangles.empty())
  {
    return "it has no triangles. An Area needs triangles";
  }
  return {};
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/Paths/HapticCurve.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/** Two unit vectors that form a right-handed frame with the normal. */
struct Plane
{
  explicit Plane(const Vector3& normal)
  {
    const Vector3 n = (1.0 / Norm(normal)) * normal;
    // For a normal along z, the vectors are x and y, as users expect.
    const Vector3 aside = std::abs(n.Z) > 0.5 ? Vector3{ 1, 0, 0 } : Vector3{ 0, 0, 1 };
    const Vector3 u = aside - Dot(aside, n) * n;
    this->U = (1.0 / Norm(u)) * u;
    this->V = Cross(n, this->U);
  }

  Vector3 At(double radius, double angle) const
  {
    return radius * std::cos(angle) * this->U + radius * std::sin(angle) * this->V;
  }

  Vector3 U;
  Vector3 V;
};

/** Computes the length of r = phi from 0 to an angle. */
double SpiralLength(double angle)
{
  return 0.5 * (angle * std::sqrt(1.0 + angle * angle) + std::asinh(angle));
}

/**
 * Computes the angle at a length, by Newton's method: its step never overshoots, because the length
 * is convex.
 */
double SpiralAngle(double length)
{
  double angle = std::sqrt(2.0 * length);
  for (int i = 0; i < 60; ++i)
  {
    const double step = (SpiralLength(angle) - length) / std::sqrt(1.0 + angle * angle);
    angle -= step;
    if (std::abs(step) <= 1e-15 * (1.0 + angle))
    {
      break;
    }
  }
  return std::max(angle, 0.0);
}

} // namespace

HapticCurve MakePolygonCurve(const std::vector<Vector3>& corners)
{
  std::vector<double> ways = { 0.0 };
  for (std::size_t i = 1; i < corners.size(); ++i)
  {
    ways.push_back(ways.back() + Norm(corners[i] - corners[i - 1]));
  }
  const double length = ways.back();
  return { length,
    [corners, ways](double way)
    {
      const auto end = std::lower_bound(ways.begin() + 1, ways.end() - 1, way);
      const auto i = static_cast<std::size_t>(end - ways.begin());
      const double side = ways[i] - ways[i - 1];
      const double share = side > 0.0 ? std::min((way - ways[i - 1]) / side, 1.0) : 1.0;
      return (1.0 - share) * corners[i - 1] + share * corners[i];
    } };
}

HapticCurve MakeCircleCurve(
  const Vector3& center, const Vector3& normal, double radius, double turns)
{
  return { 2.0 * Pi * radius * turns, [center, plane = Plane(normal), radius](double way) {
            return center + plane.At(radius, way / radius);
          } };
}

HapticCurve MakeSpiralCurve(
  const Vector3& center, const Vector3& normal, double radius, double turns)
{
  const double step = radius / (2.0 * Pi * turns); // outward step per radian
  return { step * SpiralLength(2.0 * Pi * turns),
    [center, plane = Plane(normal), step](double way)
    {
      const double angle = SpiralAngle(way / step);
      return center + plane.At(step * angle, angle);
    } };
}

} // namespace VolumeHaptics

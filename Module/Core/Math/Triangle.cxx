// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Math/Triangle.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/**
 * Two contacts count as simultaneous if their times differ by less than this fraction of the
 * displacement, which is less than the remaining gap.
 */
constexpr double Rounding = 1e-9;

/**
 * Returns the fraction of a displacement after which a path from outside enters a sphere around a
 * corner, or Never if it does not.
 */
double MeetCorner(
  const Vector3& corner, const Vector3& centre, const Vector3& displacement, double radius)
{
  const Vector3 from = centre - corner;
  const double a = Dot(displacement, displacement);
  const double b = Dot(from, displacement);
  const double c = Dot(from, from) - radius * radius;
  const double discriminant = b * b - a * c;
  if (b >= 0.0 || c < 0.0 || discriminant < 0.0)
  {
    return Never;
  }
  // The form (-b - root) / a would lose digits if the displacement is long.
  const double time = c / (-b + std::sqrt(discriminant));
  return time <= 1.0 ? time : Never;
}

/**
 * Like MeetCorner(), but for a cylinder around an edge, between the edge's ends.
 */
double MeetEdge(const Vector3& begin, const Vector3& end, const Vector3& centre,
  const Vector3& displacement, double radius)
{
  const Vector3 edge = end - begin;
  const double square = Dot(edge, edge);
  const Vector3 from = centre - begin;
  const double fromAlong = Dot(from, edge) / square;
  const double displacementAlong = Dot(displacement, edge) / square;
  const Vector3 across = from - fromAlong * edge;
  const Vector3 displacementAcross = displacement - displacementAlong * edge;
  const double time = MeetCorner({}, across, displacementAcross, radius);
  const double along = fromAlong + time * displacementAlong;
  return along >= 0.0 && along <= 1.0 ? time : Never;
}

} // namespace

TrianglePoint NearestPoint(const Triangle& triangle, const Vector3& to) noexcept
{
  const Vector3& a = triangle.Corner[0];
  const Vector3& b = triangle.Corner[1];
  const Vector3& c = triangle.Corner[2];
  const auto at = [&](double u, double v, double w) {
    return TrianglePoint{ u * a + v * b + w * c, { u, v, w } };
  };
  const Vector3 ab = b - a;
  const Vector3 ac = c - a;
  const double d1 = Dot(ab, to - a);
  const double d2 = Dot(ac, to - a);
  const double d3 = Dot(ab, to - b);
  const double d4 = Dot(ac, to - b);
  const double d5 = Dot(ab, to - c);
  const double d6 = Dot(ac, to - c);
  // Look for the region of a corner, of an edge, or of the face (Ericson, Real-Time Collision
  // Detection, 5.1.5).
  if (d1 <= 0.0 && d2 <= 0.0)
  {
    return at(1.0, 0.0, 0.0);
  }
  if (d3 >= 0.0 && d4 <= d3)
  {
    return at(0.0, 1.0, 0.0);
  }
  if (d6 >= 0.0 && d5 <= d6)
  {
    return at(0.0, 0.0, 1.0);
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0)
  {
    const double v = d1 / (d1 - d3);
    return at(1.0 - v, v, 0.0);
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0)
  {
    const double w = d2 / (d2 - d6);
    return at(1.0 - w, 0.0, w);
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0)
  {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return at(0.0, 1.0 - w, w);
  }
  const double sum = va + vb + vc;
  return at(va / sum, vb / sum, vc / sum);
}

double MeetingTime(const Triangle& triangle, const Vector3& centre, const Vector3& displacement,
  double radius, double latest) noexcept
{
  const auto& [a, b, c] = triangle.Corner;
  Vector3 normal = Cross(b - a, c - a);
  normal = (1.0 / Norm(normal)) * normal;
  const double height = Dot(centre - a, normal);
  normal = height < 0.0 ? -normal : normal;
  const double closing = -Dot(displacement, normal);
  const double gap = std::abs(height) - radius;
  // The sphere meets the triangle's plane before the triangle. Few triangles pass this test, even
  // if many are in one plane.
  if (gap > 0.0 && gap >= closing * latest * (1.0 - Rounding))
  {
    return Never;
  }
  const TrianglePoint nearest = NearestPoint(triangle, centre);
  const Vector3 off = centre - nearest.Position;
  const double square = Dot(off, off);
  if (square <= radius * radius)
  {
    return Dot(off, displacement) < 0.0 ? 0.0 : Never;
  }
  if (square > (radius + Norm(displacement)) * (radius + Norm(displacement)))
  {
    return Never;
  }
  if (closing > 0.0 && gap >= 0.0)
  {
    const double time = gap / closing;
    const Vector3 touched = centre + time * displacement - radius * normal;
    const auto& weight = NearestPoint(triangle, touched).Weight;
    // If the place is outside the face, the sphere meets an edge instead. At the border of the
    // face, it meets both at the same time.
    if (time <= 1.0 && weight[0] > 0.0 && weight[1] > 0.0 && weight[2] > 0.0)
    {
      return time;
    }
  }
  double first = Never;
  for (int i = 0; i < 3; ++i)
  {
    const Vector3& begin = triangle.Corner[i];
    const Vector3& end = triangle.Corner[(i + 1) % 3];
    first = std::min(first, MeetEdge(begin, end, centre, displacement, radius));
    first = std::min(first, MeetCorner(begin, centre, displacement, radius));
  }
  return first;
}

} // namespace VolumeHaptics

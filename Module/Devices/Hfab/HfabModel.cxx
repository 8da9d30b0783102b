// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Hfab/HfabModel.h"

#include "Core/Safety/SafetyStage.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr double Circle = 6.283185307179586;

/**
 * Lengths of Polhem's linkage (m): distance between the cranks, both cranks, the rod, from c to b,
 * and from b to the tip.
 */
constexpr double L0 = 0.034;
constexpr double L1 = 0.165;
constexpr double L2 = 0.025;
constexpr double L3 = 0.190;
constexpr double L4 = 0.034;
constexpr double L5 = 0.1308;

DeviceLimits MakeLimits(double force, double stiffness, double damping, double radius)
{
  DeviceLimits limits;
  limits.MaximumForce = force;
  limits.MaximumStiffness = stiffness;
  limits.MaximumDamping = damping;
  limits.MaximumSpeed = 2.5;
  limits.WorkspaceRadius = radius;
  return limits;
}

const HfabGeometry Polhem{ "Polhem", true, { 0.0288534, 0.0136981, 0.0137281 },
  { 0.175, 0.100, 0.100 }, {}, { 0.2045, 0.0, 0.0325 }, { 0.0603, 0.0538, 0.0538 }, 4096.0,
  { 1.0, -1.0, 1.0 }, { 8312, -10366, 19764, 0, 30, 0 }, 3000.0, 1024.0,
  MakeLimits(5.0, 2000.0, 1.0, 0.150) };

const HfabGeometry Phantom{ "PHANToM", false, { 0.013, 0.010, 0.010 }, { 0.117, 0.077, 0.077 },
  { 0.0, 0.138, 0.112 }, { 0.138, 0.0, -0.097 }, { 0.0234, 0.0234, 0.0234 }, 4000.0,
  { -1.0, 1.0, -1.0 }, { 0, 7700, 0, 0, 0, 0 }, 3000.0, 2000.0,
  MakeLimits(5.0, 800.0, 8.0, 0.100) };

// Use half of the published limits, because published builds have motors of either 0.0259 or 0.0603
// N m/A (WoodenDriver.h).
const HfabGeometry Wooden{ "WoodenHaptics", false, { 0.010, 0.010, 0.010 }, { 0.160, 0.120, 0.120 },
  { 0.080, 0.205, 0.245 }, { 0.22, 0.0, 0.08 }, { 0.0259, 0.0259, 0.0259 }, 2000.0,
  { 1.0, -1.0, -1.0 }, { 0, 0, -6000, 0, 0, 0 }, 3000.0, 0.0, MakeLimits(2.5, 500.0, 4.0, 0.100) };

struct Point
{
  double X = 0.0;
  double Y = 0.0;
};
Point U(double angle) noexcept
{
  return { std::cos(angle), std::sin(angle) };
}
Point operator+(const Point& a, const Point& b) noexcept
{
  return { a.X + b.X, a.Y + b.Y };
}
Point operator*(double s, const Point& a) noexcept
{
  return { s * a.X, s * a.Y };
}
Point operator-(const Point& a, const Point& b) noexcept
{
  return a + (-1.0) * b;
}
double Dot(const Point& a, const Point& b) noexcept
{
  return a.X * b.X + a.Y * b.Y;
}
/** Returns a vector rotated to the left by 90 degrees. The derivative of U(q) is Left(U(q)). */
Point Left(const Point& a) noexcept
{
  return { -a.Y, a.X };
}

/** A state of the linkage in its plane. */
struct Linkage
{
  Linkage(double upper, double lower) noexcept
  {
    const Point a = Point{ -0.5 * L0, 0.0 } + L2 * U(lower);
    const Point b = Point{ 0.5 * L0, 0.0 } + L1 * U(upper);
    const Point way = a - b;
    const double distance = std::sqrt(Dot(way, way));
    const double cosine = (L4 * L4 + distance * distance - L3 * L3) / (2.0 * L4 * distance);
    // This is also false for NaN.
    this->Exists = std::abs(cosine) < 1.0;
    if (!this->Exists)
    {
      return;
    }
    // The vector from b to c is along -U(l), so l is the vector's angle minus half a turn.
    this->Angle = std::atan2(way.Y, way.X) - std::acos(cosine) - 0.5 * Circle;
    const Point u = U(this->Angle);
    this->Tip = b + L5 * u;
    // Solve (c - a) . (db - L4 u' dl - da) = 0.
    const Point rod = b - L4 * u - a;
    const double lever = L4 * Dot(rod, Left(u));
    const Point byUpper = L1 * Left(U(upper));
    const Point byLower = L2 * Left(U(lower));
    this->ByUpper = byUpper + (L5 * Dot(rod, byUpper) / lever) * Left(u);
    this->ByLower = (-L5 * Dot(rod, byLower) / lever) * Left(u);
  }

  bool Exists = false;
  double Angle = 0.0;
  Point Tip;
  Point ByUpper; ///< derivatives of the tip
  Point ByLower;
};

///@{
/** Return rotations about the arm's x, y and z axes. */
Quaternion AboutX(double angle) noexcept
{
  return { std::cos(0.5 * angle), std::sin(0.5 * angle), 0.0, 0.0 };
}
Quaternion AboutY(double angle) noexcept
{
  return { std::cos(0.5 * angle), 0.0, std::sin(0.5 * angle), 0.0 };
}
Quaternion AboutZ(double angle) noexcept
{
  return { std::cos(0.5 * angle), 0.0, 0.0, std::sin(0.5 * angle) };
}
///@}

} // namespace

const HfabGeometry* HfabModel::Find(int model) noexcept
{
  const HfabGeometry* const models[] = { &Polhem, &Phantom, &Wooden };
  return model >= 1 && model <= 3 ? models[model - 1] : nullptr;
}

HfabModel::Angles HfabModel::ComputeAngles(
  const HfabGeometry& geometry, const Counts& counts) noexcept
{
  Angles angles{};
  for (std::size_t j = 0; j < angles.size(); ++j)
  {
    angles[j] = geometry.Signs[j] * geometry.Capstan[j] / geometry.Body[j] * Circle * counts[j] /
      geometry.CountsPerTurn;
  }
  return angles;
}

bool HfabModel::ComputeTip(
  const HfabGeometry& geometry, const Angles& angles, Vector3& tip) noexcept
{
  double reach = 0.0;
  double height = 0.0;
  if (geometry.IsLinkage)
  {
    const Linkage linkage(angles[1], angles[2]);
    if (!linkage.Exists)
    {
      return false;
    }
    reach = linkage.Tip.X;
    height = linkage.Tip.Y;
  }
  else
  {
    const std::array<double, 3>& l = geometry.Lengths;
    reach = l[1] * std::sin(angles[1]) + l[2] * std::sin(angles[2]);
    height = l[0] + l[1] * std::cos(angles[1]) - l[2] * std::cos(angles[2]);
  }
  tip =
    Vector3{ reach * std::cos(angles[0]), reach * std::sin(angles[0]), height } - geometry.Origin;
  return IsFinite(tip);
}

bool HfabModel::ComputeJacobian(
  const HfabGeometry& geometry, const Angles& angles, Matrix3& jacobian) noexcept
{
  double reach = 0.0;
  Point byB;
  Point byC;
  if (geometry.IsLinkage)
  {
    const Linkage linkage(angles[1], angles[2]);
    if (!linkage.Exists)
    {
      return false;
    }
    reach = linkage.Tip.X;
    byB = linkage.ByUpper;
    byC = linkage.ByLower;
  }
  else
  {
    const std::array<double, 3>& l = geometry.Lengths;
    reach = l[1] * std::sin(angles[1]) + l[2] * std::sin(angles[2]);
    byB = { l[1] * std::cos(angles[1]), -l[1] * std::sin(angles[1]) };
    byC = { l[2] * std::cos(angles[2]), l[2] * std::sin(angles[2]) };
  }
  const double sine = std::sin(angles[0]);
  const double cosine = std::cos(angles[0]);
  jacobian = Matrix3::FromColumns({ -sine * reach, cosine * reach, 0.0 },
    { cosine * byB.X, sine * byB.X, byB.Y }, { cosine * byC.X, sine * byC.X, byC.Y });
  return IsFinite(jacobian.Row[0]) && IsFinite(jacobian.Row[1]) && IsFinite(jacobian.Row[2]);
}

Quaternion HfabModel::ComputeOrientation(
  const HfabGeometry& geometry, const Counts& counts) noexcept
{
  const Angles angles = ComputeAngles(geometry, counts);
  const double perCount = Circle / geometry.GimbalCounts;
  const double d = -perCount * counts[3];
  const double e = perCount * counts[4];
  const Quaternion gimbal = geometry.IsLinkage ? AboutX(d) * AboutY(-e) : AboutZ(d) * AboutY(e);
  // The angle of the forearm above the horizontal.
  const double lift =
    geometry.IsLinkage ? Linkage(angles[1], angles[2]).Angle : angles[2] - 0.25 * Circle;
  const Quaternion turn = AboutZ(angles[0]) * AboutY(-lift) * gimbal * AboutX(perCount * counts[5]);
  const Vector3 axis = ToDevice({ turn.X, turn.Y, turn.Z });
  return { turn.W, axis.X, axis.Y, axis.Z };
}

std::array<int, 3> HfabModel::ComputeCurrents(
  const HfabGeometry& geometry, const Angles& angles, const Vector3& force) noexcept
{
  Matrix3 jacobian;
  if (!ComputeJacobian(geometry, angles, jacobian))
  {
    return {};
  }
  const Vector3 torque = Transpose(jacobian) * force;
  std::array<double, 3> milliamperes{ torque.X, torque.Y, torque.Z };
  for (std::size_t j = 0; j < milliamperes.size(); ++j)
  {
    milliamperes[j] *= 1000.0 * geometry.Signs[j] * geometry.Capstan[j] /
      (geometry.Body[j] * geometry.TorqueConstant[j]);
  }
  SaturateTogether(milliamperes.data(), 3, geometry.MaximumCurrent);
  std::array<int, 3> currents{};
  for (std::size_t j = 0; j < currents.size(); ++j)
  {
    currents[j] = static_cast<int>(std::lround(milliamperes[j]));
  }
  return currents;
}

} // namespace VolumeHaptics

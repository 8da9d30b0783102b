// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that quaternions rotate according to Rodrigues' formula: v cos a + (n x v) sin a + n (n
 * v) (1 - cos a). Testing/VTK/Device/OrientationTest.cxx compares quaternions with those of VTK.
 */

#include "Core/Math/Quaternion.h"

#include <gtest/gtest.h>

#include <random>

using namespace VolumeHaptics;

namespace
{
constexpr double Nan = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Largest = std::numeric_limits<double>::max();

class Turns
{
public:
  double Number() { return this->Uniform(this->Engine); }
  Vector3 Axis()
  {
    const Vector3 v{ this->Number(), this->Number(), this->Number() };
    return Norm(v) > 0.1 ? (1.0 / Norm(v)) * v : this->Axis();
  }
  double Angle() { return 3.5 * this->Number(); }

private:
  std::mt19937_64 Engine{ 20 };
  std::uniform_real_distribution<double> Uniform{ -1.0, 1.0 };
};

Vector3 Rodrigues(const Vector3& axis, double angle, const Vector3& v)
{
  return std::cos(angle) * v + std::sin(angle) * Cross(axis, v) +
    (1.0 - std::cos(angle)) * Dot(axis, v) * axis;
}

Quaternion Turn(const Vector3& axis, double angle)
{
  const Vector3 n = std::sin(0.5 * angle) * axis;
  return { std::cos(0.5 * angle), n.X, n.Y, n.Z };
}

/// Returns the distance between two orientations. q and -q are the same orientation.
double Difference(const Quaternion& a, const Quaternion& b)
{
  const double dot = a.W * b.W + a.X * b.X + a.Y * b.Y + a.Z * b.Z;
  const Quaternion same = (dot < 0.0 ? -1.0 : 1.0) * b;
  const Quaternion d{ a.W - same.W, a.X - same.X, a.Y - same.Y, a.Z - same.Z };
  return std::sqrt(SquaredNorm(d));
}
} // namespace

TEST(Quaternions, TurnAsRodriguesSays)
{
  Turns random;
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 axis = random.Axis();
    const double angle = random.Angle();
    const Vector3 v{ random.Number(), random.Number(), random.Number() };
    const Vector3 turned = ToMatrix(Turn(axis, angle)) * v;
    ASSERT_LT(Norm(turned - Rodrigues(axis, angle, v)), 1e-14);
    ASSERT_LT(Norm(ToMatrix(Conjugate(Turn(axis, angle))) * v - Rodrigues(axis, -angle, v)), 1e-14);
  }
}

TEST(Quaternions, AProductTurnsByTheRightOneFirst)
{
  Turns random;
  for (int i = 0; i < 2000; ++i)
  {
    const Vector3 first = random.Axis();
    const Vector3 second = random.Axis();
    const double a = random.Angle();
    const double b = random.Angle();
    const Vector3 v = random.Axis();
    const Vector3 turned = ToMatrix(Turn(second, b) * Turn(first, a)) * v;
    ASSERT_LT(Norm(turned - Rodrigues(second, b, Rodrigues(first, a, v))), 1e-14);
  }
}

TEST(Quaternions, ComeBackFromAMatrix)
{
  Turns random;
  const Vector3 corners[] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, random.Axis(), random.Axis(),
    random.Axis() };
  for (const Vector3& axis : corners)
  {
    // Test angles near half a turn, where the first component vanishes, and near 0, where the
    // others vanish.
    for (const double angle : { 0.0, 1e-9, 1.0, 2.0, 3.0, 3.141592653589793 - 1e-9,
           3.141592653589793, 3.141592653589793 + 1e-9, 6.0 })
    {
      const Vector3 columns[] = { Rodrigues(axis, angle, { 1, 0, 0 }),
        Rodrigues(axis, angle, { 0, 1, 0 }), Rodrigues(axis, angle, { 0, 0, 1 }) };
      const Quaternion q = ToQuaternion(Matrix3::FromColumns(columns[0], columns[1], columns[2]));
      EXPECT_LT(Difference(q, Turn(axis, angle)), 1e-14) << angle;
    }
  }
  for (int i = 0; i < 2000; ++i)
  {
    const Quaternion q = Turn(random.Axis(), random.Angle());
    ASSERT_LT(Difference(ToQuaternion(ToMatrix(q)), q), 1e-14);
  }
}

TEST(Quaternions, OfAboutUnitNormBecomeUnit)
{
  Turns random;
  for (int i = 0; i < 20000; ++i)
  {
    const Quaternion exact = Turn(random.Axis(), random.Angle());
    Quaternion q = (1.0 + 0.0099 * random.Number()) * exact;
    ASSERT_TRUE(MakeUnit(q));
    ASSERT_NEAR(SquaredNorm(q), 1.0, 1e-15);
    ASSERT_LT(Difference(q, exact), 1e-15);
    Quaternion again = q;
    ASSERT_TRUE(MakeUnit(again));
    ASSERT_TRUE(IsIdentical(again, q)) << "to the bit";
  }
}

TEST(Quaternions, OfAnotherNormAreNoOrientation)
{
  for (const Quaternion& bad : { Quaternion{ 0.0, 0.0, 0.0, 0.0 },
         Quaternion{ 0.98, 0.0, 0.0, 0.0 }, Quaternion{ 1.02, 0.0, 0.0, 0.0 },
         Quaternion{ Nan, 0.0, 0.0, 0.0 }, Quaternion{ 1.0, 0.0, Nan, 0.0 },
         Quaternion{ 0.0, Infinity, 0.0, 0.0 }, Quaternion{ 1.0, 0.0, 0.0, -Infinity },
         Quaternion{ Largest, Largest, 0.0, 0.0 }, Quaternion{ 1e-320, 0.0, 0.0, 0.0 } })
  {
    Quaternion q = bad;
    EXPECT_FALSE(MakeUnit(q)) << bad.W << " " << bad.X << " " << bad.Y << " " << bad.Z;
  }
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests walls in volumes whose voxels are not cubes. The wall is V = low + h Phi(d / s), where d is
 * the distance from a plane. Across an axis, or in the plane of two axes with the same spacing, the
 * samples equal those of cubes with this spacing, and so must contact and force. Where the samples
 * resolve the wall, the contact is at d = 0. Across thick slices, and where the wall leans between
 * slices, only the linear interpolation of the samples is known, which the test computes itself.
 */

#include "Rigs/CoreScene.h"
#include "Rigs/Slanted.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace coretest;

namespace
{
constexpr double Low = -1000.0;
constexpr double High = 60.0;
constexpr double Blur = 0.45; // mm
constexpr double Fine = 0.5;  // mm
constexpr double Depth = 1.5; // depth of the press behind the wall's plane (mm)
constexpr std::int64_t Samples = 28;

constexpr GradientEstimator Estimators[] = { GradientEstimator::CentralDifference,
  GradientEstimator::Gaussian, GradientEstimator::CubicBSpline };

double Phi(double x)
{
  return 0.5 * std::erfc(-x / std::sqrt(2.0));
}

Vector3 Thick(double ratio, int axis)
{
  return { axis == 0 ? ratio * Fine : Fine, axis == 1 ? ratio * Fine : Fine,
    axis == 2 ? ratio * Fine : Fine };
}

/// A volume with a wall through a point between the samples, near the volume's centre.
struct Wall
{
  /**
   * @param normal normal of the wall along the volume's axes
   * @param place position of the wall between the two middle slices of the volume
   * @param thickness thickness (mm); if finite, the wall is a sheet with air on both sides
   */
  Wall(const Vector3& spacing, const Matrix3& turn, const Vector3& normal, double place = 0.6,
    double blur = Blur, double thickness = HUGE_VAL)
    : IndexToWorld{ turn *
        Matrix3{ { { spacing.X, 0, 0 }, { 0, spacing.Y, 0 }, { 0, 0, spacing.Z } } },
      { 3.0, -7.0, 11.0 } }
    , Normal((1.0 / Norm(normal)) * (turn * normal))
    , Centre(IndexToWorld({ 13.3, 14.2, 13.0 + place }))
    , Width(blur)
    , Thickness(thickness)
    , Volume(ScalarType::Float64, { Samples, Samples, Samples })
  {
    this->Volume.Fill<double>(
      [this](std::int64_t i, std::int64_t j, std::int64_t k) {
        return this->At({ double(i), double(j), double(k) });
      });
  }

  double At(const Vector3& index) const
  {
    const double depth = Dot(this->IndexToWorld(index) - this->Centre, this->Normal);
    return Low +
      (High - Low) * (Phi(depth / this->Width) - Phi((depth - this->Thickness) / this->Width));
  }

  /// Describes a model with materials like those of "CT contrast" for air, lung, fat and muscle,
  /// without friction and drag.
  HapticModelDescription Describe(GradientEstimator estimator, int radius) const
  {
    HapticModelDescription description = coretest::Describe(this->Volume);
    description.IndexToWorld = this->IndexToWorld;
    description.Estimator = estimator;
    description.KernelRadius = radius;
    description.Material.Stiffness = { { -955.0, 0.0 }, { -900.0, 400.0 } };
    description.Material.SurfaceStrength = { { -955.0, 0.0 }, { -900.0, 0.4 }, { -500.0, 0.4 },
      { -150.0, 1.0 }, { -80.0, 1.0 }, { 50.0, 2.2 } };
    description.Material.Distinctness = { { 8.0, 0.0 }, { 40.0, 1.0 } };
    return description;
  }

  const Affine3 IndexToWorld;
  const Vector3 Normal;
  const Vector3 Centre;
  const double Width;
  const double Thickness;
  TestVolume Volume;
};

/**
 * Returns the largest distance between the true middle u = t shift and the middle of (1 - t) Phi(u)
 * + t Phi(u - shift), which is the linear interpolation of two edges with a blur of 1. Uses
 * bisection.
 */
double FarthestMiddle(double shift)
{
  double farthest = 0.0;
  for (double t = 0.005; t < 1.0; t += 0.005)
  {
    double low = -1.0;
    double high = shift + 1.0;
    for (int i = 0; i < 50; ++i)
    {
      const double u = 0.5 * (low + high);
      ((1.0 - t) * Phi(u) + t * Phi(u - shift) > 0.5 ? high : low) = u;
    }
    farthest = std::max(farthest, std::abs(low - t * shift));
  }
  return farthest;
}

/// Interpolates the samples around a position linearly. Returns the result as a fraction of the
/// wall's height.
double InterpolatedFraction(const Wall& wall, const Vector3& world)
{
  const Vector3 index = Inverse(wall.IndexToWorld)(world);
  const double at[3] = { index.X, index.Y, index.Z };
  double sum = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    double weight = 1.0;
    std::int64_t sample[3];
    for (int a = 0; a < 3; ++a)
    {
      const double low = std::floor(at[a]);
      const bool isUpper = (corner >> a & 1) != 0;
      weight *= isUpper ? at[a] - low : 1.0 - (at[a] - low);
      sample[a] = static_cast<std::int64_t>(low) + (isUpper ? 1 : 0);
    }
    sum += weight * wall.Volume(sample[0], sample[1], sample[2]);
  }
  return (sum - Low) / (High - Low);
}

struct Press
{
  double Contact = HUGE_VAL; ///< tip (mm behind the plane) at a force of 20 mN
  double Force = 0.0;        ///< final force along the normal (N)
  double Most = 0.0;         ///< largest force in any direction during the press (N)
  Vector3 Proxy;             ///< final position (world)
};

/// Moves the tip straight from 3 mm in front of the plane to `depth` (mm) behind it, by 0.05 mm per
/// tick.
Press PressInto(const Wall& wall, const HapticModelDescription& description, double depth = Depth)
{
  const HapticModel model(description);
  ServoState state;
  TickRecord record;
  Press press;
  const int ticks = static_cast<int>(std::lround((3.0 + depth) / 0.05));
  for (int i = 0; i <= ticks; ++i)
  {
    const double at = -3.0 + (3.0 + depth) * i / ticks;
    Tick(model, state, 0.001 * (wall.Centre + at * wall.Normal), record);
    press.Most = std::max(press.Most, Norm(record.Force));
    if (record.NormalForce > 0.02 && press.Contact == HUGE_VAL)
    {
      press.Contact = Dot(1000.0 * record.Proxy - wall.Centre, wall.Normal);
    }
  }
  press.Proxy = 1000.0 * record.Proxy;
  press.Force = -Dot(record.Force, wall.Normal);
  return press;
}
} // namespace

TEST(ThickSlices, AWallIsFeltAsInCubes)
{
  for (const double ratio : { 2.0, 5.0, 10.0 })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      // Normals along the two fine axes, and halfway between them.
      Vector3 normals[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, -1 } };
      normals[axis] = normals[(axis + 1) % 3] + normals[(axis + 2) % 3];
      for (const Vector3& normal : normals)
      {
        for (const Matrix3& turn : { Matrix3{}, Slanted() })
        {
          const Wall cubes({ Fine, Fine, Fine }, turn, normal);
          const Wall wall(Thick(ratio, axis), turn, normal);
          for (const GradientEstimator estimator : Estimators)
          {
            for (const int radius : { 1, 2, 3 })
            {
              SCOPED_TRACE(testing::Message()
                << "1:" << ratio << " along axis " << axis << ", normal " << normal.X << " "
                << normal.Y << " " << normal.Z << ", estimator " << int(estimator) << ", radius "
                << radius);
              const Press expected = PressInto(cubes, cubes.Describe(estimator, radius));
              const Press felt = PressInto(wall, wall.Describe(estimator, radius));
              EXPECT_NEAR(felt.Contact, expected.Contact, 0.05) << "a tick of the press";
              EXPECT_NEAR(felt.Contact, 0.0, 0.25 * Fine);
              EXPECT_NEAR(felt.Force, expected.Force, 1e-4 * expected.Force);
            }
          }
        }
      }
    }
  }
}

TEST(ThickSlices, ALeaningWallThatIsResolvedIsWhereItIs)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const Vector3& normal :
      { Vector3{ 1, -1, 0 }, Vector3{ 1, 0, 1 }, Vector3{ 0, 1, 1 }, Vector3{ 1, 2, 3 } })
    {
      for (const Matrix3& turn : { Matrix3{}, Slanted() })
      {
        const Wall cubes({ Fine, Fine, Fine }, turn, normal);
        const Wall wall(Thick(1.6, axis), turn, normal);
        for (const GradientEstimator estimator : Estimators)
        {
          for (const int radius : { 1, 2, 3 })
          {
            SCOPED_TRACE(testing::Message()
              << "along axis " << axis << ", normal " << normal.X << " " << normal.Y << " "
              << normal.Z << ", estimator " << int(estimator) << ", radius " << radius);
            const Press expected = PressInto(cubes, cubes.Describe(estimator, radius));
            const Press felt = PressInto(wall, wall.Describe(estimator, radius));
            EXPECT_NEAR(felt.Contact, 0.0, 0.25 * Fine);
            EXPECT_NEAR(felt.Force, expected.Force, 0.02 * expected.Force);
          }
        }
      }
    }
  }
}

TEST(ThickSlices, ALeaningWallIsNoFartherOffThanItsInterpolation)
{
  constexpr double stiffness = 0.4; // N/mm
  for (const double ratio : { 2.0, 3.0, 5.0, 10.0 })
  {
    for (const double degrees : { 15.0, 30.0, 45.0, 60.0, 75.0, 90.0 })
    {
      const double angle = degrees / 57.29577951308232;
      const double shift = ratio * Fine * std::sin(angle) / Blur;
      // The sum of two edges up to 2 blurs apart has one steepest place. At larger distances there
      // are two edges, and the first one may be felt. The spline is wider, so it merges edges that
      // are farther apart.
      const bool isOne = shift <= 2.0;
      if (shift > 3.4)
      {
        continue;
      }
      const double off = Blur * FarthestMiddle(shift);
      const Vector3 normal{ std::cos(angle), 0.0, std::sin(angle) };
      const Wall cubes({ Fine, Fine, Fine }, Slanted(), normal);
      for (const double place : { 0.0, 0.23, 0.5, 0.77 })
      {
        const Wall wall(Thick(ratio, 2), Slanted(), normal, place);
        for (const GradientEstimator estimator : Estimators)
        {
          for (const int radius : { 1, 2, 3 })
          {
            if (!isOne && estimator != GradientEstimator::CubicBSpline)
            {
              continue;
            }
            SCOPED_TRACE(testing::Message()
              << "1:" << ratio << ", " << degrees << " degrees, place " << place << ", estimator "
              << int(estimator) << ", radius " << radius);
            const Press expected = PressInto(cubes, cubes.Describe(estimator, radius));
            const Press felt = PressInto(wall, wall.Describe(estimator, radius));
            EXPECT_NEAR(felt.Contact, 0.0, off + 0.05) << "a tick of the press";
            EXPECT_NEAR(felt.Force, expected.Force, stiffness * off + 0.02 * expected.Force);
          }
        }
      }
    }
  }
}

TEST(ThickSlices, ASplineHoldsAnEdgeWithAnyRadius)
{
  // The spline reads 64 samples for any radius, so contact and force are independent of the radius.
  for (const double blur : { 0.05, Blur })
  {
    for (const Vector3& normal : { Vector3{ 1, 0, 0 }, Vector3{ 1, 2, 3 } })
    {
      const Wall wall({ Fine, Fine, Fine }, Slanted(), normal, 0.0, blur);
      const Press one = PressInto(wall, wall.Describe(GradientEstimator::CubicBSpline, 1));
      for (const int radius : { 2, 3, 6 })
      {
        SCOPED_TRACE(testing::Message()
          << "blur " << blur << " mm, normal " << normal.Y << ", radius " << radius);
        const Press felt = PressInto(wall, wall.Describe(GradientEstimator::CubicBSpline, radius));
        EXPECT_NEAR(felt.Contact, one.Contact, 0.05);
        EXPECT_NEAR(felt.Force, one.Force, 0.02 * one.Force);
      }
    }
  }
}

TEST(ThickSlices, PaperFeelsNoSheetThatItsReachPasses)
{
  // The gradient begins at KernelRadius times the fine spacing in front of the sheet, and x_s is
  // KernelRadius times the largest spacing farther ahead. Behind sheets thinner than 2 (2.5 - 0.5)
  // mm, x_s is in air. The blur of both sides extends two blurs outward.
  const Vector3 normal{ 1, 0, 0 };
  for (const double thickness : { 1.0, 1.6, 4.0 - 4.0 * Blur })
  {
    const Wall slices(Thick(5.0, 2), Slanted(), normal, 0.6, Blur, thickness);
    const Wall cubes({ Fine, Fine, Fine }, Slanted(), normal, 0.6, Blur, thickness);
    const auto press = [=](const Wall& sheet, HapticSolver solver)
    {
      HapticModelDescription description = sheet.Describe(GradientEstimator::Gaussian, 2);
      description.Settings.Solver = solver;
      return PressInto(sheet, description, thickness + 1.0).Most;
    };
    EXPECT_EQ(press(slices, HapticSolver::Paper), 0.0) << thickness << " mm";
    EXPECT_GT(press(cubes, HapticSolver::Paper), 0.1) << thickness << " mm";
    EXPECT_GT(press(slices, HapticSolver::Precise), 0.1) << thickness << " mm";
  }
}

TEST(ThickSlices, AcrossThemAWallIsInTheMiddleOfItsSamples)
{
  for (const double ratio : { 2.0, 5.0, 10.0 })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      const double spacing = ratio * Fine;
      const Vector3 normal{ axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0 };
      const Wall wall(Thick(ratio, axis), Slanted(), normal);
      const Wall cubes({ spacing, spacing, spacing }, Slanted(), normal);
      // Find the two samples on either side of the middle level along the axis, and interpolate
      // between them.
      const double centre[3] = { 13.3, 14.2, 13.6 };
      const auto value = [&](double at)
      { return Low + (High - Low) * Phi((at - centre[axis]) * spacing / Blur); };
      double sample = std::floor(centre[axis]) - 1.0;
      for (; value(sample + 1.0) < 0.5 * (Low + High); sample += 1.0)
      {
      }
      const double part =
        (0.5 * (Low + High) - value(sample)) / (value(sample + 1.0) - value(sample));
      const double middle = (sample + part - centre[axis]) * spacing;
      for (const int radius : { 1, 2, 3 })
      {
        SCOPED_TRACE(
          testing::Message() << "1:" << ratio << " along axis " << axis << ", radius " << radius);
        for (const GradientEstimator estimator :
          { GradientEstimator::CentralDifference, GradientEstimator::Gaussian })
        {
          const double depth = middle + Depth;
          const Press felt = PressInto(wall, wall.Describe(estimator, radius), depth);
          EXPECT_NEAR(InterpolatedFraction(wall, felt.Proxy), 0.5, 0.06);
          const Press expected = PressInto(cubes, cubes.Describe(estimator, radius), depth);
          EXPECT_NEAR(felt.Contact, expected.Contact, 0.05) << "a tick of the press";
          EXPECT_NEAR(felt.Force, expected.Force, 1e-4 * expected.Force);
        }
      }
    }
  }
}

TEST(ThickSlices, AWallThatLeansBetweenThemIsFelt)
{
  for (const double ratio : { 2.0, 5.0, 10.0 })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const Vector3& normal :
        { Vector3{ 1, -1, 0 }, Vector3{ 1, 0, 1 }, Vector3{ 0, 1, 1 }, Vector3{ 1, 2, 3 } })
      {
        const Wall wall(Thick(ratio, axis), Slanted(), normal);
        for (const int radius : { 1, 2, 3 })
        {
          for (const GradientEstimator estimator :
            { GradientEstimator::CentralDifference, GradientEstimator::Gaussian })
          {
            SCOPED_TRACE(testing::Message()
              << "1:" << ratio << " along axis " << axis << ", normal " << normal.X << " "
              << normal.Y << " " << normal.Z << ", estimator " << int(estimator) << ", radius "
              << radius);
            const Press felt =
              PressInto(wall, wall.Describe(estimator, radius), Depth + 0.5 * ratio * Fine);
            const double fraction = InterpolatedFraction(wall, felt.Proxy);
            EXPECT_GE(fraction, 0.05) << "no more is known of where it is";
            EXPECT_LE(fraction, 0.95);
            EXPECT_GE(felt.Force, 0.3);
          }
        }
      }
    }
  }
}

TEST(ThickSlices, TheKernelCountsVoxelsAlongTheNormal)
{
  const TestVolume volume = MakeRamp(16);
  HapticModelDescription description = Describe(volume);
  description.IndexToWorld.Linear =
    Slanted() * Matrix3{ { { 0.5, 0, 0 }, { 0, 2.5, 0 }, { 0, 0, 1.25 } } };
  const HapticModel model(description);
  description.Settings.Solver = HapticSolver::Paper;
  const HapticModel paper(description);
  for (const Vector3& n :
    { Vector3{ 1, 0, 0 }, Vector3{ 0, 1, 0 }, Vector3{ 0, 0, 1 }, Vector3{ 0.6, 0.0, 0.8 } })
  {
    const Vector3 scaled{ n.X / 0.5, n.Y / 2.5, n.Z / 1.25 };
    EXPECT_NEAR(model.KernelLengthAlong(Slanted() * n), 0.002 / Norm(scaled), 1e-15);
    EXPECT_EQ(paper.KernelLengthAlong(Slanted() * n), paper.KernelLength);
  }
  EXPECT_NEAR(paper.KernelLength, 0.005, 1e-15);
  EXPECT_EQ(model.KernelLengthAlong({}), model.KernelLengthAlong({})) << "no normal is no NaN";
}

TEST(ThickSlices, CubesHaveOneLength)
{
  const TestVolume volume = MakeRamp(16);
  HapticModelDescription description = Describe(volume);
  for (const double spacing : { 1.0, 0.3, 0.7 })
  {
    description.IndexToWorld.Linear = spacing * Slanted();
    const HapticModel model(description);
    const Vector3 direction{ 0.36, 0.48, 0.8 };
    EXPECT_EQ(model.KernelLengthAlong(direction), model.KernelLength);
    EXPECT_TRUE(IsIdentical(model.ComputeReach(direction), direction));
  }
}

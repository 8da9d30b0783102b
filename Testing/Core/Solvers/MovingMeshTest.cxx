// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a sphere with a radius of 1 mm on moving meshes. The sphere rests on the mesh, so its force
 * is known at all times.
 */

#include "Rigs/SurfaceRig.h"

#include <cmath>
#include <functional>

using namespace coretest;

namespace
{
/// A mesh whose points move with the time steps, one unit of time apart. The mesh of each time step
/// contains the motions of its points to the next time step.
class MovingMesh : public testing::Test
{
protected:
  using Place = std::function<Vector3(const Vector3& point, int timeStep)>;

  HapticModelDescription Describe(
    const Corners& points, const Faces& faces, int timeSteps, const Place& place)
  {
    HapticModelDescription description = DescribeMesh(this->Volume, nullptr);
    for (int timeStep = 0; timeStep < timeSteps; ++timeStep)
    {
      Corners here;
      Corners motions;
      for (const Vector3& point : points)
      {
        here.push_back(place(point, timeStep));
        motions.push_back(place(point, timeStep + 1) - here.back());
      }
      VolumeTimeStep made{ static_cast<double>(timeStep), this->Volume.View, nullptr };
      made.Mesh = std::make_shared<SurfaceMesh>(here, faces, Corners{}, motions);
      description.TimeSteps.push_back(made);
    }
    description.Mesh = description.TimeSteps.front().Mesh;
    return description;
  }
  /// Describes a flat floor of 2 n^2 triangles, from -50 mm to 50 mm, that moves.
  HapticModelDescription DescribeFloor(int timeSteps, const Place& place)
  {
    Corners points;
    Faces faces;
    constexpr int n = 10;
    for (int p = 0; p < (n + 1) * (n + 1); ++p)
    {
      points.push_back({ 10.0 * (p % (n + 1)) - 50.0, 10.0 * (p / (n + 1)) - 50.0, 0.0 });
      if (p % (n + 1) < n && p / (n + 1) < n)
      {
        faces.push_back({ p, p + 1, p + n + 2 });
        faces.push_back({ p, p + n + 2, p + n + 1 });
      }
    }
    return this->Describe(points, faces, timeSteps, place);
  }

  const TestVolume Volume = MakeRamp();
};
} // namespace

/// V3: a floor rises by 5 mm per time step, presses against a tip that rests at 4 mm, and returns.
TEST_F(MovingMesh, AFloorThatComesPushesATipThatRests)
{
  const auto height = [](double time) { return time < 2.0 ? 5.0 * time : 20.0 - 5.0 * time; };
  Hand hand(this->DescribeFloor(5,
              [&](const Vector3& point, int timeStep) {
                return point + Vector3{ 0.0, 0.0, height(timeStep) };
              }),
    { 0.3, 0.2, 4.0 });
  double work = 0.0;
  double given = 0.0;
  for (int tick = 1; tick <= 4000; ++tick)
  {
    hand.State.DataTime = 0.001 * tick;
    const double before = hand.Record.Force.Z;
    hand.Tick();
    const double force = 0.5 * std::max(0.0, height(hand.State.DataTime) + 1.0 - 4.0);
    ASSERT_NEAR(hand.Record.Force.Z, force, 1e-4) << "tick " << tick;
    ASSERT_LT(std::hypot(hand.Record.Force.X, hand.Record.Force.Y), 1e-9) << "tick " << tick;
    work += hand.Record.WallWork;
    given += 0.5 * (before + hand.Record.Force.Z) * 0.001 *
      (height(hand.State.DataTime) - height(hand.State.DataTime - 0.001));
    if (tick == 2000)
    {
      // This is the energy of the spring of 500 N/m, compressed by 7 mm.
      EXPECT_NEAR(work, 0.5 * 500.0 * 0.007 * 0.007, 1e-5);
    }
  }
  EXPECT_NEAR(given, 0.0, 1e-5);
}

/// The floor jumps by some millimetres in a tick. It must not pass through the sphere.
TEST_F(MovingMesh, AFastFloorDoesNotPass)
{
  Hand hand(this->DescribeFloor(3,
              [](const Vector3& point, int timeStep) {
                return point + Vector3{ 0.0, 0.0, 4.0 * timeStep };
              }),
    { 1.3, 2.2, 3.0 });
  for (const double time : { 0.0, 0.9, 1.9, 0.8, 2.0 })
  {
    hand.State.DataTime = time;
    hand.Tick();
    hand.Tick();
    EXPECT_NEAR(hand.Record.Force.Z, 0.5 * std::max(0.0, 4.0 * time + 1.0 - 3.0), 1e-4)
      << "at " << time;
  }
}

/// A flat floor that slides below a sphere leaves it at rest; a sloping floor that slides pushes it
/// up.
TEST_F(MovingMesh, ASlopeThatSlidesLiftsTheSphere)
{
  constexpr double slope = 0.2;
  const auto at = [](const Vector3& point, int timeStep) {
    return Vector3{ point.X - 5.0 * timeStep, point.Y, slope * point.X };
  };
  Hand hand(this->DescribeFloor(4, at), { 0.0, 0.2, 5.0 });
  hand.Lead({ 0.0, 0.2, -1.0 });
  const double length = std::hypot(1.0, slope);
  for (int tick = 1; tick <= 3000; ++tick)
  {
    hand.State.DataTime = 0.001 * tick;
    hand.Tick();
    // Depth of the tip below the plane z = slope (x + 5 t), plus the sphere's radius of 1 mm.
    const double deep = (slope * 5.0 * hand.State.DataTime + 1.0) / length + 1.0;
    if (tick > 1)
    {
      ASSERT_NEAR(Norm(hand.Record.Force), 0.5 * std::max(0.0, deep), 0.02) << "tick " << tick;
    }
  }
}

/// With displacements, a sliding floor carries a sticking sphere along, until the sphere slips at
/// the friction of 0.4 times 1 N. Without displacements, the sphere stays.
TEST_F(MovingMesh, AFloorThatSlidesTakesAlongWhatSticks)
{
  const auto at = [](const Vector3& point, int timeStep) {
    return point + Vector3{ 5.0 * timeStep, 0.0, 0.0 };
  };
  HapticModelDescription description = this->DescribeFloor(3, at);
  description.Material.Friction = ConstantPolyline(0.4);
  const std::int64_t* const n = this->Volume.View.Dimensions;
  std::vector<double> motion(3 * n[0] * n[1] * n[2]);
  for (std::size_t i = 0; i < motion.size(); i += 3)
  {
    motion[i] = 5.0;
  }
  for (const bool isKnown : { true, false })
  {
    for (VolumeTimeStep& timeStep : description.TimeSteps)
    {
      timeStep.Displacements = { isKnown ? motion.data() : nullptr, ScalarType::Float64 };
    }
    // Start inside a triangle, because at an edge both triangles hold the sphere.
    Hand hand(description, { 8.0, 2.0, 4.0 });
    hand.Lead({ 8.0, 2.0, -1.0 });
    for (int tick = 1; tick <= 1200; ++tick)
    {
      hand.State.DataTime = 0.001 * tick;
      hand.Tick();
      const double along = isKnown ? std::min(0.4, 0.5 * 5.0 * hand.State.DataTime) : 0.0;
      ASSERT_NEAR(hand.Record.Force.X, along, 1e-3) << "tick " << tick;
      ASSERT_NEAR(hand.Record.Force.Z, 1.0, 1e-3) << "tick " << tick;
    }
  }
}

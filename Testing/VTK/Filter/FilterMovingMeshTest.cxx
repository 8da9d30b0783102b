// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests SURFACE_PROXY on the time steps of a source. The mesh moves with the volume, and pushes a
 * resting tip.
 */

#include "Rigs/ApiRig.h"
#include "Rigs/TimeSource.h"

#include <vtkAlgorithmOutput.h>

#include <algorithm>
#include <cmath>

using namespace apitest;

namespace
{
constexpr double MeshStiffness = 500.0;
constexpr double MeshRest = 12.0;

/// Returns the x coordinate (mm) of the wall: 9 at time 10, increasing by 1 per unit of time.
double MeshWallAt(double time)
{
  return 9.0 + time - 10.0;
}

class FilterMovingMesh : public ApiTest
{
protected:
  FilterMovingMesh()
  {
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    this->Filter->SetMethodToSurfaceProxy();
    this->Filter->SetIsoValue(500.0);
  }
  vtkNew<TimeSource> Source;
};
} // namespace

/// The proxy is a sphere of 1 mm that rests against the mesh of the moving wall.
TEST_F(FilterMovingMesh, AMeshMovesWithItsVolume)
{
  this->Source->Steps = { 10.0, 11.0, 12.0, 13.0, 14.0 };
  this->Source->Make = [](double time)
  {
    return MakeImage(24, VTK_DOUBLE,
      [wall = MeshWallAt(time)](const Point& p)
      { return 500.0 * (1.0 - std::tanh((p[0] - wall) / 1.5)); });
  };
  const Point at{ MeshRest, 11.5, 11.5 };
  this->Filter->SetPathData(MakePath({ at, at }, { 0.0, 1.0 }));
  this->Filter->SetTimeUnitsPerSecond(4.0);
  this->Filter->SetProxyRadius(1.0);
  vtkPolyData* const trace = this->Run(1001);
  for (vtkIdType tick = 0; tick <= 1000; ++tick)
  {
    const double wall = MeshWallAt(Get(trace, "DataTime", tick));
    ASSERT_NEAR(
      Get(trace, "Force", tick), 0.001 * MeshStiffness * std::max(0.0, wall + 1.0 - MeshRest), 1e-3)
      << "tick " << tick;
  }
  this->Filter->SetSurfaceData(MakePath({ { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 } }, { 0.0, 1.0 }));
  this->ExpectError({ "surface on input port 2", "SetTimeUnitsPerSecond(0)" });
}

/// Case V1: the radius of a ball varies from 18 mm to 22 mm and back. The ball pushes a tip that
/// rests at 19 mm with up to 1.5 N; the proxy's radius of 0.1 mm adds to the depth.
TEST_F(FilterMovingMesh, AMeshThatBeatsPushesATipThatRests)
{
  const auto radius = [](int frame) { return 20.0 - 2.0 * std::cos(0.7853981633974483 * frame); };
  this->Source->Steps = { 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0 };
  this->Source->Make = [radius](double time)
  {
    return MakeImage(48, VTK_DOUBLE,
      [r = radius(static_cast<int>(time))](const Point& p)
      {
        const double rho = std::sqrt((p[0] - 23.6) * (p[0] - 23.6) + (p[1] - 23.6) * (p[1] - 23.6) +
          (p[2] - 23.6) * (p[2] - 23.6));
        return 500.0 * (1.0 - std::tanh((rho - r) / 1.5));
      });
  };
  const Point at{ 23.6 + 19.0 / std::sqrt(2.0), 23.6, 23.6 + 19.0 / std::sqrt(2.0) };
  this->Filter->SetPathData(MakePath({ at, at }, { 0.0, 1.0 }));
  this->Filter->SetTimeUnitsPerSecond(8.0);
  this->Filter->SetProxyRadius(0.1);
  vtkPolyData* const trace = this->Run(1001);
  double most = 0.0;
  for (vtkIdType tick = 0; tick <= 1000; ++tick)
  {
    const double time = Get(trace, "DataTime", tick);
    const int frame = std::min(static_cast<int>(time), 7);
    const double r = radius(frame) + (time - frame) * (radius(frame + 1) - radius(frame));
    const double force = std::hypot(Get(trace, "Force", tick, 0), Get(trace, "Force", tick, 2));
    ASSERT_NEAR(force, 0.001 * MeshStiffness * std::max(0.0, r + 0.1 - 19.0), 0.015)
      << "at " << time;
    most = std::max(most, force);
  }
  EXPECT_NEAR(most, 1.5 + 0.001 * MeshStiffness * 0.1, 0.015);
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests where the method SurfaceProxy starts its proxy if another method was used before at the
 * same position.
 */

#include "Rigs/MeshScene.h"
#include "Rigs/SurfaceRig.h"

#include "Core/Solvers/SurfaceProxy/SurfaceProxy.h"

using namespace coretest;

namespace
{
/// A ramp with a surface at z = 10 mm. The tissue above it is felt. The proxy starts at most 6 mm
/// deep.
class SurfaceEntry : public testing::Test
{
protected:
  SurfaceEntry()
  {
    this->Scene.Settings.IsoValue = 1000.0;
    this->Scene.Settings.HasIsoSurface = true;
  }
  /// Changes the method from `from` to the surface's. Returns the proxy's position (mm) after the
  /// change.
  Vector3 Enter(const Vector3& proxy, HapticMethod from = HapticMethod::ForceField)
  {
    HapticModelDescription other = this->Scene;
    other.Settings.Method = from;
    ServoState state;
    state.Enabled = true;
    state.Proxy = 0.001 * proxy;
    CarryState(HapticModel(other), HapticModel(this->Scene), state);
    return 1000.0 * state.Proxy;
  }

  const TestVolume Volume = MakeRamp();
  HapticModelDescription Scene = DescribeMesh(this->Volume, MakeFloor());
};
} // namespace

TEST_F(SurfaceEntry, GoesToTheNearestOutside)
{
  const Vector3 proxy = this->Enter({ 12.0, 11.0, 13.0 });
  EXPECT_EQ(proxy.X, 12.0);
  EXPECT_EQ(proxy.Y, 11.0);
  EXPECT_LE(proxy.Z, 9.0) << "a sphere of 1 mm";
  EXPECT_GE(proxy.Z, 8.0);
  this->Scene.Settings.Side = SurfaceSide::Lower;
  EXPECT_NEAR(this->Enter({ 12.0, 12.0, 7.0 }).Z, 11.5, 0.5);
}

/// A coarse image that replaces the volume has a surface 2 mm deeper, so its proxy is inside the
/// fine surface.
TEST_F(SurfaceEntry, ComesOutOfAFineSurfaceThatReplacesACoarseOne)
{
  HapticModelDescription coarse = this->Scene;
  coarse.ResidentShare = 0.5;
  coarse.Settings.IsoValue = 1200.0;
  const auto swap = [&](const Vector3& proxy)
  {
    ServoState state;
    state.Enabled = true;
    state.Proxy = 0.001 * proxy;
    CarryState(HapticModel(coarse), HapticModel(this->Scene), state);
    return 1000.0 * state.Proxy;
  };
  EXPECT_LE(swap({ 12.0, 11.0, 11.0 }).Z, 9.0) << "a sphere of 1 mm";
  const Vector3 free{ 12.0, 11.0, 8.5 };
  EXPECT_LE(Norm(swap(free) - free), 1e-12) << "it is outside of both";
  const Vector3 within{ 12.0, 11.0, 13.0 };
  EXPECT_LE(Norm(swap(within) - within), 1e-12) << "it is held from within";
}

TEST_F(SurfaceEntry, StaysWhereItIs)
{
  const auto expectStays = [this](const Vector3& proxy, HapticMethod from, const char* why)
  { EXPECT_LE(Norm(this->Enter(proxy, from) - proxy), 1e-12) << why; };
  expectStays({ 12.0, 12.0, 9.9 }, HapticMethod::Proxy, "it is outside");
  expectStays({ 12.0, 12.0, 16.1 }, HapticMethod::Proxy, "it is too deep");
  expectStays({ 12.0, 12.0, 13.0 }, HapticMethod::SurfaceProxy, "the method is the same");
  this->Scene.Settings.HasIsoSurface = false;
  expectStays({ 12.0, 12.0, 13.0 }, HapticMethod::Proxy, "the mesh is not where the value is");
}

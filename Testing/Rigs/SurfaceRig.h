// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Moves a hand on a mesh. */
#ifndef SurfaceRig_h
#define SurfaceRig_h

#include "CoreScene.h"
#include "MeshScene.h"

#include <gtest/gtest.h>

namespace coretest
{
/// Describes a mesh in millimetres, for a proxy of 1 mm radius and a stiffness of 500 N/m.
inline HapticModelDescription DescribeMesh(
  const TestVolume& volume, std::shared_ptr<const SurfaceMesh> mesh, double friction = 0.0)
{
  HapticModelDescription description = Describe(volume);
  description.Settings.Method = HapticMethod::SurfaceProxy;
  description.Settings.ProxyRadius = 1.0;
  description.Material.Friction = ConstantPolyline(friction);
  description.Mesh = std::move(mesh);
  return description;
}

/// Moves a tip along straight paths in small steps. Lengths are in mm.
class Hand
{
public:
  Hand(const HapticModelDescription& description, const Vector3& start)
    : Model(description)
    , Tip(start)
  {
    this->Tick();
  }
  const TickRecord& Lead(const Vector3& goal, double step = 0.1)
  {
    const Vector3 way = goal - this->Tip;
    const double steps = std::ceil(Norm(way) / step);
    const Vector3 from = this->Tip;
    for (double i = 1.0; i <= steps; i += 1.0)
    {
      this->Tip = from + (i / steps) * way;
      this->Tick();
    }
    return this->Record;
  }
  const TickRecord& Tick()
  {
    VolumeHaptics::Tick(this->Model, this->State, 0.001 * this->Tip, this->Record);
    return this->Record;
  }
  Vector3 Proxy() const { return 1000.0 * this->Record.Proxy; }

  const HapticModel Model;
  Vector3 Tip;
  ServoState State;
  TickRecord Record;
};
/// Fixture for a proxy of 1 mm radius, whose position (mm) the tests compare.
class SurfaceTest : public testing::Test
{
protected:
  void ExpectAt(const Hand& hand, const Vector3& proxy)
  {
    constexpr double tolerance = 1e-4; // mm
    EXPECT_LE(Norm(hand.Proxy() - proxy), tolerance);
    const Vector3 force = 0.5 * (proxy - hand.Tip);
    EXPECT_LE(Norm(hand.Record.Force - force), 0.5 * tolerance);
    EXPECT_FALSE(hand.Record.IsUnfinished);
  }

  const TestVolume Volume = MakeRamp();
};
} // namespace coretest

#endif

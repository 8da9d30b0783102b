// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a burr on a real head CT, which Examples/explore.sh fetches; without the CT, the test is
 * skipped. While the burr is pressed, its energy must remove tissue: Q = mu F v/U (method.md, "The
 * burr").
 */

#include "Rigs/BurrRig.h"

#include <gtest/gtest.h>

#include <fstream>

using namespace coretest;

namespace
{
/// Reads the samples of Cranium.mhd, the head CT whose header Data/head-ct.sh writes. Returns false
/// if they do not exist.
bool ReadHead(TestVolume& volume)
{
  std::vector<std::int16_t> samples(256 * 256 * 108);
  std::ifstream file(VolumeHaptics_HEAD_CT_SAMPLES, std::ios::binary);
  const std::size_t size = samples.size() * sizeof(samples[0]);
  if (!file.read(reinterpret_cast<char*>(samples.data()), static_cast<std::streamsize>(size)))
  {
    return false;
  }
  volume.Fill<std::int16_t>([&](std::int64_t i, std::int64_t j, std::int64_t k)
    { return samples[static_cast<std::size_t>(i + 256 * (j + 256 * k))]; });
  return true;
}
} // namespace

/// The explorer's burr: its radius is four voxels, and the level is that of the skin. The specific
/// energy is least at that level and largest at the largest value. At the top of the head, the burr
/// drills through 15 mm of bone.
TEST(BurrOnAHead, GoesOnInBoneForAMinute)
{
  TestVolume volume(ScalarType::Int16, { 256, 256, 108 });
  if (!ReadHead(volume))
  {
    GTEST_SKIP() << "There is no head CT. Cure: start Examples/explore.sh, which fetches it.";
  }
  const Vector3 spacing{ 0.957031, 0.957031, 1.5 };
  HapticModelDescription scene = Describe(volume);
  scene.IndexToWorld.Linear = { { { spacing.X, 0, 0 }, { 0, spacing.Y, 0 }, { 0, 0, spacing.Z } } };
  scene.Removal = std::make_shared<TissueRemoval>();
  scene.AirValue = -1024.0;
  BurrInHand settings;
  settings.Radius = 4.0 * std::cbrt(spacing.X * spacing.Y * spacing.Z);
  settings.Shell.Level = -300.0;
  constexpr double force = 10.0;
  BurrInVolume hand(scene, settings, { { -300.0, 0.5 }, { 3071.0, 10.0 } }, 500);
  Vector3 at{ 128.3 * spacing.X, 128.4 * spacing.Y, 107.0 * spacing.Z + 2.0 * settings.Radius };
  hand.Tick(at);
  double energy = 0.0;
  double earned = 0.0;
  for (int tick = 1; tick <= 60000; ++tick)
  {
    const double tool = 1000.0 * hand.Record.Shell.Tool.Position.Z;
    at.Z = std::max(at.Z - 0.05, tool - 1000.0 * force / settings.Shell.CouplingStiffness);
    hand.Tick(at);
    if (tick % 5000 == 0)
    {
      const int second = tick / 1000;
      EXPECT_NEAR(Norm(hand.Record.Shell.Force), force, 0.1) << "N after " << second << " s";
      EXPECT_GE(hand.Energy - energy, 0.9 * (hand.Earned - earned)) << "J until " << second << " s";
      energy = hand.Energy;
      earned = hand.Earned;
    }
  }
  EXPECT_LE(hand.Energy, hand.Earned);
  EXPECT_GE(hand.Energy, 0.99 * hand.Earned);
  EXPECT_GT(hand.Removed, 2000.0) << "mm^3";
}

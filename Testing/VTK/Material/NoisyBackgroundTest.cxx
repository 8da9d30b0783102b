// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests proposals for a background with noise, dark or bright, that extends close to the next
 * material. The background must not resist, and the functions of the other materials must be the
 * same as without noise.
 */

#include "Core/Proposal/MaterialProposal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

using namespace VolumeHaptics;

namespace
{
constexpr double Grey = 111.5; // grey level between 0 outside and 215 inside

/// Makes a proposal from two boundaries. A `sign` of -1 swaps bright and dark.
MaterialProposal Propose(double sign, std::optional<double> end)
{
  Boundary outer;
  outer.High = Grey;
  outer.LeastRise = Grey;
  outer.Width = outer.Voxel = 1.0;
  outer.Fraction = outer.Inward = 0.7;
  Boundary inner = outer;
  inner.Low = Grey;
  inner.High = 215.0;
  inner.LeastRise = inner.High - inner.Low;
  inner.Fraction = 0.3;
  std::vector<Boundary> boundaries = { outer, inner };
  EdgeLine first;
  first.High = Grey;
  first.Weight = 1.0;
  EdgeLine second = first;
  second.Low = Grey;
  second.High = inner.High;
  std::vector<EdgeLine> lines = { first, second };
  const auto turn = [sign](double& low, double& high)
  {
    low *= sign;
    high *= sign;
    if (sign < 0.0)
    {
      std::swap(low, high);
    }
  };
  for (EdgeLine& line : lines)
  {
    turn(line.Low, line.High);
  }
  for (Boundary& boundary : boundaries)
  {
    turn(boundary.Low, boundary.High);
    boundary.Inward = sign < 0.0 ? 1.0 - boundary.Inward : boundary.Inward;
  }
  ProposalFacts facts;
  facts.NoiseGradient = [](int) { return 0.0; };
  if (end)
  {
    facts.BackgroundEnd = sign * *end;
  }
  return ProposeMaterials(boundaries, ValueAxis(lines, 0.0), facts);
}

double ValueAt(const Polyline& line, double x)
{
  const auto above = std::upper_bound(
    line.begin(), line.end(), x, [](double at, const Vertex& vertex) { return at < vertex.X; });
  if (above == line.begin() || above == line.end())
  {
    return above == line.begin() ? line.front().Y : line.back().Y;
  }
  const Vertex& a = *std::prev(above);
  return a.Y + (x - a.X) / (above->X - a.X) * (above->Y - a.Y);
}
} // namespace

TEST(NoisyBackground, ResistsNothingHoweverNearTheNextMaterialIs)
{
  for (const double sign : { 1.0, -1.0 })
  {
    const MaterialProposal quiet = Propose(sign, {});
    ASSERT_EQ(quiet.Materials.size(), 3U);
    for (const double end : { 30.0, 60.0, 88.0, 105.0 })
    {
      SCOPED_TRACE(sign * end);
      const MaterialProposal noisy = Propose(sign, end);
      ASSERT_EQ(noisy.Side, sign > 0.0 ? ProposedSide::Higher : ProposedSide::Lower);
      const Polyline* const lines[] = { &noisy.SurfaceStrength, &noisy.Friction, &noisy.Viscosity };
      const Polyline* const before[] = { &quiet.SurfaceStrength, &quiet.Friction,
        &quiet.Viscosity };
      for (int i = 0; i < 3; ++i)
      {
        const Polyline& line = *lines[i];
        for (std::size_t v = 1; v < line.size(); ++v)
        {
          EXPECT_LE(line[v - 1].X, line[v].X) << i;
        }
        for (const double value : { -50.0, 0.0, 0.5 * end, end })
        {
          EXPECT_EQ(ValueAt(line, sign * value), 0.0) << i << " at " << value;
        }
        // Grains that reach a fourteenth of the way to the next material must have no strength.
        const double grain = end + (Grey - end) / 14.0;
        EXPECT_EQ(ValueAt(noisy.SurfaceStrength, sign * grain), 0.0) << grain;
        for (const double value : { Grey, 160.0, 215.0, 300.0 })
        {
          EXPECT_NEAR(ValueAt(line, sign * value), ValueAt(*before[i], sign * value), 1e-12)
            << i << " at " << value;
        }
      }
    }
  }
}

TEST(NoisyBackground, ValuesInItAreOneMaterial)
{
  EXPECT_EQ(Propose(1.0, 88.0).Materials.size(), 3U);
  EXPECT_EQ(Propose(1.0, 150.0).Materials.size(), 2U) << "the grey is background, too";
}

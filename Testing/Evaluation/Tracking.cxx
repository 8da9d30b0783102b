// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Tracking.h"

#include "Shapes.h"

#include <numeric>

using namespace VolumeHaptics;

namespace evaluation
{

std::vector<double> TrackSphere(const Candidate& candidate, const Wall& wall, int turns)
{
  const Volume volume([&](const Vector3& x) { return wall.TheField(Norm(x - OddCentre)); },
    { 27.0, { 1.0, 1.0, 1.0 }, wall.Type, 0.0, 1, false });
  const auto model =
    volume.Bake(TouchingOf(candidate, MakeMaterial(500.0, 0.0, 0.0, Impenetrable)));
  Path path = { OnOddCircle(SphereRadius, 0.0) };
  for (int tick = 0; tick <= turns * TicksPerTurn; ++tick)
  {
    path.push_back(OnOddCircle(wall.TipRadius, TwoPi * tick / TicksPerTurn));
  }
  std::vector<double> radii;
  for (const TickRecord& tick : Play(*model, path))
  {
    radii.push_back(Norm(ProxyOf(tick) - OddCentre));
  }
  radii.erase(radii.begin());
  return radii;
}

std::vector<Wall> GetWalls()
{
  const auto edge = [](double sign) {
    return [sign](double r) { return 1000.0 * BlurredStep(sign * (SphereRadius - r), 1.5, 1.0); };
  };
  return {
    { "ball, linear", [](double r) { return -100.0 * r; }, ScalarType::Float64, 18.0 },
    { "cavity, linear", [](double r) { return 100.0 * r; }, ScalarType::Float64, 22.0 },
    { "ball, blurred 16-bit edge", edge(1.0), ScalarType::Int16, 18.0, true },
    { "cavity, blurred 16-bit edge", edge(-1.0), ScalarType::Int16, 22.0, true },
  };
}

Figures MeasureTracking(const Candidate& candidate, const Effort& effort)
{
  Figures figures;
  const int turns = effort.Pick(10, 100);
  for (const Wall& wall : GetWalls())
  {
    std::vector<double> radii = TrackSphere(candidate, wall, turns);
    // With alignment Edge, an edge's strength increases within the edge. So the reference is not
    // the level at the start, but the level on which the proxy comes to rest in the first turn.
    const bool comesToRest = wall.IsEdge && candidate.Solver == HapticSolver::Precise &&
      candidate.Alignment == ContactAlignment::Edge;
    double surface = SphereRadius;
    if (comesToRest)
    {
      radii.erase(radii.begin(), radii.begin() + TicksPerTurn);
      surface = std::accumulate(radii.begin(), radii.end(), 0.0) / double(radii.size());
    }
    double sum = 0.0;
    double worst = 0.0;
    double drift = 0.0;
    const std::size_t lastTurn = radii.size() - TicksPerTurn;
    for (std::size_t i = 0; i < radii.size(); ++i)
    {
      const double off = radii[i] - surface;
      sum += off * off;
      worst = std::max(worst, std::abs(off));
      if (i >= lastTurn)
      {
        // Compare with the same position in the first turn.
        drift = std::max(drift, std::abs(radii[i] - radii[i % TicksPerTurn + TicksPerTurn]));
      }
    }
    const double count = static_cast<double>(radii.size());
    figures.push_back({ "tracking RMS, " + wall.Name, "voxel", std::sqrt(sum / count), 0.002 });
    figures.push_back({ "tracking worst, " + wall.Name, "voxel", worst, 0.005 });
    figures.push_back(
      { "drift in " + std::to_string(turns) + " turns, " + wall.Name, "voxel", drift, 0.001 });
    if (comesToRest)
    {
      figures.push_back(
        { "felt under the middle, " + wall.Name, "voxel", std::abs(surface - SphereRadius), 0.2 });
    }
  }
  return figures;
}

} // namespace evaluation

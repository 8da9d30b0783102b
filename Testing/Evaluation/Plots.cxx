// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Angle.h"
#include "Energy.h"
#include "Figure.h"
#include "Ripple.h"
#include "Shapes.h"
#include "Tracking.h"

#include <algorithm>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
struct Named
{
  const char* Name;
  Candidate Who;
};

const Named Solvers[] = {
  { "PAPER", { HapticSolver::Paper, GradientEstimator::Gaussian } },
  { "PRECISE", { HapticSolver::Precise, GradientEstimator::Gaussian } },
};

/** Makes a plot with a curve for each solver. */
template <typename MakeCurve>
Plot PlotSolvers(
  const char* file, const char* title, const char* x, const char* y, MakeCurve&& make)
{
  Plot plot{ file, title, x, y, {} };
  for (const Named& solver : Solvers)
  {
    Curve curve{ solver.Name, {}, {} };
    make(solver.Who, curve);
    plot.Curves.push_back(std::move(curve));
  }
  return plot;
}

/** Plots a function of the proxy's radius against the number of turns. */
template <typename GetValue>
void TraceTurns(
  const Candidate& candidate, const Wall& wall, int turns, Curve& curve, GetValue&& getValue)
{
  const std::vector<double> radii = TrackSphere(candidate, wall, turns);
  for (std::size_t i = 0; i < radii.size(); i += 5)
  {
    curve.X.push_back(static_cast<double>(i) / TicksPerTurn);
    curve.Y.push_back(getValue(radii[i]));
  }
}

Plot PlotDrift()
{
  return PlotSolvers("drift", "Round a ball of 20 voxels, 2 voxels deep, 0.2 m/s", "turns",
    "proxy's radius (voxels)",
    [](const Candidate& candidate, Curve& curve)
    { TraceTurns(candidate, GetWalls()[0], 5, curve, [](double radius) { return radius; }); });
}

Plot PlotLeak()
{
  const Wall cavity = GetWalls()[1];
  return PlotSolvers("leak", "Round in a cavity of 20 voxels, 2 voxels deep, 0.2 m/s", "turns",
    "force (N)",
    [&](const Candidate& candidate, Curve& curve)
    {
      TraceTurns(candidate, cavity, 12, curve,
        [&](double radius) { return 0.5 * (cavity.TipRadius - radius); });
    });
}

Plot PlotRipple()
{
  return PlotSolvers("ripple", "Sliding on a clean plane, blurred edge, 0.1 m/s", "frequency (Hz)",
    "force, log10 of N RMS",
    [](const Candidate& candidate, Curve& curve)
    {
      const std::vector<double> spectrum = MeasureSpectrum(candidate, true);
      for (std::size_t i = 1; i < spectrum.size(); ++i)
      {
        curve.X.push_back(static_cast<double>(i));
        curve.Y.push_back(std::log10(std::max(spectrum[i], 1e-12)));
      }
    });
}

/**
 * Plots the cumulative distribution of the angle between the force and the true normal: for each
 * angle, the percentage of ticks with a smaller angle.
 */
Plot PlotAngle()
{
  return PlotSolvers("angle", "Force and true normal, 8-bit sphere, 2 voxels deep",
    "angle (degrees)", "share of ticks below (%)",
    [](const Candidate& candidate, Curve& curve)
    {
      std::vector<double> angles = MeasureAngles(candidate);
      std::sort(angles.begin(), angles.end());
      const std::size_t step = std::max<std::size_t>(1, angles.size() / 500);
      for (std::size_t i = 0; i < angles.size(); i += step)
      {
        curve.X.push_back(angles[i]);
        curve.Y.push_back(100.0 * static_cast<double>(i) / static_cast<double>(angles.size()));
      }
    });
}

Plot PlotEnergy(const Effort& effort)
{
  return PlotSolvers("energy", "Closed cycles: energy that the hand loses, by size", "cycle",
    "log10 of uJ (gains are drawn at -3)",
    [&](const Candidate& candidate, Curve& curve)
    {
      std::vector<double> energies = MeasureCycles(candidate, effort.Pick(32, 320));
      std::sort(energies.begin(), energies.end());
      for (std::size_t i = 0; i < energies.size(); ++i)
      {
        curve.X.push_back(static_cast<double>(i));
        curve.Y.push_back(std::log10(std::max(-1e6 * energies[i], 1e-3)));
      }
    });
}

} // namespace

std::vector<Plot> MakePlots(const Effort& effort)
{
  std::vector<Plot> plots = { PlotDrift(), PlotLeak(), PlotRipple(), PlotAngle(),
    PlotEnergy(effort) };
  for (const Plot& plot : PlotMovingWalls())
  {
    plots.push_back(plot);
  }
  return plots;
}

} // namespace evaluation

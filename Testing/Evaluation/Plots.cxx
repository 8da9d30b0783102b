// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Angle.h"
#include "Energy.h"
#include "Figure.h"
#include "Ripple.h"
#include "Shapes.h"
#include "Tracking.h"
#include "ZWidth.h"

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

Plot PlotDrift()
{
  Plot plot{ "drift", "Round a ball of 20 voxels, 2 voxels deep, 0.2 m/s", "turns",
    "proxy's radius (voxels)", {} };
  const std::vector<Wall> walls = GetWalls();
  for (const Named& solver : Solvers)
  {
    Curve curve{ solver.Name, {}, {} };
    const std::vector<double> radii = TrackSphere(solver.Who, walls[0], 5);
    for (std::size_t i = 0; i < radii.size(); i += 5)
    {
      curve.X.push_back(static_cast<double>(i) / TicksPerTurn);
      curve.Y.push_back(radii[i]);
    }
    plot.Curves.push_back(std::move(curve));
  }
  return plot;
}

Plot PlotLeak()
{
  Plot plot{ "leak", "Round in a cavity of 20 voxels, 2 voxels deep, 0.2 m/s", "turns", "force (N)",
    {} };
  const Wall cavity = GetWalls()[1];
  for (const Named& solver : Solvers)
  {
    Curve curve{ solver.Name, {}, {} };
    const std::vector<double> radii = TrackSphere(solver.Who, cavity, 12);
    for (std::size_t i = 0; i < radii.size(); i += 5)
    {
      curve.X.push_back(static_cast<double>(i) / TicksPerTurn);
      curve.Y.push_back(0.5 * (cavity.TipRadius - radii[i]));
    }
    plot.Curves.push_back(std::move(curve));
  }
  return plot;
}

Plot PlotRipple()
{
  Plot plot{ "ripple", "Sliding on a clean plane, blurred edge, 0.1 m/s", "frequency (Hz)",
    "force, log10 of N RMS", {} };
  for (const Named& solver : Solvers)
  {
    Curve curve{ solver.Name, {}, {} };
    const std::vector<double> spectrum = MeasureSpectrum(solver.Who, true);
    for (std::size_t i = 1; i < spectrum.size(); ++i)
    {
      curve.X.push_back(static_cast<double>(i));
      curve.Y.push_back(std::log10(std::max(spectrum[i], 1e-12)));
    }
    plot.Curves.push_back(std::move(curve));
  }
  return plot;
}

/** 2 b / T. */
Curve Theory()
{
  return { "2 b / T", { 0.0, 1.0 }, { 0.0, 2000.0 } };
}

/** How much of what is measured lies below a value. */
Curve Distribution(const char* name, std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  Curve curve{ name, {}, {} };
  const std::size_t step = std::max<std::size_t>(1, values.size() / 500);
  for (std::size_t i = 0; i < values.size(); i += step)
  {
    curve.X.push_back(values[i]);
    curve.Y.push_back(100.0 * static_cast<double>(i) / static_cast<double>(values.size()));
  }
  return curve;
}

Plot PlotAngle()
{
  Plot plot{ "angle", "Force and true normal, 8-bit sphere, 2 voxels deep", "angle (degrees)",
    "share of ticks below (%)", {} };
  for (const Named& solver : Solvers)
  {
    plot.Curves.push_back(Distribution(solver.Name, MeasureAngles(solver.Who)));
  }
  return plot;
}

Plot PlotEnergy(const Effort& effort)
{
  Plot plot{ "energy", "Closed cycles: energy that the hand loses, by size", "cycle",
    "log10 of uJ (gains are drawn at -3)", {} };
  for (const Named& solver : Solvers)
  {
    std::vector<double> energies = MeasureCycles(solver.Who, effort.Pick(32, 320));
    std::sort(energies.begin(), energies.end());
    Curve curve{ solver.Name, {}, {} };
    for (std::size_t i = 0; i < energies.size(); ++i)
    {
      curve.X.push_back(static_cast<double>(i));
      curve.Y.push_back(std::log10(std::max(-1e6 * energies[i], 1e-3)));
    }
    plot.Curves.push_back(std::move(curve));
  }
  return plot;
}

Plot PlotZWidth(const Effort& effort)
{
  Plot plot{ "zwidth", "Stiffest stable wall, 0.1 kg at 1 kHz", "damping (N s/m)",
    "stiffness (N/m)", {} };
  for (const int delay : { 0, 1 })
  {
    for (const Named& solver : Solvers)
    {
      Curve curve{ std::string(solver.Name) + (delay ? ", one tick of delay" : ""), {}, {} };
      const int points = effort.Pick(4, 10);
      for (int i = 1; i <= points; ++i)
      {
        const double damping = 1.0 * i / points;
        curve.X.push_back(damping);
        curve.Y.push_back(FindStiffestWall(solver.Who, damping, delay));
      }
      plot.Curves.push_back(std::move(curve));
    }
  }
  plot.Curves.push_back(Theory());
  return plot;
}

} // namespace

std::vector<Plot> MakePlots(const Effort& effort)
{
  return { PlotDrift(), PlotLeak(), PlotRipple(), PlotAngle(), PlotEnergy(effort),
    PlotZWidth(effort) };
}

} // namespace evaluation

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Volumes that move under a tip that rests. A ball of 20 mm pulsates by 2 mm a second; the tip is 1
 * mm inside its mean surface, k = 500 N/m, and the force that is right is
 *
 *   V1  k max(0, r(t) - 19 mm)                with T_N = 2 N, which holds it
 *   V2  min(1, 0.5 + sin) N up to a quarter,  with T_N = 1 N: what is above slips through, so that
 *       then max(0, sin) N                    it is less on the way back
 *   V4  as V1, with r(t) straight between frames 50 and 100 ms apart: all that frames tell
 *
 * A wall that leaps by six of its widths from frame to frame is right where its displacements are;
 * a blend in place is a cross-fade.
 */
#include "Figure.h"
#include "Shapes.h"

#include <algorithm>
#include <string>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double WallStiffness = 500.0; // N/m
constexpr double WallHeight = 1000.0;
constexpr double WallBlur = 1.5;      // mm
constexpr double BallMean = 20.0;     // mm
constexpr double BallDepth = 1.0;     // mm, of the tip
constexpr double BallAmplitude = 2.0; // mm
constexpr double LeapLength = 9.0;    // mm
constexpr double WallTick = 1e-3;     // s

using Motion = std::function<double(double time)>; ///< mm, of the surface out of the structure

double Pulse(double time)
{
  return BallAmplitude * std::sin(TwoPi * time);
}

/** The motion that frames tell of another one. */
Motion BetweenFrames(const Motion& motion, double period)
{
  return [=](double time)
  {
    const double before = period * std::floor(time / period);
    const double share = (time - before) / period;
    return (1.0 - share) * motion(before) + share * motion(before + period);
  };
}

/** What moves, and what is right. */
struct MovingCase
{
  const char* Name;
  double Curvature;     ///< radius, mm
  double FramePeriod;   ///< s
  double Strength;      ///< N
  bool HasDisplacement; ///< the frames tell where the material goes
  double End;           ///< s
  Motion Surface;
  std::function<double(double time)> Force; ///< N
};

double Held(double surface)
{
  return 1e-3 * WallStiffness * std::max(0.0, BallDepth + surface);
}

double Slipping(double time)
{
  const double sine = std::sin(TwoPi * time);
  return time < 0.25 ? std::min(1.0, 0.5 + sine) : std::max(0.0, sine);
}

std::vector<MovingCase> MakeMovingCases()
{
  const auto pulse = [](const char* name, double period, const Motion& told)
  {
    return MovingCase{ name, BallMean, period, 2.0, false, 1.0, Pulse,
      [told](double time) { return Held(told(time)); } };
  };
  MovingCase slipping = pulse("V2, ball that pulsates, of which 1 N slips", 0.01, Pulse);
  slipping.Strength = 1.0;
  slipping.End = 0.9; // then the ball comes back
  slipping.Force = Slipping;
  // From 5 mm in front of the tip to 4 mm behind it.
  const Motion leap = [](double time) { return -6.0 + LeapLength * time; };
  return { pulse("V1, ball that pulsates", 0.01, Pulse), slipping,
    pulse("V4, frames 50 ms apart", 0.05, BetweenFrames(Pulse, 0.05)),
    pulse("V4, frames 100 ms apart", 0.1, BetweenFrames(Pulse, 0.1)),
    { "wall that leaps by 6 widths, with displacements", 1e6, 1.0, 5.0, true, 1.0, leap,
      [leap](double time) { return Held(leap(time)); } } };
}

std::unique_ptr<HapticModel> BakeMoving(const Candidate& candidate, const MovingCase& c)
{
  Touching touching = TouchingOf(candidate, MakeMaterial(WallStiffness, 0.0, 0.0, c.Strength));
  // With materials of the far side, a surface's strength begins at the middle of its edge and grows
  // from there on; here it is whole, so that the middle is where the force comes from.
  touching.Alignment = ContactAlignment::Edge;
  touching.Placement = MaterialPlacement::Kernel;
  // A step of one unit of the scalar is no edge.
  const double steepest = WallHeight / (WallBlur * std::sqrt(TwoPi));
  touching.Material.Distinctness = { { 0.05 * steepest, 0.0 }, { 0.1 * steepest, 1.0 } };
  const Vector3 centre = OddCentre - c.Curvature * OddNormal;
  HapticModelDescription d;
  for (int i = 0; i * c.FramePeriod < c.End + 0.5 * c.FramePeriod; ++i)
  {
    const double time = i * c.FramePeriod;
    const double radius = c.Curvature + c.Surface(time);
    const Volume frame([&](const Vector3& x)
      { return BlurredStep(radius - Norm(x - centre), WallBlur, WallHeight); },
      { 18.0, { 1.0, 1.0, 1.0 }, ScalarType::Float64, 0.0, 1, true });
    const HapticModelDescription described = frame.Describe(touching);
    const std::int64_t* const n = described.View.Dimensions;
    d.Settings = described.Settings;
    if (i == 0)
    {
      d = described;
    }
    d.Frames.push_back({ time, described.View, described.Samples });
    if (c.HasDisplacement)
    {
      const Vector3 u = (c.Surface(time + c.FramePeriod) - c.Surface(time)) * OddNormal;
      const auto points = static_cast<std::size_t>(n[0] * n[1] * n[2]);
      const auto all = std::make_shared<std::vector<Vector3>>(points, u);
      d.Frames.back().Displacements = { all->data(), ScalarType::Float64 };
      d.Frames.back().DisplacementSamples = all;
    }
  }
  return std::make_unique<HapticModel>(d);
}

/** The forces along the normal, tick by tick. */
std::vector<double> FeelMoving(const Candidate& candidate, const MovingCase& c)
{
  const auto model = BakeMoving(candidate, c);
  Path path = { OddCentre + 6.0 * OddNormal };
  const Vector3 at = OddCentre - BallDepth * OddNormal;
  MoveTo(path, at, 0.02);
  ServoState state;
  TickRecord record;
  for (const Vector3& tip : path)
  {
    Tick(*model, state, 1e-3 * tip, record);
  }
  std::vector<double> forces = { Dot(record.Force, OddNormal) };
  for (double time = WallTick; time < c.End; time += WallTick)
  {
    state.DataTime = time;
    Tick(*model, state, 1e-3 * at, record);
    forces.push_back(Dot(record.Force, OddNormal));
  }
  return forces;
}

double FastestOf(const MovingCase& c)
{
  return c.HasDisplacement ? LeapLength / c.FramePeriod : TwoPi * BallAmplitude;
}
} // namespace

Figures MeasureMovingWall(const Candidate& candidate, const Effort&)
{
  Figures figures;
  double steepest = 0.0;
  for (const MovingCase& c : MakeMovingCases())
  {
    const std::vector<double> forces = FeelMoving(candidate, c);
    double worst = 0.0;
    double most = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i)
    {
      const double right = c.Force(WallTick * static_cast<double>(i));
      most = std::max(most, right);
      worst = std::max(worst, std::abs(forces[i] - right));
      const double step = i > 0 ? std::abs(forces[i] - forces[i - 1]) : 0.0;
      steepest = std::max(steepest, step / (1e-3 * WallStiffness * FastestOf(c) * WallTick));
    }
    // A hundredth of the force, and a surface that is found to 0.02 voxel; between frames that are
    // apart, a blend is off by 0.02 widths.
    const double apart = c.HasDisplacement || c.FramePeriod < 0.05 ? 0.0 : 0.02 * WallBlur;
    const double bound = 0.01 * most + 1e-3 * WallStiffness * (0.02 + apart);
    figures.push_back({ std::string("moving wall: ") + c.Name + ", worst force", "%",
      100.0 * worst / most, 100.0 * bound / most });
  }
  figures.push_back(
    { "moving walls: largest step of the force in a tick", "times k |v| dt", steepest, 2.0 });
  return figures;
}

std::vector<Plot> PlotMovingWalls()
{
  std::vector<Plot> plots;
  const std::vector<MovingCase> cases = MakeMovingCases();
  const std::pair<std::size_t, const char*> shown[] = { { 0, "moving-held" },
    { 1, "moving-slipping" }, { 4, "moving-leap" } };
  for (const auto& [number, file] : shown)
  {
    const MovingCase& c = cases[number];
    Plot plot{ file, std::string("A tip that rests: ") + c.Name, "time (s)", "force (N)", {} };
    const auto add = [&](const char* name, const std::vector<double>& forces)
    {
      Curve curve{ name, {}, {} };
      for (std::size_t i = 0; i < forces.size(); i += 2)
      {
        curve.X.push_back(WallTick * static_cast<double>(i));
        curve.Y.push_back(forces[i]);
      }
      plot.Curves.push_back(std::move(curve));
    };
    std::vector<double> right;
    for (double time = 0.0; time < c.End; time += WallTick)
    {
      right.push_back(c.Force(time));
    }
    add("right", right);
    add("PAPER", FeelMoving({ HapticSolver::Paper, GradientEstimator::Gaussian }, c));
    add("PRECISE", FeelMoving({ HapticSolver::Precise, GradientEstimator::Gaussian }, c));
    if (c.HasDisplacement)
    {
      MovingCase blended = c;
      blended.HasDisplacement = false;
      add("PRECISE, blended in place",
        FeelMoving({ HapticSolver::Precise, GradientEstimator::Gaussian }, blended));
    }
    plots.push_back(std::move(plot));
  }
  return plots;
}

} // namespace evaluation

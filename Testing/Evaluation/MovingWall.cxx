// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Moving volumes under a resting tip. A ball of 20 mm pulsates by 2 mm with a period of 1 s. The
 * tip is 1 mm inside its mean surface, k = 500 N/m, and the right force is
 *
 *   V1  k max(0, r(t) - 19 mm)                with T_N = 2 N, so that the surface holds
 *   V2  min(1, 0.5 + sin) N up to a quarter,  with T_N = 1 N: above that, the surface slips, so
 *       then max(0, sin) N                    that the force is smaller on the way back
 *   V3  k max(0, s(t))                        for a flat wall that moves at 10 mm/s through a
 *       s: the wall is so far beyond the tip  medium of 0.5 N, which moves along and does not drag
 *   V4  as V1, for the blend of two time steps 50 or 100 ms apart, which is all they tell
 *
 * The field reads the ball through its kernel, whose blur moves the surface by up to 0.03 mm. So
 * forces and levels are compared with those of the blurred ball, which also has a closed form
 * (BlurredBall); V1 and V2 are also compared with the forms above.
 *
 *   V5  if all time steps are alike, the force equals that at rest to the bit
 *   V6  if the volume moves as a whole and its displacements tell so, the force equals that of a
 *       hand that moves the other way
 *   V7  over a period, a wall that holds gives no work; a wall that slips by 1 mm at 1 N gives 1 mJ
 *
 * A wall that leaps by six of its widths per time step is right if it has displacements. Without
 * them, the blend is a cross-fade.
 */
#include "Figure.h"
#include "Shapes.h"

#include <algorithm>
#include <limits>
#include <string>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double WallStiffness = 500.0; // N/m
constexpr double WallHeight = 1000.0;
constexpr double WallBlur = 1.5;      // mm, scale of the wall's edge
constexpr double BallMean = 20.0;     // mm, mean radius
constexpr double BallDepth = 1.0;     // mm, depth of the tip
constexpr double BallAmplitude = 2.0; // mm, amplitude of the radius
constexpr double LeapLength = 9.0;    // mm, of a jump per time step
constexpr double WallSpeed = 10.0;    // mm/s, of an approaching wall
/**
 * Kernel radius (voxels). An edge begins where V is the mean of the interpolated values at this
 * distance in front and behind. With 2 voxels, these values are still on the flanks of the edges
 * below, which shifts the surface by up to 0.025 voxel; with 3 voxels, by 0.01.
 */
constexpr int WallRadius = 3;
constexpr double WallTick = 1e-3; // s, duration of a tick

/// mm: displacement of the surface, outwards
using Motion = std::function<double(double time)>;

double Pulse(double time)
{
  return BallAmplitude * std::sin(TwoPi * time);
}

/** A motion of a surface, with the correct force. */
struct MovingCase
{
  const char* Name;
  double Curvature;     ///< mm, radius of the surface
  double FramePeriod;   ///< s between time steps
  double Strength;      ///< N, surface strength
  bool HasDisplacement; ///< whether the time steps have displacements
  double Drag;          ///< N, drag of the medium
  double End;           ///< s, end of the comparison
  Motion Surface;
  /** Force (N), without the field's blur and the blend of the time steps. */
  std::function<double(double time)> Force;
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
  const auto pulse = [](const char* name, double period)
  {
    return MovingCase{ name, BallMean, period, 2.0, false, 0.0, 1.0, Pulse,
      [](double time) { return Held(Pulse(time)); } };
  };
  MovingCase slipping = pulse("V2, ball that pulsates, of which 1 N slips", 0.01);
  slipping.Strength = 1.0;
  slipping.End = 0.9; // later the ball returns
  slipping.Force = Slipping;
  // The wall moves from 5 mm in front of the tip to 4 mm behind it.
  const Motion leap = [](double time) { return -6.0 + LeapLength * time; };
  const Motion come = [](double time) { return -3.0 + WallSpeed * time; };
  return { pulse("V1, ball that pulsates", 0.01), slipping,
    { "V3, wall that comes through a medium", 1e6, 0.02, 5.0, false, 0.5, 0.5, come,
      [come](double time) { return Held(come(time)); } },
    pulse("V4, frames 50 ms apart", 0.05), pulse("V4, frames 100 ms apart", 0.1),
    { "wall that leaps by 6 widths, with displacements", 1e6, 1.0, 5.0, true, 0.0, 1.0, leap,
      [leap](double time) { return Held(leap(time)); } } };
}

/**
 * A ball between two time steps, as the field reads it. A Gaussian of variance q turns f(rho), a
 * step that a Gaussian of variance w^2 blurs along the radius, into
 *
 *   f~(rho) + q/rho f~'(rho),   f~: the step with a variance of w^2 + q,
 *
 * since it blurs rho f(rho) in one dimension, where z has the mean q d/dz (Stein). The surface
 * keeps the level of the first contact. By the definition of an edge, it is never in front of the
 * middle, V = (V(x_s) + V(x_v))/2.
 */
class BlurredBall
{
public:
  BlurredBall(const Candidate& candidate, const MovingCase& c)
    : Case(c)
    , IsSpline(candidate.Estimator == GradientEstimator::CubicBSpline)
    , OwnVariance(IsSpline ? SplineVariance : ComputeGaussianVariance())
    , ValueVariance(IsSpline ? SplineVariance : LinearVariance)
  {
  }

  /** Returns the force on a resting tip for each tick. */
  std::vector<double> Push(std::size_t ticks) const
  {
    const double tip = BallMean - BallDepth;
    const double most = tip + 1e3 * this->Case.Strength / WallStiffness;
    std::vector<double> forces;
    double level = this->Read(this->ComputeMiddle(0.0), 0.0, this->OwnVariance);
    for (std::size_t i = 0; i < ticks; ++i)
    {
      const double time = WallTick * static_cast<double>(i);
      const double middle = this->ComputeMiddle(time);
      const double held = this->Descend(
        time, [&](double rho) { return this->Read(rho, time, this->OwnVariance) - level; });
      const double surface = std::min({ held, middle, most });
      if (middle <= tip || surface < held)
      {
        // Without contact, the level follows the middle. After a slip, it follows the surface.
        level = this->Read(middle <= tip ? middle : surface, time, this->OwnVariance);
      }
      forces.push_back(middle <= tip ? 0.0 : 1e-3 * WallStiffness * std::max(0.0, surface - tip));
    }
    return forces;
  }

private:
  static constexpr double SplineVariance = 1.0 / 3.0; ///< square voxels, of a cubic B-spline
  static constexpr double LinearVariance = 1.0 / 6.0; ///< square voxels, of linear interpolation

  /**
   * Returns the variance of a window for which the derivative of the windowed Gaussian is
   * consistent (Core/Field/GradientKernel.h).
   */
  static double ComputeGaussianVariance()
  {
    constexpr double scale = 0.56 * WallRadius;
    constexpr double cut = WallRadius + 1.0;
    constexpr double step = 1e-3;
    constexpr double last = 0.5 * cut * cut / (scale * scale);
    double sum = 0.0;
    double second = 0.0;
    for (double t = 0.5 * step; t < cut; t += step)
    {
      const double u = 0.5 * t * t / (scale * scale);
      const double w = std::exp(-u) - std::exp(-last) * (1.0 + last - u);
      sum += w;
      second += w * t * t;
    }
    return second / sum;
  }

  /** Returns the value at a radius as a fraction of the step's height. */
  double Read(double rho, double time, double variance) const
  {
    const double period = this->Case.FramePeriod;
    // A tick at a time step uses exactly this time step, despite rounding errors.
    const double before = period * std::floor(time / period + 1e-9);
    const double fraction = (time - before) / period;
    const double width = std::sqrt(WallBlur * WallBlur + variance);
    const auto read = [&](double timeStep)
    {
      const double u = (BallMean + this->Case.Surface(timeStep) - rho) / width;
      const double slope = std::exp(-0.5 * u * u) / (width * std::sqrt(TwoPi));
      return BlurredStep(u, 1.0, 1.0) - variance / rho * slope;
    };
    return (1.0 - fraction) * read(before) + fraction * read(before + period);
  }

  double ComputeMiddle(double time) const
  {
    return this->Descend(time,
      [&](double rho)
      {
        const auto value = [&](double x) { return this->Read(x, time, this->ValueVariance); };
        return value(rho) - 0.5 * (value(rho - WallRadius) + value(rho + WallRadius));
      });
  }

  /** Returns the root near the surface of a function that decreases with the radius. */
  template <typename Function>
  double Descend(double time, const Function& function) const
  {
    double low = BallMean + this->Case.Surface(time) - 1.5 * WallBlur;
    double high = low + 3.0 * WallBlur;
    for (int i = 0; i < 50; ++i)
    {
      const double at = 0.5 * (low + high);
      (function(at) > 0.0 ? low : high) = at;
    }
    return 0.5 * (low + high);
  }

  const MovingCase& Case;
  const bool IsSpline;
  const double OwnVariance;   ///< variance of the levels that support the proxy
  const double ValueVariance; ///< square voxels, of the interpolation of V
};

HapticModelDescription DescribeMoving(const Candidate& candidate, const MovingCase& c)
{
  Touching touching = TouchingOf(candidate, MakeMaterial(WallStiffness, 0.0, c.Drag, c.Strength));
  // With far-side materials, the surface's strength would increase from the middle of the edge
  // onwards. With kernel materials, the strength is complete, and the force starts in the middle.
  touching.Alignment = ContactAlignment::Edge;
  touching.Placement = MaterialPlacement::Kernel;
  touching.KernelRadius = WallRadius;
  // A step of one scalar unit does not count as an edge.
  const double steepest = WallHeight / (WallBlur * std::sqrt(TwoPi));
  touching.Material.Distinctness = { { 0.05 * steepest, 0.0 }, { 0.1 * steepest, 1.0 } };
  const Vector3 centre = OddCentre - c.Curvature * OddNormal;
  HapticModelDescription d;
  for (int i = 0; i * c.FramePeriod < c.End + 0.5 * c.FramePeriod; ++i)
  {
    const double time = i * c.FramePeriod;
    const double radius = c.Curvature + c.Surface(time);
    const Volume timeStep([&](const Vector3& x)
      { return BlurredStep(radius - Norm(x - centre), WallBlur, WallHeight); },
      { 18.0, { 1.0, 1.0, 1.0 }, ScalarType::Float64, 0.0, 1, true });
    const HapticModelDescription described = timeStep.Describe(touching);
    const std::int64_t* const n = described.View.Dimensions;
    d.Settings = described.Settings;
    if (i == 0)
    {
      d = described;
    }
    d.TimeSteps.push_back({ time, described.View, described.Samples });
    if (c.HasDisplacement)
    {
      const Vector3 u = (c.Surface(time + c.FramePeriod) - c.Surface(time)) * OddNormal;
      const auto points = static_cast<std::size_t>(n[0] * n[1] * n[2]);
      const auto all = std::make_shared<std::vector<Vector3>>(points, u);
      d.TimeSteps.back().Displacements = { all->data(), ScalarType::Float64 };
      d.TimeSteps.back().DisplacementSamples = all;
    }
  }
  return d;
}

struct FeltMotion
{
  std::vector<double> Forces; ///< N, along the normal, one per tick
  double Work = 0.0;          ///< J, work of the wall
};

FeltMotion FeelMoving(const Candidate& candidate, const MovingCase& c)
{
  const HapticModel model(DescribeMoving(candidate, c));
  const Vector3 at = OddCentre - BallDepth * OddNormal;
  // In a medium with drag, an approaching hand would retain a force when it stops, so start at rest
  // at the final position.
  Path path = { c.Drag > 0.0 ? at : OddCentre + 6.0 * OddNormal };
  MoveTo(path, at, 0.02);
  ServoState state;
  TickRecord record;
  for (const Vector3& tip : path)
  {
    Tick(model, state, 1e-3 * tip, record);
  }
  FeltMotion felt{ { Dot(record.Force, OddNormal) } };
  for (double time = WallTick; time < c.End; time += WallTick)
  {
    state.DataTime = time;
    Tick(model, state, 1e-3 * at, record);
    felt.Forces.push_back(Dot(record.Force, OddNormal));
    felt.Work += record.WallWork;
  }
  return felt;
}

bool IsFlat(const MovingCase& c)
{
  return c.Curvature > 1e3;
}

double FastestOf(const MovingCase& c)
{
  const double flat = c.HasDisplacement ? LeapLength / c.FramePeriod : WallSpeed;
  return IsFlat(c) ? flat : TwoPi * BallAmplitude;
}

/** V7: returns the error (mJ) of the wall's work over a period. */
double MeasureWorkError(const Candidate& candidate, double strength, double right)
{
  MovingCase c = MakeMovingCases().front();
  c.Strength = strength;
  c.End = 1.0 + 0.5 * WallTick;
  return std::abs(1e3 * FeelMoving(candidate, c).Work - right);
}

/**
 * V5: returns the largest difference (N) between the forces of the series and those of its first
 * time step alone.
 */
double MeasureStillDifference(const Candidate& candidate)
{
  constexpr int timeSteps = 1000;
  HapticModelDescription d = DescribeMoving(candidate, MakeMovingCases().front());
  const VolumeTimeStep first = d.TimeSteps.front();
  d.TimeSteps.clear();
  const HapticModel still(d);
  for (int i = 0; i < timeSteps; ++i)
  {
    d.TimeSteps.push_back({ 0.003 * i, first.View, first.Samples });
  }
  const HapticModel moving(d);
  Path path = { OddCentre + 3.0 * OddNormal };
  MoveTo(path, OddCentre - 2.0 * OddNormal + Vector3{ 3.0, -2.0, 1.0 }, 0.005);
  MoveTo(path, OddCentre + 3.0 * OddNormal, 0.005);
  ServoState states[2];
  TickRecord record;
  double worst = 0.0;
  for (const Vector3& tip : path)
  {
    Tick(still, states[0], 1e-3 * tip, record);
    const Vector3 force = record.Force;
    Tick(moving, states[1], 1e-3 * tip, record);
    worst = std::max(worst, Norm(record.Force - force));
    states[1].DataTime += WallTick;
  }
  return worst;
}

/**
 * V6: returns the largest difference of forces (N) between a hand in a volume that moves as a
 * whole, with displacements, and a hand that moves in the opposite direction in a static volume.
 * The motion per time step is a whole number of voxels, so that sampling adds no error.
 *
 * Each tick starts from the static volume's state. Where a graded edge yields, PRECISE may
 * overshoot by 2e-4 of the lag, and rounding errors grow from tick to tick, by the edge's rise of
 * strength over k.
 */
double MeasureRigidDifference(const Candidate& candidate)
{
  constexpr int timeSteps = 3;
  const Vector3 spacing{ 1.0, 1.1, 0.9 };
  const Vector3 velocity{ 2.0 * spacing.X, spacing.Y, -spacing.Z }; // mm/s
  const Touching touching = TouchingOf(candidate, MakeMaterial(WallStiffness, 0.3, 0.0, 5.0));
  const Sampling sampling{ 18.0, spacing, ScalarType::Float64, 0.0, 1, false };
  HapticModelDescription d;
  for (int i = 0; i < timeSteps; ++i)
  {
    const auto bumpyWall = [&](const Vector3& place)
    {
      const Vector3 x = place - static_cast<double>(i) * velocity;
      const double bumps = 0.4 * std::sin(0.3 * x.Y) * std::cos(0.2 * x.Z);
      return BlurredStep(bumps - Dot(x, OddNormal), WallBlur, WallHeight);
    };
    const HapticModelDescription described = Volume(bumpyWall, sampling).Describe(touching);
    const std::int64_t* const n = described.View.Dimensions;
    d = i == 0 ? described : d;
    d.TimeSteps.push_back({ static_cast<double>(i), described.View, described.Samples });
    const auto all = std::make_shared<std::vector<Vector3>>(
      static_cast<std::size_t>(n[0] * n[1] * n[2]), velocity);
    d.TimeSteps.back().Displacements = { all->data(), ScalarType::Float64 };
    d.TimeSteps.back().DisplacementSamples = all;
  }
  const HapticModel moving(d);
  d.TimeSteps.clear();
  const HapticModel still(d);
  ServoState states[2];
  TickRecord record;
  double worst = 0.0;
  for (double time = 0.0; time < timeSteps - 1; time += WallTick)
  {
    const Vector3 at = 3.0 * std::cos(5.0 * time) * OddNormal + 3.0 * time * OddAside +
      2.0 * std::sin(3.0 * time) * OddUp;
    const double before = states[1].DataTime;
    states[1] = states[0];
    for (Vector3* place :
      { &states[1].Proxy, &states[1].PreviousTip, &states[1].Precise.ReachedTip })
    {
      *place += 1e-3 * before * velocity;
    }
    states[1].CarriedTo = before;
    Tick(still, states[0], 1e-3 * at, record);
    const Vector3 force = record.Force;
    states[1].DataTime = time;
    Tick(moving, states[1], 1e-3 * (at + time * velocity), record);
    worst = std::max(worst, Norm(record.Force - force));
  }
  return worst;
}

/**
 * Returns the energy (mJ) that a hand gains beyond its own work and the wall's. The hand wanders in
 * and out of a pulsating ball with friction, and presses harder than the ball can resist.
 */
double MeasureEnergyGiven(const Candidate& candidate)
{
  MovingCase c = MakeMovingCases().front();
  c.Strength = 1.5;
  HapticModelDescription d = DescribeMoving(candidate, c);
  d.Material.Friction = MakeMaterial(WallStiffness, 0.2).Friction;
  const HapticModel model(d);
  ServoState state;
  TickRecord record;
  Vector3 tip = OddCentre;
  Tick(model, state, 1e-3 * tip, record);
  double given = 0.0; // J that the hand has gained
  double walls = 0.0;
  double exchanged = 0.0;
  double most = 0.0;
  for (int tick = 1; tick < 20000; ++tick)
  {
    const double time = WallTick * tick;
    const Vector3 before = tip;
    const Vector3 force = record.Force;
    tip =
      OddCentre + 3.0 * std::sin(7.1 * time) * OddNormal + 2.0 * std::sin(5.3 * time) * OddAside;
    // The time oscillates over the period's time steps without a jump.
    state.DataTime = 0.5 * (1.0 - std::cos(TwoPi * 0.4 * time));
    Tick(model, state, 1e-3 * tip, record);
    given += 0.5e-3 * Dot(force + record.Force, tip - before);
    walls += record.WallWork;
    exchanged += std::abs(record.WallWork);
    most = std::max(most, given - walls);
  }
  // Without work of the wall, the measurement is void.
  return exchanged > 0.01 ? 1e3 * most : std::numeric_limits<double>::infinity();
}
} // namespace

Figures MeasureMovingWall(const Candidate& candidate, const Effort&)
{
  Figures figures;
  double steepest = 0.0;
  for (const MovingCase& c : MakeMovingCases())
  {
    const std::vector<double> forces = FeelMoving(candidate, c).Forces;
    std::vector<double> plain;
    for (std::size_t i = 0; i < forces.size(); ++i)
    {
      plain.push_back(c.Force(WallTick * static_cast<double>(i)));
      const double step = i > 0 ? std::abs(forces[i] - forces[i - 1]) : 0.0;
      steepest = std::max(steepest, step / (1e-3 * WallStiffness * FastestOf(c) * WallTick));
    }
    const auto worst = [&forces](const std::vector<double>& right)
    {
      double error = 0.0;
      for (std::size_t i = 0; i < forces.size(); ++i)
      {
        error = std::max(error, std::abs(forces[i] - right[i]));
      }
      return error;
    };
    const auto percent = [](double error, const std::vector<double>& right)
    { return 100.0 * error / *std::max_element(right.begin(), right.end()); };
    // Blur does not move a flat wall.
    const std::vector<double> right =
      IsFlat(c) ? plain : BlurredBall(candidate, c).Push(forces.size());
    const std::string name = std::string("moving wall: ") + c.Name;
    const double error = worst(right);
    figures.push_back({ name + ", worst force", "%", percent(error, right), 1.0 });
    figures.push_back({ name + ", worst level", "voxel", 1e3 * error / WallStiffness, 0.02 });
    if (!IsFlat(c) && c.FramePeriod < 0.05)
    {
      figures.push_back(
        { name + ", worst force, blur not counted in", "%", percent(worst(plain), plain), 1.0 });
    }
  }
  figures.push_back(
    { "moving wall: V5, 1000 frames that are alike, force off one that stands still", "N",
      MeasureStillDifference(candidate), 0.0 });
  figures.push_back({ "moving wall: V6, rigid motion, force off that of the hand's opposite motion",
    "N in a tick", MeasureRigidDifference(candidate), 1e-9 });
  figures.push_back({ "moving wall: V7, work of a wall that holds", "mJ",
    MeasureWorkError(candidate, 2.0, 0.0), 0.02 });
  figures.push_back({ "moving wall: V7, work of a wall that slips by 1 mm at 1 N", "mJ off 1",
    MeasureWorkError(candidate, 1.0, 1.0), 0.02 });
  figures.push_back({ "moving wall: energy beyond the work of hand and wall", "mJ",
    MeasureEnergyGiven(candidate), 0.1 });
  figures.push_back(
    { "moving walls: largest step of the force in a tick", "times k |v| dt", steepest, 1.1 });
  return figures;
}

std::vector<Plot> PlotMovingWalls()
{
  std::vector<Plot> plots;
  const std::vector<MovingCase> cases = MakeMovingCases();
  struct Shown
  {
    std::size_t Number;
    const char* File;
    LegendPlace Legend;
  };
  const Shown all[] = { { 0, "moving-held", LegendPlace::TopRight },
    { 1, "moving-slipping", LegendPlace::TopRight }, { 5, "moving-leap", LegendPlace::TopLeft } };
  for (const auto& [number, file, legend] : all)
  {
    const MovingCase& c = cases[number];
    Plot plot{ file, std::string("A tip that rests: ") + c.Name, "time (s)", "force (N)", {},
      legend };
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
    add("PAPER", FeelMoving({ HapticSolver::Paper, GradientEstimator::Gaussian }, c).Forces);
    add("PRECISE", FeelMoving({ HapticSolver::Precise, GradientEstimator::Gaussian }, c).Forces);
    if (c.HasDisplacement)
    {
      MovingCase blended = c;
      blended.HasDisplacement = false;
      add("PRECISE, blended in place",
        FeelMoving({ HapticSolver::Precise, GradientEstimator::Gaussian }, blended).Forces);
    }
    plots.push_back(std::move(plot));
  }
  return plots;
}

} // namespace evaluation

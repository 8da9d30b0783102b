// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "CostFit.h"

#include "Shapes.h"

#include "vtkImageData.h"

#include <algorithm>
#include <chrono>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr int LargestRadius = 6;
constexpr double BallRadius = 20.0; // mm
constexpr int BatchSize = 32;       // ticks: the clock is too coarse for a single tick

/** Returns the median time (us) of a tick that slides around a ball, 2 mm deep at 0.1 m/s. */
double TimeTick(const HapticModel& model, int batches)
{
  ServoState state;
  TickRecord record;
  Tick(model, state, 0.001 * OnOddCircle(BallRadius, 0.0), record);
  std::vector<double> times;
  int tick = 0;
  for (int batch = 0; batch < batches; ++batch)
  {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < BatchSize; ++i)
    {
      Tick(model, state, 0.001 * OnOddCircle(18.0, 0.1 / 18.0 * ++tick), record);
    }
    times.push_back(1e6 / BatchSize *
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  std::nth_element(times.begin(), times.begin() + batches / 2, times.end());
  return times[batches / 2];
}

/**
 * Returns the times (us) for the radii 1, 2 ... Measures in several rounds and reports the fastest
 * time, because other work of the machine slows some rounds.
 */
std::vector<double> TimeRadii(Scene& scene, const Method& method, const Effort& effort)
{
  std::vector<double> times(LargestRadius, 1e9);
  for (int round = effort.Pick(6, 60); round > 0; --round)
  {
    for (int i = 0; i < LargestRadius; ++i)
    {
      scene.SetKernelRadius(i + 1);
      times[i] = std::min(times[i], TimeTick(*scene.Bake(method), effort.Pick(25, 100)));
    }
  }
  return times;
}

/** A range of radii to which one curve is fitted. */
struct Range
{
  int First;
  int Last;
};
/**
 * All radii; the radii with kernels compiled for their number of taps; the radii with the general
 * kernel.
 */
constexpr Range Ranges[] = { { 1, LargestRadius }, { 1, 3 }, { 4, LargestRadius } };

LineFit FitRange(const std::vector<double>& times, const Range& range)
{
  std::vector<double> taps;
  for (int radius = range.First; radius <= range.Last; ++radius)
  {
    taps.push_back(TapsOf(radius));
  }
  return FitLine(taps, { times.begin() + range.First - 1, times.begin() + range.Last });
}

std::vector<std::string> MakeRow(
  const Method& method, const std::vector<double>& times, const Range& range, const LineFit& fit)
{
  std::vector<std::string> row{ std::string(method.Name) + ", r = " + std::to_string(range.First) +
    " to " + std::to_string(range.Last) };
  for (int radius = 1; radius <= LargestRadius; ++radius)
  {
    const bool isFitted = radius >= range.First && radius <= range.Last;
    row.push_back(isFitted ? Number(times[radius - 1]) : "");
  }
  row.push_back(Number(fit.Constant));
  row.push_back(fit.Constant > 0.0 ? Number(PaperConstant / fit.Constant) : "none");
  row.push_back(Number(1000.0 * fit.Slope));
  row.push_back(Number(100.0 * fit.Residual) + " %");
  row.push_back(Number(100.0 * fit.Worst) + " %");
  return row;
}

Curve Draw(const Method& method, const Range& range, const LineFit& fit)
{
  const bool isWhole = range.First == 1 && range.Last == LargestRadius;
  const std::string radii = std::to_string(range.First) + " to " + std::to_string(range.Last);
  // Draw the fit of all radii paler (see the plots' palette), to show the error of a single cubic.
  Curve curve{ std::string(method.Name) + ", fit of r = " + radii, {}, {},
    isWhole ? method.Colour + 2 : method.Colour };
  for (double radius = range.First - 0.25; radius < range.Last + 0.3; radius += 0.1)
  {
    curve.X.push_back(radius);
    curve.Y.push_back(fit.Constant + fit.Slope * TapsOf(radius));
  }
  return curve;
}
} // namespace

LineFit FitLine(const std::vector<double>& x, const std::vector<double>& y)
{
  double weights = 0.0, sumX = 0.0, sumY = 0.0, sumXX = 0.0, sumXY = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    if (!(y[i] > 0.0))
    {
      return {};
    }
    const double weight = 1.0 / (y[i] * y[i]);
    weights += weight;
    sumX += weight * x[i];
    sumY += weight * y[i];
    sumXX += weight * x[i] * x[i];
    sumXY += weight * x[i] * y[i];
  }
  const double determinant = weights * sumXX - sumX * sumX;
  if (!(determinant > 1e-12 * weights * sumXX))
  {
    return {};
  }
  LineFit fit;
  fit.Slope = (weights * sumXY - sumX * sumY) / determinant;
  fit.Constant = (sumY - fit.Slope * sumX) / weights;
  for (std::size_t i = 0; i < x.size(); ++i)
  {
    const double error = std::abs((fit.Constant + fit.Slope * x[i]) / y[i] - 1.0);
    fit.Residual += error * error / static_cast<double>(x.size());
    fit.Worst = std::max(fit.Worst, error);
  }
  fit.Residual = std::sqrt(fit.Residual);
  return fit;
}

Table MeasureCost(const Effort& effort, std::vector<Plot>& plots)
{
  Table table{ "What a tick costs against the radius of the gradient kernel",
    "The paper: a constant of about 35 us (Pentium II, 800 MHz), and a gradient whose cost "
    "is cubic in the radius. Here: the median time of a tick in contact, of this machine in "
    "this run (GAUSSIAN, round a ball of 20 voxels at 0.1 m/s), fitted by a + b (2 r + 2)^3, "
    "the kernel's taps, with the least squares of relative errors. Radii 1 to 3 have kernels "
    "that are compiled for their number of taps and the larger ones share a general one: no "
    "one cubic fits both, so they are fitted apart, too.",
    { "method" }, {} };
  for (int radius = 1; radius <= LargestRadius; ++radius)
  {
    table.Columns.push_back("r = " + std::to_string(radius) + " (us)");
  }
  table.Columns.insert(table.Columns.end(),
    { "a (us)", "paper's 35 us / a", "b (ns a tap)", "fit: RMS error", "worst error" });
  Plot plot{ "cost", "A tick in contact against the kernel's radius, fitted",
    "kernel radius (voxels)", "median time of a tick (us)", {}, LegendPlace::TopLeft };
  Scene scene(SampleImage([](const Vector3& x)
                { return BlurredStep(BallRadius - Norm(x - OddCentre), 1.5, 1000.0); },
                29.0),
    500.0);
  for (const Method& method : AllMethods())
  {
    if (method.Kind != vtkVolumeHapticsFilter::PROXY)
    {
      continue; // has no gradient kernel, or consists only of the gradient
    }
    Curve measured{ method.Name, {}, TimeRadii(scene, method, effort), method.Colour, true };
    for (const Range& range : Ranges)
    {
      const LineFit fit = FitRange(measured.Y, range);
      table.Rows.push_back(MakeRow(method, measured.Y, range, fit));
      plot.Curves.push_back(Draw(method, range, fit));
    }
    for (int radius = 1; radius <= LargestRadius; ++radius)
    {
      measured.X.push_back(radius);
    }
    plot.Curves.push_back(std::move(measured));
  }
  plots.push_back(std::move(plot));
  return table;
}

} // namespace evaluation

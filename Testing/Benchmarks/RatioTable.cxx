// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RatioTable.h"

#include "Benchmarks.h"

#include <cmath>
#include <cstdio>
#include <utility>

namespace benchmarks
{
namespace
{

constexpr double NoTarget = 0.0;
/**
 * Largest ratio of ticks in a volume 32 times as large to ticks in the small volume, with warm
 * caches. The cost should not depend on the size; the tolerance is for noise.
 */
constexpr double SameCost = 1.15;
/** Largest ratio of PRECISE to PAPER for ticks in contact. */
constexpr double PreciseTarget = 4.0;
/** Largest ratio of the median tick with labels to the median tick without labels. */
constexpr double LabelTarget = 1.25;
/**
 * Largest ratio of PRECISE with default settings to PRECISE with the paper's placement and
 * alignment.
 */
constexpr double PlacementTarget = 1.25;
/**
 * Largest ratio of PRECISE on a moving volume (a blend of two time steps) to PRECISE on a static
 * volume.
 */
constexpr double BlendTarget = 2.2;
/**
 * Largest ratios of a gradient to a bare reading of its taps: with the taps in the cache, and with
 * the taps in memory.
 */
constexpr double WarmTarget = 2.0;
constexpr double ColdTarget = 1.3;
/** Largest ratio of a tick with radius 3 (512 taps) to a tick with radius 2 (216 taps). */
constexpr double RadiusTarget = 1.5;
/** Longest tick (us) on a mesh of about 300 000 triangles. */
constexpr double SurfaceTarget = 10.0;
/** Longest ticks (us) with one vector mode, and with four oblique primitives. */
constexpr double ModeTarget = 1.5;
constexpr double SetTarget = 4.0;
/**
 * Largest ratios of the ticks with one and with four modes to a tick of PRECISE, which takes 0.6 us
 * if both kinds of targets are met.
 */
constexpr double ModeRatio = 2.5;
constexpr double SetRatio = 6.7;
/** Longest tick (us) of a tool of 10^4 points. */
constexpr double ShellTarget = 250.0;
/** Longest time (ns) of a step without its gradient. */
constexpr double RestTarget = 60.0;
/** Longest ticks (ns) of the offline filter with all its outputs, for PAPER and PRECISE. */
constexpr double PaperFilterTarget = 250.0;
constexpr double PreciseFilterTarget = 600.0;
/** Longest additional time (ns) per tick for the trace. */
constexpr double TraceTarget = 150.0;

void PrintTitle(const char* title)
{
  std::printf("\n%-70s %7s %7s %7s\n", title, "median", "least", "target");
}

/**
 * Prints a line whose target applies to the median. Prints nothing if the ratio was not measured.
 */
void PrintLine(const std::string& name, double median, double least, double target)
{
  if (!std::isfinite(median))
  {
    return;
  }
  std::printf("  %-68s %7.2f %7.2f", name.c_str(), median, least);
  if (target > NoTarget)
  {
    std::printf(" %7.2f %s", target, median <= target ? "reached" : "NOT reached");
  }
  std::printf("\n");
}

void PrintRatio(
  const Medians& medians, const std::string& over, const std::string& under, double target)
{
  PrintLine(over + " : " + under, medians[over].Median / medians[under].Median,
    medians[over].Least / medians[under].Least, target);
}

/** Returns the largest ratio of a whole tick to seven linear interpolations by VTK. */
double TickTarget(const Estimator& estimator)
{
  if (estimator.Kind == VolumeHaptics::GradientEstimator::CubicBSpline)
  {
    return 1.0;
  }
  const bool isDefault =
    estimator.Kind == VolumeHaptics::GradientEstimator::Gaussian && estimator.Radius == 2;
  return isDefault ? 2.1 : NoTarget;
}

} // namespace

void PrintRatios(const Medians& medians)
{
  const char* const volumes[] = { "256^3", "1GiB" };
  const char* const motions[] = { "slide", "random" };
  const auto forEach = [&](const auto& print)
  {
    for (const char* motion : motions)
    {
      for (const char* volume : volumes)
      {
        for (const Estimator& estimator : GetEstimators())
        {
          print(estimator, motion, volume);
        }
      }
    }
  };

  PrintTitle("Tick beside vtkImageInterpolator, value and 6 taps");
  forEach(
    [&](const Estimator& estimator, const std::string& motion, const std::string& volume)
    {
      const bool isTarget = motion == "slide" && volume == "256^3";
      PrintRatio(medians, NameOf("tick", estimator.Name, motion, volume),
        NameOf("InterpolateIJK", "value+6", motion, volume),
        isTarget ? TickTarget(estimator) : NoTarget);
    });
  PrintTitle("Gradient beside a bare gather of its taps");
  forEach(
    [&](const Estimator& estimator, const std::string& motion, const std::string& volume)
    {
      PrintRatio(medians, NameOf("gradient", estimator.Name, motion, volume),
        NameOf("gather", estimator.Name, motion, volume),
        motion == "slide" ? WarmTarget : (volume == "1GiB" ? ColdTarget : NoTarget));
    });
  PrintTitle("Tick of PRIMITIVES and the forces of its modes beside PRECISE");
  const std::string precise = NameOf("precise_tick", GetEstimators()[2].Name, "slide", "256^3");
  const std::pair<const char*, double> modes[] = { { "mode_tick/follow", ModeRatio },
    { "mode_tick/vortex", ModeRatio }, { "mode_tick/four_oblique", SetRatio },
    { "mode_forces/four_oblique", NoTarget } };
  for (const auto& [subject, most] : modes)
  {
    PrintRatio(medians, std::string(subject) + "/slide/96^3", precise, most);
  }
  PrintTitle("Tick of PRIMITIVES, median tick of a slide, us");
  for (const char* subject : { "mode_tick/follow", "mode_tick/vortex", "mode_tick/four_oblique" })
  {
    const IterationTime tick = medians[std::string(subject) + "/slide/96^3/p50"];
    const bool isSet = subject == std::string("mode_tick/four_oblique");
    PrintLine(subject, 1e-3 * tick.Median, 1e-3 * tick.Least, isSet ? SetTarget : ModeTarget);
  }
  PrintTitle("Tick of a shell of 10^4 points, a quarter in contact, us; beside its taps");
  {
    const std::string shell = NameOf("shell_tick", "sphere", "slide", "256^3");
    const IterationTime tick = medians[shell + "/p50"];
    PrintLine(shell + ", median tick", 1e-3 * tick.Median, 1e-3 * tick.Least, ShellTarget);
    PrintRatio(medians, shell, NameOf("shell_gather", "sphere", "slide", "256^3"), NoTarget);
  }
  PrintTitle("Gaussian of radius 3 beside radius 2");
  for (const char* subject : { "tick", "gradient" })
  {
    PrintRatio(medians, NameOf(subject, "GAUSSIAN_r3", "slide", "256^3"),
      NameOf(subject, "GAUSSIAN_r2", "slide", "256^3"), RadiusTarget);
  }
  PrintTitle("Tick less its gradient, ns");
  for (const Estimator& estimator : GetEstimators())
  {
    const IterationTime tick = medians[NameOf("tick", estimator.Name, "slide", "256^3")];
    const IterationTime gradient = medians[NameOf("gradient", estimator.Name, "slide", "256^3")];
    PrintLine(
      estimator.Name, tick.Median - gradient.Median, tick.Least - gradient.Least, RestTarget);
  }
  PrintTitle("Cost independent of the volume's size when warm");
  for (const Estimator& estimator : GetEstimators())
  {
    PrintRatio(medians, NameOf("tick", estimator.Name, "slide", "1GiB"),
      NameOf("tick", estimator.Name, "slide", "256^3"), SameCost);
  }
  PrintTitle("Solver PRECISE beside PAPER, sliding at 0.1 m/s");
  for (const Estimator& estimator : GetEstimators())
  {
    PrintRatio(medians, NameOf("precise_tick", estimator.Name, "slide", "256^3"),
      NameOf("tick", estimator.Name, "slide", "256^3"), PreciseTarget);
  }
  PrintTitle("Between two frames, beside a volume that stands still");
  for (const Estimator& estimator : GetEstimators())
  {
    PrintRatio(medians, NameOf("blended_tick", estimator.Name, "slide", "256^3"),
      NameOf("precise_tick", estimator.Name, "slide", "256^3"), BlendTarget);
    PrintRatio(medians, NameOf("blended_paper_tick", estimator.Name, "slide", "256^3"),
      NameOf("tick", estimator.Name, "slide", "256^3"), BlendTarget);
    PrintRatio(medians, NameOf("displaced_tick", estimator.Name, "slide", "256^3"),
      NameOf("precise_tick", estimator.Name, "slide", "256^3"), NoTarget);
  }
  PrintTitle("Tick of the filter, with its trace, ns; and beside its ticks alone");
  for (const char* const solver : { "PAPER", "PRECISE" })
  {
    const auto nameOf = [solver](const char* variant)
    { return NameOf("filter", solver + std::string(variant), "slide", "256^3"); };
    for (const char* const arrays : { "_all", "_Force" })
    {
      const IterationTime whole = medians[nameOf(arrays)];
      const bool isAll = arrays == std::string("_all");
      // Apart from the ticks, the value at the proxy is all that the arrays need from the volume.
      const std::string computed = isAll ? "_bare+value" : "_bare";
      const IterationTime bare = medians[nameOf(computed.c_str())];
      const double target =
        solver == std::string("PAPER") ? PaperFilterTarget : PreciseFilterTarget;
      PrintLine(nameOf(arrays), whole.Median, whole.Least, isAll ? target : NoTarget);
      PrintLine(nameOf(arrays) + " less " + computed.substr(1), whole.Median - bare.Median,
        whole.Least - bare.Least, TraceTarget);
      PrintRatio(medians, nameOf(arrays), nameOf("_bare"), NoTarget);
      // Compare with the least possible work of a tick: reading the samples that the gradient sums.
      PrintRatio(medians, nameOf(arrays),
        NameOf("gather", GetEstimators()[2].Name, "slide", "256^3"), NoTarget);
    }
  }
  for (const char* const measure : { "", "/p50" })
  {
    PrintTitle(*measure ? "Tick with labels beside one without, median tick of a slide"
                        : "Tick with labels beside one without, mean of a slide");
    for (const char* const tick : { "label_tick", "precise_label_tick" })
    {
      for (const char* const variant : { "materials", "geometry", "geometry+materials" })
      {
        for (const char* const type : { "uint8", "int16", "int32" })
        {
          PrintRatio(medians,
            NameOf(tick, std::string(variant) + "_" + type, "slide", "256^3") + measure,
            NameOf(tick, "none", "slide", "256^3") + measure, *measure ? LabelTarget : NoTarget);
        }
      }
    }
  }
  PrintTitle("PRECISE with far side and Edge beside kernel and Distinctness");
  for (const Estimator& estimator : GetEstimators())
  {
    PrintRatio(medians, NameOf("precise_tick", estimator.Name, "slide", "256^3"),
      NameOf("placed_as_paper_tick", estimator.Name, "slide", "256^3"), PlacementTarget);
  }
  PrintTitle("Tick on the isosurface, sliding at 0.1 m/s, us");
  for (const char* variant : { "surface_tick/shaded", "surface_tick/flat",
         "local_surface_tick/plane", "local_surface_tick/quadric" })
  {
    const IterationTime tick = medians[std::string(variant) + "/slide/256^3"];
    PrintLine(variant, 1e-3 * tick.Median, 1e-3 * tick.Least, SurfaceTarget);
  }
  PrintTitle("Force field beside the proxy");
  for (const Estimator& estimator : GetEstimators())
  {
    PrintRatio(medians, NameOf("force_field_tick", estimator.Name, "slide", "256^3"),
      NameOf("tick", estimator.Name, "slide", "256^3"), NoTarget);
  }
  PrintTitle("vtkProbeFilter, value and 6 taps, beside a tick");
  for (const Estimator& estimator : GetEstimators())
  {
    PrintRatio(medians, NameOf("vtkProbeFilter", "value+6", "slide", "256^3"),
      NameOf("tick", estimator.Name, "slide", "256^3"), NoTarget);
  }
  PrintTitle("Gradient with the best instruction set beside the baseline's");
  for (const Estimator& estimator : GetEstimators())
  {
    PrintRatio(medians, NameOf("gradient", estimator.Name, "slide", "256^3"),
      NameOf("baseline_gradient", estimator.Name, "slide", "256^3"), NoTarget);
  }
}

void PrintMemory(const BallVolume& volume)
{
  constexpr double mebibyte = 1024.0 * 1024.0;
  std::printf("\n%-70s %7s %7s %7s\n", "Memory beyond the image", "MiB", "", "target");
  for (const Estimator& estimator : GetEstimators())
  {
    const double size = static_cast<double>(MakeModel(volume, estimator)->GetMemorySize());
    std::printf("  %-68s %7.3f %7s %7.2f %s\n", estimator.Name.c_str(), size / mebibyte, "", 1.0,
      size < mebibyte ? "reached" : "NOT reached");
  }
}

} // namespace benchmarks

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Likeness.h"

#include "Shapes.h"

#include <algorithm>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Stiffness = 500.0; // N/m
constexpr double Frictions[] = { 0.0, 0.3 };
constexpr double MostDrawn = 20.0; // %, right end of the curves

double AngleBetween(const Vector3& a, const Vector3& b)
{
  const bool isNone = Norm(a) == 0.0 || Norm(b) == 0.0;
  return isNone ? 180.0 : 360.0 / TwoPi * std::atan2(Norm(Cross(a, b)), Dot(a, b));
}

/**
 * Returns the slope (N/mm) of the force while a stroke presses. A hand perceives this slope as
 * stiffness.
 */
double PressedSlope(const Stroke& stroke, const Trace& trace)
{
  double sum = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < stroke.Pressed; ++i)
  {
    const double depth = Norm(stroke.Tips[i] - stroke.Start);
    sum += depth * Norm(trace[i].Force);
    square += depth * depth;
  }
  return square > 0.0 ? sum / square : 0.0;
}

std::string Cell(const std::vector<double>& values, double scale = 1.0)
{
  const Spread spread = SpreadOf(values);
  return Number(scale * spread.RootMeanSquare) + " / " + Number(scale * spread.Median) + " / " +
    Number(scale * spread.P95);
}

const char* Verdict(const Differences& differences)
{
  if (differences.Percent.empty())
  {
    return "nothing to compare";
  }
  const double force = SpreadOf(differences.Percent).P95;
  const double stiffness = SpreadOf(differences.Stiffness).P95;
  if (SpreadOf(differences.Degrees).P95 >= DirectionThreshold || force >= ForceThresholds.Upper ||
    stiffness >= StiffnessThresholds.Upper)
  {
    return "can be told apart";
  }
  return force < ForceThresholds.Lower && stiffness < StiffnessThresholds.Lower
    ? "not to be told apart"
    : "between the thresholds";
}

/** Returns a curve: the fraction of ticks as a function of the difference. */
Curve Draw(const Method& method, std::vector<double> percents)
{
  Curve curve{ method.Name, {}, {}, method.Colour };
  std::sort(percents.begin(), percents.end());
  for (std::size_t i = 0; i < percents.size() && percents[i] <= MostDrawn; ++i)
  {
    curve.X.push_back(percents[i]);
    curve.Y.push_back(100.0 * static_cast<double>(i + 1) / static_cast<double>(percents.size()));
  }
  return curve;
}
} // namespace

Spread SpreadOf(std::vector<double> values)
{
  if (values.empty())
  {
    return {};
  }
  std::sort(values.begin(), values.end());
  double square = 0.0;
  for (const double value : values)
  {
    square += value * value;
  }
  const std::size_t last = values.size() - 1;
  return { std::sqrt(square / static_cast<double>(values.size())), values[last / 2],
    values[last * 95 / 100] };
}

double FractionBelow(const std::vector<double>& values, double bound)
{
  const auto below =
    std::count_if(values.begin(), values.end(), [&](double value) { return value < bound; });
  return values.empty() ? 0.0
                        : 100.0 * static_cast<double>(below) / static_cast<double>(values.size());
}

void Differences::Add(const Stroke& stroke, const Trace& reference, const Trace& other)
{
  for (std::size_t i = 0; i < reference.size(); ++i)
  {
    const double force = Norm(reference[i].Force);
    if (force < LeastForce)
    {
      continue;
    }
    const double difference = std::abs(Norm(other[i].Force) - force);
    this->Newtons.push_back(difference);
    this->Percent.push_back(100.0 * difference / force);
    if (i >= stroke.Pressed)
    {
      this->Sliding.push_back(this->Percent.back());
    }
    this->Degrees.push_back(AngleBetween(other[i].Force, reference[i].Force));
    this->Millimeters.push_back(Norm(ProxyOf(other[i]) - ProxyOf(reference[i])));
  }
  const double slope = PressedSlope(stroke, reference);
  if (slope > 0.0)
  {
    this->Stiffness.push_back(100.0 * std::abs(PressedSlope(stroke, other) / slope - 1.0));
  }
}

double UnfinishedFraction(const std::vector<Trace>& traces)
{
  std::vector<double> finished;
  for (const Trace& trace : traces)
  {
    for (const TickRecord& tick : trace)
    {
      finished.push_back(tick.IsUnfinished ? 0.0 : 1.0);
    }
  }
  return FractionBelow(finished, 0.5);
}

double OffSurface(const Subject& subject, const std::vector<Trace>& traces)
{
  std::vector<double> distances;
  for (const Trace& trace : traces)
  {
    for (const TickRecord& tick : trace)
    {
      if (Norm(tick.Force) >= LeastForce)
      {
        distances.push_back(subject.Off(ProxyOf(tick)));
      }
    }
  }
  return SpreadOf(distances).RootMeanSquare;
}

Table MakeLikenessTable()
{
  return { "Is it possible to tell the volume haptics from proxy-based surface haptics?",
    "The paper: \"When following well defined surfaces it is virtually impossible to "
    "distinguish the volume haptics algorithm from the proxy-based surface haptics "
    "algorithm.\" Here the same strokes (1.5 mm deep at 0.1 m/s, k = 500 N/m, no limit to "
    "what the surface holds) are played on the same surface, and each method is compared, "
    "tick by tick, with SURFACE_PROXY on the isosurface on which the contact was made; its "
    "sphere (0.02 mm) is taken at its contact. Smoothed: SURFACE_PROXY has the isosurface "
    "of the volume as smoothed by the kernel of PRECISE, so that only the methods differ "
    "(LOCAL_SURFACE, which has the volume's own, is left out there: a plane, renewed 60 times a "
    "second, whose lag is what the figures of the other surfaces show). "
    "Entries are RMS / median / 95th percentile over the ticks at which SURFACE_PROXY holds "
    "more than 0.1 N. Off: RMS distance of the proxy, and of the reference's, to the surface "
    "itself, of which the reference has triangles, straight between samples (for bone, "
    "difference of the value over the gradient). Unfinished: the reference's ticks whose "
    "passes did not do, so that it went on in the next. The plane's 0.4 degrees are those of "
    "force shading, whose normals are central differences. Verdict: not to be told apart, if "
    "the 95th percentiles are below 7 % of force, 8 % of stiffness and 25 degrees, the "
    "smallest differences that people are known to notice (Pang et al. 1991, Tan et al. 1995, "
    "Barbagli et al. 2006); can be told apart beyond 10 %, 22 % or 25 degrees.",
    { "surface", "mu", "method", "force (mN)", "force (%)", "while sliding (%)",
      "direction (degrees)", "position (mm)", "stiffness (%)", "off (mm)", "reference off (mm)",
      "reference unfinished", "ticks < 7 %", "< 10 %", "< 25 deg", "verdict" },
    {} };
}

Plot MakeLikenessPlot(const std::string& file, const std::string& surface)
{
  Plot plot{ file, "Force beside SURFACE_PROXY's, " + surface, "difference of force (%)",
    "share of ticks below (%)", {} };
  for (const double threshold : { ForceThresholds.Lower, ForceThresholds.Upper })
  {
    plot.Curves.push_back(
      { "noticed from " + Number(threshold) + " %", { threshold, threshold }, { 0.0, 100.0 }, 4 });
  }
  return plot;
}

void CompareOn(const Subject& subject, Table& table, Plot* plot)
{
  for (const double friction : Frictions)
  {
    subject.TheScene->SetMaterial(Stiffness, friction);
    std::vector<Trace> references;
    for (const Stroke& stroke : subject.Strokes)
    {
      references.push_back(subject.TheScene->Feel(SurfaceHaptics(), stroke));
    }
    for (const Method& method : AllMethods())
    {
      if (!subject.TheScene->CanFeel(method) || method.Kind == SurfaceHaptics().Kind)
      {
        continue;
      }
      Differences all;
      std::vector<Trace> traces;
      for (std::size_t i = 0; i < references.size(); ++i)
      {
        traces.push_back(subject.TheScene->Feel(method, subject.Strokes[i]));
        if (traces[i].size() == references[i].size())
        {
          all.Add(subject.Strokes[i], references[i], traces[i]);
        }
      }
      if (plot && friction == 0.0)
      {
        plot->Curves.push_back(Draw(method, all.Percent));
      }
      table.Rows.push_back({ subject.Name, Number(friction), method.Name, Cell(all.Newtons, 1000.0),
        Cell(all.Percent), Cell(all.Sliding), Cell(all.Degrees), Cell(all.Millimeters),
        Cell(all.Stiffness), Number(OffSurface(subject, traces)),
        Number(OffSurface(subject, references)), Number(UnfinishedFraction(references)) + " %",
        Number(FractionBelow(all.Percent, ForceThresholds.Lower)) + " %",
        Number(FractionBelow(all.Percent, ForceThresholds.Upper)) + " %",
        Number(FractionBelow(all.Degrees, DirectionThreshold)) + " %", Verdict(all) });
    }
  }
}

} // namespace evaluation

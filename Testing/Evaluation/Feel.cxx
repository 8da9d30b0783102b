// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Feel.h"

#include "Roughness.h"
#include "Shapes.h"
#include "SmoothedVolume.h"

#include "VTK/Baking/HapticBaker.h"

#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkImageMedian3D.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <optional>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
using Filter = vtkVolumeHapticsFilter;

constexpr double Step = 0.05;        // mm a tick: 50 mm/s
constexpr double Depth = 2.0;        // mm
constexpr double Smoothing = 5.0;    // mm, the scale of an arc's course
constexpr double Backing = 4.0;      // mm
constexpr double Leap = 0.5;         // mm, between neighbours of an arc
constexpr double Shortest = 30.0;    // mm
constexpr double Above = 10.0;       // mm, from which the hand comes
constexpr std::size_t Settled = 200; // ticks of a stroke that are not judged

/** A surface to stroke. */
struct Target
{
  const char* Name;
  double Level;  // HU
  double Beyond; // mm, see FindArcs
};
constexpr Target Targets[] = { { "skin", -300.0, 0.0 }, { "skull", 300.0, 10.0 } };

/** A volume and the settings with which it is felt. */
struct Variant
{
  std::string Name;
  std::function<void(Filter*)> Set;
  bool IsFiltered = false; ///< the volume without noise
  int Colour = -1;
};

/** The outermost radius (mm) at which a value is reached, and stays so. */
std::optional<double> FindRadius(const SmoothedVolume& volume, double level, const Vector3& middle,
  const Vector3& out, const double* box)
{
  const double width = 0.5 * (box[1] - box[0]);
  const double height = 0.5 * (box[3] - box[2]);
  const double reach =
    std::min(width / std::max(std::abs(out.X), 1e-9), height / std::max(std::abs(out.Y), 1e-9));
  const auto value = [&](double radius) { return volume.Value(middle + radius * out); };
  constexpr double step = 0.5;
  for (double radius = reach - step; radius > Backing; radius -= step)
  {
    if (value(radius) < level)
    {
      continue;
    }
    double below = radius;
    while (below > radius - Backing && value(below) >= level)
    {
      below -= step;
    }
    if (below > radius - Backing)
    {
      radius = below; // too thin
      continue;
    }
    double inside = radius;
    double outside = radius + step;
    for (int i = 0; i < 20; ++i)
    {
      const double between = 0.5 * (inside + outside);
      (value(between) < level ? outside : inside) = between;
    }
    return inside;
  }
  return {};
}

/** Smoothed by a Gaussian, with the ends repeated. */
std::vector<double> Smooth(const std::vector<double>& values, double scale)
{
  const int reach = static_cast<int>(4.0 * scale);
  const int last = static_cast<int>(values.size()) - 1;
  std::vector<double> smooth(values.size());
  for (int i = 0; i <= last; ++i)
  {
    double sum = 0.0;
    double weights = 0.0;
    for (int j = -reach; j <= reach; ++j)
    {
      const double w = std::exp(-0.5 * j * j / (scale * scale));
      sum += w * values[std::clamp(i + j, 0, last)];
      weights += w;
    }
    smooth[i] = sum / weights;
  }
  return smooth;
}

/** A run of radii as an arc, without the ends, whose course is not smoothed from both sides. */
std::optional<Arc> MakeArc(const std::vector<double>& radii, const std::vector<Vector3>& outs,
  const Vector3& middle, double beyond)
{
  const auto margin = static_cast<std::size_t>(2.0 * Smoothing / Step);
  if (static_cast<double>(radii.size()) * Step < Shortest + 4.0 * Smoothing)
  {
    return {};
  }
  const std::vector<double> course = Smooth(radii, Smoothing / Step);
  const auto tip = [&](std::size_t i, double depth)
  { return middle + (course[i] - depth) * outs[i]; };
  Arc arc;
  arc.Tips = { tip(margin, -Above) };
  MoveTo(arc.Tips, tip(margin, Depth + beyond), Step);
  MoveTo(arc.Tips, tip(margin, Depth), Step);
  arc.Pressed = arc.Tips.size();
  for (std::size_t i = margin; i < course.size() - margin; ++i)
  {
    arc.Tips.push_back(tip(i, Depth));
  }
  return arc;
}

/** Makes the ramps between the materials of a function at least so wide (HU). */
void Widen(vtkPiecewiseFunction* function, double width)
{
  std::vector<std::array<double, 4>> nodes(function->GetSize());
  for (int i = 0; i < function->GetSize(); ++i)
  {
    function->GetNodeValue(i, nodes[i].data());
  }
  function->RemoveAllPoints();
  for (std::size_t i = 0; i < nodes.size(); ++i)
  {
    // Nodes come in pairs: the ends of a material's range.
    const bool isLow = i % 2 == 0;
    const std::size_t other = isLow ? i - 1 : i + 1;
    const bool hasOther = isLow ? i > 0 : other < nodes.size();
    const double gap = hasOther ? std::abs(nodes[other][0] - nodes[i][0]) : width;
    const double shift = 0.5 * std::max(0.0, width - gap);
    const double range = std::abs(nodes[isLow ? i + 1 : i - 1][0] - nodes[i][0]);
    function->AddPoint(
      nodes[i][0] + (isLow ? 1.0 : -1.0) * std::min(shift, 0.5 * range - 0.1), nodes[i][1]);
  }
}

vtkSmartPointer<vtkImageData> RemoveNoise(vtkImageData* volume)
{
  vtkNew<vtkImageMedian3D> median;
  median->SetKernelSize(3, 3, 3);
  median->SetInputDataObject(0, volume);
  median->Update();
  return median->GetOutput();
}

std::vector<Variant> MakeVariants()
{
  std::vector<Variant> variants;
  for (const Method& method : AllMethods())
  {
    // A field of forces has no surface, and the law of local surfaces is not on trial.
    if (method.Kind == Filter::PROXY || method.Kind == Filter::SURFACE_PROXY)
    {
      variants.push_back({ method.Name,
        [method](Filter* filter)
        {
          filter->SetMethod(method.Kind);
          filter->SetSolver(method.Solver);
        },
        false, method.Colour });
    }
  }
  const auto edge = [](Filter* filter) { filter->SetContactAlignment(Filter::EDGE); };
  const auto functions = [](Filter* filter)
  {
    vtkHapticProperty* const feel = filter->GetProperty();
    return std::array<vtkPiecewiseFunction*, 4>{ feel->GetStiffness(), feel->GetFriction(),
      feel->GetViscosity(), feel->GetSurfaceStrength() };
  };
  variants.push_back({ "PRECISE, Edge", edge });
  variants.push_back({ "... without noise (median of 27)", edge, true });
  variants.push_back({ "... ramps of 60 HU",
    [=](Filter* filter)
    {
      edge(filter);
      for (vtkPiecewiseFunction* const function : functions(filter))
      {
        Widen(function, 60.0);
      }
    } });
  variants.push_back({ "... one stiffness",
    [=](Filter* filter)
    {
      edge(filter);
      SetConstant(filter->GetProperty()->GetStiffness(), 500.0);
    } });
  variants.push_back({ "... one strength",
    [=](Filter* filter)
    {
      edge(filter);
      SetConstant(filter->GetProperty()->GetSurfaceStrength(), Impenetrable);
    } });
  variants.push_back({ "... one material",
    [=](Filter* filter)
    {
      edge(filter);
      const double values[] = { 500.0, 0.2, 0.2, Impenetrable };
      for (std::size_t i = 0; i < 4; ++i)
      {
        SetConstant(functions(filter)[i], values[i]);
      }
    } });
  return variants;
}

/** The force's magnitude along each arc, strokes only; none after an error of the filter. */
std::vector<std::vector<double>> FeelArcs(
  vtkImageData* volume, const Variant& variant, double level, const std::vector<Arc>& arcs)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(0, volume);
  filter->GetProperty()->ApplyPreset("CT contrast");
  filter->SetIsoValue(level);
  filter->SetProxyRadius(ProbeRadius);
  variant.Set(filter);
  const auto model = HapticBaker(filter).Bake(1000.0, {}, nullptr);
  std::vector<std::vector<double>> forces;
  for (std::size_t i = 0; model && i < arcs.size(); ++i)
  {
    const Trace trace = Play(*model, arcs[i].Tips);
    forces.emplace_back();
    for (std::size_t tick = arcs[i].Pressed + Settled; tick < trace.size(); ++tick)
    {
      forces.back().push_back(Norm(trace[tick].Force));
    }
  }
  return forces;
}
} // namespace

std::vector<Arc> FindArcs(vtkImageData* volume, double level, double beyond, const Effort& effort)
{
  const SmoothedVolume smoothed(volume);
  if (!smoothed.IsValid())
  {
    return {};
  }
  double box[6];
  volume->GetBounds(box);
  const int heights = effort.Pick(2, 6);
  const int count = static_cast<int>(TwoPi * 80.0 / Step); // a head's radius is about 80 mm
  std::vector<Arc> arcs;
  for (int height = 0; height < heights; ++height)
  {
    const double share = 0.6 + 0.25 * (height + 0.5) / heights;
    const Vector3 middle = { 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]),
      box[4] + share * (box[5] - box[4]) };
    std::vector<double> radii;
    std::vector<Vector3> outs;
    const auto end = [&]()
    {
      if (const auto arc = MakeArc(radii, outs, middle, beyond))
      {
        arcs.push_back(*arc);
      }
      radii.clear();
      outs.clear();
    };
    for (int i = 0; i < count; ++i)
    {
      const double angle = TwoPi * i / count;
      const Vector3 out = { std::cos(angle), std::sin(angle), 0.0 };
      const auto radius = FindRadius(smoothed, level, middle, out, box);
      if (!radius || (!radii.empty() && std::abs(*radius - radii.back()) > Leap))
      {
        end();
      }
      if (radius)
      {
        radii.push_back(*radius);
        outs.push_back(out);
      }
    }
    end();
  }
  return arcs;
}

Table CompareFeel(vtkImageData* volume, const Effort& effort, std::vector<Plot>& plots)
{
  Table table{ "Smooth or rough: strokes over skin and skull",
    "Arcs at 50 mm/s, 2 mm under the smoothed course of the surface, preset \"CT contrast\". "
    "Shares are the root mean square of the force in a band beside its mean. A drop is a fall by "
    "more than 30 % within 5 ms, a reversal a rise after a fall, each by 5 % of the mean. The "
    "lines that begin with ... take one cause away at a time.",
    { "surface", "method", "mean (N)", "30-100 Hz (%)", "100-500 Hz (%)", "drops / s",
      "reversals / s", "largest step (N)" },
    {} };
  const vtkSmartPointer<vtkImageData> quiet = RemoveNoise(volume);
  for (const Target& target : Targets)
  {
    const std::vector<Arc> arcs = FindArcs(volume, target.Level, target.Beyond, effort);
    Plot plot{ std::string("feel-") + target.Name,
      std::string("Force of a stroke over the ") + target.Name, "time (s)", "force (N)", {} };
    for (const Variant& variant : MakeVariants())
    {
      const auto forces =
        FeelArcs(variant.IsFiltered ? quiet.Get() : volume, variant, target.Level, arcs);
      std::vector<Roughness> each;
      std::transform(forces.begin(), forces.end(), std::back_inserter(each), FindRoughness);
      const Roughness all = Average(each);
      const double perSecond = all.Duration > 0.0 ? 1.0 / all.Duration : 0.0;
      table.Rows.push_back({ target.Name, variant.Name, Number(all.Mean), Number(all.Low),
        Number(all.High), Number(perSecond * all.Drops), Number(perSecond * all.Reversals),
        Number(all.LargestStep) });
      if (variant.Colour >= 0 && !forces.empty())
      {
        Curve curve{ variant.Name, {}, forces.front(), variant.Colour };
        for (std::size_t i = 0; i < curve.Y.size(); ++i)
        {
          curve.X.push_back(0.001 * static_cast<double>(i));
        }
        plot.Curves.push_back(std::move(curve));
      }
    }
    plots.push_back(std::move(plot));
  }
  return table;
}

} // namespace evaluation

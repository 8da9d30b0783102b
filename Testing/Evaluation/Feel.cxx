// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Feel.h"

#include "Roughness.h"
#include "Shapes.h"
#include "SmoothedVolume.h"

#include "VTK/Filter/HapticBaker.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkImageMedian3D.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"

#include <algorithm>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
using Filter = vtkVolumeHapticsFilter;

constexpr std::size_t Window = 5; // ticks during which a force must fall to count as a drop
constexpr double LongMove = 0.3;  // mm in one tick: a jump of the proxy

constexpr const char* ByDefault = "PRECISE";
constexpr const char* SmoothedMesh = "SURFACE_PROXY, of smoothed data";

enum class Data
{
  AsIs,
  Filtered,  ///< the volume after noise filtering
  SmoothMesh ///< isosurface of the volume after the kernel's smoothing
};

/** A method and settings to compare. */
struct Variant
{
  std::string Name;
  std::function<void(Filter*, const FeltSurface&)> Set;
  Data Of = Data::AsIs;
  int Colour = -1;
};

/** Results of all strokes with one variant. */
struct Felt
{
  Roughness All;
  DropCauses Causes;
  std::vector<double> First; ///< N: force along the first stroke
};

vtkSmartPointer<vtkImageData> RemoveNoise(vtkImageData* volume)
{
  vtkNew<vtkImageMedian3D> median;
  median->SetKernelSize(3, 3, 3);
  median->SetInputDataObject(0, volume);
  median->Update();
  return median->GetOutput();
}

std::array<vtkPiecewiseFunction*, 4> FunctionsOf(Filter* filter)
{
  vtkHapticProperty* const feel = filter->GetProperty();
  return { feel->GetStiffness(), feel->GetFriction(), feel->GetViscosity(),
    feel->GetSurfaceStrength() };
}

/** Selects PRECISE with the settings whose roughness is analysed. */
void SetEdge(Filter* filter)
{
  filter->SetContactAlignment(Filter::EDGE);
  filter->SetMaterialPlacement(Filter::KERNEL);
}

std::vector<Variant> MakeMethods()
{
  std::vector<Variant> variants;
  for (const Method& method : AllMethods())
  {
    variants.push_back({ method.Name,
      [method](Filter* filter, const FeltSurface&)
      {
        filter->SetMethod(method.Kind);
        filter->SetSolver(method.Solver);
      },
      Data::AsIs, method.Colour });
  }
  variants.push_back({ SmoothedMesh,
    [](Filter* filter, const FeltSurface&) { filter->SetMethod(Filter::SURFACE_PROXY); },
    Data::SmoothMesh });
  return variants;
}

std::vector<Variant> MakeVariants()
{
  std::vector<Variant> variants = MakeMethods();
  const std::pair<const char*, int> placements[] = { { "far side", Filter::FAR_SIDE },
    { "kernel", Filter::KERNEL } };
  const std::pair<const char*, int> alignments[] = { { "Distinctness", Filter::DISTINCTNESS },
    { "Edge", Filter::EDGE } };
  for (const auto& [place, placement] : placements)
  {
    for (const auto& [align, alignment] : alignments)
    {
      variants.push_back({ std::string("PRECISE, ") + place + ", " + align,
        [placement = placement, alignment = alignment](Filter* filter, const FeltSurface&)
        {
          filter->SetMaterialPlacement(placement);
          filter->SetContactAlignment(alignment);
        } });
    }
  }
  variants.push_back({ "... without noise (median of 27)",
    [](Filter* filter, const FeltSurface&) { SetEdge(filter); }, Data::Filtered });
  variants.push_back({ "... wide ramps",
    [](Filter* filter, const FeltSurface& surface)
    {
      SetEdge(filter);
      for (vtkPiecewiseFunction* const function : FunctionsOf(filter))
      {
        Widen(function, surface.WideRamp);
      }
    } });
  variants.push_back({ "... one stiffness",
    [](Filter* filter, const FeltSurface&)
    {
      SetEdge(filter);
      SetConstant(filter->GetProperty()->GetStiffness(), 500.0);
    } });
  variants.push_back({ "... one strength",
    [](Filter* filter, const FeltSurface&)
    {
      SetEdge(filter);
      SetConstant(filter->GetProperty()->GetSurfaceStrength(), Impenetrable);
    } });
  variants.push_back({ "... one material",
    [](Filter* filter, const FeltSurface&)
    {
      SetEdge(filter);
      const double values[] = { 500.0, 0.2, 0.2, Impenetrable };
      for (std::size_t i = 0; i < 4; ++i)
      {
        SetConstant(FunctionsOf(filter)[i], values[i]);
      }
    } });
  return variants;
}

/** Runs all strokes over a surface. After an error of the filter, the result has no force. */
Felt FeelArcs(const FeltSurface& surface, const Variant& variant, vtkImageData* filtered,
  vtkPolyData* smoothMesh)
{
  vtkNew<Filter> filter;
  filter->SetInputDataObject(
    0, variant.Of == Data::Filtered ? filtered : surface.Image.GetPointer());
  filter->GetProperty()->ApplyPreset(surface.Preset.c_str());
  filter->SetIsoValue(surface.Level);
  filter->SetProxyRadius(ProbeRadius);
  if (variant.Of == Data::SmoothMesh)
  {
    filter->SetSurfaceData(smoothMesh);
  }
  variant.Set(filter, surface);
  const auto model = filter->GetBaker().Bake(1000.0, {}, nullptr);
  Felt felt;
  std::vector<Roughness> each;
  for (std::size_t i = 0; model && i < surface.Arcs.size(); ++i)
  {
    const Arc& arc = surface.Arcs[i];
    const Trace trace = Play(*model, arc.Tips);
    const std::size_t first = arc.GetSettled();
    std::vector<double> force;
    for (std::size_t tick = first; tick < trace.size(); ++tick)
    {
      force.push_back(Norm(trace[tick].Force));
    }
    each.push_back(MeasureRoughness(force));
    AddDropCauses(trace, first, felt.Causes);
    if (i == 0)
    {
      felt.First = std::move(force);
    }
  }
  felt.All = Average(each);
  return felt;
}

Curve MakeCurve(const Variant& variant, const std::vector<double>& force)
{
  Curve curve{ variant.Name, {}, force, variant.Colour };
  for (std::size_t i = 0; i < force.size(); ++i)
  {
    curve.X.push_back(0.001 * static_cast<double>(i));
  }
  return curve;
}

/**
 * Adds the figures that the default settings must reach. The roughness of the mesh is the bound.
 */
void AddRequired(
  const std::string& name, const Roughness& felt, double smoothest, Figures& required)
{
  const double seconds = std::max(felt.Duration, 1e-9);
  required.push_back({ name + ", 30-500 Hz", "% of the mean", felt.Both, smoothest });
  required.push_back({ name + ", drops (> 30 % within 5 ms)", "/s", felt.Drops / seconds, 0.0 });
  required.push_back({ name + ", largest step of |F| in a tick", "N", felt.LargestStep, 0.1 });
}
} // namespace

void Widen(vtkPiecewiseFunction* function, double width)
{
  constexpr int samples = 16; // samples of a width, on each side
  double range[2];
  function->GetRange(range);
  const double step = width / samples;
  const auto count = static_cast<std::size_t>(std::ceil((range[1] - range[0]) / step)) + samples;
  std::vector<double> sums(count + samples + 2, 0.0); // integral of the function before each sample
  const double start = range[0] - width;
  for (std::size_t i = 1; i < sums.size(); ++i)
  {
    sums[i] = sums[i - 1] + function->GetValue(start + (static_cast<double>(i) - 0.5) * step);
  }
  function->RemoveAllPoints();
  for (std::size_t i = 0; i + samples < sums.size(); ++i)
  {
    function->AddPoint(start + (static_cast<double>(i) + 0.5 * samples) * step,
      (sums[i + samples] - sums[i]) / samples);
  }
}

void AddDropCauses(const Trace& trace, std::size_t first, DropCauses& causes)
{
  std::vector<double> force;
  for (std::size_t i = first; i < trace.size(); ++i)
  {
    force.push_back(Norm(trace[i].Force));
  }
  for (const std::size_t drop : DetectDrops(force))
  {
    bool strength = false;
    bool stiffness = false;
    bool snap = false;
    const auto differ = [](double a, double b, double factor)
    { return std::max(a, b) > factor * std::min(a, b); };
    for (std::size_t i = first + drop + 1 - Window; i <= first + drop; ++i)
    {
      const TickRecord& before = trace[i - 1];
      const TickRecord& after = trace[i];
      strength = strength || differ(before.SurfaceStrength, after.SurfaceStrength, 2.0);
      stiffness = stiffness || differ(before.Stiffness, after.Stiffness, 1.2);
      snap = snap || Norm(ProxyOf(after) - ProxyOf(before)) > LongMove;
    }
    ++causes.Drops;
    causes.Strength += strength ? 1 : 0;
    causes.Stiffness += stiffness ? 1 : 0;
    causes.Snap += snap ? 1 : 0;
    causes.Unexplained += strength || stiffness || snap ? 0 : 1;
  }
}

Feel MeasureFeel(const std::vector<FeltSurface>& surfaces)
{
  Table roughness{ "Smooth or rough: strokes over the surfaces of scans",
    "Arcs at 50 mm/s, 2 mm under the smoothed course of the surface. Shares are the root mean "
    "square of the force in a band beside its mean. A drop is a fall by more than 30 % within "
    "5 ms, a reversal a rise after a fall, each by 5 % of the mean. PRECISE has its default "
    "settings; the lines that begin with ... take one cause away from \"PRECISE, kernel, Edge\" at "
    "a time. "
    "Wide ramps: the functions are averaged over 60 HU, or 30 grey levels.",
    { "surface", "method", "mean (N)", "30-100 Hz (%)", "100-500 Hz (%)", "30-500 Hz (%)",
      "drops / s", "reversals / s", "largest step (N)" },
    {} };
  Table drops{ "What changes within the 5 ms of a drop",
    "Of the drops above: those during which the strength of the surface changes more than "
    "twofold, the stiffness by more than a fifth, the proxy moves by more than 0.3 mm in a tick, "
    "and those with none of these.",
    { "surface", "method", "drops", "strength", "stiffness", "snap of the proxy", "none" }, {} };
  Feel feel;
  for (const FeltSurface& surface : surfaces)
  {
    const std::string name = surface.Scan + ", " + surface.Name;
    if (surface.Arcs.empty())
    {
      roughness.Rows.push_back({ name, "no arc of 30 mm", "", "", "", "", "", "", "" });
      continue;
    }
    const vtkSmartPointer<vtkImageData> filtered = RemoveNoise(surface.Image);
    const vtkSmartPointer<vtkPolyData> mesh =
      SmoothedVolume(surface.Image).ComputeSurface(surface.Level);
    Plot plot{ "feel-" + surface.Scan + "-" + surface.Name, "Force of a stroke: " + name,
      "time (s)", "force (N)", {} };
    std::replace(plot.File.begin(), plot.File.end(), ' ', '-');
    Roughness precise;
    Roughness smoothest;
    for (const Variant& variant : MakeVariants())
    {
      const Felt felt = FeelArcs(surface, variant, filtered, mesh);
      const Roughness& all = felt.All;
      const double perSecond = all.Duration > 0.0 ? 1.0 / all.Duration : 0.0;
      roughness.Rows.push_back({ name, variant.Name, Number(all.Mean), Number(all.Low),
        Number(all.High), Number(all.Both), Number(perSecond * all.Drops),
        Number(perSecond * all.Reversals), Number(all.LargestStep) });
      const DropCauses& causes = felt.Causes;
      if (causes.Drops > 0)
      {
        drops.Rows.push_back({ name, variant.Name, std::to_string(causes.Drops),
          std::to_string(causes.Strength), std::to_string(causes.Stiffness),
          std::to_string(causes.Snap), std::to_string(causes.Unexplained) });
      }
      if (variant.Colour >= 0)
      {
        plot.Curves.push_back(MakeCurve(variant, felt.First));
      }
      precise = variant.Name == ByDefault ? all : precise;
      smoothest = variant.Name == SmoothedMesh ? all : smoothest;
    }
    feel.Found.Plots.push_back(std::move(plot));
    if (surface.IsRequired)
    {
      AddRequired(name, precise,
        surface.RoughestFraction > 0.0 ? surface.RoughestFraction : smoothest.Both, feel.Required);
    }
  }
  feel.Found.Tables = { std::move(roughness), std::move(drops) };
  return feel;
}

Table ComparePresets(const std::vector<FeltSurface>& surfaces)
{
  Table table{ "Presets on the surfaces that they are for", "The same strokes, default settings.",
    { "preset", "surface", "mean (N)", "30-500 Hz (%)", "drops / s", "largest step (N)" }, {} };
  const Variant byDefault{ ByDefault, [](Filter*, const FeltSurface&) {} };
  for (FeltSurface surface : surfaces)
  {
    std::vector<std::string> presets = { surface.Preset };
    if (surface.Scan == "chest CT")
    {
      presets.insert(presets.end(), { "CT chest", "CT angiography" });
    }
    for (const std::string& preset : presets)
    {
      surface.Preset = preset;
      const Roughness felt = FeelArcs(surface, byDefault, nullptr, nullptr).All;
      const double perSecond = felt.Duration > 0.0 ? 1.0 / felt.Duration : 0.0;
      table.Rows.push_back({ preset, surface.Scan + ", " + surface.Name, Number(felt.Mean),
        Number(felt.Both), Number(perSecond * felt.Drops), Number(felt.LargestStep) });
    }
  }
  return table;
}

} // namespace evaluation

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/TissueTable.h"

#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRegionFilter.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTable.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <limits>

namespace
{
using Explore::Analysis;
using Explore::VolumeKind;

constexpr double ENDLESS = std::numeric_limits<double>::infinity();

/// Smallest noise, as a fraction of the range. Smaller values are rounding to 8 bits, or gradual
/// changes within smooth parts.
constexpr double LEAST_NOISE = 0.002;

/// If no tissue is denser than the body, moves the deep threshold to the middle of the body's
/// range.
void PutDeepInside(Analysis& analysis)
{
  if (analysis.DeepThreshold <= analysis.OuterThreshold)
  {
    analysis.DeepThreshold =
      std::max(analysis.OuterThreshold, 0.5 * (analysis.OuterThreshold + analysis.High));
  }
}

double EdgeOf(const Analysis& analysis)
{
  return 0.02 * (analysis.High - analysis.Low);
}

/// The values of an image's background and of its solid parts.
struct Background
{
  double Noise = 0.0;
  double Threshold = 0.0; ///< upper limit of values that are not solid
  double Full = 0.0;      ///< lower limit of solid values; unknown if it is at most Threshold
};

Background FindBackground(vtkImageData* image)
{
  // computes statistics of the whole volume; its output region is only one sample
  vtkNew<vtkHapticRegionFilter> whole;
  const int* const extent = image->GetExtent();
  whole->SetRegion(extent[0], extent[0], extent[2], extent[2], extent[4], extent[4]);
  whole->SetInputData(image);
  whole->Update();
  vtkFieldData* const facts = whole->GetOutput()->GetFieldData();
  vtkDataArray* const noise = facts->GetArray("HapticNoise");
  vtkDataArray* const solid = facts->GetArray("HapticSolid");
  return noise && solid
    ? Background{ noise->GetTuple1(0), solid->GetTuple1(0), solid->GetTuple1(1) }
    : Background{};
}

/// Raises the outer threshold above the background's noise, if the brightness of the background is
/// known.
void LeaveBackground(Analysis& analysis, vtkImageData* image)
{
  if (analysis.Kind == VolumeKind::Field)
  {
    return; // in a simulation's field, values near the background are data, not noise
  }
  const Background found = FindBackground(image);
  if (found.Threshold < found.Full &&
    found.Noise >= LEAST_NOISE * (analysis.Range[1] - analysis.Range[0]))
  {
    analysis.OuterThreshold = std::max(analysis.OuterThreshold, found.Threshold + EdgeOf(analysis));
    PutDeepInside(analysis);
  }
}

/// Moves the outer threshold to the value at which the preset reaches half of its surface strength,
/// so that the background is hidden.
void BeginAtSolid(Analysis& analysis, vtkImageData* image)
{
  const Background found = FindBackground(image);
  if (found.Threshold < found.Full)
  {
    analysis.OuterThreshold =
      std::max(analysis.OuterThreshold, 0.5 * (found.Threshold + found.Full));
    PutDeepInside(analysis);
  }
}

/// Makes a function with steps at the two thresholds. The steps are slightly smoothed, so that
/// nothing jumps.
void TwoSteps(vtkPiecewiseFunction* function, const Analysis& analysis, const double values[3])
{
  const double edge = EdgeOf(analysis);
  function->RemoveAllPoints();
  function->AddPoint(analysis.OuterThreshold - edge, values[0]);
  function->AddPoint(analysis.OuterThreshold, values[1]);
  function->AddPoint(analysis.DeepThreshold - edge, values[1]);
  function->AddPoint(analysis.DeepThreshold, values[2]);
}

void HistogramMaterials(const Analysis& analysis, vtkHapticProperty* property)
{
  // Free below OuterThreshold, soft above it, and hard above DeepThreshold.
  const double stiffness[3] = { 0.0, 350.0, 800.0 };
  const double friction[3] = { 0.0, 0.25, 0.30 };
  const double viscosity[3] = { 0.0, 0.2, 0.2 };
  const double strength[3] = { 0.0, 1.2, 20.0 };
  TwoSteps(property->GetStiffness(), analysis, stiffness);
  TwoSteps(property->GetFriction(), analysis, friction);
  TwoSteps(property->GetViscosity(), analysis, viscosity);
  TwoSteps(property->GetSurfaceStrength(), analysis, strength);
  const double edge = EdgeOf(analysis);
  const double ends[2] = { std::min(analysis.Low, analysis.OuterThreshold - 2.0 * edge),
    std::max(analysis.High, analysis.DeepThreshold + edge) };
  property->RemoveAllTissues();
  property->AddTissue("background", ends[0], analysis.OuterThreshold - edge);
  if (analysis.DeepThreshold - edge > analysis.OuterThreshold)
  {
    property->AddTissue("body, darker", analysis.OuterThreshold, analysis.DeepThreshold - edge);
    property->AddTissue("body, brighter", analysis.DeepThreshold, ends[1]);
  }
  // A surface counts as distinct if its values change within about 8 mm or less.
  const double step = analysis.OuterThreshold - analysis.Low;
  const double gradient = step * analysis.MetersPerWorldUnit / 0.008;
  property->GetDistinctness()->RemoveAllPoints();
  property->GetDistinctness()->AddPoint(0.25 * gradient, 0.0);
  property->GetDistinctness()->AddPoint(gradient, 1.0);
  property->DistinctnessPerMillimeterOff();
  property->SolidFromImageOff();
  property->ShiftFromImageOff();
}

/// Returns the value in the middle of a boundary or, if the strength there is still 0, the value at
/// which the strength begins.
double ComputeFeltMiddle(vtkPiecewiseFunction* strength, double low, double high)
{
  const double middle = 0.5 * (low + high);
  for (int i = 1; i < strength->GetSize(); ++i)
  {
    double from[4]; // value, strength, midpoint and sharpness
    double to[4];
    strength->GetNodeValue(i - 1, from);
    strength->GetNodeValue(i, to);
    if (from[1] == 0.0 && to[1] > 0.0 && from[0] >= low && from[0] < high)
    {
      return std::max(middle, from[0]);
    }
  }
  return middle;
}

/// Like ComputeFeltMiddle(), for a boundary of a dark body, whose strength ends within the
/// boundary.
double ComputeDarkMiddle(vtkPiecewiseFunction* strength, double low, double high)
{
  const double middle = 0.5 * (low + high);
  for (int i = 1; i < strength->GetSize(); ++i)
  {
    double from[4];
    double to[4];
    strength->GetNodeValue(i - 1, from);
    strength->GetNodeValue(i, to);
    if (from[1] > 0.0 && to[1] == 0.0 && to[0] > low && to[0] <= high)
    {
      return std::min(middle, to[0]);
    }
  }
  return middle;
}

/// Proposes functions from the image. Returns the reason if that is impossible; otherwise an empty
/// text.
std::string Propose(vtkImageData* image, vtkVolumeHapticsFilter* filter)
{
  vtkHapticProperty* const property = filter->GetProperty();
  const Explore::MessageCapture capture;
  if (!property->ProposeFromImage(image))
  {
    std::string reason = capture.FirstError();
    reason.resize(reason.find_last_not_of('.') + 1);
    return reason.empty() ? "no functions can be proposed" : reason;
  }
  filter->SetKernelRadius(property->GetProposedKernelRadius());
  return {};
}
} // namespace

namespace Explore
{
std::vector<Tissue> MakeTissueTable(const Analysis& analysis)
{
  if (analysis.Kind == VolumeKind::CT)
  {
    return { { "air", -ENDLESS, -950.0 }, { "lung or air-filled", -950.0, -500.0 },
      { "edge of the skin", -500.0, -150.0 }, { "fat", -150.0, -20.0 }, { "fluid", -20.0, 17.5 },
      { "muscle, organ", 17.5, 90.0 }, { "contrast medium, cartilage", 90.0, 300.0 },
      { "bone", 300.0, ENDLESS } };
  }
  if (analysis.Kind == VolumeKind::Field || analysis.Kind == VolumeKind::Labels)
  {
    return {};
  }
  if (analysis.IsDark)
  {
    return { { "body", -ENDLESS, analysis.OuterThreshold },
      { "background", analysis.OuterThreshold, ENDLESS } };
  }
  return { { "background", -ENDLESS, analysis.OuterThreshold },
    { "body, darker", analysis.OuterThreshold, analysis.DeepThreshold },
    { "body, brighter", analysis.DeepThreshold, ENDLESS } };
}

std::size_t FindTissue(const std::vector<Tissue>& table, double value)
{
  std::size_t row = 0;
  while (row + 1 < table.size() && value >= table[row].To)
  {
    ++row;
  }
  return row;
}

std::string ApplyMaterials(const std::string& preset, Analysis& analysis, vtkImageData* image,
  vtkVolumeHapticsFilter* filter)
{
  const bool isAutomatic = preset == "auto";
  std::string name = preset;
  if (isAutomatic)
  {
    name = analysis.Kind == VolumeKind::CT  ? "CT contrast"
      : analysis.Kind == VolumeKind::Labels ? "Labels"
                                            : "propose";
  }
  if (name == "propose")
  {
    const std::string reason = Propose(image, filter);
    if (reason.empty())
    {
      return name;
    }
    if (!isAutomatic)
    {
      throw InputError("--preset propose", reason, "use another preset");
    }
    name = "histogram";
    // Place the surface where the body begins, because the steepest place of the edge is
    // meaningless for this image.
    filter->SetContactAlignmentToDistinctness();
  }
  if (name == "histogram")
  {
    LeaveBackground(analysis, image);
    HistogramMaterials(analysis, filter->GetProperty());
    return name;
  }
  const MessageCapture capture;
  if (!filter->GetProperty()->ApplyPreset(name.c_str(), image))
  {
    throw InputError("--preset " + name, capture.FirstError(),
      "use auto, propose, histogram, one of the presets, or a file that ends in .json, such as "
      "key F8 in the window saves");
  }
  if (filter->GetProperty()->GetSolidFromImage() && analysis.Kind != VolumeKind::CT &&
    analysis.Kind != VolumeKind::Labels)
  {
    BeginAtSolid(analysis, image);
  }
  return name;
}

void FitThresholds(vtkHapticProperty* property, Analysis& analysis)
{
  vtkTable* const boundaries = property->GetProposedBoundaries();
  if (analysis.Kind == VolumeKind::CT || !boundaries)
  {
    return; // the thresholds of a CT are fixed, and without boundaries nothing was proposed
  }
  const auto column = [&](const char* name)
  { return vtkDataArray::SafeDownCast(boundaries->GetColumnByName(name)); };
  vtkDataArray* const low = column("Low");
  vtkDataArray* const high = column("High");
  vtkDataArray* const area = column("Share");
  analysis.IsDark = property->GetSurfaceSide() == vtkHapticProperty::LOWER;
  double largest = 0.0;
  for (vtkIdType i = 0; i < boundaries->GetNumberOfRows(); ++i)
  {
    const double from = low->GetComponent(i, 0);
    const double to = high->GetComponent(i, 0);
    vtkPiecewiseFunction* const strength = property->GetSurfaceStrength();
    const bool isOutside = strength->GetValue(analysis.IsDark ? to : from) == 0.0;
    if (isOutside && area->GetComponent(i, 0) > largest)
    {
      largest = area->GetComponent(i, 0);
      analysis.OuterThreshold = analysis.IsDark ? ComputeDarkMiddle(strength, from, to)
                                                : ComputeFeltMiddle(strength, from, to);
    }
  }
  if (largest > 0.0)
  {
    PutDeepInside(analysis);
  }
}
} // namespace Explore

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "InsideTissues.h"

#include "Roughness.h"
#include "Shapes.h"

#include "VTK/Filter/HapticBaker.h"

#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkImageGaussianSmooth.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Blur = 1.0;             // mm, scale of the smoothing
constexpr double StrokeStep = 0.045;     // mm per tick
constexpr double LookStep = 1.0;         // mm, along a stroke
constexpr std::size_t SkippedTicks = 60; // ticks until the drag has built up
constexpr int MostAttempts = 2000000;

vtkSmartPointer<vtkImageData> Smooth(vtkImageData* image)
{
  const double* const spacing = image->GetSpacing();
  vtkNew<vtkImageGaussianSmooth> smooth;
  smooth->SetInputData(image);
  smooth->SetStandardDeviations(Blur / spacing[0], Blur / spacing[1], Blur / spacing[2]);
  smooth->Update();
  return smooth->GetOutput();
}

/** Tests whether positions are in a tissue, by the value and label of the nearest voxel. */
class Look
{
public:
  Look(const BandedScan& scan, const TissueBand& tissue)
    : Smoothed(Smooth(scan.Image))
    , Labels(scan.Labels)
    , Tissue(tissue)
  {
    this->Smoothed->GetDimensions(this->Size);
  }

  bool IsOfTissue(const Vector3& world) const
  {
    const double x[3] = { world.X, world.Y, world.Z };
    double index[3];
    this->Smoothed->TransformPhysicalPointToContinuousIndex(x, index);
    int at[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      at[axis] = static_cast<int>(std::lround(index[axis]));
      if (at[axis] < 0 || at[axis] >= this->Size[axis])
      {
        return false;
      }
    }
    const double value = this->Smoothed->GetScalarComponentAsDouble(at[0], at[1], at[2], 0);
    return value > this->Tissue.Low && value < this->Tissue.High &&
      (!this->Labels ||
        this->Tissue.Labels.count(
          static_cast<int>(this->Labels->GetScalarComponentAsDouble(at[0], at[1], at[2], 0))) > 0);
  }

  /** Returns whether all positions at the margin around `at` belong to the tissue. */
  bool IsInside(const Vector3& at) const
  {
    for (int i = -1; i <= 1; ++i)
    {
      for (int j = -1; j <= 1; ++j)
      {
        for (int k = -1; k <= 1; ++k)
        {
          const double size = std::sqrt(std::max(1.0, 1.0 * (i * i + j * j + k * k)));
          const Vector3 way{ i / size, j / size, k / size };
          if (!this->IsOfTissue(at + this->Tissue.Margin * way))
          {
            return false;
          }
        }
      }
    }
    return true;
  }

private:
  vtkSmartPointer<vtkImageData> Smoothed;
  vtkSmartPointer<vtkImageData> Labels;
  const TissueBand& Tissue;
  int Size[3];
};

std::set<int> FindLabels(const LabelNames& names, std::initializer_list<const char*> words)
{
  std::set<int> found;
  for (const auto& [label, name] : names)
  {
    const bool isMeant = std::any_of(words.begin(), words.end(),
      [&name = name](const char* word) { return name.find(word) != std::string::npos; });
    if (isMeant)
    {
      found.insert(label);
    }
  }
  return found;
}

void AddRows(const BandedScan& scan, const std::vector<TissueBand>& tissues,
  const std::vector<std::string>& presets, const Effort& effort, Table& table)
{
  for (const TissueBand& tissue : tissues)
  {
    const std::vector<Path> strokes = FindStrokesInside(scan, tissue, effort.Pick(5, 40));
    for (const std::string& preset : presets)
    {
      vtkNew<vtkVolumeHapticsFilter> filter;
      filter->SetInputDataObject(0, scan.Image);
      filter->GetProperty()->ApplyPreset(preset.c_str(), scan.Image);
      const auto model = filter->GetBaker().Bake(1000.0, {}, nullptr);
      std::vector<Roughness> each;
      double roughest = 0.0;
      std::size_t drops = 0;
      for (std::size_t i = 0; model && i < strokes.size(); ++i)
      {
        std::vector<double> force;
        const Trace trace = Play(*model, strokes[i]);
        for (std::size_t tick = SkippedTicks; tick < trace.size(); ++tick)
        {
          force.push_back(Norm(trace[tick].Force));
        }
        each.push_back(MeasureRoughness(force));
        roughest = std::max(roughest, each.back().Both);
        drops += DetectDrops(force).size();
      }
      const Roughness all = Average(each);
      table.Rows.push_back(
        { scan.Name, tissue.Name, preset, std::to_string(strokes.size()), Number(all.Mean),
          Number(all.Both), Number(roughest), std::to_string(drops), Number(all.LargestStep) });
    }
  }
}
} // namespace

std::vector<Path> FindStrokesInside(const BandedScan& scan, const TissueBand& tissue, int count)
{
  const Look look(scan, tissue);
  double bounds[6];
  scan.Image->GetBounds(bounds);
  std::mt19937 random(7);
  Uniform uniform(random);
  std::vector<Path> strokes;
  for (int i = 0; i < MostAttempts && static_cast<int>(strokes.size()) < count; ++i)
  {
    const Vector3 from{ uniform(bounds[0], bounds[1]), uniform(bounds[2], bounds[3]),
      uniform(bounds[4], bounds[5]) };
    const double up = uniform(-1.0, 1.0);
    const double around = uniform(0.0, TwoPi);
    const double flat = std::sqrt(1.0 - up * up);
    const Vector3 way{ flat * std::cos(around), flat * std::sin(around), up };
    double length = 0.0;
    while (length <= tissue.Length && look.IsInside(from + length * way))
    {
      length += LookStep;
    }
    if (length > tissue.Length)
    {
      Path stroke = { from };
      MoveTo(stroke, from + tissue.Length * way, StrokeStep);
      strokes.push_back(std::move(stroke));
    }
  }
  return strokes;
}

Table MeasureInsideTissues(const Scans& scans, const Effort& effort)
{
  Table table{ "Inside tissues",
    "Straight strokes at 45 mm/s. All within 3 mm of them, in the head's thin layers within 2 mm, "
    "is "
    "of the tissue: in its range of values after a Gaussian of 1 mm, and in its labels. Roughness, "
    "of all and of the roughest stroke, and drops as above; both are 0 for forces below 0.05 N.",
    { "scan", "tissue", "preset", "strokes", "mean (N)", "30-500 Hz (%)", "roughest (%)", "drops",
      "largest step (N)" },
    {} };
  if (scans.Head)
  {
    AddRows({ "head CT", scans.Head, nullptr },
      { { "brain", 0.0, 50.0, {}, 30.0, 5.0 }, { "muscle", 15.0, 95.0, {}, 12.0, 2.5 },
        { "fat", -150.0, -55.0, {}, 12.0, 2.0 } },
      { "CT contrast", "CT angiography", "CT physical" }, effort, table);
  }
  if (scans.Chest)
  {
    AddRows({ "chest CT", scans.Chest, scans.ChestLabels },
      { { "liver", 30.0, 115.0, FindLabels(scans.Names, { "liver" }) },
        { "muscle", 10.0, 100.0,
          FindLabels(scans.Names, { "autochthon", "iliopsoas", "gluteus" }) },
        { "fat", -145.0, -65.0, { 0 } },
        { "lung", -1100.0, -650.0, FindLabels(scans.Names, { "lung_" }) } },
      { "CT contrast", "CT chest", "CT angiography", "CT physical" }, effort, table);
  }
  if (scans.Mri)
  {
    AddRows({ "head MRI", scans.Mri, nullptr },
      { { "grey matter", 76.0, 104.0, {}, 8.0, 1.5 },
        { "white matter", 108.0, 145.0, {}, 12.0, 2.0 } },
      { "MRI" }, effort, table);
  }
  return table;
}

} // namespace evaluation

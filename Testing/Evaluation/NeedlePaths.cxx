// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "NeedlePaths.h"

#include "Shapes.h"

#include "VTK/Filter/HapticBaker.h"

#include "vtkHapticLabelTable.h"
#include "vtkHapticNeedle.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double TickStep = 0.1;   // mm per tick: 0.1 m/s
constexpr double SearchStep = 1.0; // mm between tests along a path
constexpr double Outside = 5.0;    // mm outside of the skin: start of the needle
constexpr double Longest = 150.0;  // mm, largest length of a path
constexpr double Safety = 6.0;     // mm, distance to bone
constexpr double AirValue = -300.0;
constexpr double BoneValue = 200.0;
constexpr double AirGap = 15.0; // mm of air that count as the end of the body
constexpr double Same = 0.01;   // N: largest difference that counts as none

/** Reads the nearest voxel of an image. */
class Voxels
{
public:
  explicit Voxels(vtkImageData* image)
    : Image(image)
  {
    image->GetDimensions(this->Size);
  }

  std::optional<double> At(const Vector3& world) const
  {
    const double x[3] = { world.X, world.Y, world.Z };
    double index[3];
    this->Image->TransformPhysicalPointToContinuousIndex(x, index);
    int at[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      at[axis] = static_cast<int>(std::lround(index[axis]));
      if (at[axis] < 0 || at[axis] >= this->Size[axis])
      {
        return {};
      }
    }
    return this->Image->GetScalarComponentAsDouble(at[0], at[1], at[2], 0);
  }

private:
  vtkImageData* const Image;
  int Size[3];
};

/** A scan with its segmentation. */
struct Body
{
  Voxels Values;
  Voxels Labels;
  const NeedleLabels& Sorted;

  bool IsOf(const std::set<int>& labels, const Vector3& at) const
  {
    const auto label = this->Labels.At(at);
    return label && labels.count(static_cast<int>(*label)) > 0;
  }

  bool IsBone(const Vector3& at) const
  {
    const auto value = this->Values.At(at);
    return this->IsOf(this->Sorted.Bone, at) || (value && *value > BoneValue);
  }

  /**
   * Returns whether the needle can pass here: neither bone nor another organ to avoid is nearby.
   */
  bool IsFree(const Vector3& at, const Vector3& side, const Vector3& up) const
  {
    if (this->IsOf(this->Sorted.Others, at) || this->IsBone(at))
    {
      return false;
    }
    constexpr int directions = 8;
    for (int i = 0; i < 2 * directions; ++i)
    {
      const double angle = TwoPi * i / directions;
      const Vector3 out = std::cos(angle) * side + std::sin(angle) * up;
      if (this->IsBone(at + (i < directions ? 1.0 : 0.5) * Safety * out))
      {
        return false;
      }
    }
    return true;
  }

  /**
   * Returns the distance (mm) from a target to the skin along a free path. Returns nothing if the
   * path is not free.
   */
  std::optional<double> FindSkin(const Vector3& target, const Vector3& way) const
  {
    Vector3 side = Cross(way, std::abs(way.Z) < 0.9 ? Vector3{ 0, 0, 1 } : Vector3{ 1, 0, 0 });
    side = (1.0 / Norm(side)) * side;
    const Vector3 up = Cross(way, side);
    double skin = 0.0;
    for (double length = 0.0;; length += SearchStep)
    {
      const Vector3 at = target + length * way;
      const auto value = this->Values.At(at);
      if (!value)
      {
        // The scan ends here, in air outside or inside the body.
        return length - skin > AirGap ? std::optional<double>(skin) : std::nullopt;
      }
      if (*value > AirValue)
      {
        // Bone just behind the target also counts, because the kernel reads materials there.
        if (length > Longest || length - skin > AirGap || !this->IsFree(at, side, up) ||
          (length == 0.0 && this->IsBone(at - Safety * way)))
        {
          return {};
        }
        skin = length;
      }
    }
  }
};

/** Returns the centres of all voxels with given labels. */
std::vector<Vector3> CollectVoxels(vtkImageData* labels, const std::set<int>& wanted)
{
  std::vector<Vector3> found;
  int n[3];
  labels->GetDimensions(n);
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        if (wanted.count(static_cast<int>(labels->GetScalarComponentAsDouble(i, j, k, 0))) > 0)
        {
          double x[3];
          labels->TransformIndexToPhysicalPoint(i, j, k, x);
          found.push_back({ x[0], x[1], x[2] });
        }
      }
    }
  }
  return found;
}

bool Holds(const std::string& name, std::initializer_list<const char*> words)
{
  return std::any_of(words.begin(), words.end(),
    [&](const char* word) { return name.find(word) != std::string::npos; });
}

Curve CurveOf(const std::string& name, const Trace& trace, int colour)
{
  Curve curve{ name, {}, {}, colour };
  for (std::size_t i = 0; i < trace.size(); ++i)
  {
    curve.X.push_back(TickStep * static_cast<double>(i));
    curve.Y.push_back(Norm(trace[i].Force));
  }
  return curve;
}
} // namespace

NeedleLabels SortLabels(const LabelNames& names)
{
  NeedleLabels sorted;
  for (const auto& [label, name] : names)
  {
    if (name == "liver")
    {
      sorted.Liver.insert(label);
    }
    else if (Holds(name,
               { "rib_", "vertebrae", "sternum", "sacrum", "scapula", "clavicula", "humerus",
                 "hip_", "femur", "skull", "costal_cartilages" }))
    {
      sorted.Bone.insert(label);
    }
    else if (Holds(name, { "lung_", "heart" }))
    {
      sorted.Others.insert(label);
    }
  }
  return sorted;
}

std::vector<Path> PlanNeedlePaths(vtkImageData* image, vtkImageData* labels,
  const NeedleLabels& sorted, std::size_t count, unsigned seed)
{
  const Body body{ Voxels(image), Voxels(labels), sorted };
  const std::vector<Vector3> targets = CollectVoxels(labels, sorted.Liver);
  std::mt19937 random(seed);
  Uniform uniform(random);
  std::vector<Path> paths;
  for (std::size_t attempt = 0; attempt < 1000 * count && paths.size() < count && !targets.empty();
       ++attempt)
  {
    const double fraction = uniform(0.0, 1.0) * static_cast<double>(targets.size());
    const Vector3 target =
      targets[std::min(static_cast<std::size_t>(fraction), targets.size() - 1)];
    const double up = uniform(-1.0, 1.0);
    const double around = uniform(0.0, TwoPi);
    const double flat = std::sqrt(1.0 - up * up);
    const Vector3 way = { flat * std::cos(around), flat * std::sin(around), up };
    if (const auto skin = body.FindSkin(target, way))
    {
      Path path = { target + (*skin + Outside) * way };
      MoveTo(path, target, TickStep);
      paths.push_back(std::move(path));
    }
  }
  return paths;
}

ForceError CompareForces(const std::vector<Trace>& some, const std::vector<Trace>& others)
{
  ForceError error;
  std::size_t ticks = 0;
  std::vector<double> worst(some.size(), 0.0);
  for (std::size_t path = 0; path < some.size(); ++path)
  {
    double squares = 0.0;
    for (std::size_t i = 0; i < some[path].size(); ++i)
    {
      const double off = Norm(some[path][i].Force - others[path][i].Force);
      squares += off * off;
      worst[path] = std::max(worst[path], off);
      error.Affected += off > Same ? 1.0 : 0.0;
      ++ticks;
    }
    error.RootMeanSquare += std::sqrt(squares / std::max<double>(1.0, some[path].size()));
  }
  error.RootMeanSquare /= std::max<double>(1.0, some.size());
  std::sort(worst.begin(), worst.end());
  error.Largest = worst.empty() ? 0.0 : worst.back();
  error.Typical = worst.empty() ? 0.0 : worst[worst.size() / 2];
  error.Affected *= 100.0 / std::max<double>(1.0, ticks);
  return error;
}

std::optional<double> TissueValueOf(const std::string& structure)
{
  if (Holds(structure, { "costal_cartilages" }))
  {
    return 200.0;
  }
  if (Holds(structure,
        { "rib_", "vertebrae", "sternum", "sacrum", "scapula", "clavicula", "humerus", "hip_",
          "femur", "skull" }))
  {
    return 900.0;
  }
  if (Holds(structure, { "lung_" }))
  {
    return -725.0;
  }
  if (Holds(structure,
        { "artery", "vein", "vena", "aorta", "trunk", "gallbladder", "cyst", "urinary_bladder" }))
  {
    return 3.0;
  }
  if (Holds(structure, { "stomach", "bowel", "duodenum", "colon", "trachea", "esophagus" }))
  {
    return {};
  }
  return 50.0;
}

vtkSmartPointer<vtkHapticLabelTable> MakeLabelTable(
  const LabelNames& names, vtkHapticProperty* feel)
{
  auto table = vtkSmartPointer<vtkHapticLabelTable>::New();
  for (const auto& [label, name] : names)
  {
    if (const auto value = TissueValueOf(name))
    {
      table->SetLabelName(label, name);
      table->SetStiffness(label, feel->GetStiffness()->GetValue(*value));
      table->SetFriction(label, feel->GetFriction()->GetValue(*value));
      table->SetViscosity(label, feel->GetViscosity()->GetValue(*value));
      table->SetSurfaceStrength(label, feel->GetSurfaceStrength()->GetValue(*value));
    }
  }
  return table;
}

ForceError RunNeedleProtocol(vtkImageData* image, vtkImageData* labels, const LabelNames& names,
  std::size_t count, Comparison& found)
{
  const std::vector<Path> paths = PlanNeedlePaths(image, labels, SortLabels(names), count);
  std::vector<Trace> traces[2];
  for (const bool isByLabel : { false, true })
  {
    vtkNew<vtkVolumeHapticsFilter> filter;
    filter->SetInputDataObject(0, image);
    filter->GetProperty()->ApplyPreset("CT contrast");
    vtkNew<vtkHapticNeedle> needle; // only the needle's tip is felt, not its shaft
    needle->ApplyPreset("CT contrast");
    filter->GetProperty()->SetViscosity(needle->GetCuttingForce());
    if (isByLabel)
    {
      filter->SetLabelData(labels);
      filter->SetLabelTable(MakeLabelTable(names, filter->GetProperty()));
    }
    const auto model = filter->GetBaker().Bake(1000.0, {}, nullptr);
    for (std::size_t i = 0; model && i < paths.size(); ++i)
    {
      traces[isByLabel ? 1 : 0].push_back(Play(*model, paths[i]));
    }
  }
  Table table{ "Needle paths from the skin to the liver: functions of the value against labels",
    "Differences of the force along straight paths that avoid bone, with \"CT contrast\": by "
    "functions of the value alone, and by the materials of the labels. Mean of the paths' root "
    "mean squares; the largest difference; the share of ticks at which they differ by more than "
    "0.01 N. Mastmeyer, Fortmeier and Handels (2017) compare partly with fully segmented data.",
    { "", "paths", "patients", "root mean square (N)", "largest (N)",
      "largest of a path, median (N)", "affected (%)" },
    { { "Mastmeyer et al. 2017", "31222", "10", "0.12", "1.6", "", "12" } } };
  ForceError error;
  if (!paths.empty() && traces[0].size() == traces[1].size())
  {
    error = CompareForces(traces[0], traces[1]);
    table.Rows.push_back(
      { "here, PRECISE", std::to_string(paths.size()), "1", Number(error.RootMeanSquare),
        Number(error.Largest), Number(error.Typical), Number(error.Affected) });
    found.Plots.push_back(
      { "needle", "Force along a path from the skin to the liver", "way (mm)", "force (N)",
        { CurveOf("functions of the value", traces[0].front(), 0),
          CurveOf("labels", traces[1].front(), 1) } });
  }
  else
  {
    table.Text += " No path leads to the liver here.";
  }
  found.Tables.push_back(std::move(table));
  return error;
}

} // namespace evaluation

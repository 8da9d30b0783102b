// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "RealVolumes.h"

#include "Arcs.h"
#include "Presses.h"
#include "Roughness.h"

#include "Applications/Explorer/Analysis/ValueProbe.h"
#include "Applications/Explorer/Exploration/TissueTable.h"
#include "Applications/Explorer/Scene/VolumeLook.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/LabelLoader.h"
#include "VTK/Reading/VolumeLoader.h"

#include "vtkDataArray.h"
#include "vtkImageConnectivityFilter.h"
#include "vtkImageData.h"
#include "vtkImageShiftScale.h"
#include "vtkImageThreshold.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeProperty.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
struct KnownVolume
{
  std::string Name;
  std::string File;
  std::vector<std::string> Presets;
  bool IsLabels = false;
};

std::vector<KnownVolume> ListVolumes(const VolumePlaces& places)
{
  const std::vector<std::string> ct = { "CT contrast", "CT physical" };
  const std::vector<std::string> chest = { "CT contrast", "CT chest", "CT angiography",
    "CT physical" };
  const std::vector<std::string> mri = { "auto", "MRI" };
  const std::vector<std::string> micro = { "auto", "histogram", "Micro-CT" };
  const std::vector<std::string> own = { "auto" };
  std::vector<KnownVolume> all;
  if (!places.Head.empty())
  {
    all.push_back({ "head CT", places.Head, ct });
  }
  if (!places.Chest.empty())
  {
    all.push_back({ "chest CT", places.Chest + "/cxr.nii.gz", chest });
    all.push_back({ "chest labels", places.Chest + "/mask.nii.gz", own, true });
  }
  const auto add = [&](const char* name, const char* file, const std::vector<std::string>& presets,
                     bool isLabels = false)
  {
    if (!places.Others.empty())
    {
      all.push_back({ name, places.Others + "/" + file, presets, isLabels });
    }
  };
  add("head CT, 2nd slices", "head-slice2.vti", ct);
  add("head CT, 4th slices", "head-slice4.vti", ct);
  for (const char* const noise : { "20", "35", "60" })
  {
    add((std::string("head CT + ") + noise + " HU white").c_str(),
      (std::string("head-white") + noise + ".vti").c_str(), ct);
    add((std::string("head CT + ") + noise + " HU smooth").c_str(),
      (std::string("head-smooth") + noise + ".vti").c_str(), ct);
  }
  add("shell", "shell.vti", micro);
  add("bone", "bone.vti", micro);
  add("fly", "fly.vti", micro);
  add("fibres", "fibers.vti", micro);
  add("NT", "NT.vti", micro);
  add("stent CT", "stent.vti", micro);
  add("MNI T1", "mni_icbm152_t1_tal_nlin_sym_09a_converted.nii.gz", mri);
  add("MNI grey matter", "mni_icbm152_gm_tal_nlin_sym_09a_converted.nii.gz", own);
  add("MNI white matter", "mni_icbm152_wm_tal_nlin_sym_09a_converted.nii.gz", own);
  add("ch2", "ch2.nii.gz", mri);
  add("ch2better", "ch2better.nii.gz", mri);
  add("macaque T1", "inia19-t1-brain.nii.gz", own);
  add("volpack MRI", "volpack.vti", { "auto", "histogram", "MRI", "Micro-CT" });
  add("diffusion S0", "aniso_vox.nii.gz", own);
  add("AAL", "aal.nii.gz", own, true);
  add("Brodmann", "brodmann.nii.gz", own, true);
  add("JHU", "JHU-WhiteMatter-labels-1mm.nii.gz", own, true);
  add("Harvard-Oxford", "HarvardOxford-cort-maxprob-thr0-1mm.nii.gz", own, true);
  add("frog", "frog_tissues.vti", own, true);
  return all;
}

/** The outer surface of a volume, either of its values or of all labels together. */
struct Outline
{
  vtkSmartPointer<vtkImageData> Image;
  double Level;
};

Outline MakeOutline(const Explore::Volume& volume, const Explore::Analysis& values)
{
  if (!volume.AreLabels)
  {
    return { volume.Image, values.OuterThreshold };
  }
  vtkNew<vtkImageThreshold> any;
  any->SetInputData(volume.Image);
  any->ThresholdByUpper(1.0); // also casts to the type of the labels
  any->SetInValue(1.0);
  any->SetOutValue(0.0);
  any->SetOutputScalarTypeToUnsignedChar();
  any->Update();
  return { any->GetOutput(), 0.5 };
}

/**
 * Returns Otsu's threshold of all samples (IEEE Transactions on Systems, Man, and Cybernetics 9,
 * 1979), which is between the background and the least value that is solid in "Micro-CT".
 */
double ComputeOtsuThreshold(vtkImageData* image)
{
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  std::map<double, double> counts;
  double sum = 0.0;
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    counts[scalars->GetComponent(i, 0)] += 1.0;
    sum += scalars->GetComponent(i, 0);
  }
  const auto all = static_cast<double>(scalars->GetNumberOfTuples());
  double below = 0.0;
  double moment = 0.0;
  double best = 0.0;
  double threshold = 0.0;
  for (auto at = counts.begin(); std::next(at) != counts.end(); ++at)
  {
    below += at->second;
    moment += at->first * at->second;
    const double gap = moment / below - (sum - moment) / (all - below);
    if (below * (all - below) * gap * gap > best)
    {
      best = below * (all - below) * gap * gap;
      threshold = 0.5 * (at->first + std::next(at)->first);
    }
  }
  return threshold;
}

/** Smallest number of connected samples above a level that counts as structure, not as noise. */
constexpr vtkIdType LeastStructure = 27;

/** Removes structures above a level that have fewer samples than LeastStructure. */
vtkSmartPointer<vtkImageData> RemoveSpecks(vtkImageData* image, double level)
{
  vtkNew<vtkImageConnectivityFilter> connectivity;
  connectivity->SetInputData(image);
  // The filter cuts the range to whole numbers if the samples are whole: 2.8 would be 2.
  const int type = image->GetScalarType();
  const bool isWhole = type != VTK_FLOAT && type != VTK_DOUBLE;
  connectivity->SetScalarRange(isWhole ? std::ceil(level) : level, VTK_DOUBLE_MAX);
  connectivity->SetExtractionModeToAllRegions();
  connectivity->SetSizeRange(LeastStructure, VTK_ID_MAX);
  connectivity->SetLabelScalarTypeToInt();
  connectivity->Update();
  vtkDataArray* const labels = connectivity->GetOutput()->GetPointData()->GetScalars();
  auto cleaned = vtkSmartPointer<vtkImageData>::New();
  cleaned->DeepCopy(image);
  vtkDataArray* const scalars = cleaned->GetPointData()->GetScalars();
  const double fill = scalars->GetRange(0)[0];
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    if (labels->GetComponent(i, 0) == 0.0 && scalars->GetComponent(i, 0) >= level)
    {
      scalars->SetComponent(i, 0, fill);
    }
  }
  scalars->Modified();
  return cleaned;
}

std::shared_ptr<const HapticModel> BakeShape(vtkImageData* image, double metersPerUnit)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputDataObject(0, image);
  filter->SetMetersPerWorldUnit(metersPerUnit);
  return filter->GetBaker().Bake(1000.0, {}, nullptr);
}

/** Returns the extinction of the rendered volume as a function of the position. */
Field MakeExtinction(const Explore::Volume& volume, vtkVolumeProperty* look)
{
  const Explore::ValueProbe probe(volume.Image, 0.0);
  vtkImageData* const image = volume.Image;
  const bool isNearest = look->GetInterpolationType() == VTK_NEAREST_INTERPOLATION;
  vtkPiecewiseFunction* const opacity = look->GetScalarOpacity();
  const double unit = look->GetScalarOpacityUnitDistance();
  return [=](const Vector3& world)
  {
    double position[3] = { world.X, world.Y, world.Z };
    bool isInside = false;
    double value = probe.Value(position, isInside);
    if (!isInside)
    {
      return 0.0;
    }
    if (isNearest)
    {
      double index[3];
      image->TransformPhysicalPointToContinuousIndex(position, index);
      value = image->GetScalarComponentAsDouble(static_cast<int>(std::lround(index[0])),
        static_cast<int>(std::lround(index[1])), static_cast<int>(std::lround(index[2])), 0);
    }
    return -std::log(1.0 - std::min(opacity->GetValue(value), 0.99999)) / unit;
  };
}

/**
 * Makes strokes in planes through the middle. Adds to `seen` how far behind the proxies half of the
 * opacity is reached.
 */
Roughness Stroke(const PressedVolume& pressed, const Outline& outline, const Effort& effort,
  std::vector<double>& seen)
{
  constexpr std::size_t every = 50; // ticks between measurements
  const Vector3 axes[3] = { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } };
  Course course;
  course.Level = outline.Level;
  course.Middles = { pressed.Middle };
  const auto& b = pressed.Box;
  course.Radius = (b[1] - b[0] + b[3] - b[2] + b[5] - b[4]) / 6.0;
  std::vector<Roughness> strokes;
  for (int plane = 0; plane < effort.Pick(1, 3); ++plane)
  {
    course.Side = axes[plane];
    course.Up = axes[(plane + 1) % 3];
    for (Arc& arc : FindArcs(outline.Image, course))
    {
      for (Vector3& tip : arc.Tips)
      {
        tip = pressed.Scale * tip;
      }
      const Trace trace = Play(*pressed.Model, arc.Tips);
      std::vector<double> force;
      for (std::size_t i = arc.GetSettled(); i < trace.size(); ++i)
      {
        force.push_back(Norm(trace[i].Force));
        const Vector3 proxy = ProxyOf(trace[i]);
        const auto inwards = i % every == 0 && force.back() > FeltForce
          ? ComputeInwards(pressed, proxy)
          : std::nullopt;
        const auto behind = inwards ? MeasureSeenBehind(pressed, proxy, *inwards) : std::nullopt;
        if (behind)
        {
          seen.push_back(*behind);
        }
      }
      strokes.push_back(MeasureRoughness(force));
    }
  }
  return Average(strokes);
}

/** Returns the stiffness (N/m) of the stiffest material in a range of values. */
double FindStiffest(const HapticModel& model, const double range[2])
{
  constexpr int parts = 4096;
  double stiffest = 0.0;
  for (int i = 0; i <= parts; ++i)
  {
    const double value = range[0] + (range[1] - range[0]) * i / parts;
    stiffest = std::max(stiffest, model.Baked->Materials(value)[0]);
  }
  return stiffest;
}

/**
 * Returns the least value whose material resists with FeltForce, in the outline's values. An edge
 * up to this value is a surface, regardless of the outline's level.
 */
double FindHoldingLevel(
  const HapticModel& model, const Outline& outline, const double range[2], bool isBelow)
{
  constexpr int parts = 4096;
  for (int i = 0; i <= parts; ++i)
  {
    const double along = (range[1] - range[0]) * i / parts;
    const double value = isBelow ? range[1] - along : range[0] + along;
    if (model.Baked->Materials(value)[2] >= FeltForce)
    {
      return isBelow ? -value : value;
    }
  }
  return outline.Level;
}

/**
 * Returns a line of the table. The volume is touched and rendered as by ExploreVolume() and
 * BuildScene().
 */
std::vector<std::string> MeasureVolume(const std::string& name, const Explore::Volume& volume,
  const std::string& preset, const Effort& effort)
{
  Explore::Analysis values = Explore::AnalyseVolume(volume.Image, volume.IsField, volume.AreLabels);
  vtkNew<vtkVolumeHapticsFilter> filter;
  const std::string materials = Explore::ApplyMaterials(preset, values, volume.Image, filter);
  Explore::FitThresholds(filter->GetProperty(), values);
  vtkNew<vtkVolumeProperty> look;
  Explore::SetVolumeLook(values, look);
  const bool isBelow = filter->GetProperty()->GetSurfaceSide() == vtkHapticProperty::LOWER;
  if (materials == "Micro-CT" || isBelow)
  {
    values.OuterThreshold = ComputeOtsuThreshold(volume.Image);
  }
  Explore::MeasureBody(values, volume.Image);
  filter->SetMetersPerWorldUnit(values.MetersPerWorldUnit);
  filter->SetInputDataObject(0, volume.Image);
  if (volume.AreLabels)
  {
    filter->SetLabelData(volume.Labels);
    filter->SetLabelTable(volume.LabelTable);
    filter->SetGeometryFromLabels();
    Explore::SetLabelLook(volume.LabelTable, look);
  }
  Outline outline = MakeOutline(volume, values);
  if (isBelow)
  {
    vtkNew<vtkImageShiftScale> negative;
    negative->SetInputData(outline.Image);
    negative->SetScale(-1.0);
    negative->SetOutputScalarTypeToDouble();
    negative->Update();
    outline = { negative->GetOutput(), -outline.Level };
  }
  PressedVolume pressed;
  pressed.Model = filter->GetBaker().Bake(1000.0, {}, nullptr);
  pressed.Shape = BakeShape(outline.Image, values.MetersPerWorldUnit);
  pressed.Level = outline.Level;
  pressed.HeldLevel = pressed.Model && !volume.AreLabels
    ? FindHoldingLevel(*pressed.Model, outline, values.Range, isBelow)
    : outline.Level;
  pressed.Structures =
    BakeShape(RemoveSpecks(outline.Image, pressed.Level), values.MetersPerWorldUnit);
  pressed.Held =
    BakeShape(RemoveSpecks(outline.Image, pressed.HeldLevel), values.MetersPerWorldUnit);
  if (!pressed.Model || !pressed.Shape || !pressed.Structures || !pressed.Held)
  {
    return { name, materials, "can't be touched" };
  }
  pressed.Scale = 1000.0 * values.MetersPerWorldUnit;
  std::copy_n(values.BodyBounds, 6, pressed.Box.begin());
  pressed.Middle = { values.Centre[0], values.Centre[1], values.Centre[2] };
  const double* const spacing = volume.Image->GetSpacing();
  pressed.Voxel = { spacing[0], spacing[1], spacing[2] };
  pressed.Extinction = MakeExtinction(volume, look);
  const Presses presses = PressFromAllSides(pressed, effort.Pick(60, 400));
  std::vector<double> unused;
  const Roughness strokes = Stroke(pressed, outline, effort, unused);
  filter->GetProperty()->SetVisibilityFrom(look);
  PressedVolume shown = pressed;
  shown.Model = filter->GetBaker().Bake(1000.0, {}, nullptr);
  const Presses inWindow = PressFromAllSides(shown, effort.Pick(60, 400));
  std::vector<double> seen;
  Stroke(shown, outline, effort, seen);
  const auto far = std::count_if(presses.OffSurface.begin(), presses.OffSurface.end(),
    [](double off) { return std::abs(off) > 2.0; });
  const double felt = std::max<double>(1.0, static_cast<double>(presses.OffSurface.size()));
  const double feltInWindow =
    std::max<double>(1.0, static_cast<double>(inWindow.OffSurface.size()));
  const double seconds = std::max(strokes.Duration, 1e-9);
  const int walkCount = effort.Pick(5, 60);
  const Steps walks = WalkAtRandom(pressed, walkCount, FindStiffest(*pressed.Model, values.Range));
  const Steps fastWalks = WalkAtRandom(pressed, walkCount, 0.0);
  return { name, materials, std::to_string(presses.Count), std::to_string(presses.Unfelt),
    std::to_string(presses.UnfeltBehindEdge), Number(ComputeMedian(presses.OffSurface)),
    Number(FindLargest(presses.OffSurface, 0.95)), Number(100.0 * static_cast<double>(far) / felt),
    Number(100.0 * presses.Astray / felt), Number(100.0 * presses.AstrayOfHeld / felt),
    std::to_string(inWindow.Unfelt), std::to_string(inWindow.UnfeltThoughSeen),
    Number(100.0 * inWindow.Astray / feltInWindow),
    Number(100.0 * inWindow.AstrayOfHeld / feltInWindow), Number(ComputeMedian(inWindow.OffSeen)),
    Number(FindLargest(inWindow.OffSeen, 0.95)),
    Number(FindLargest(inWindow.OffSeenStraight, 0.95)),
    Number(FindLargest(inWindow.OffSeenTouched, 0.95)), Number(ComputeMedian(seen)),
    Number(FindLargest(seen, 0.95)), Number(strokes.Mean), Number(strokes.Both),
    Number(strokes.Drops / seconds), Number(strokes.LargestStep), Number(presses.LargestStep),
    Number(walks.Largest), Number(fastWalks.Largest), Number(fastWalks.Beyond),
    Number(fastWalks.BeyondSpring) };
}

void PrintLine(const std::vector<std::string>& row)
{
  for (const std::string& cell : row)
  {
    std::fprintf(stderr, "%s  ", cell.c_str());
  }
  std::fprintf(stderr, "\n");
}
} // namespace

Table MeasureRealVolumes(const VolumePlaces& places, const Effort& effort)
{
  Table table{ "Real volumes: felt and seen",
    "Presses from outside of the volume, 40 mm away at least, and 5 mm deep, but at least 3 "
    "voxels, on rays from all sides within 45 degrees of the normal; "
    "unfelt are those with less than 0.1 N, and behind an edge are those of them that go 0.25 mm "
    "behind the middle of an edge of the smoothed values, where the second derivative along the "
    "gradient is negative. The felt place is the proxy at 0.1 N: voxels behind "
    "the isosurface of the outer threshold (with \"Micro-CT\", of Otsu's) that the ray meets, "
    "as the kernel smooths it, and from it to half of the opacity along the ray, each the median "
    "and the magnitude that 95 % do not exceed. Felt places are counted that are more than 2 "
    "voxels from this isosurface, and that are from any of this threshold, of the samples without "
    "specks of less than 27: structures that the kernel smooths away have one, too. Of the latter, "
    "those are counted apart that are from any of the value from which on the preset holds 0.1 N, "
    "too; as that depends on the preset, it judges nothing. Strokes as above, in planes "
    "through the middle; along the normal, half of the opacity is by so many voxels behind the "
    "proxy. Walks are random ways through the body, at up to 0.45 m/s, and slower where the "
    "stiffest material has more than 400 N/m, by as much, and then all at 0.45 m/s; beyond the "
    "bound is what, at 0.45 m/s, "
    "neither 0.25 N, to which releases are bound, nor the hand's own step explains: stiffness "
    "times sqrt(1 + friction^2) times its length, and 0.02 N; beyond the spring is the largest "
    "step "
    "without stiffness times the length of the hand's. For what is seen, what the picture "
    "hides is not felt, as in the explorer's window: what is unfelt there is hidden, or it is seen "
    "within 2 voxels of the isosurface, and counted apart. A ray that grazes a strand sees it, and "
    "a press slides off it: straight are the rays that meet what they see within 45 degrees of its "
    "normal, too, and at 0.01 N is for all rays the first place with that force.",
    { "volume", "preset", "presses", "unfelt", "behind an edge", "off surface", "95 %",
      "> 2 voxels (%)", "from any (%)", "and from held (%)", "unfelt in window", "though seen",
      "from any (%)", "and from held (%)", "seen behind", "95 %", "straight, 95 %",
      "at 0.01 N, 95 %", "by strokes", "95 %", "stroke (N)", "30-500 Hz (%)", "drops / s",
      "largest step (N)", "of presses (N)", "of walks (N)", "at 0.45 m/s (N)", "beyond bound (N)",
      "beyond spring (N)" },
    {} };
  for (const KnownVolume& known : ListVolumes(places))
  {
    try
    {
      if (!vtksys::SystemTools::FileExists(known.File, true))
      {
        std::fprintf(
          stderr, "%s is not there: %s is left out\n", known.File.c_str(), known.Name.c_str());
        continue;
      }
      Explore::Volume volume = Explore::LoadVolume(known.File);
      if (known.IsLabels)
      {
        Explore::UseAsLabels(volume, known.File, {});
      }
      for (const std::string& preset : known.Presets)
      {
        if ((known.Name + ", " + preset).find(places.Only) == std::string::npos)
        {
          continue;
        }
        table.Rows.push_back(MeasureVolume(known.Name, volume, preset, effort));
        table.Rows.back().resize(table.Columns.size());
        PrintLine(table.Rows.back());
      }
    }
    catch (const Explore::InputError& error)
    {
      std::fprintf(stderr, "%s\n", error.what());
    }
  }
  return table;
}

} // namespace evaluation

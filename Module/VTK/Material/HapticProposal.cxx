// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/HapticProposal.h"

#include "Core/Field/Estimates/BackgroundLevel.h"
#include "Core/Field/Estimates/NoiseEstimate.h"
#include "VTK/Base/HapticNoise.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Base/OutsideFiller.h"
#include "VTK/Base/SampleRange.h"
#include "VTK/Material/HapticFunctions.h"
#include "VTK/Material/HapticPropertySettings.h"
#include "VTK/Material/HapticTissues.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

namespace VolumeHaptics
{

namespace
{

constexpr double MostVoxels = 1e6;
constexpr std::size_t MostLines = 50000;
/**
 * Largest number of rows that are read in a large volume. Each block of voxels also reads the 36
 * rows of samples around it, which its gradients need.
 */
constexpr std::int64_t MostRows = 512;
constexpr std::int64_t MostVoxelsInARow = 2048;
/** Number of voxels in one piece of background work: some milliseconds. */
constexpr std::size_t VoxelsAtOnce = 4096;
constexpr std::size_t LinesAtOnce = 128;
/** Fraction of a search's progress that finding steep voxels takes. */
constexpr double SteepFraction = 0.5;

/** Mixes the bits of a number like the finalizer of MurmurHash3 (public domain). */
std::uint64_t Scramble(std::uint64_t number)
{
  number = (number ^ (number >> 33)) * 0xff51afd7ed558ccdULL;
  number = (number ^ (number >> 33)) * 0xc4ceb9fe1a85ec53ULL;
  return number ^ (number >> 33);
}

/** Returns a pseudo-random number below `room`, and divides it out of `random`. */
std::int64_t Draw(std::uint64_t& random, std::int64_t room)
{
  const auto count = static_cast<std::uint64_t>(room);
  const auto drawn = static_cast<std::int64_t>(random % count);
  random /= count;
  return drawn;
}

/**
 * Picks the voxels of one row along the first axis in each of at most MostRows equal parts of the
 * volume.
 */
std::vector<Vector3> ScatterRows(const VolumeView& view)
{
  const std::int64_t* const n = view.Dimensions;
  const double ratio = static_cast<double>(n[1]) / static_cast<double>(n[2]);
  const std::int64_t most = std::min(MostRows, n[1]);
  const std::int64_t along =
    std::clamp<std::int64_t>(std::llround(std::sqrt(MostRows * ratio)), 1, most);
  const std::int64_t across = std::min(MostRows / along, n[2]);
  const std::int64_t length = std::min(MostVoxelsInARow, n[0]);
  std::vector<Vector3> voxels;
  voxels.reserve(static_cast<std::size_t>(along * across * length));
  for (std::int64_t column = 0; column < along * across; ++column)
  {
    const std::int64_t j = column % along;
    const std::int64_t k = column / along;
    // Range of rows in this part: its first row, and the first row after it.
    const std::int64_t firstRow[2] = { n[1] * j / along, n[1] * (j + 1) / along };
    const std::int64_t firstSlice[2] = { n[2] * k / across, n[2] * (k + 1) / across };
    std::uint64_t random = Scramble(static_cast<std::uint64_t>(column) + 1);
    const std::int64_t row = firstRow[0] + Draw(random, firstRow[1] - firstRow[0]);
    const std::int64_t slice = firstSlice[0] + Draw(random, firstSlice[1] - firstSlice[0]);
    const std::int64_t first = Draw(random, n[0] - length + 1);
    for (std::int64_t i = first; i < first + length; ++i)
    {
      voxels.push_back({ static_cast<double>(view.First[0] + i),
        static_cast<double>(view.First[1] + row), static_cast<double>(view.First[2] + slice) });
    }
  }
  return voxels;
}

} // namespace

//------------------------------------------------------------------------------
std::vector<Vector3> ScatterVoxels(const VolumeView& view)
{
  if (IsLargeVolume(view.Dimensions))
  {
    return ScatterRows(view);
  }
  const std::int64_t* const n = view.Dimensions;
  const double all =
    static_cast<double>(n[0]) * static_cast<double>(n[1]) * static_cast<double>(n[2]);
  const auto side =
    static_cast<std::int64_t>(std::ceil(std::cbrt(std::max(1.0, all / MostVoxels))));
  std::vector<Vector3> voxels;
  std::uint64_t block = 0;
  for (std::int64_t k = 0; k < n[2]; k += side)
  {
    for (std::int64_t j = 0; j < n[1]; j += side)
    {
      for (std::int64_t i = 0; i < n[0]; i += side)
      {
        std::uint64_t random = Scramble(++block);
        const std::int64_t first[3] = { i, j, k };
        double at[3];
        for (int a = 0; a < 3; ++a)
        {
          const auto room = static_cast<std::uint64_t>(std::min(side, n[a] - first[a]));
          at[a] = static_cast<double>(
            view.First[a] + first[a] + static_cast<std::int64_t>(random % room));
          random /= room;
        }
        voxels.push_back({ at[0], at[1], at[2] });
      }
    }
  }
  return voxels;
}

//------------------------------------------------------------------------------
std::vector<EdgeLine> DetectEdges(const VolumeView& view, const EdgeTracer& tracer,
  const EdgeThresholds& thresholds, const SearchPart& part)
{
  const double middle = part.Begin + SteepFraction * (part.End - part.Begin);
  const std::vector<Vector3> voxels = ScatterVoxels(view);
  std::vector<char> isSteep(voxels.size());
  auto look = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      isSteep[i] = tracer.Slope(voxels[i]) >= thresholds.Least;
    }
  };
  if (!LookAtAll(voxels.size(), VoxelsAtOnce, { part.Monitor, part.Begin, middle }, look))
  {
    return {};
  }
  std::vector<Vector3> steep;
  for (std::size_t i = 0; i < voxels.size(); ++i)
  {
    if (isSteep[i])
    {
      steep.push_back(voxels[i]);
    }
  }
  const std::size_t count = std::min(steep.size(), MostLines);
  std::vector<EdgeLine> lines(count);
  std::vector<char> isEdge(count);
  auto trace = [&](vtkIdType begin, vtkIdType end)
  {
    for (vtkIdType i = begin; i < end; ++i)
    {
      isEdge[i] = tracer.Trace(steep[i * steep.size() / count], lines[i]);
    }
  };
  LookAtAll(count, LinesAtOnce, { part.Monitor, middle, part.End }, trace);
  std::vector<EdgeLine> edges;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (isEdge[i])
    {
      edges.push_back(lines[i]);
    }
  }
  return edges;
}

namespace
{
constexpr int SearchRadius = 2; // radius (voxels) of the gradient kernel that finds edges
constexpr std::int64_t LeastPoints = PointsNeeded(SearchRadius);
/**
 * Smallest rise of an edge per voxel, as a fraction of the range. A smaller rise is shading or
 * rounding.
 */
constexpr double LeastSlopeFraction = 0.003;
// Gradient, in standard deviations of its noise, at which the distinctness begins to rise.
constexpr double NoiseThreshold = 3.4;
constexpr double FlatNoise = 2.0; // largest gradient of a flat place, in standard deviations of its
                                  // noise
/** If more than this fraction of all edges are noise of the background, those edges are removed. */
constexpr double LeastNoise = 0.003;

std::string NameOf(vtkDataArray* scalars)
{
  const char* const name = scalars->GetName();
  return std::string("array \"") + (name ? name : "(unnamed)") + "\"";
}

/**
 * Computes the thresholds at which a plateau ends and an edge begins, from the noise and the range
 * of the values.
 */
EdgeThresholds MakeThresholds(double noise, const double range[2], const GradientKernel& kernel)
{
  const Polyline ramp = MakeNoiseRamp(noise, kernel, Affine3{});
  EdgeThresholds thresholds;
  thresholds.Least = LeastSlopeFraction * (range[1] - range[0]);
  if (!ramp.empty())
  {
    thresholds.Least = std::max(thresholds.Least, ramp.back().X);
    thresholds.Flat = FlatNoise * ramp.front().X / NoiseThreshold;
  }
  return thresholds;
}

/**
 * Returns the value where a dark or bright background ends, provided that the value `outside`
 * belongs to the background.
 */
std::optional<double> DetectBackgroundEnd(const ProposalInput& input, double outside)
{
  vtkDataArray* const scalars = input.Image->GetPointData()->GetScalars();
  const HapticVolume& volume = input.Volume;
  const BackgroundLevel dark = volume.Whole.IsThere
    ? volume.Whole.Solid
    : EstimateSolid(input.Image, scalars, volume.View, input.Component);
  if (dark.IsThere && outside <= dark.Threshold)
  {
    return dark.Threshold;
  }
  if (volume.Whole.IsThere)
  {
    return {}; // a region has too few samples to detect a bright background
  }
  const BackgroundLevel bright = BackgroundLevel::Estimate([&](std::int64_t i)
    { return -scalars->GetComponent(i, input.Component); },
    volume.View.Dimensions);
  return bright.IsThere && outside >= -bright.Threshold ? std::optional<double>(-bright.Threshold)
                                                        : std::nullopt;
}

/**
 * Replaces the points of a function with the points of a line.
 * @param toValue maps scalars, or their slopes, to the values of the property
 */
template <typename ToValue>
void Replace(vtkPiecewiseFunction* function, const Polyline& line, const ToValue& toValue)
{
  function->RemoveAllPoints();
  function->ClampingOn();
  function->UseLogScaleOff();
  for (const Vertex& vertex : line)
  {
    function->AddPoint(toValue(vertex.X), vertex.Y);
  }
}

/** Makes the table of boundaries: see vtkHapticProperty::GetProposedBoundaries. */
vtkSmartPointer<vtkTable> MakeBoundaryTable(
  const MaterialProposal& proposal, vtkHapticProperty* property)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  const auto add = [&](const char* name, const auto& get)
  {
    vtkNew<vtkDoubleArray> column;
    column->SetName(name);
    for (std::size_t i = 0; i < proposal.Boundaries.size(); ++i)
    {
      column->InsertNextValue(get(i));
    }
    table->AddColumn(column);
  };
  const std::vector<Boundary>& all = proposal.Boundaries;
  add("Low", [&](std::size_t i) { return property->ScalarToValue(all[i].Low); });
  add("High", [&](std::size_t i) { return property->ScalarToValue(all[i].High); });
  add("Width", [&](std::size_t i) { return all[i].Width; });
  add("Slope", [&](std::size_t i) { return proposal.Slopes[i] * property->GetScalarScale(); });
  add("Share", [&](std::size_t i) { return all[i].Fraction; });
  return table;
}

} // namespace

//------------------------------------------------------------------------------
bool ReadProposalInput(vtkImageData* image, int component, ProposalInput& input, std::string& error)
{
  vtkDataArray* const scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars)
  {
    error = !image
      ? "There is no image to propose functions from: pass a vtkImageData."
      : "The input image has no active point scalars to propose functions from: choose "
        "an array with GetPointData()->SetActiveScalars(name), or turn cell data into "
        "point data with vtkCellDataToPointData.";
    return false;
  }
  input.Image = vtkSmartPointer<vtkImageData>::New();
  input.Image->ShallowCopy(image);
  input.Component = component;
  // Skip samples that are not numbers, because they have no edges.
  OutsideSamples outside = DetectOutside(image, scalars, component);
  const bool hasHoles = std::exchange(outside.AreNonFinite, false);
  const vtkSmartPointer<vtkDataArray> filled = CopyFilled(outside, scalars, component);
  input.Image->GetPointData()->SetScalars(filled);
  const bool isRead = ReadVolume(image, filled, component, SearchRadius, input.Volume, error);
  if (hasHoles)
  {
    input.Volume.View.BorderValue = outside.Fill;
  }
  return isRead;
}

//------------------------------------------------------------------------------
bool ProposeFromVolume(const ProposalInput& input, const SearchPart& part,
  MaterialProposal& proposal, std::string& error)
{
  std::ostringstream message;
  vtkImageData* const image = input.Image;
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  const int component = input.Component;
  const HapticVolume& volume = input.Volume;
  const VolumeView& view = volume.View;
  const std::int64_t* const n = view.Dimensions;
  const std::int64_t fewest = std::min({ n[0], n[1], n[2] });
  double range[2];
  if (IsLargeVolume(n))
  {
    std::copy_n(EstimateImageNoise(image, scalars, view, component).Range, 2, range);
  }
  else
  {
    ComputeFiniteRange(scalars, component, range);
  }
  if (fewest < LeastPoints)
  {
    message << "The input image is " << n[0] << " x " << n[1] << " x " << n[2]
            << " points, in which edges can't be told from noise. Use an image of at least "
            << LeastPoints << " points along every axis, or set the functions by hand.";
  }
  else if (!(range[0] <= range[1]))
  {
    message << "The " << NameOf(scalars)
            << " of the input image has no finite value. Use another array or component.";
  }
  else if (!(range[1] - range[0] > 0.0))
  {
    message << "The " << NameOf(scalars) << " of the input image is " << range[0]
            << " everywhere: there are no edges to propose functions from. Use another array or "
               "component, or set the functions by hand.";
  }
  else
  {
    const GradientKernel kernel(
      GradientEstimator::Gaussian, SearchRadius, GaussianWeights::OwnDerivative);
    const double noise = volume.Whole.IsThere
      ? volume.Whole.Noise
      : EstimateImageNoise(image, scalars, view, component).Noise;
    const EdgeThresholds thresholds = MakeThresholds(noise, range, kernel);
    const FieldSampler field(view, kernel);
    ProposalFacts facts;
    facts.SearchVariance = MeasureKernelVariance(kernel);
    const EdgeTracer tracer(field, volume.IndexToWorld, facts.SearchVariance, thresholds);
    std::vector<EdgeLine> lines = DetectEdges(view, tracer, thresholds, part);
    if (part.IsCancelled())
    {
      error = "The search for functions was cancelled.";
      return false;
    }
    facts.Outside = view.BorderValue;
    facts.BackgroundEnd = DetectBackgroundEnd(input, facts.Outside);
    if (facts.BackgroundEnd)
    {
      // Detect streaks and other correlated noise, which the noise estimate does not include.
      const auto isNoise = [&](const EdgeLine& line)
      { return facts.Covers(line.Low) && facts.Covers(line.High); };
      const auto count = std::count_if(lines.begin(), lines.end(), isNoise);
      if (static_cast<double>(count) > LeastNoise * static_cast<double>(lines.size()))
      {
        lines.erase(std::remove_if(lines.begin(), lines.end(), isNoise), lines.end());
      }
      else
      {
        facts.BackgroundEnd.reset();
      }
    }
    const ValueAxis axis(lines, noise);
    facts.MostRadius =
      static_cast<int>(std::min<std::int64_t>(GradientKernel::MaximumRadius, (fewest - 1) / 2));
    facts.NoiseGradient = [&](int radius)
    {
      const Polyline ramp = MakeNoiseRamp(
        noise, GradientKernel(GradientEstimator::Gaussian, radius), volume.IndexToWorld);
      return ramp.empty() ? 0.0 : ramp.front().X;
    };
    const std::vector<Boundary> boundaries = DetectBoundaries(lines, axis);
    proposal = ProposeMaterials(boundaries, axis, facts);
    if (!proposal.Boundaries.empty())
    {
      return true;
    }
    message << "No edge between two materials stands out in the " << NameOf(scalars)
            << " of the input image";
    // Smooth only if there is noise, because smoothing widens edges that are already too wide.
    const bool isNoisy =
      !boundaries.empty() || thresholds.Least > LeastSlopeFraction * (range[1] - range[0]);
    if (isNoisy)
    {
      message << ", whose noise has a standard deviation of " << noise
              << ". Smooth it, for example with vtkImageGaussianSmooth, ";
    }
    else
    {
      message << ", which has little noise. If its edges are many voxels wide, make the voxels "
                 "larger with vtkImageResample, ";
    }
    message << "or set the functions by hand.";
  }
  error = message.str();
  return false;
}

//------------------------------------------------------------------------------
void FillFromProposal(const MaterialProposal& proposal, vtkHapticProperty* property)
{
  const double k = MaterialProposal::Stiffness;
  // Move FoundShift into ScalarShift, so that the axes of the functions stay the same.
  property->SetScalarShift(property->GetScalarShift() + property->GetFoundShift());
  property->NoteShift(0.0);
  property->ShiftFromImageOff();
  const auto toValue = [property](double scalar) { return property->ScalarToValue(scalar); };
  Replace(property->GetStiffness(),
    { { proposal.SurfaceStrength.front().X, k }, { proposal.SurfaceStrength.back().X, k } },
    toValue);
  Replace(property->GetFriction(), proposal.Friction, toValue);
  Replace(property->GetViscosity(), proposal.Viscosity, toValue);
  Replace(property->GetSurfaceStrength(), proposal.SurfaceStrength, toValue);
  Replace(property->GetDistinctness(), proposal.Distinctness,
    [property](double slope) { return slope * property->GetScalarScale(); });
  property->DistinctnessPerMillimeterOff();
  property->SolidFromImageOff();
  property->SetSurfaceSide(proposal.Side == ProposedSide::Higher ? vtkHapticProperty::HIGHER
      : proposal.Side == ProposedSide::Lower                     ? vtkHapticProperty::LOWER
                                                                 : vtkHapticProperty::BOTH);
  property->RemoveAllTissues();
  for (std::size_t i = 0; i < proposal.Materials.size(); ++i)
  {
    const std::string name = i == proposal.Background
      ? "outside"
      : "material " + std::to_string(i < proposal.Background ? i + 1 : i);
    // Name a tissue only over the values where the functions are constant.
    property->AddTissue(name.c_str(), toValue(proposal.SurfaceStrength[2 * i].X),
      toValue(proposal.SurfaceStrength[2 * i + 1].X));
  }
  property->NoteProposal(MakeBoundaryTable(proposal, property), proposal.KernelRadius);
}

//------------------------------------------------------------------------------
void CopyProposal(vtkHapticProperty* proposed, vtkHapticProperty* property)
{
  for (const PropertyFunction& function : PropertyFunctions)
  {
    CopyFunction((proposed->*function.Get)(), (property->*function.Get)());
  }
  property->SetDistinctnessPerMillimeter(proposed->GetDistinctnessPerMillimeter());
  property->SetSolidFromImage(proposed->GetSolidFromImage());
  property->SetShiftFromImage(proposed->GetShiftFromImage());
  property->SetScalarShift(proposed->GetScalarShift());
  property->NoteShift(0.0);
  property->SetScalarScale(proposed->GetScalarScale());
  property->SetSurfaceSide(proposed->GetSurfaceSide());
  SetTissues(property, GetTissues(proposed));
  property->NoteProposal(proposed->GetProposedBoundaries(), proposed->GetProposedKernelRadius());
}

} // namespace VolumeHaptics

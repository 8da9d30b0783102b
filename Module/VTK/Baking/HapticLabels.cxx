// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/HapticLabels.h"

#include "Core/Field/Estimates/NoiseEstimate.h"
#include "Core/Field/LabelSamples.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Material/HapticPropertySettings.h"

#include "vtkDataArray.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <sstream>
#include <string>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/**
 * Largest difference between the highest and the lowest scalar that can be used as labels. It
 * limits memory: the table has an entry for each whole number in between.
 */
constexpr int MostScalarLabels = 1 << 16;

/**
 * Evaluates a function of the property at a scalar. A function without points yields its default.
 */
double ComputeScalarMaterial(vtkHapticProperty* property, const char* name, double label)
{
  for (const PropertyFunction& rule : PropertyFunctions)
  {
    if (std::string(rule.Name) == name)
    {
      vtkPiecewiseFunction* const function = (property->*rule.Get)();
      return function->GetSize() > 0 ? function->GetValue(property->ScalarToValue(label))
                                     : rule.Default;
    }
  }
  return 0.0;
}

/**
 * Fills the table for a segmentation whose numbers are the touched scalars. The property's
 * functions map each number to a material. The table gets an entry for each whole number between
 * the smallest and the largest sample, including the background. Returns false, with an empty
 * table, if the samples can't be labels: if they have several components, or values that are not
 * finite, or a span of more than MostScalarLabels.
 */
bool FillScalarLabels(
  vtkDataArray* scalars, vtkHapticProperty* property, vtkHapticLabelTable* table)
{
  table->RemoveAllLabels();
  double range[2];
  scalars->GetRange(range, 0);
  constexpr double most = VTK_INT_MAX;
  // Each comparison is false for NaN.
  const bool isSpanned = range[0] >= -most && range[1] <= most && range[0] <= range[1] &&
    range[1] - range[0] < MostScalarLabels;
  if (scalars->GetNumberOfComponents() != 1 || !isSpanned)
  {
    return false;
  }
  for (int label = static_cast<int>(std::ceil(range[0])); label <= range[1]; ++label)
  {
    table->SetStiffness(label, ComputeScalarMaterial(property, "Stiffness", label));
    table->SetFriction(label, ComputeScalarMaterial(property, "Friction", label));
    table->SetViscosity(label, ComputeScalarMaterial(property, "Viscosity", label));
    table->SetSurfaceStrength(label, ComputeScalarMaterial(property, "SurfaceStrength", label));
  }
  return true;
}

constexpr const char* LabelImage = "label image on input port 3";

/**
 * Returns whether a value is a whole number of at most 2^53, up to which a double holds every whole
 * number exactly. Returns false for NaN.
 */
template <typename T>
bool IsWhole(T value)
{
  constexpr T most = T(9007199254740992.0);
  // Numbers of at least this size have no fraction, so adding it to a smaller number rounds that
  // number.
  constexpr T unit = T(1) / std::numeric_limits<T>::epsilon();
  const T size = std::abs(value);
  return size <= most && (size >= unit || (size + unit) - unit == size);
}

/**
 * Returns the index of the first sample in a range that is not a whole number; -1 if there is none.
 */
template <typename T>
std::int64_t FindFraction(const T* data, std::int64_t stride, std::int64_t first, std::int64_t end)
{
  constexpr std::int64_t piece = 1024;
  for (std::int64_t from = first; from < end; from += piece)
  {
    const std::int64_t to = std::min(from + piece, end);
    int fractions = 0;
    for (std::int64_t i = from; i < to; ++i)
    {
      fractions += IsWhole(data[i * stride]) ? 0 : 1; // adding instead of branching lets the
                                                      // compiler vectorize the loop
    }
    for (std::int64_t i = from; i < to && fractions > 0; ++i)
    {
      if (!IsWhole(data[i * stride]))
      {
        return i;
      }
    }
  }
  return -1;
}

/**
 * Returns the index of a sample that is not a whole number; -1 if none was found. Examines only
 * some ranges of samples in a large image. Fractions elsewhere in that image are truncated.
 */
std::int64_t FindFraction(const VolumeView& view)
{
  return WithSampleType(view.Type,
    [&view](auto sample) -> std::int64_t
    {
      using T = decltype(sample);
      if constexpr (std::is_floating_point_v<T>)
      {
        constexpr std::int64_t runs = 512;
        constexpr std::int64_t length = 1024;
        const std::int64_t* const n = view.Dimensions;
        const T* const data = static_cast<const T*>(view.Data);
        const std::int64_t points = n[0] * n[1] * n[2];
        if (!IsLargeVolume(n))
        {
          return FindFraction(data, view.Stride[0], 0, points);
        }
        for (std::int64_t run = 0; run < runs; ++run)
        {
          const std::int64_t first = points / runs * run;
          const std::int64_t found = FindFraction(data, view.Stride[0], first, first + length);
          if (found >= 0)
          {
            return found;
          }
        }
      }
      return -1;
    });
}

bool CheckArray(vtkImageData* image, vtkDataArray* labels, std::string& error)
{
  std::ostringstream message;
  const std::string name = DescribeArray(labels);
  if (image->GetNumberOfPoints() == 0)
  {
    message << "The " << LabelImage
            << " is empty: its extent holds no points. Update its source, or disconnect it.";
  }
  else if (labels->GetNumberOfTuples() != image->GetNumberOfPoints())
  {
    message << "The " << name << " of the " << LabelImage << " has " << labels->GetNumberOfTuples()
            << " tuples for " << image->GetNumberOfPoints()
            << " points. Use point scalars with one tuple a point.";
  }
  else if (labels->GetNumberOfComponents() != 1)
  {
    message << "The " << name << " of the " << LabelImage << " has "
            << labels->GetNumberOfComponents()
            << " components, and a label is one number. Extract one of them, for example with "
               "vtkImageExtractComponents.";
  }
  error = message.str();
  return error.empty();
}

bool ReadLabels(vtkImageData* image, vtkDataArray* labels, BakedLabels& baked, std::string& error)
{
  VolumeView view;
  vtkSmartPointer<vtkDataArray> holder;
  const int* const extent = image->GetExtent();
  if (!CheckArray(image, labels, error) ||
    !MakeIndexToWorld(image, extent, LabelImage, baked.IndexToWorld, error))
  {
    return false;
  }
  if (!LocateSamples(labels, 0, image->GetDimensions(), view, holder))
  {
    std::ostringstream message;
    message << "The " << DescribeArray(labels) << " of the " << LabelImage
            << " has the scalar type " << labels->GetDataTypeAsString() << " in a "
            << labels->GetClassName()
            << ", which is unsupported. Copy it into an array of numbers, for example with "
               "vtkIntArray::DeepCopy(), and make that the active scalars.";
    error = message.str();
    return false;
  }
  const std::int64_t wrong = FindFraction(view);
  if (wrong >= 0)
  {
    const std::int64_t* const n = view.Dimensions;
    std::ostringstream message;
    message << "The " << DescribeArray(labels) << " of the " << LabelImage << " has the value "
            << labels->GetComponent(wrong, 0) << " at the point (" << wrong % n[0] << ", "
            << wrong / n[0] % n[1] << ", " << wrong / (n[0] * n[1])
            << "), and labels are whole numbers. Connect a segmentation, not an image of "
               "intensities or probabilities, and resample it without interpolation.";
    error = message.str();
    return false;
  }
  baked.View = LabelView(view);
  holder->Register(nullptr);
  vtkDataArray* const held = holder;
  baked.Samples = { static_cast<const void*>(held),
    [held](const void*) { held->UnRegister(nullptr); } };
  return true;
}

/**
 * Bakes the table of labels into the core's table, and appends the forbidden labels to `forbidden`.
 */
LabelTable BakeTable(vtkHapticLabelTable* table, std::vector<int>& forbidden)
{
  std::vector<LabelledMaterial> entries;
  for (vtkIdType i = 0; table && i < table->GetNumberOfLabels(); ++i)
  {
    const int label = table->GetLabel(i);
    LabelledMaterial entry;
    entry.Label = label;
    entry.Material.Value = { table->GetStiffness(label), table->GetFriction(label),
      table->GetSurfaceStrength(label), table->GetViscosity(label) };
    for (int c = 0; c < LabelMaterial::Channels; ++c)
    {
      entry.Material.IsSet[c] = entry.Material.Value[c] >= 0.0; // a negative value is not set
    }
    entry.Material.ShaftFriction = table->GetShaftFriction(label);
    entry.Material.HasShaftFriction = entry.Material.ShaftFriction >= 0.0;
    entry.Material.SpecificEnergy = table->GetSpecificEnergy(label);
    entry.Material.HasSpecificEnergy = entry.Material.SpecificEnergy >= 0.0;
    entry.Material.IsFelt = table->GetFelt(label);
    entry.Material.IsForbidden = table->GetForbidden(label);
    // Skip an entry with only a name or a colour: it does not change the forces.
    if (table->HasMaterial(label) || !entry.Material.IsFelt || entry.Material.IsForbidden)
    {
      entries.push_back(entry);
    }
    if (entry.Material.IsForbidden)
    {
      forbidden.push_back(label);
    }
  }
  return LabelTable(entries);
}

/** Number of voxels in one piece of the distance measurement: about 10 ms of work. */
constexpr vtkIdType MostMeasuredAtOnce = 1 << 20;
/** Number of fine voxels that are made in one piece: about 10 ms of work. */
constexpr double MostRefinedAtOnce = 1 << 20;

/**
 * Makes the forbidden zone. Returns false and sets `error` if the stand-off spans too many voxels.
 */
bool BakeZone(double standOff, BakedLabels& baked, std::string& error)
{
  try
  {
    baked.Zone = ForbiddenZone::Make(baked.View, baked.Table, baked.IndexToWorld, standOff);
  }
  catch (const std::bad_alloc&)
  {
    std::ostringstream message;
    message
      << "The forbidden labels of the " << LabelImage << " with a stand-off of " << standOff
      << " take in more than " << ForbiddenZone::MostVoxels
      << " voxels, or more memory than there is. Lower vtkHapticLabelTable::SetStandOff, forbid "
         "fewer labels, or crop or coarsen the label image.";
    error = message.str();
    return false;
  }
  return true;
}

/** Copies the label image at its own resolution, without the finer grid. */
void CopyImage(const BakedLabels& from, BakedLabels& to)
{
  to.View = from.Fine ? from.Image : from.View;
  to.IndexToWorld = from.Fine ? from.ImageToWorld : from.IndexToWorld;
  to.Samples = from.Samples;
}

Vector3 SpacingOf(const BakedLabels& labels)
{
  const Matrix3 columns = Transpose(labels.IndexToWorld.Linear);
  return { Norm(columns.Row[0]), Norm(columns.Row[1]), Norm(columns.Row[2]) };
}

/**
 * Runs a loop on all processors. The first exception in any thread stops the loop and is rethrown
 * here.
 */
void LoopOnAll(std::int64_t count, const std::function<void(std::int64_t)>& body)
{
  std::atomic<bool> isEnded{ false };
  std::exception_ptr thrown;
  const auto range = [&](vtkIdType from, vtkIdType to)
  {
    for (vtkIdType i = from; i < to && !isEnded; ++i)
    {
      try
      {
        body(i);
      }
      catch (...)
      {
        if (!isEnded.exchange(true))
        {
          thrown = std::current_exception();
        }
      }
    }
  };
  vtkSMPTools::For(0, count, 1, range);
  if (thrown)
  {
    std::rethrow_exception(thrown);
  }
}

} // namespace

void HapticLabels::Refine(const ImageKey& key, const BakedLabels* last, BakedLabels& made)
{
  const Vector3 spacing = SpacingOf(made);
  const Fine* const refined = this->Refining.Find(key);
  made.Refine(refined
      ? *refined
      : FineLabels::Make(made.View, spacing, LoopOnAll, last ? last->Fine.get() : nullptr));
  const double finest = std::min({ spacing.X, spacing.Y, spacing.Z });
  const Vector3 steps = made.Fine ? made.Fine->GetSteps() : Vector3{ 1.0, 1.0, 1.0 };
  const double longest =
    std::max({ spacing.X / steps.X, spacing.Y / steps.Y, spacing.Z / steps.Z });
  const std::int64_t* const n = made.View.GetView().Dimensions;
  if (longest > FineLabels::LargestRatio * finest && std::min({ n[0], n[1], n[2] }) > 1)
  {
    std::ostringstream message;
    message << "The label image has spacings of " << spacing.X << ", " << spacing.Y << " and "
            << spacing.Z
            << ", and too many voxels or labels for a finer grid on which they are alike: walls "
               "between labels are stairs of its slices. Crop the label image, keep fewer labels, "
               "or resample it to cubic voxels.";
    this->Warning = message.str();
  }
}

const char* HapticLabels::Prepare(
  vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table, bool isFine)
{
  return !this->PrepareZone(image, labels, table) ? "the distances to forbidden labels are measured"
    : !this->PrepareFine(image, labels, isFine)
    ? "the shapes of labels are found between thick slices"
    : nullptr;
}

const char* HapticLabels::PrepareScalars(
  vtkImageData* image, vtkDataArray* scalars, vtkHapticProperty* property)
{
  vtkHapticLabelTable* const table = this->GetScalarTable(scalars, property);
  return this->Prepare(image, scalars, table, table->GetNumberOfLabels() > 0);
}

void HapticLabels::EndPreparing()
{
  this->Measuring.Forget();
  this->Refining.Forget();
}

bool HapticLabels::PrepareFine(vtkImageData* image, vtkDataArray* labels, bool isFine)
{
  const ImageKey key{ image, labels, image->GetMTime(), labels->GetMTime() };
  const std::shared_ptr<const BakedLabels> last = this->Baked.lock();
  if (!isFine || (last && this->BakedFine && key == this->BakedImage))
  {
    this->Refining.Abandon();
    return true;
  }
  if (this->Refining.IsOf(key))
  {
    return !this->Refining.IsUnderWay();
  }
  const auto read = std::make_shared<BakedLabels>();
  std::string error;
  if (!ReadLabels(image, labels, *read, error))
  {
    return true; // Get() will report the error
  }
  const Vector3 spacing = SpacingOf(*read);
  const Vector3 steps = FineLabels::ChooseSteps(read->View, spacing);
  const double finer = steps.X * steps.Y * steps.Z;
  if (finer == 1.0 || finer * labels->GetNumberOfTuples() <= MostRefinedAtOnce)
  {
    this->Refining.Abandon();
    return true;
  }
  const std::shared_ptr<const FineLabels> before = last ? last->Fine : nullptr;
  this->Refining.Poll(key,
    [read, spacing, before](WorkMonitor& monitor) -> std::optional<Fine>
    {
      // Run on this thread only, because other threads might not have its low priority.
      const auto loop = [&monitor](std::int64_t count, const FineLabels::Body& body)
      {
        for (std::int64_t i = 0; i < count && !monitor.IsCancelled(); ++i)
        {
          body(i);
        }
      };
      Fine fine = FineLabels::Make(read->View, spacing, loop, before.get());
      return monitor.IsCancelled() ? std::nullopt : std::optional<Fine>(std::move(fine));
    });
  return false;
}

bool HapticLabels::PrepareZone(
  vtkImageData* image, vtkDataArray* labels, vtkHapticLabelTable* table)
{
  const ImageKey imageKey{ image, labels, image->GetMTime(), labels->GetMTime() };
  ZoneKey zoneKey;
  std::get<double>(zoneKey) = table ? table->GetStandOff() : 0.0;
  const auto baked = std::make_shared<BakedLabels>();
  baked->Table = BakeTable(table, std::get<std::vector<int>>(zoneKey));
  const std::tuple<ImageKey, ZoneKey> key{ imageKey, zoneKey };
  if (this->Measuring.IsOf(key))
  {
    return !this->Measuring.IsUnderWay();
  }
  const std::shared_ptr<const BakedLabels> last = this->Baked.lock();
  const bool isImage = last && imageKey == this->BakedImage;
  if (std::get<std::vector<int>>(zoneKey).empty() ||
    labels->GetNumberOfTuples() <= MostMeasuredAtOnce || (isImage && zoneKey == this->BakedZone))
  {
    this->Measuring.Abandon();
    return true;
  }
  std::string error;
  if (isImage)
  {
    CopyImage(*last, *baked);
  }
  else if (!ReadLabels(image, labels, *baked, error))
  {
    return true; // Get() will report the error
  }
  const double standOff = std::get<double>(zoneKey);
  this->Measuring.Poll(key,
    [baked, standOff](WorkMonitor& monitor) -> std::optional<Zone>
    {
      auto zone = ForbiddenZone::Make(baked->View, baked->Table, baked->IndexToWorld, standOff,
        [&monitor] { return !monitor.IsCancelled(); });
      return monitor.IsCancelled() ? std::nullopt : std::optional<Zone>(std::move(zone));
    });
  return false;
}

std::shared_ptr<const BakedLabels> HapticLabels::Get(vtkImageData* image, vtkDataArray* labels,
  vtkHapticLabelTable* table, bool isFine, std::string& error)
{
  const ImageKey imageKey{ image, labels, image->GetMTime(), labels->GetMTime() };
  const TableKey tableKey{ table, table ? table->GetMTime() : 0 };
  std::shared_ptr<const BakedLabels> last = this->Baked.lock();
  const bool isImage = last && imageKey == this->BakedImage;
  if (isImage && tableKey == this->BakedTable && isFine == this->BakedFine)
  {
    return last;
  }
  const auto made = std::make_shared<BakedLabels>();
  if (isImage)
  {
    CopyImage(*last, *made);
  }
  else if (!ReadLabels(image, labels, *made, error))
  {
    return nullptr;
  }
  ZoneKey zoneKey;
  std::get<double>(zoneKey) = table ? table->GetStandOff() : 0.0;
  made->Table = BakeTable(table, std::get<std::vector<int>>(zoneKey));
  if (isImage && zoneKey == this->BakedZone)
  {
    made->Zone = last->Zone;
  }
  else if (const Zone* const measured = this->Measuring.Find({ imageKey, zoneKey }))
  {
    made->Zone = *measured;
  }
  else if (!std::get<std::vector<int>>(zoneKey).empty() &&
    !BakeZone(std::get<double>(zoneKey), *made, error))
  {
    return nullptr;
  }
  if (isFine && isImage && this->BakedFine)
  {
    made->Refine(last->Fine);
  }
  else if (isFine)
  {
    this->Refine(imageKey, last.get(), *made);
  }
  this->BakedFine = isFine;
  this->BakedImage = imageKey;
  this->BakedTable = tableKey;
  this->BakedZone = std::move(zoneKey);
  this->Baked = made;
  return made;
}

std::shared_ptr<const BakedLabels> HapticLabels::GetOfScalars(
  vtkImageData* image, vtkDataArray* scalars, vtkHapticProperty* property, bool isFine)
{
  vtkHapticLabelTable* const table = this->GetScalarTable(scalars, property);
  std::string ignored;
  return table->GetNumberOfLabels() > 0 ? this->Get(image, scalars, table, isFine, ignored)
                                        : nullptr;
}

vtkHapticLabelTable* HapticLabels::GetScalarTable(
  vtkDataArray* scalars, vtkHapticProperty* property)
{
  const ImageKey key{ scalars, property, scalars->GetMTime(), property->GetMTime() };
  if (!this->ScalarTable || key != this->ScalarKey)
  {
    this->ScalarTable = vtkSmartPointer<vtkHapticLabelTable>::New();
    this->ScalarKey = key;
    FillScalarLabels(scalars, property, this->ScalarTable);
  }
  return this->ScalarTable;
}

} // namespace VolumeHaptics

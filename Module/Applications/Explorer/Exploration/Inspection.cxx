// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Exploration/Inspection.h"

#include "vtkDataArray.h"
#include "vtkExtractVOI.h"
#include "vtkFieldData.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRegionFilter.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{
// The local noise is measured in this number of parts along each axis.
constexpr int PARTS = 3;
constexpr int SMALL_PART = 16; // samples along an axis; smaller parts have too few flat blocks

/// Returns the noise of an image (scalar units), as the filter estimates it.
double EstimateImageNoise(vtkImageData* image)
{
  // computes statistics of the whole image; its output region is only one sample
  vtkNew<vtkHapticRegionFilter> whole;
  const int* const extent = image->GetExtent();
  whole->SetRegion(extent[0], extent[0], extent[2], extent[2], extent[4], extent[4]);
  whole->SetInputData(image);
  whole->Update();
  vtkDataArray* const noise = whole->GetOutput()->GetFieldData()->GetArray("HapticNoise");
  return noise ? noise->GetTuple1(0) : 0.0;
}

/// Returns the largest gradient magnitude (scalar per world unit), as the filter estimates it, at a
/// sheet of value 1 in a volume of value 0. `layers` is the thickness of the sheet in voxels along
/// x; 0 makes a step from 0 to 1 instead.
double ComputeLargestGradient(vtkVolumeHapticsFilter* like, double spacing, int layers)
{
  const int radius = like->GetKernelRadius();
  const int size = 4 * radius + 4 + layers;
  const int first = 2 * radius + 2;
  vtkNew<vtkImageData> image;
  image->SetDimensions(size, size, size);
  image->SetSpacing(spacing, spacing, spacing);
  image->AllocateScalars(VTK_FLOAT, 1);
  auto* value = static_cast<float*>(image->GetScalarPointer());
  for (int p = 0; p < size * size * size; ++p)
  {
    const int i = p % size;
    *value++ = i >= first && (layers == 0 || i < first + layers) ? 1.0F : 0.0F;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  constexpr int steps = 10; // number of subvoxel positions
  for (int i = -2 * steps; i <= (layers + 1) * steps; ++i)
  {
    const double middle = 0.5 * spacing * (size - 1);
    points->InsertNextPoint(spacing * (first + static_cast<double>(i) / steps), middle, middle);
  }
  vtkNew<vtkPolyData> path;
  path->SetPoints(points);
  vtkNew<vtkVolumeHapticsFilter> field;
  field->SetInputData(0, image);
  field->SetPathData(path);
  field->SetGradientEstimator(like->GetGradientEstimator());
  field->SetKernelRadius(radius);
  field->SetMethodToForceField();
  field->Update();
  vtkDataArray* const found = field->GetOutput()->GetPointData()->GetArray("GradientMagnitude");
  double range[2] = { 0.0, 0.0 };
  if (found)
  {
    found->GetRange(range);
  }
  return range[1];
}

/// Returns the gradient magnitude (scalar per world unit) at which the distinctness from noise is
/// one half; 0 if there is no noise.
double ComputeFeltGradient(vtkImageData* image, vtkVolumeHapticsFilter* like)
{
  vtkNew<vtkPoints> points;
  double at[3];
  image->GetCenter(at);
  points->InsertNextPoint(at);
  vtkNew<vtkPolyData> path;
  path->SetPoints(points);
  vtkNew<vtkVolumeHapticsFilter> probe;
  probe->SetInputData(0, image);
  probe->SetPathData(path);
  probe->SetGradientEstimator(like->GetGradientEstimator());
  probe->SetKernelRadius(like->GetKernelRadius());
  probe->Update();
  const double* const ramp = probe->GetProperty()->GetNoiseRamp();
  return 0.5 * (ramp[0] + ramp[1]);
}

std::string NameAxes(Explore::WorldAxes axes)
{
  return axes == Explore::WorldAxes::Patient
    ? "the patient's: x to the left, y to the back, z to the head"
    : axes == Explore::WorldAxes::Other ? "the file's own, not a patient's"
                                        : "not stated in the file";
}

std::string NameModality(Explore::VolumeKind kind)
{
  switch (kind)
  {
    case Explore::VolumeKind::CT:
      return "CT";
    case Explore::VolumeKind::EightBit:
      return "8-bit grey values, as in MRI or photographs";
    case Explore::VolumeKind::Field:
      return "a field of a simulation";
    case Explore::VolumeKind::Labels:
      return "labels";
    default:
      return "unknown";
  }
}

std::string ExplainPreset(const std::string& preset, const std::string& modality)
{
  return preset == "propose" ? "no preset fits its grey levels: what is solid is found by its edges"
    : preset == "histogram"  ? "no edges were found to propose from, so that its histogram is used"
    : modality == "CT"       ? "its values are Hounsfield units"
    : modality == "labels"   ? "its values are label numbers"
                             : "it was chosen";
}

template <typename Number>
std::string Join(const Number* numbers, int count, const char* between)
{
  std::ostringstream text;
  for (int i = 0; i < count; ++i)
  {
    text << (i > 0 ? between : "") << numbers[i];
  }
  return text.str();
}

std::string Quote(const std::string& text)
{
  std::string quoted = "\"";
  for (const char letter : text)
  {
    constexpr char firstPrintable = ' ';
    quoted += letter == '"' || letter == '\\' ? "\\" : "";
    quoted += letter >= 0 && letter < firstPrintable ? ' ' : letter;
  }
  return quoted + '"';
}

std::string Round(double number)
{
  std::ostringstream text;
  constexpr int digits = 3, all = 15; // significant digits of numbers below and above 1000
  text.precision(std::abs(number) < 1000.0 ? digits : all);
  text << (std::abs(number) < 1000.0 ? number : std::round(number));
  return text.str();
}

std::string FirstLine(const std::string& text)
{
  return text.substr(0, text.find('\n'));
}

/// Breaks a text into rows of a sheet. The first row also shows the name.
std::string Wrap(const std::string& name, const std::string& text)
{
  constexpr std::size_t width = 40; // letters
  std::istringstream words(text);
  std::string rows = name + "\t", word;
  for (std::size_t used = 0; words >> word; used += word.size() + 1)
  {
    if (used > 0 && used + word.size() > width)
    {
      rows += "\n \t";
      used = 0;
    }
    rows += (used > 0 ? " " : "") + word;
  }
  return rows + "\n";
}
} // namespace

namespace Explore
{
Inspection::Inspection(const Volume& volume, const Analysis& values, const std::string& materials,
  vtkVolumeHapticsFilter* filter)
  : Name(volume.Name)
  , Format(volume.Format)
  , Type(volume.Image->GetScalarTypeAsString())
  , Axes(NameAxes(volume.Axes))
  , Modality(volume.Modality.empty() ? NameModality(values.Kind) : volume.Modality)
  , ModalityReason(
      (volume.Modality.empty() ? "" : "the file says so, and its ") + values.KindReason)
  , Padding(volume.Padding)
  , Preset(materials)
  , PresetReason(ExplainPreset(materials, NameModality(values.Kind)))
  , Unit(values.Kind == VolumeKind::CT ? " HU" : "")
  , Notes(volume.Notes)
  , MetersPerUnit(values.MetersPerWorldUnit)
{
  vtkImageData* const image = volume.Image;
  std::copy_n(image->GetDimensions(), 3, this->Size);
  std::copy_n(image->GetSpacing(), 3, this->Spacing);
  std::copy_n(image->GetOrigin(), 3, this->Origin);
  std::copy_n(image->GetDirectionMatrix()->GetData(), 9, this->Direction);
  if (volume.Large)
  {
    const int* const whole = volume.Large->GetWholeExtent();
    for (int a = 0; a < 3; ++a)
    {
      this->Size[a] = whole[2 * a + 1] - whole[2 * a] + 1;
    }
    std::copy_n(volume.Large->GetSpacing(), 3, this->Spacing);
    std::copy_n(volume.Large->GetOrigin(), 3, this->Origin);
    std::copy_n(volume.Large->GetDirection(), 9, this->Direction);
    this->Notes.emplace_back("values, noise and steps are those of the coarse level");
  }
  std::copy_n(values.Range, 2, this->Range);
  this->Usual[0] = values.Low;
  this->Usual[1] = values.High;
  const bool hasNoise = values.Kind != VolumeKind::Labels && values.Kind != VolumeKind::Field;
  if (hasNoise)
  {
    this->MeasureNoise(image);
    this->ComputeSmallestStep(image, filter);
  }
}

void Inspection::MeasureNoise(vtkImageData* image)
{
  this->Noise = EstimateImageNoise(image);
  const int* const extent = image->GetExtent();
  const int* const size = image->GetDimensions();
  if (*std::min_element(size, size + 3) < PARTS * SMALL_PART)
  {
    return;
  }
  vtkNew<vtkExtractVOI> crop;
  crop->SetInputData(image);
  for (int part = 0; part < PARTS * PARTS * PARTS; ++part)
  {
    const int place[3] = { part % PARTS, part / PARTS % PARTS, part / (PARTS * PARTS) };
    int box[6];
    for (int a = 0; a < 3; ++a)
    {
      box[2 * a] = extent[2 * a] + size[a] * place[a] / PARTS;
      box[2 * a + 1] = extent[2 * a] + size[a] * (place[a] + 1) / PARTS - 1;
    }
    crop->SetVOI(box);
    crop->Update();
    const double noise = EstimateImageNoise(crop->GetOutput());
    if (noise > 0.0) // padded or saturated parts have zero noise
    {
      const bool isFirst = this->LocalNoise[1] == 0.0;
      this->LocalNoise[0] = isFirst ? noise : std::min(this->LocalNoise[0], noise);
      this->LocalNoise[1] = std::max(this->LocalNoise[1], noise);
    }
  }
}

void Inspection::ComputeSmallestStep(vtkImageData* image, vtkVolumeHapticsFilter* filter)
{
  // One spacing suffices: along an axis with another spacing, noise and gradients scale by the same
  // factor.
  const double finest = *std::min_element(image->GetSpacing(), image->GetSpacing() + 3);
  const double felt = ComputeFeltGradient(image, filter);
  const double step = ComputeLargestGradient(filter, finest, 0);
  const double sheet = ComputeLargestGradient(filter, finest, 1);
  this->SmallestStep = step > 0.0 ? felt / step : 0.0;
  this->SmallestSheetStep = sheet > 0.0 ? felt / sheet : 0.0;
}

std::string Inspection::DescribeNoise() const
{
  return this->Noise <= 0.0 ? "none was found"
                            : Round(this->Noise) + this->Unit +
      (this->LocalNoise[1] > 0.0 ? ", " + Round(this->LocalNoise[0]) + " to " +
            Round(this->LocalNoise[1]) + " in its parts"
                                 : "");
}

std::string Inspection::DescribeFeature() const
{
  const double longest = *std::max_element(this->Spacing, this->Spacing + 3);
  std::ostringstream text;
  text << "sheets of " << Round(longest) << " mm, a voxel along its longest edge";
  if (this->SmallestStep > 0.0)
  {
    text << ", that differ by " << Round(this->SmallestSheetStep) << this->Unit
         << "; broad surfaces whose sides differ by " << Round(this->SmallestStep) << this->Unit;
  }
  return text.str();
}

std::string Inspection::Describe() const
{
  std::ostringstream text;
  text << this->Name << " is read as " << this->Format << ".\n"
       << "It has " << Join(this->Size, 3, " x ") << " voxels of " << Join(this->Spacing, 3, " x ")
       << " mm, from (" << Join(this->Origin, 3, ", ") << ") on, of type " << this->Type << ".\n"
       << "Lengths are assumed to be millimetres, and "
       << (this->MetersPerUnit == 0.001 ? "felt at life size.\n"
                                        : "felt at a scale of " +
                Round(1000.0 * this->MetersPerUnit) + ", so that it fits a hand.\n")
       << "Its axes are " << this->Axes << ".\n"
       << "Values are " << this->Range[0] << " to " << this->Range[1] << this->Unit
       << ", and nearly all of them " << this->Usual[0] << " to " << this->Usual[1] << ".\n"
       << "Padding: " << (this->Padding.empty() ? "none was found" : this->Padding) << ".\n"
       << "Modality: " << this->Modality << "; " << this->ModalityReason << ".\n"
       << "Noise (standard deviation): " << this->DescribeNoise() << ".\n"
       << "The smallest feature that is felt reliably: " << this->DescribeFeature() << ".\n"
       << "Suggested preset: " << this->Preset << ", because " << this->PresetReason << ".\n";
  for (const std::string& note : this->Notes)
  {
    text << "Note: " << note << ".\n";
  }
  return text.str();
}

std::string Inspection::ToJson() const
{
  std::ostringstream json;
  json.precision(17);
  json << "{\n  \"name\": " << Quote(this->Name) << ",\n  \"format\": " << Quote(this->Format)
       << ",\n  \"size\": [" << Join(this->Size, 3, ", ") << "],\n  \"spacing\": [";
  const auto list = [&json](const double* numbers, int count)
  {
    for (int i = 0; i < count; ++i)
    {
      json << (i > 0 ? ", " : "") << numbers[i];
    }
    json << "]";
  };
  list(this->Spacing, 3);
  json << ",\n  \"origin\": [";
  list(this->Origin, 3);
  json << ",\n  \"direction\": [";
  list(this->Direction, 9);
  json << ",\n  \"unit\": \"mm\",\n  \"meters_per_unit\": " << this->MetersPerUnit
       << ",\n  \"axes\": " << Quote(this->Axes) << ",\n  \"type\": " << Quote(this->Type)
       << ",\n  \"range\": [";
  list(this->Range, 2);
  json << ",\n  \"usual_range\": [";
  list(this->Usual, 2);
  json << ",\n  \"padding\": " << (this->Padding.empty() ? "null" : Quote(this->Padding))
       << ",\n  \"modality\": " << Quote(this->Modality)
       << ",\n  \"modality_reason\": " << Quote(this->ModalityReason)
       << ",\n  \"noise\": " << this->Noise << ",\n  \"local_noise\": ";
  if (this->LocalNoise[1] > 0.0)
  {
    json << "[";
    list(this->LocalNoise, 2);
  }
  else
  {
    json << "null";
  }
  json << ",\n  \"smallest_sheet\": " << *std::max_element(this->Spacing, this->Spacing + 3)
       << ",\n  \"smallest_sheet_step\": " << this->SmallestSheetStep
       << ",\n  \"smallest_step\": " << this->SmallestStep
       << ",\n  \"preset\": " << Quote(this->Preset)
       << ",\n  \"preset_reason\": " << Quote(this->PresetReason) << ",\n  \"notes\": [";
  for (std::size_t i = 0; i < this->Notes.size(); ++i)
  {
    json << (i > 0 ? ", " : "") << Quote(this->Notes[i]);
  }
  json << "]\n}\n";
  return json.str();
}

std::string Inspection::ListFacts() const
{
  std::ostringstream text;
  text << "Volume\n"
       << "format\t" << this->Format << ", " << this->Type << "\n"
       << "voxels\t" << Join(this->Size, 3, " x ") << "\n"
       << "size\t" << Round(this->Spacing[0]) << " x " << Round(this->Spacing[1]) << " x "
       << Round(this->Spacing[2]) << " mm\n"
       << "from\t" << Round(this->Origin[0]) << ", " << Round(this->Origin[1]) << ", "
       << Round(this->Origin[2]) << " mm\n"
       << Wrap("axes", this->Axes);
  if (this->MetersPerUnit != 0.001)
  {
    text << "felt at\t" << Round(1000.0 * this->MetersPerUnit) << " times its size\n";
  }
  text << "Values\n"
       << Wrap("values",
            Round(this->Range[0]) + " to " + Round(this->Range[1]) + this->Unit + ", nearly all " +
              Round(this->Usual[0]) + " to " + Round(this->Usual[1]))
       << Wrap("kind", this->Modality + "; " + this->ModalityReason)
       << Wrap("padding", this->Padding.empty() ? "none" : this->Padding)
       << Wrap("noise", this->DescribeNoise()) << "Felt\n"
       << Wrap("least", this->DescribeFeature())
       << Wrap("preset", this->Preset + ", because " + this->PresetReason);
  // The sheet is too small for more notes; --inspect lists all of them.
  constexpr std::size_t most = 5;
  text << (this->Notes.empty() ? "" : "Notes\n");
  for (std::size_t i = 0; i < std::min(most, this->Notes.size()); ++i)
  {
    text << Wrap(std::to_string(i + 1), FirstLine(this->Notes[i]));
  }
  if (this->Notes.size() > most)
  {
    text << "...\t" << this->Notes.size() - most << " more, by --inspect\n";
  }
  return text.str();
}

std::string Inspection::ListTold() const
{
  constexpr std::size_t most = 4; // lines of notes over the picture
  std::string text;
  for (std::size_t i = 0; i < std::min(most, this->Notes.size()); ++i)
  {
    text += (i > 0 ? "\n" : "") + FirstLine(this->Notes[i]);
  }
  return this->Notes.size() > most ? text + "\nF1 shows more" : text;
}
} // namespace Explore

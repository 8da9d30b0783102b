// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/VolumeChecks.h"

#include "Core/Platform/ControlGroup.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeLoader.h"

#include "VTK/Base/HapticNoise.h"
#include "VTK/Base/OutsideFiller.h"

#include "vtkCellData.h"
#include "vtkCellDataToPointData.h"
#include "vtkDataArray.h"
#include "vtkImageExtractComponents.h"
#include "vtkImageShiftScale.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <vtksys/SystemInformation.hxx>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

namespace
{
using Explore::InputError;
using Explore::Volume;

// Smallest size along an axis: a kernel of the default radius of 2 voxels needs samples on both
// sides.
constexpr int MINIMUM_SIZE = 5;

std::string SizeText(const int size[3])
{
  std::ostringstream text;
  text << size[0] << " x " << size[1] << " x " << size[2];
  return text.str();
}

void CheckGeometry(const std::string& path, vtkImageData* image)
{
  Explore::CheckSize(path, image->GetDimensions());
  for (int axis = 0; axis < 3; ++axis)
  {
    const double spacing = image->GetSpacing()[axis];
    if (!std::isfinite(spacing) || spacing == 0.0 || !std::isfinite(image->GetOrigin()[axis]))
    {
      throw InputError(path, "has a spacing or an origin that is not a finite, non-zero number",
        "correct the spacing in the file's header");
    }
  }
  const double determinant = image->GetDirectionMatrix()->Determinant();
  if (!std::isfinite(determinant) || std::abs(determinant) < 1e-6)
  {
    throw InputError(path, "has a singular direction matrix", "correct it in the file's header");
  }
}

/// Makes a point array the active scalars if the image has none.
void ChooseScalars(const std::string& path, Volume& volume)
{
  vtkImageData* image = volume.Image;
  vtkPointData* points = image->GetPointData();
  if (!points->GetScalars() && image->GetCellData()->GetNumberOfArrays() > 0 &&
    points->GetNumberOfArrays() == 0)
  {
    vtkNew<vtkCellDataToPointData> toPoints;
    toPoints->SetInputData(image);
    toPoints->Update();
    vtkNew<vtkImageData> converted;
    converted->ShallowCopy(toPoints->GetOutput());
    volume.Image = converted;
    volume.Notes.emplace_back("cell values averaged to the points");
    points = converted->GetPointData();
  }
  for (int i = 0; i < points->GetNumberOfArrays() && !points->GetScalars(); ++i)
  {
    if (points->GetArray(i) && points->GetArray(i)->GetName())
    {
      points->SetActiveScalars(points->GetArray(i)->GetName());
      volume.Notes.push_back(std::string("no active scalars: point array '") +
        points->GetArray(i)->GetName() + "' used");
    }
  }
  if (!points->GetScalars())
  {
    throw InputError(path, "has no scalars: there is nothing to feel",
      "write the file with a point-data array of numbers");
  }
}

/// Replaces RGB or RGBA bytes with their brightness, which can be felt.
void UseBrightness(Volume& volume)
{
  vtkDataArray* const colours = volume.Image->GetPointData()->GetScalars();
  vtkNew<vtkUnsignedCharArray> brightness;
  brightness->SetName(colours->GetName() ? colours->GetName() : "Brightness");
  brightness->SetNumberOfValues(colours->GetNumberOfTuples());
  for (vtkIdType i = 0; i < colours->GetNumberOfTuples(); ++i)
  {
    // Weights of red, green and blue as in vtkImageLuminance.
    const double value = 0.30 * colours->GetComponent(i, 0) + 0.59 * colours->GetComponent(i, 1) +
      0.11 * colours->GetComponent(i, 2);
    brightness->SetValue(i, static_cast<unsigned char>(value));
  }
  vtkNew<vtkImageData> single;
  single->CopyStructure(volume.Image);
  single->GetPointData()->SetScalars(brightness);
  volume.Image = single;
  volume.Notes.emplace_back("colours: their brightness is used");
}

/// Returns, as a cure for errors, how to read another volume of the same file; empty if there is
/// none.
std::string NameAnother(const Volume& volume)
{
  if (volume.Series.size() < 2)
  {
    return {};
  }
  const int first = std::stoi(volume.Series.front());
  const std::string other = std::to_string(first == volume.SeriesNumber ? first + 1 : first);
  return ", or use another of the " + std::to_string(volume.Series.size()) +
    " that it has, such as --series " + other + " (Series = " + other + ")";
}

void CheckRange(const std::string& path, const Volume& volume)
{
  double range[2];
  volume.Image->GetPointData()->GetScalars()->GetFiniteRange(range, 0);
  if (!(range[0] < range[1]))
  {
    std::ostringstream fault;
    fault << "is uniform (every finite voxel is " << range[0] << "): there is nothing to feel";
    throw InputError(path, range[0] > range[1] ? "has no finite voxel" : fault.str(),
      "check the export, in particular its rescale slope and window" + NameAnother(volume));
  }
}

/// Sets outside samples to the value that the filter feels there, so that picture and thresholds
/// agree with the touch.
void UseOutside(Volume& volume)
{
  vtkDataArray* const scalars = volume.Image->GetPointData()->GetScalars();
  const VolumeHaptics::OutsideSamples outside =
    VolumeHaptics::DetectOutside(volume.Image, scalars, 0);
  const std::string notice = VolumeHaptics::DescribeOutside(outside, scalars);
  if (!notice.empty())
  {
    volume.Notes.push_back(notice);
    volume.Padding = notice;
  }
  if (!outside.HasAny())
  {
    return;
  }
  vtkNew<vtkImageData> image;
  image->ShallowCopy(volume.Image);
  image->GetPointData()->SetScalars(VolumeHaptics::CopyFilled(outside, scalars, 0));
  volume.Image = image; // assigned last, because the old image may own the scalars
}

/// Adds a note if the values of a CT can't be Hounsfield units, which the presets of CT assume.
void NoteOddValues(const VolumeHaptics::StoredShift& found, Volume& volume)
{
  constexpr double lowest = -4096.0, highest = 40000.0; // HU: of air beside metal; of metal
  vtkDataArray* const scalars = volume.Image->GetPointData()->GetScalars();
  double range[2];
  scalars->GetFiniteRange(range, 0);
  if (volume.Modality == "CT" &&
    (found.IsStrange || scalars->GetDataTypeSize() == 1 || range[0] < lowest || range[1] > highest))
  {
    std::ostringstream note;
    note << "the file says CT, but values from " << range[0] << " to " << range[1]
         << " are not Hounsfield units: presets for CT do not fit them";
    volume.Notes.push_back(note.str());
  }
}

/// Shifts the values of a scanner that stores Hounsfield units with an offset, so that picture and
/// thresholds agree with the touch.
void UseHounsfieldUnits(Volume& volume)
{
  if (volume.IsField || !Explore::MayBeHounsfield(volume.Modality))
  {
    return;
  }
  vtkDataArray* const scalars = volume.Image->GetPointData()->GetScalars();
  const int* const size = volume.Image->GetDimensions();
  const std::int64_t dimensions[3] = { size[0], size[1], size[2] };
  const VolumeHaptics::StoredShift found =
    VolumeHaptics::EstimateStoredShift(scalars, dimensions, 0);
  if (found.Shift == 0.0)
  {
    NoteOddValues(found, volume);
    return;
  }
  Explore::ShiftValues(volume, found.Shift);
  std::ostringstream note;
  note << "air is at " << found.Air << ": taken for Hounsfield units + " << -found.Shift
       << ", which is subtracted";
  volume.Notes.push_back(note.str());
}
} // namespace

namespace Explore
{
double GetFreeMemory()
{
  constexpr double mebibyte = 1024.0 * 1024.0;
  vtksys::SystemInformation system;
  system.RunMemoryCheck();
  const double free = mebibyte * static_cast<double>(system.GetAvailablePhysicalMemory());
  // In a container, less memory may be free than the system reports.
  const double ofGroup = VolumeHaptics::ReadGroupMemory();
  return free > 0.0 ? std::min(free, ofGroup) : ofGroup;
}

void CheckMemory(const std::string& path, double bytes, std::size_t frames)
{
  constexpr double mebibyte = 1024.0 * 1024.0;
  const double needed = bytes * static_cast<double>(frames) / mebibyte;
  const double free = GetFreeMemory() / mebibyte;
  if (needed > free)
  {
    std::ostringstream fault;
    fault << "has " << frames << " frames, which need " << std::lround(needed)
          << " MiB of memory, and " << std::lround(free) << " MiB are free";
    throw InputError(path, fault.str(), "give fewer or smaller frames");
  }
}

void CheckSize(const std::string& path, const int size[3])
{
  if (std::any_of(size, size + 3, [](int count) { return count < 1; }))
  {
    throw InputError(path, "has no voxels", "export the volume again");
  }
  if (std::count(size, size + 3, 1) > 0)
  {
    throw InputError(path, "is a single slice (" + SizeText(size) + " voxels), not a volume",
      "export the whole series as one three-dimensional image");
  }
  if (std::any_of(size, size + 3, [](int count) { return count < MINIMUM_SIZE; }))
  {
    throw InputError(path,
      "is too thin to be touched (" + SizeText(size) + " voxels; at least 5 each way)",
      "export more slices");
  }
}

bool MayBeHounsfield(const std::string& modality)
{
  static const char* const others[] = { "MR", "PT", "NM", "US", "OPT", "OCT", "IVUS", "IVOCT", "MG",
    "RTDOSE", "SEG" };
  return std::find(std::begin(others), std::end(others), modality) == std::end(others);
}

void UseComponent(const std::string& path, Volume& volume, int chosen)
{
  const int components = volume.Image->GetNumberOfScalarComponents();
  const bool isColour =
    (components == 3 || components == 4) && volume.Image->GetScalarType() == VTK_UNSIGNED_CHAR;
  // If there were series to choose from, as for DICOM, `chosen` was the number of the series.
  const int number = volume.Series.empty() && volume.Format != "DICOM" ? chosen : 0;
  const int count = isColour ? 1 : components;
  if (number > 0 && count == 1)
  {
    throw InputError(path, "has one volume only, which needs no number", "leave out Series");
  }
  if (number > count)
  {
    throw InputError(path,
      "has " + std::to_string(count) + " components, and none with the number " +
        std::to_string(number),
      "use Series = 1 to Series = " + std::to_string(count));
  }
  if (components == 1)
  {
    return;
  }
  if (isColour)
  {
    UseBrightness(volume);
    return;
  }
  const int used = std::max(number - 1, 0);
  vtkDataArray* const scalars = volume.Image->GetPointData()->GetScalars();
  std::vector<std::string> names;
  for (int c = 0; c < components; ++c)
  {
    const char* const name = scalars->GetComponentName(c);
    names.push_back(std::to_string(c + 1) + " component " + std::to_string(c) +
      (name && *name ? " (" + std::string(name) + ")" : ""));
  }
  vtkNew<vtkImageExtractComponents> extract;
  extract->SetInputData(volume.Image);
  extract->SetComponents(used);
  extract->Update();
  vtkNew<vtkImageData> single;
  single->ShallowCopy(extract->GetOutput());
  single->SetDirectionMatrix(volume.Image->GetDirectionMatrix());
  volume.Image = single;
  volume.Notes.push_back(std::to_string(components) + " components per voxel: component " +
    std::to_string(used) + " used, the others ignored" +
    (volume.Series.empty()
        ? "; Series = 1 to Series = " + std::to_string(components) + " choose one of them"
        : std::string()));
  if (volume.Series.empty())
  {
    volume.Series = names;
    volume.SeriesNumber = used + 1;
  }
}

void ShiftValues(Volume& volume, double shift)
{
  if (shift == 0.0)
  {
    return;
  }
  vtkDataArray* const scalars = volume.Image->GetPointData()->GetScalars();
  const bool isWhole = scalars->GetDataType() != VTK_FLOAT && scalars->GetDataType() != VTK_DOUBLE;
  vtkNew<vtkImageShiftScale> shifted;
  shifted->SetInputData(volume.Image);
  shifted->SetShift(shift);
  shifted->SetOutputScalarType(isWhole ? VTK_INT : scalars->GetDataType());
  shifted->Update();
  vtkNew<vtkImageData> image;
  image->ShallowCopy(shifted->GetOutput());
  image->SetDirectionMatrix(volume.Image->GetDirectionMatrix());
  image->GetPointData()->GetScalars()->SetName(scalars->GetName());
  volume.Image = image;
  volume.Shift += shift;
}

void CheckVolume(const std::string& path, Volume& volume, int chosen)
{
  CheckGeometry(path, volume.Image);
  ChooseScalars(path, volume);
  UseComponent(path, volume, chosen);
  UseOutside(volume);
  UseHounsfieldUnits(volume);
  CheckRange(path, volume);
}
} // namespace Explore

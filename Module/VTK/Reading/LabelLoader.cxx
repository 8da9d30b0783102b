// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/LabelLoader.h"

#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Reading/VolumeChecks.h"

#include "Core/Platform/HapticFiles.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <sstream>
#include <unordered_set>

namespace
{
using Explore::InputError;
using Explore::Volume;

bool IsNrrd(const std::string& path)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(path)) ==
    ".nrrd";
}

void ReadTables(Volume& volume, const std::vector<std::string>& tables)
{
  for (const std::string& table : tables)
  {
    const Explore::MessageCapture capture;
    if (!volume.LabelTable->ReadFile(table.c_str()))
    {
      throw InputError("--materials " + table, capture.FirstError(), "choose another file");
    }
  }
}

/// Rounds floating-point labels to integers if all of them are within 0.001 of one: a NIfTI header
/// may scale labels by 1.00002, for example. Returns the first value that is not, or 0 if all are.
double RoundLabels(vtkImageData* image, std::vector<std::string>& notes)
{
  constexpr double most = 0.001;
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  if (values->GetDataType() != VTK_FLOAT && values->GetDataType() != VTK_DOUBLE)
  {
    return 0.0;
  }
  vtkNew<vtkIntArray> labels;
  labels->SetName(values->GetName());
  labels->SetNumberOfValues(values->GetNumberOfTuples());
  bool isChanged = false;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    const double label = std::round(value);
    if (!(std::abs(value - label) <= most) || std::abs(label) > VTK_INT_MAX)
    {
      return value;
    }
    isChanged = isChanged || value != label;
    labels->SetValue(i, static_cast<int>(label));
  }
  image->GetPointData()->SetScalars(labels);
  if (isChanged)
  {
    notes.emplace_back("labels within 0.001 of a whole number were rounded");
  }
  return 0.0;
}

/// Labels other than 0 that occur in an image.
struct LabelNumbers
{
  std::set<int> Found;
  bool AreAll = true; ///< whether all values are integers that fit into an int
};

/// Collects the labels of an image and stops at more than `Most`.
struct NumberCollector
{
  std::size_t Most;
  LabelNumbers Numbers;

  template <typename Array>
  void operator()(Array* values)
  {
    std::unordered_set<int> found;
    double last = 0.0;
    for (const auto value : vtk::DataArrayValueRange<1>(values))
    {
      const auto label = static_cast<double>(value);
      if (label == last)
      {
        continue;
      }
      if (label != std::floor(label) || std::abs(label) > VTK_INT_MAX)
      {
        this->Numbers.AreAll = false;
        break;
      }
      last = label;
      if (found.insert(static_cast<int>(label)).second && found.size() > this->Most)
      {
        break;
      }
    }
    this->Numbers.Found.insert(found.begin(), found.end());
    this->Numbers.Found.erase(0);
  }
};

LabelNumbers CollectLabels(vtkDataArray* values, std::size_t most = SIZE_MAX)
{
  NumberCollector collector{ most, {} };
  if (!vtkArrayDispatch::Dispatch::Execute(values, collector))
  {
    collector(values);
  }
  return collector.Numbers;
}

/// Narrows the sample range [first, last] of a row to the samples whose coordinate begin + i * step
/// is within half a voxel of `range`.
void ClipRow(double begin, double step, const int range[2], double& first, double& last)
{
  const double low = range[0] - 0.5 - begin, high = range[1] + 0.5 - begin;
  if (std::abs(step) < 1e-9)
  {
    last = low <= 0.0 && high >= 0.0 ? last : first - 1.0;
    return;
  }
  first = std::max(first, std::ceil(std::min(low / step, high / step)));
  last = std::min(last, std::floor(std::max(low / step, high / step)));
}

/// Returns whether any voxel with a label other than 0 is inside a volume.
bool IsAnyInside(vtkImageData* labels, vtkImageData* volume)
{
  vtkDataArray* const values = labels->GetPointData()->GetScalars();
  vtkNew<vtkMatrix4x4> toVolume;
  vtkMatrix4x4::Multiply4x4(
    volume->GetPhysicalToIndexMatrix(), labels->GetIndexToPhysicalMatrix(), toVolume);
  const int* const extent = labels->GetExtent();
  const int* const range = volume->GetExtent();
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      const double start[4] = { 0.0, static_cast<double>(j), static_cast<double>(k), 1.0 };
      double begin[4], first = extent[0], last = extent[1];
      toVolume->MultiplyPoint(start, begin);
      for (int axis = 0; axis < 3; ++axis)
      {
        ClipRow(begin[axis], toVolume->GetElement(axis, 0), range + 2 * axis, first, last);
      }
      int at[3] = { static_cast<int>(first), j, k };
      for (vtkIdType id = first <= last ? labels->ComputePointId(at) : 0; at[0] <= last;
           ++at[0], ++id)
      {
        if (values->GetComponent(id, 0) != 0.0)
        {
          return true;
        }
      }
    }
  }
  return false;
}

/// Returns a note if labels of a table do not occur in the voxels; empty otherwise.
std::string DescribeUnused(const std::set<int>& used, vtkHapticLabelTable* table)
{
  std::string first;
  vtkIdType unused = 0;
  for (vtkIdType i = 0; i < table->GetNumberOfLabels(); ++i)
  {
    const int label = table->GetLabel(i);
    if (label != 0 && used.count(label) == 0)
    {
      const std::string name = VolumeHaptics::Printable(table->GetLabelName(label));
      first = unused == 0
        ? std::to_string(label) + (name.empty() ? std::string() : " (" + name + ")")
        : first;
      ++unused;
    }
  }
  return unused == 0
    ? std::string()
    : std::to_string(unused) + " of " + std::to_string(table->GetNumberOfLabels()) +
      " labels of the table are in no voxel, such as " + first;
}

/// Sets the colour of a label. The hues of successive labels differ by the golden ratio.
void SetColor(vtkHapticLabelTable* table, int label, std::size_t number)
{
  const double hue = std::fmod(0.08 + 0.618034 * static_cast<double>(number), 1.0);
  double color[3];
  vtkMath::HSVToRGB(hue, number % 3 == 2 ? 0.35 : 0.55, 0.92, color, color + 1, color + 2);
  table->SetColor(label, color);
}
} // namespace

namespace Explore
{
void UseAsLabels(Volume& volume, const std::string& path, const std::vector<std::string>& tables)
{
  RoundLabels(volume.Image, volume.Notes);
  constexpr std::size_t most = 4096;
  constexpr int highest = 1000000;
  const auto [labels, areAll] = CollectLabels(volume.Image->GetPointData()->GetScalars(), most);
  if (!areAll || labels.size() > most ||
    (!labels.empty() && (*labels.begin() < 0 || *labels.rbegin() > highest)))
  {
    throw InputError("--as-labels " + path, "has values that are not label numbers",
      "leave --as-labels out; labels are up to 4096 whole numbers of 0 or more");
  }
  const bool hasNames = volume.LabelTable != nullptr;
  if (!hasNames)
  {
    volume.LabelTable = vtkSmartPointer<vtkHapticLabelTable>::New();
  }
  vtkHapticLabelTable* const table = volume.LabelTable;
  volume.MayBeLabels = volume.MayBeLabels && !hasNames; // names in the file prove that the values
                                                        // are labels
  if (!hasNames && !vtksys::SystemTools::FileIsDirectory(path))
  {
    const MessageCapture capture; // a file need not have names: its labels are then named by their
                                  // numbers
    table->ReadFile(path.c_str());
  }
  std::size_t number = 0;
  for (const int label : labels)
  {
    if (table->GetLabelName(label).empty())
    {
      table->SetLabelName(label, "label " + std::to_string(label));
    }
    if (!table->HasColor(label))
    {
      SetColor(table, label, number);
    }
    ++number;
  }
  ReadTables(volume, tables);
  const std::string unused = DescribeUnused(labels, table);
  volume.Notes.insert(volume.Notes.end(), unused.empty() ? 0 : 1, unused);
  volume.Labels = volume.Image;
  volume.AreLabels = true;
  volume.Notes.push_back("its values are taken as labels: " + std::to_string(labels.size()));
}

Volume ReadLabels(const std::string& path, int series, bool canChoose)
{
  if (IsNrrd(path) && series == 0)
  {
    return ReadNrrdSegmentation(path);
  }
  Volume labels = ReadVolume(path, series > 0, series);
  if (labels.IsGrid)
  {
    throw InputError(path, "has no voxels, but cells", "write the labels as an image");
  }
  if (labels.Format == "DICOM")
  {
    throw InputError(path, "is DICOM, but not a segmentation (SEG)", "give it as the volume");
  }
  const int components = labels.Image->GetNumberOfScalarComponents();
  const int count = std::max(
    { ReadNiftiTimes(path, 1.0).Count, static_cast<int>(labels.Series.size()), components });
  if (series == 0 && count > 1 && !labels.LabelTable)
  {
    throw InputError(path, "has several volumes, and labels need one",
      (canChoose ? "use Series = 1 to Series = " + std::to_string(count) + ", or "
                 : std::string()) +
        "write the volume that you mean into its own file");
  }
  UseComponent(path, labels, series);
  const double wrong = RoundLabels(labels.Image, labels.Notes);
  if (wrong != 0.0)
  {
    std::ostringstream fault;
    fault << "has values that are not label numbers, such as " << wrong;
    throw InputError(path, fault.str(),
      "write whole numbers; if a NIfTI header scales them, with the slope 1 and the intercept 0");
  }
  if (!labels.LabelTable)
  {
    labels.LabelTable = vtkSmartPointer<vtkHapticLabelTable>::New();
    const MessageCapture capture; // a file need not have names: its labels are then named by their
                                  // numbers
    labels.LabelTable->ReadFile(path.c_str());
  }
  return labels;
}

std::vector<std::string> DescribeLabels(
  vtkImageData* labels, vtkImageData* volume, vtkHapticLabelTable* table)
{
  vtkDataArray* const values = labels->GetPointData()->GetScalars();
  if (!values || values->GetNumberOfTuples() != labels->GetNumberOfPoints() ||
    values->GetNumberOfComponents() != 1)
  {
    return {}; // the filter will report the fault
  }
  std::vector<std::string> notes;
  if (!IsAnyInside(labels, volume))
  {
    notes.emplace_back("no voxel of the volume has a label: the labels are all 0, or belong to "
                       "another scan or place");
  }
  const std::string unused = table && table->GetNumberOfLabels() > 0
    ? DescribeUnused(CollectLabels(values).Found, table)
    : std::string();
  notes.insert(notes.end(), unused.empty() ? 0 : 1, unused);
  return notes;
}

void LoadLabels(
  Volume& volume, const std::string& segmentation, const std::vector<std::string>& tables)
{
  volume.MayBeLabels = false; // the labels are in the segmentation instead
  const Volume labels = ReadLabels(segmentation, 0, false);
  volume.Labels = labels.Image;
  volume.LabelTable = labels.LabelTable;
  const std::string file = vtksys::SystemTools::GetFilenameName(segmentation);
  for (const std::string& note : labels.Notes)
  {
    volume.Notes.push_back(file + ": " + note);
  }
  ReadTables(volume, tables);
  for (const std::string& note : DescribeLabels(volume.Labels, volume.Image, volume.LabelTable))
  {
    volume.Notes.push_back(note);
  }
  int withMaterial = 0;
  for (vtkIdType i = 0; i < volume.LabelTable->GetNumberOfLabels(); ++i)
  {
    withMaterial += volume.LabelTable->HasMaterial(volume.LabelTable->GetLabel(i)) ? 1 : 0;
  }
  volume.Notes.push_back("labels from " + file + ": " +
    std::to_string(volume.LabelTable->GetNumberOfLabels()) + " in the table, " +
    std::to_string(withMaterial) + " with a material of their own");
}
} // namespace Explore

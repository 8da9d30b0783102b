// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/LabelLoader.h"

#include "VTK/Reading/InputError.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Reading/VolumeChecks.h"

#include "vtkDataArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

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
      throw InputError("--materials " + table, capture.FirstError(), "name another file");
    }
  }
}

/// Rounds labels that a NIfTI header scales by very little, such as by 1.00002, if all of them are
/// within 0.001 of whole numbers. Returns the first value that is not; 0 if all are.
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
    notes.emplace_back("labels were rounded to whole numbers, from which they are 0.001 at most");
  }
  return 0.0;
}

/// Whether the box of a volume contains a label other than 0.
bool IsAnyInside(vtkImageData* labels, vtkImageData* volume)
{
  vtkDataArray* const values = labels->GetPointData()->GetScalars();
  double bounds[6];
  volume->GetBounds(bounds);
  for (vtkIdType i = 0; values && i < values->GetNumberOfTuples(); ++i)
  {
    double at[3];
    if (values->GetComponent(i, 0) != 0.0)
    {
      labels->GetPoint(i, at);
      if (at[0] >= bounds[0] && at[0] <= bounds[1] && at[1] >= bounds[2] && at[1] <= bounds[3] &&
        at[2] >= bounds[4] && at[2] <= bounds[5])
      {
        return true;
      }
    }
  }
  return false;
}

/// Collects the label numbers except 0. Throws InputError for other values, or for too many labels.
std::set<int> CollectLabels(const std::string& path, vtkImageData* image)
{
  constexpr std::size_t most = 4096;
  constexpr double highest = 1e6;
  vtkDataArray* const values = image->GetPointData()->GetScalars();
  std::set<int> labels;
  double last = 0.0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    if (value == last)
    {
      continue;
    }
    if (value != std::floor(value) || value < 0.0 || value > highest || labels.size() > most)
    {
      throw InputError("--as-labels " + path, "has values that are no numbers of labels",
        "leave --as-labels out; labels are up to 4096 whole numbers of 0 or more");
    }
    last = value;
    labels.insert(static_cast<int>(value));
  }
  labels.erase(0);
  return labels;
}

/// Adds a note if labels of the table are in no voxel.
void NoteUnused(const std::set<int>& used, Volume& volume)
{
  vtkHapticLabelTable* const table = volume.LabelTable;
  std::string first;
  vtkIdType unused = 0;
  for (vtkIdType i = 0; i < table->GetNumberOfLabels(); ++i)
  {
    const int label = table->GetLabel(i);
    if (label != 0 && used.count(label) == 0)
    {
      const std::string name = table->GetLabelName(label);
      first = unused == 0
        ? std::to_string(label) + (name.empty() ? std::string() : " (" + name + ")")
        : first;
      ++unused;
    }
  }
  if (unused > 0)
  {
    volume.Notes.push_back(std::to_string(unused) + " of " +
      std::to_string(table->GetNumberOfLabels()) +
      " labels of the table are in no voxel, such as " + first);
  }
}

/// Sets the colour of a label. The hues of successive labels differ by the golden section.
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
  const std::set<int> labels = CollectLabels(path, volume.Image);
  const bool hasNames = volume.LabelTable != nullptr;
  if (!hasNames)
  {
    volume.LabelTable = vtkSmartPointer<vtkHapticLabelTable>::New();
  }
  vtkHapticLabelTable* const table = volume.LabelTable;
  volume.MayBeLabels = volume.MayBeLabels && !hasNames; // names prove that the values are labels
  if (!hasNames && !vtksys::SystemTools::FileIsDirectory(path))
  {
    const MessageCapture capture; // a file may have no names: its labels are then named by numbers
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
  NoteUnused(labels, volume);
  volume.Labels = volume.Image;
  volume.AreLabels = true;
  volume.Notes.push_back("its values are taken as labels: " + std::to_string(labels.size()));
}

Volume ReadLabels(const std::string& path, int series)
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
    throw InputError(path, "is DICOM, but no segmentation (SEG)", "name it as the volume");
  }
  const int components = labels.Image->GetNumberOfScalarComponents();
  const int count = std::max(
    { ReadNiftiTimes(path, 1.0).Count, static_cast<int>(labels.Series.size()), components });
  if (series == 0 && count > 1 && !labels.LabelTable)
  {
    throw InputError(path, "has several volumes, and labels are one",
      "take Series = 1 to Series = " + std::to_string(count) +
        ", or write the volume that is meant into a file of its own");
  }
  UseComponent(path, labels, series);
  labels.Notes.clear(); // the notes of the volume reader do not apply to labels
  const double wrong = RoundLabels(labels.Image, labels.Notes);
  if (wrong != 0.0)
  {
    std::ostringstream fault;
    fault << "has values that are no numbers of labels, such as " << wrong;
    throw InputError(path, fault.str(),
      "write whole numbers; if a NIfTI header scales them, with the slope 1 and the intercept 0");
  }
  if (!labels.LabelTable)
  {
    labels.LabelTable = vtkSmartPointer<vtkHapticLabelTable>::New();
    const MessageCapture capture; // a file may have no names: its labels are then named by numbers
    labels.LabelTable->ReadFile(path.c_str());
  }
  return labels;
}

void LoadLabels(
  Volume& volume, const std::string& segmentation, const std::vector<std::string>& tables)
{
  volume.MayBeLabels = false; // its labels are in the segmentation
  const Volume labels = ReadLabels(segmentation);
  volume.Labels = labels.Image;
  volume.LabelTable = labels.LabelTable;
  volume.Notes.insert(volume.Notes.end(), labels.Notes.begin(), labels.Notes.end());
  if (!IsAnyInside(volume.Labels, volume.Image))
  {
    volume.Notes.push_back("no label of " + vtksys::SystemTools::GetFilenameName(segmentation) +
      " lies in the volume: its labels are of another scan, or in another place");
  }
  ReadTables(volume, tables);
  vtkDataArray* const values = volume.Labels->GetPointData()->GetScalars();
  std::set<int> used;
  double last = 0.0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const double value = values->GetComponent(i, 0);
    if (value != last && std::abs(value) <= VTK_INT_MAX)
    {
      last = value;
      used.insert(static_cast<int>(value));
    }
  }
  NoteUnused(used, volume);
  int withMaterial = 0;
  for (vtkIdType i = 0; i < volume.LabelTable->GetNumberOfLabels(); ++i)
  {
    withMaterial += volume.LabelTable->HasMaterial(volume.LabelTable->GetLabel(i)) ? 1 : 0;
  }
  volume.Notes.push_back("labels from " + vtksys::SystemTools::GetFilenameName(segmentation) +
    ": " + std::to_string(volume.LabelTable->GetNumberOfLabels()) + " in the table, " +
    std::to_string(withMaterial) + " with a material of their own");
}
} // namespace Explore

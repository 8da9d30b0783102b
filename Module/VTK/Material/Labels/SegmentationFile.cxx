// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Material/Labels/SegmentationFile.h"

#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Material/Labels/NrrdFile.h"

#include "vtkHapticLabelTable.h"
#include "vtkImageData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <limits>
#include <new>

namespace VolumeHaptics
{
namespace
{

bool ReadLabelImage(const NrrdFile& file, vtkImageData* image, std::string& error)
{
  const NrrdImage& read = file.Image;
  vtkNew<vtkIntArray> labels;
  labels->SetName("Labels");
  error = "there is not enough memory for its voxels. Crop it, or free some memory.";
  const std::size_t voxels = read.CountVoxels();
  if (voxels == 0 || voxels > std::size_t{ std::numeric_limits<int>::max() } * 1000)
  {
    return false;
  }
  try
  {
    AllocateTuples(labels, static_cast<vtkIdType>(voxels));
    labels->Fill(0.0);
    if (!ReadNrrdFile(file, labels->GetPointer(0), error))
    {
      return false;
    }
  }
  catch (const std::bad_alloc&)
  {
    return false;
  }
  image->SetDimensions(
    static_cast<int>(read.Size[0]), static_cast<int>(read.Size[1]), static_cast<int>(read.Size[2]));
  image->SetSpacing(read.Spacing.data());
  image->SetOrigin(read.Origin.data());
  image->SetDirectionMatrix(read.Directions.data());
  image->GetPointData()->SetScalars(labels);
  return true;
}

} // namespace

std::string ReadSegmentation(
  const std::string& fileName, vtkImageData* image, vtkHapticLabelTable* table)
{
  image->Initialize();
  NrrdFile file;
  std::string error;
  if (!OpenNrrdFile(fileName, file, error) || !ReadLabelImage(file, image, error))
  {
    return "No segmentation can be read from \"" + Printable(fileName) + "\": " + error;
  }
  for (const NrrdSegment& segment : file.Header.Segments)
  {
    if (segment.Entry.Name)
    {
      table->SetLabelName(segment.Label, *segment.Entry.Name);
    }
    if (segment.Entry.Color)
    {
      table->SetColor(segment.Label, segment.Entry.Color->data());
    }
  }
  return {};
}

} // namespace VolumeHaptics

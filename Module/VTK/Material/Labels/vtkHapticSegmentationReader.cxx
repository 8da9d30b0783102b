// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticSegmentationReader.h"

#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Material/Labels/NrrdFile.h"

#include "vtkDataObject.h"
#include "vtkHapticLabelTable.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <limits>

vtkStandardNewMacro(vtkHapticSegmentationReader);

//------------------------------------------------------------------------------
class vtkHapticSegmentationReader::vtkInternals
{
public:
  VolumeHaptics::NrrdFile File;
};

//------------------------------------------------------------------------------
vtkHapticSegmentationReader::vtkHapticSegmentationReader()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHapticSegmentationReader::~vtkHapticSegmentationReader() = default;

//------------------------------------------------------------------------------
vtkHapticLabelTable* vtkHapticSegmentationReader::GetLabelTable()
{
  return this->LabelTable;
}

//------------------------------------------------------------------------------
int vtkHapticSegmentationReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  VolumeHaptics::NrrdFile& file = this->Internals->File;
  std::string error = "there is no file name. Set FileName.";
  file = {};
  if (this->FileName.empty() || !VolumeHaptics::OpenNrrdFile(this->FileName, file, error))
  {
    file = {};
    vtkErrorMacro(<< "No segmentation can be read from \""
                  << VolumeHaptics::Printable(this->FileName) << "\": " << error);
    return 0;
  }
  const VolumeHaptics::NrrdImage& image = file.Image;
  const auto last = [&image](std::size_t axis) { return static_cast<int>(image.Size[axis]) - 1; };
  const int extent[6] = { 0, last(0), 0, last(1), 0, last(2) };
  vtkInformation* const out = outputVector->GetInformationObject(0);
  out->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
  out->Set(vtkDataObject::SPACING(), image.Spacing.data(), 3);
  out->Set(vtkDataObject::ORIGIN(), image.Origin.data(), 3);
  out->Set(vtkDataObject::DIRECTION(), image.Directions.data(), 9);
  vtkDataObject::SetPointDataActiveScalarInfo(out, VTK_INT, 1);
  for (const VolumeHaptics::NrrdSegment& segment : file.Header.Segments)
  {
    if (segment.Entry.Name)
    {
      this->LabelTable->SetLabelName(segment.Label, *segment.Entry.Name);
    }
    if (segment.Entry.Color)
    {
      this->LabelTable->SetColor(segment.Label, segment.Entry.Color->data());
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHapticSegmentationReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const VolumeHaptics::NrrdFile& file = this->Internals->File;
  const VolumeHaptics::NrrdImage& image = file.Image;
  vtkImageData* const output = vtkImageData::GetData(outputVector);
  vtkNew<vtkIntArray> labels;
  labels->SetName("Labels");
  std::string error = "there is not enough memory for its voxels. Crop it, or free some memory.";
  const std::size_t voxels = image.CountVoxels();
  bool isGood = voxels > 0 && voxels <= std::size_t{ std::numeric_limits<int>::max() } * 1000;
  try
  {
    VolumeHaptics::AllocateTuples(labels, isGood ? static_cast<vtkIdType>(voxels) : 0);
    labels->Fill(0.0);
    isGood = isGood && VolumeHaptics::ReadNrrdFile(file, labels->GetPointer(0), error);
  }
  catch (const std::bad_alloc&)
  {
    isGood = false;
  }
  if (!isGood)
  {
    vtkErrorMacro(<< "No segmentation can be read from \""
                  << VolumeHaptics::Printable(this->FileName) << "\": " << error);
    output->Initialize();
    return 0;
  }
  output->SetDimensions(static_cast<int>(image.Size[0]), static_cast<int>(image.Size[1]),
    static_cast<int>(image.Size[2]));
  output->SetSpacing(image.Spacing.data());
  output->SetOrigin(image.Origin.data());
  output->SetDirectionMatrix(image.Directions.data());
  output->GetPointData()->SetScalars(labels);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHapticSegmentationReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: "
     << (this->FileName.empty() ? "(none)" : VolumeHaptics::Printable(this->FileName)) << "\n";
  os << indent << "LabelTable:\n";
  this->LabelTable->PrintSelf(os, indent.GetNextIndent());
}

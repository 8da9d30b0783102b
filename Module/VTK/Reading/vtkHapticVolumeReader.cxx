// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticVolumeReader.h"

#include "Core/Platform/HapticFiles.h"
#include "Core/Platform/ReaderProcess.h"
#include "VTK/Reading/ForeignData.h"
#include "VTK/Reading/GridLoader.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/LabelLoader.h"
#include "VTK/Reading/MessageCapture.h"
#include "VTK/Reading/VolumeSeries.h"
#include "VTK/Regions/Formats/LargeFile.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <exception>
#include <vector>

vtkStandardNewMacro(vtkHapticVolumeReader);

//------------------------------------------------------------------------------
class vtkHapticVolumeReader::vtkInternals
{
public:
  Explore::Volume Volume;
  std::string Notes;
  std::string Error; // empty if the volume was read
  vtkTimeStamp ReadTime;

  void Read(vtkHapticVolumeReader* self)
  {
    this->Volume = {};
    this->Notes.clear();
    this->Error.clear();
    this->ReadTime.Modified();
    if (!self->FileName || !*self->FileName)
    {
      this->Error = "There is no file name. Cure: set FileName.";
      return;
    }
    try
    {
      const Explore::MessageCapture capture; // hides VTK's messages, because Error says everything
      this->Volume = self->AsLabels
        ? Explore::ReadLabels(self->FileName, self->Series)
        : Explore::LoadIntoMemory({ self->FileName }, self->Series, self->ArrayName);
    }
    catch (const std::bad_alloc&)
    {
      this->Error = std::string(self->FileName) +
        ": there is not enough memory for it. Cure: free some, or read it by regions.";
    }
    catch (const std::exception& error)
    {
      this->Error = error.what();
    }
    for (const std::string& note : this->Volume.Notes)
    {
      this->Notes += note + "\n";
    }
  }
};

//------------------------------------------------------------------------------
vtkHapticVolumeReader::vtkHapticVolumeReader()
  : Internals(std::make_unique<vtkInternals>())
{
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkHapticVolumeReader::~vtkHapticVolumeReader()
{
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
const char* vtkHapticVolumeReader::GetNotes()
{
  return this->Internals->Notes.c_str();
}

//------------------------------------------------------------------------------
const char* vtkHapticVolumeReader::GetFormat()
{
  return this->Internals->Volume.Format.c_str();
}

//------------------------------------------------------------------------------
const char* vtkHapticVolumeReader::GetModality()
{
  return this->Internals->Volume.Modality.c_str();
}

//------------------------------------------------------------------------------
int vtkHapticVolumeReader::GetNumberOfSeries()
{
  return static_cast<int>(this->Internals->Volume.Series.size());
}

//------------------------------------------------------------------------------
const char* vtkHapticVolumeReader::GetSeriesName(int index)
{
  return index >= 0 && index < this->GetNumberOfSeries()
    ? this->Internals->Volume.Series[static_cast<std::size_t>(index)].c_str()
    : nullptr;
}

//------------------------------------------------------------------------------
int vtkHapticVolumeReader::GetSeriesNumber()
{
  return this->Internals->Volume.SeriesNumber;
}

//------------------------------------------------------------------------------
bool vtkHapticVolumeReader::HasPlace()
{
  return this->Internals->Volume.HasPlace;
}

//------------------------------------------------------------------------------
vtkHapticLabelTable* vtkHapticVolumeReader::GetLabelTable()
{
  return this->Internals->Volume.LabelTable;
}

//------------------------------------------------------------------------------
std::string vtkHapticVolumeReader::DescribeLabels(
  vtkImageData* labels, vtkImageData* volume, vtkHapticLabelTable* table)
{
  std::string text;
  for (const std::string& note :
    labels&& volume ? Explore::DescribeLabels(labels, volume, table) : std::vector<std::string>())
  {
    text += note + "\n";
  }
  return text;
}

//------------------------------------------------------------------------------
int vtkHapticVolumeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInternals& internals = *this->Internals;
  if (internals.ReadTime < this->GetMTime())
  {
    internals.Read(this);
  }
  if (!internals.Error.empty())
  {
    vtkErrorMacro(<< VolumeHaptics::Printable(internals.Error));
    return 0;
  }
  vtkImageData* const image = internals.Volume.Image;
  vtkInformation* const out = outputVector->GetInformationObject(0);
  out->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), image->GetExtent(), 6);
  out->Set(vtkDataObject::SPACING(), image->GetSpacing(), 3);
  out->Set(vtkDataObject::ORIGIN(), image->GetOrigin(), 3);
  out->Set(vtkDataObject::DIRECTION(), image->GetDirectionMatrix()->GetData(), 9);
  vtkDataObject::SetPointDataActiveScalarInfo(
    out, image->GetScalarType(), image->GetNumberOfScalarComponents());
  vtkHapticTimeStepSource* const steps = internals.Volume.TimeSteps;
  out->Remove(vtkStreamingDemandDrivenPipeline::TIME_STEPS());
  out->Remove(vtkStreamingDemandDrivenPipeline::TIME_RANGE());
  if (steps)
  {
    std::vector<double> times;
    for (int i = 0; i < steps->GetNumberOfTimeSteps(); ++i)
    {
      times.push_back(steps->GetTimeStepValue(i));
    }
    const double range[2] = { times.front(), times.back() };
    out->Set(
      vtkStreamingDemandDrivenPipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    out->Set(vtkStreamingDemandDrivenPipeline::TIME_RANGE(), range, 2);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHapticVolumeReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  Explore::Volume& volume = this->Internals->Volume;
  vtkInformation* const out = outputVector->GetInformationObject(0);
  vtkImageData* const output = vtkImageData::GetData(outputVector);
  vtkImageData* image = volume.Image;
  if (!image) // ParaView requests data even after an error
  {
    output->Initialize();
    return 0;
  }
  if (volume.TimeSteps && out->Has(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()))
  {
    volume.TimeSteps->UpdateTimeStep(
      out->Get(vtkStreamingDemandDrivenPipeline::UPDATE_TIME_STEP()));
    image = volume.TimeSteps->GetOutput();
    output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(),
      image->GetInformation()->Get(vtkDataObject::DATA_TIME_STEP()));
  }
  output->ShallowCopy(image);
  vtkNew<vtkFieldData> fields; // a copy, so that the volume's own fields stay unchanged
  fields->ShallowCopy(image->GetFieldData());
  if (volume.LabelTable)
  {
    volume.LabelTable->WriteFieldData(fields);
  }
  if (!volume.Notes.empty())
  {
    vtkNew<vtkStringArray> notes;
    notes->SetName("Notes");
    for (const std::string& note : volume.Notes)
    {
      notes->InsertNextValue(note);
    }
    fields->AddArray(notes);
  }
  output->SetFieldData(fields);
  return 1;
}

//------------------------------------------------------------------------------
void vtkHapticVolumeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: "
     << (this->FileName ? VolumeHaptics::Printable(this->FileName) : std::string("(none)")) << "\n";
  os << indent << "Series: " << this->Series << "\n";
  os << indent << "ArrayName: "
     << (this->ArrayName.empty() ? "(none)" : VolumeHaptics::Printable(this->ArrayName)) << "\n";
  os << indent << "AsLabels: " << (this->AsLabels ? "On" : "Off") << "\n";
  os << indent << "Notes: " << this->Internals->Notes << "\n";
}

//------------------------------------------------------------------------------
std::string vtkHapticVolumeReader::ReadSurface(const char* file, vtkPolyData* surface)
{
  std::string error = "there is no file";
  const vtkSmartPointer<vtkPolyData> read =
    file && surface ? Explore::ReadPolyData(file, error) : nullptr;
  if (read)
  {
    surface->ShallowCopy(read);
    return {};
  }
  return VolumeHaptics::Printable(error);
}

//------------------------------------------------------------------------------
void vtkHapticServeReading(int link)
{
  VolumeHaptics::ServeReading(link,
    [](VolumeHaptics::ReadTask task, const std::string& path, const std::string& detail)
    {
      switch (task)
      {
        case VolumeHaptics::ReadTask::Grid:
        case VolumeHaptics::ReadTask::Case:
          return Explore::PackGrid(path);
        case VolumeHaptics::ReadTask::Surface:
          return Explore::PackSurface(path);
        case VolumeHaptics::ReadTask::Tiff:
          return VolumeHaptics::PackTiff(path, detail);
        case VolumeHaptics::ReadTask::TiffBox:
          return VolumeHaptics::PackTiffBox(detail);
        case VolumeHaptics::ReadTask::VtkHdf:
          break;
      }
      return VolumeHaptics::PackVtkHdf(path);
    });
}

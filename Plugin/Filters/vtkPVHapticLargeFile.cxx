// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVHapticLargeFile.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObject.h"
#include "vtkHapticRegionSource.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkObjectFactory.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <string>

//------------------------------------------------------------------------------
/** A region source that opens the file before a pipeline reads from it. */
class vtkPVHapticLargeFile::Regions : public vtkHapticRegionSource
{
public:
  static Regions* New();
  vtkTypeMacro(Regions, vtkHapticRegionSource);

  vtkMTimeType GetMTime() override
  {
    // Open the file here: opening changes this source, which is not allowed while the pipeline
    // requests information.
    this->IsOpen = this->Owner && this->Owner->Open();
    return this->Superclass::GetMTime();
  }

  vtkPVHapticLargeFile* Owner = nullptr; ///< null if the file has left the pipeline

protected:
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override
  {
    // Fail silently, because the owner has reported the reason.
    return this->IsOpen ? this->Superclass::RequestInformation(request, inputs, outputs) : 0;
  }

private:
  bool IsOpen = false;
};

vtkStandardNewMacro(vtkPVHapticLargeFile::Regions);
vtkStandardNewMacro(vtkPVHapticLargeFile);

//------------------------------------------------------------------------------
vtkPVHapticLargeFile::vtkPVHapticLargeFile()
  : Volume(vtkSmartPointer<Regions>::New())
{
  this->Volume->Owner = this;
  this->SetNumberOfInputPorts(0);
}

//------------------------------------------------------------------------------
vtkPVHapticLargeFile::~vtkPVHapticLargeFile()
{
  this->Volume->Owner = nullptr;
  this->SetFileName(nullptr);
}

//------------------------------------------------------------------------------
vtkPVHapticLargeFile* vtkPVHapticLargeFile::Find(vtkAlgorithmOutput* output)
{
  vtkAlgorithm* producer = output ? output->GetProducer() : nullptr;
  while (producer && producer->IsA("vtkPVPostFilter") && producer->GetNumberOfInputConnections(0))
  {
    producer = producer->GetInputAlgorithm(0, 0);
  }
  return vtkPVHapticLargeFile::SafeDownCast(producer);
}

//------------------------------------------------------------------------------
vtkHapticRegionSource* vtkPVHapticLargeFile::GetRegions()
{
  return this->Volume;
}

//------------------------------------------------------------------------------
const char* vtkPVHapticLargeFile::GetNotes()
{
  this->Notes = this->IsOpen ? this->Volume->GetFileNotes() : std::string();
  return this->Notes.c_str();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkHapticRegionSource> vtkPVHapticLargeFile::MakeRegions()
{
  if (!this->Open())
  {
    return nullptr;
  }
  auto regions = vtkSmartPointer<vtkHapticRegionSource>::New();
  std::string error;
  if (!regions->OpenFile(this->FileName, error, this->Series))
  {
    vtkErrorMacro(<< error);
    return nullptr;
  }
  regions->SetCoarseImage(this->Volume->GetCoarseImage());
  return regions;
}

//------------------------------------------------------------------------------
bool vtkPVHapticLargeFile::Open()
{
  if (this->GetMTime() > this->Opened)
  {
    this->Opened.Modified(); // set this first, because the calls below re-enter this function
    this->IsOpen = false;
    if (!this->FileName || !*this->FileName)
    {
      vtkErrorMacro(<< "No file is chosen. Set FileName to a file or folder that holds a volume.");
      return false;
    }
    std::string error;
    if (!this->Volume->OpenFile(this->FileName, error, this->Series))
    {
      vtkErrorMacro(<< error);
      return false;
    }
    this->IsOpen = this->Volume->GetCoarseImage() || this->Volume->MakeCoarseImage();
    this->Opened.Modified();
  }
  return this->IsOpen;
}

//------------------------------------------------------------------------------
int vtkPVHapticLargeFile::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (!this->Open())
  {
    return 0;
  }
  vtkImageData* const coarse = this->Volume->GetCoarseImage();
  vtkInformation* const info = outputs->GetInformationObject(0);
  info->Set(Pipeline::WHOLE_EXTENT(), coarse->GetExtent(), 6);
  info->Set(vtkDataObject::SPACING(), coarse->GetSpacing(), 3);
  info->Set(vtkDataObject::ORIGIN(), coarse->GetOrigin(), 3);
  info->Set(vtkDataObject::DIRECTION(), coarse->GetDirectionMatrix()->GetData(), 9);
  info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
  vtkDataObject::SetPointDataActiveScalarInfo(
    info, coarse->GetScalarType(), coarse->GetNumberOfScalarComponents());
  return 1;
}

//------------------------------------------------------------------------------
int vtkPVHapticLargeFile::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkInformation* const info = outputs->GetInformationObject(0);
  vtkImageData* const output = vtkImageData::GetData(info);
  output->ShallowCopy(this->Volume->GetCoarseImage());
  // Output only this process's piece.
  output->Crop(info->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()));
  return 1;
}

//------------------------------------------------------------------------------
void vtkPVHapticLargeFile::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Series: " << this->Series << "\n";
  os << indent << "Notes: " << this->Notes << "\n";
  os << indent << "IsOpen: " << this->IsOpen << "\n";
  os << indent << "Regions:\n";
  this->Volume->PrintSelf(os, indent.GetNextIndent());
}

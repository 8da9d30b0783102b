// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVHapticRegionFilter.h"

#include "HapticPieceGather.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <new>

vtkStandardNewMacro(vtkPVHapticRegionFilter);

//------------------------------------------------------------------------------
vtkPVHapticRegionFilter::vtkPVHapticRegionFilter()
  : Producer(vtkSmartPointer<vtkTrivialProducer>::New())
{
  this->SetInputConnection(this->Producer->GetOutputPort());
}

//------------------------------------------------------------------------------
vtkPVHapticRegionFilter::~vtkPVHapticRegionFilter() = default;

//------------------------------------------------------------------------------
void vtkPVHapticRegionFilter::SetController(vtkMultiProcessController* controller)
{
  this->Controller = controller;
}

//------------------------------------------------------------------------------
bool vtkPVHapticRegionFilter::IsAlone() const
{
  return !this->Controller || this->Controller->GetNumberOfProcesses() == 1;
}

//------------------------------------------------------------------------------
void vtkPVHapticRegionFilter::SetPiece(vtkImageData* piece, const int whole[6])
{
  if (piece != this->Seen || (piece ? piece->GetMTime() : 0) != this->SeenTime)
  {
    this->Seen = piece;
    this->SeenTime = piece ? piece->GetMTime() : 0;
    vtkNew<vtkImageData> copy;
    if (piece)
    {
      copy->ShallowCopy(piece);
    }
    this->Producer->SetOutput(copy);
  }
  this->Producer->SetWholeExtent(whole[0], whole[1], whole[2], whole[3], whole[4], whole[5]);
}

//------------------------------------------------------------------------------
bool vtkPVHapticRegionFilter::CanExecute(bool hasPiece, std::string& error)
{
  auto* const piece = vtkImageData::SafeDownCast(this->Producer->GetOutputDataObject(0));
  int association = vtkDataObject::FIELD_ASSOCIATION_POINTS;
  vtkDataArray* const array = piece ? this->GetInputArrayToProcess(0, piece, association) : nullptr;
  const bool isEmpty = !piece || piece->GetNumberOfPoints() == 0;
  // Bits have no size of their own, and can't be sent.
  const bool hasArray = array && association == vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    array->GetDataTypeSize() > 0 && array->GetNumberOfTuples() == piece->GetNumberOfPoints();
  const bool isPart = hasArray && !isEmpty;
  const std::string name = isPart && array->GetName() ? array->GetName() : "";
  // The largest over all processes: whether something is wrong here, the kind of the array, and the
  // number of a process with a part of it.
  const int here[6] = { hasPiece ? 0 : 1, isEmpty || hasArray ? 0 : 1, isEmpty ? 0 : 1,
    isPart ? array->GetDataType() : -1, isPart ? array->GetNumberOfComponents() : 0,
    isPart && !this->IsAlone() ? this->Controller->GetLocalProcessId() : -1 };
  int all[6];
  std::copy_n(here, 6, all);
  int isOdd = 0;
  this->ArrayName = name;
  if (!this->IsAlone())
  {
    this->Controller->AllReduce(here, all, 6, vtkCommunicator::MAX_OP);
    if (all[5] >= 0)
    {
      this->ShareName(all[5]);
    }
    const int odd =
      here[2] && (here[3] != all[3] || here[4] != all[4] || name != this->ArrayName) ? 1 : 0;
    this->Controller->AllReduce(&odd, &isOdd, 1, vtkCommunicator::MAX_OP);
  }
  this->Problem.clear();
  this->ArrayType = all[3];
  this->Components = all[4];
  if (all[0])
  {
    error = "The server could not bring the volume up to date. Its messages say why.";
  }
  else if (all[1] || isOdd)
  {
    error = "The volume on the server has no point scalars to touch, or bits, or not the same ones "
            "on every process. Give its point data active scalars of numbers, or choose a point "
            "array in the filter that Touch names.";
  }
  else if (!all[2])
  {
    error = "The volume on the server is empty. Update its source, or give it dimensions of at "
            "least 3 x 3 x 3, for the least KernelRadius.";
  }
  return error.empty();
}

//------------------------------------------------------------------------------
void vtkPVHapticRegionFilter::ShareName(int from)
{
  auto size = static_cast<vtkIdType>(this->ArrayName.size());
  this->Controller->Broadcast(&size, 1, from);
  this->ArrayName.resize(static_cast<std::size_t>(size));
  if (size > 0)
  {
    this->Controller->Broadcast(this->ArrayName.data(), size, from);
  }
}

//------------------------------------------------------------------------------
int vtkPVHapticRegionFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // Request only the piece of this process: nothing has to be read again.
  vtkInformation* const info = inputs[0]->GetInformationObject(0);
  if (auto* const piece = vtkImageData::GetData(info))
  {
    info->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), piece->GetExtent(), 6);
  }
  return 1;
}

//------------------------------------------------------------------------------
bool vtkPVHapticRegionFilter::IsCurrent(vtkMTimeType time)
{
  int isCurrent = this->Superclass::IsCurrent(time) ? 1 : 0;
  if (!this->IsAlone())
  {
    const int here = isCurrent;
    this->Controller->AllReduce(&here, &isCurrent, 1, vtkCommunicator::MIN_OP);
  }
  return isCurrent != 0;
}

//------------------------------------------------------------------------------
void vtkPVHapticRegionFilter::GatherSamples(SamplesOfComponents& samples)
{
  if (this->IsAlone())
  {
    return;
  }
  int whole[6];
  this->Producer->GetOutputInformation(0)->Get(
    vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole);
  VolumeHapticsLive::HapticPieceGather(
    this->Controller, this->ArrayType, this->Components, this->ArrayName)
    .GatherSamples(whole, samples);
}

//------------------------------------------------------------------------------
bool vtkPVHapticRegionFilter::GatherRegion(vtkImageData* piece, vtkDataArray* array,
  const int region[6], vtkImageData* output, std::string& error)
{
  bool isThere = false;
  try
  {
    isThere = this->IsAlone()
      ? this->Superclass::GatherRegion(piece, array, region, output, error)
      : VolumeHapticsLive::HapticPieceGather(
          this->Controller, this->ArrayType, this->Components, this->ArrayName)
          .GatherRegion(piece, array, region, &vtkPVHapticRegionFilter::CopySamples, output, error);
  }
  catch (const std::bad_alloc&)
  {
    output->Initialize();
    error = "The server has no memory for the region around the tip. Lower MaximumRegionVoxels.";
  }
  this->Problem = error;
  return isThere;
}

//------------------------------------------------------------------------------
std::string vtkPVHapticRegionFilter::GetProblem() const
{
  return this->Problem;
}

//------------------------------------------------------------------------------
void vtkPVHapticRegionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.GetPointer() << "\n";
}

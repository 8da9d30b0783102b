// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVHapticRegionFilter.h"

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
#include <cstring>

vtkStandardNewMacro(vtkPVHapticRegionFilter);

namespace
{

constexpr int Tag = 78232;

/** The part of a box that is in another one; false where there is none. */
bool Intersect(const int a[6], const int b[6], int both[6])
{
  bool isThere = true;
  for (int i = 0; i < 6; i += 2)
  {
    both[i] = std::max(a[i], b[i]);
    both[i + 1] = std::min(a[i + 1], b[i + 1]);
    isThere = isThere && both[i] <= both[i + 1];
  }
  return isThere;
}

vtkIdType CountOf(const int extent[6])
{
  return (vtkIdType{ extent[1] } - extent[0] + 1) * (vtkIdType{ extent[3] } - extent[2] + 1) *
    (vtkIdType{ extent[5] } - extent[4] + 1);
}

template <typename T>
void SendNumbers(vtkMultiProcessController* controller, const std::vector<T>& numbers, int to)
{
  const auto size = static_cast<vtkIdType>(numbers.size());
  controller->Send(&size, 1, to, Tag);
  if (size > 0)
  {
    controller->Send(reinterpret_cast<const char*>(numbers.data()),
      size * static_cast<vtkIdType>(sizeof(T)), to, Tag);
  }
}

template <typename T>
std::vector<T> ReceiveNumbers(vtkMultiProcessController* controller, int from)
{
  vtkIdType size = 0;
  controller->Receive(&size, 1, from, Tag);
  std::vector<T> numbers(static_cast<std::size_t>(size));
  if (size > 0)
  {
    controller->Receive(
      reinterpret_cast<char*>(numbers.data()), size * static_cast<vtkIdType>(sizeof(T)), from, Tag);
  }
  return numbers;
}

vtkSmartPointer<vtkDataArray> NewArray(int type, int components, vtkIdType tuples)
{
  vtkSmartPointer<vtkDataArray> array;
  array.TakeReference(vtkDataArray::CreateDataArray(type));
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  return array;
}

} // namespace

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
  const bool hasArray = array && association == vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    array->GetNumberOfTuples() == piece->GetNumberOfPoints();
  // What is wrong here, and what the array is like: the largest of all processes.
  const int here[5] = { hasPiece ? 0 : 1, isEmpty || hasArray ? 0 : 1, isEmpty ? 0 : 1,
    hasArray && !isEmpty ? array->GetDataType() : -1,
    hasArray && !isEmpty ? array->GetNumberOfComponents() : 0 };
  int all[5];
  std::copy_n(here, 5, all);
  int isOdd = 0;
  if (!this->IsAlone())
  {
    this->Controller->AllReduce(here, all, 5, vtkCommunicator::MAX_OP);
    const int odd = here[2] && (here[3] != all[3] || here[4] != all[4]) ? 1 : 0;
    this->Controller->AllReduce(&odd, &isOdd, 1, vtkCommunicator::MAX_OP);
  }
  this->ArrayType = all[3];
  this->Components = all[4];
  this->ArrayName = hasArray && array->GetName() ? array->GetName() : "";
  if (all[0])
  {
    error = "The server could not bring the volume up to date. Its messages say why.";
  }
  else if (all[1] || isOdd)
  {
    error = "The volume on the server has no point scalars to touch, or not the same ones on every "
            "process. Give its "
            "point data active scalars, or choose a point array in the filter that Touch names.";
  }
  else if (!all[2])
  {
    error = "The volume on the server is empty. Update its source, or give it dimensions of at "
            "least 2 x 2 x 2.";
  }
  return error.empty();
}

//------------------------------------------------------------------------------
int vtkPVHapticRegionFilter::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector*)
{
  // What is here, and nothing that would have to be read.
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
  samples.resize(static_cast<std::size_t>(this->Components));
  for (VolumeHaptics::WholeSamples& component : samples)
  {
    int extent[6];
    this->Producer->GetOutputInformation(0)->Get(
      vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent);
    for (int a = 0; a < 3; ++a)
    {
      component.Dimensions[a] = std::int64_t{ extent[2 * a + 1] } - extent[2 * a] + 1;
    }
    if (this->Controller->GetLocalProcessId() > 0)
    {
      SendNumbers(this->Controller, component.Places, 0);
      SendNumbers(this->Controller, component.Values, 0);
      SendNumbers(this->Controller, std::vector<double>(component.Range, component.Range + 2), 0);
      continue;
    }
    for (int from = 1; from < this->Controller->GetNumberOfProcesses(); ++from)
    {
      VolumeHaptics::WholeSamples other;
      other.Places = ReceiveNumbers<std::int64_t>(this->Controller, from);
      other.Values = ReceiveNumbers<double>(this->Controller, from);
      const std::vector<double> range = ReceiveNumbers<double>(this->Controller, from);
      std::copy(range.begin(), range.end(), other.Range);
      component.Merge(other);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkPVHapticRegionFilter::GatherRegion(vtkImageData* piece, vtkDataArray* array,
  const int region[6], vtkImageData* output, std::string& error)
{
  if (this->IsAlone())
  {
    return this->Superclass::GatherRegion(piece, array, region, output, error);
  }
  int both[6] = { 0, -1, 0, -1, 0, -1 };
  const bool hasPart = array && Intersect(piece->GetExtent(), region, both);
  if (this->Controller->GetLocalProcessId() > 0)
  {
    SendNumbers(this->Controller, std::vector<int>(both, both + (hasPart ? 6 : 0)), 0);
    if (hasPart)
    {
      const auto part = NewArray(this->ArrayType, this->Components, CountOf(both));
      CopySamples(array, piece->GetExtent(), part, both);
      this->Controller->Send(static_cast<const char*>(part->GetVoidPointer(0)),
        part->GetDataSize() * part->GetDataTypeSize(), 0, Tag);
    }
    output->Initialize();
    return true;
  }
  const auto whole = NewArray(this->ArrayType, this->Components, CountOf(region));
  std::vector<bool> isThere(static_cast<std::size_t>(CountOf(region)));
  const auto note = [&](const int extent[6])
  {
    for (int k = extent[4]; k <= extent[5]; ++k)
    {
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        const int row[6] = { region[0], region[1], region[2], region[3], region[4], k - 1 };
        const vtkIdType first = CountOf(row) +
          (vtkIdType{ region[1] } - region[0] + 1) * (j - region[2]) + (extent[0] - region[0]);
        std::fill_n(isThere.begin() + first, extent[1] - extent[0] + 1, true);
      }
    }
  };
  if (hasPart)
  {
    CopySamples(array, piece->GetExtent(), whole, region);
    note(both);
  }
  for (int from = 1; from < this->Controller->GetNumberOfProcesses(); ++from)
  {
    const std::vector<int> extent = ReceiveNumbers<int>(this->Controller, from);
    if (!extent.empty())
    {
      const auto part = NewArray(this->ArrayType, this->Components, CountOf(extent.data()));
      this->Controller->Receive(static_cast<char*>(part->GetVoidPointer(0)),
        part->GetDataSize() * part->GetDataTypeSize(), from, Tag);
      CopySamples(part, extent.data(), whole, region);
      note(extent.data());
    }
  }
  if (std::find(isThere.begin(), isThere.end(), false) != isThere.end())
  {
    error = "The server's processes do not hold all of the volume between them: its source gave "
            "only a part of what "
            "was asked for.";
    return false;
  }
  whole->SetName(array ? array->GetName() : this->ArrayName.c_str());
  output->GetPointData()->SetScalars(whole);
  return true;
}

//------------------------------------------------------------------------------
void vtkPVHapticRegionFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller.GetPointer() << "\n";
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPVHapticRegionFilter.h"

#include "Core/Field/NoiseSamples.h"
#include "VTK/Base/ArrayMemory.h"

#include "vtkDataArray.h"
#include "vtkHapticRegionFilter.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTrivialProducer.h"

#include <algorithm>
#include <exception>
#include <new>
#include <string>
#include <utility>
#include <vector>

namespace VolumeHapticsLive
{
namespace
{

/**
 * Gathers samples from the pieces of a volume on several processes.
 *
 * All processes of the controller must call its functions collectively, with the same array type,
 * number of components and name.
 */
class HapticPieceGather
{
public:
  /** See vtkHapticRegionFilter::CopySamples. */
  using SampleCopier = void (*)(
    vtkDataArray* from, const int fromExtent[6], vtkDataArray* to, const int toExtent[6]);

  HapticPieceGather(
    vtkMultiProcessController* controller, int arrayType, int components, std::string arrayName);

  /** See vtkHapticRegionFilter::GatherSamples. `samples` has one entry per component. */
  void GatherSamples(const int whole[6], std::vector<VolumeHaptics::NoiseSamples>& samples) const;

  /** See vtkHapticRegionFilter::GatherRegion. Only the first process gets an output. */
  bool GatherRegion(vtkImageData* piece, vtkDataArray* array, const int region[6],
    SampleCopier copySamples, vtkImageData* output, std::string& error) const;

private:
  void ShareParts(const std::vector<int>& part, std::vector<std::vector<int>>& others) const;

  vtkMultiProcessController* const Controller;
  const int ArrayType;
  const int Components;
  const std::string ArrayName;
};

constexpr int PieceTag = 78232;

/** Computes the intersection of two boxes. Returns false if it is empty. */
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
  controller->Send(&size, 1, to, PieceTag);
  if (size > 0)
  {
    controller->Send(reinterpret_cast<const char*>(numbers.data()),
      size * static_cast<vtkIdType>(sizeof(T)), to, PieceTag);
  }
}

template <typename T>
std::vector<T> ReceiveNumbers(vtkMultiProcessController* controller, int from)
{
  vtkIdType size = 0;
  controller->Receive(&size, 1, from, PieceTag);
  std::vector<T> numbers(static_cast<std::size_t>(size));
  if (size > 0)
  {
    controller->Receive(reinterpret_cast<char*>(numbers.data()),
      size * static_cast<vtkIdType>(sizeof(T)), from, PieceTag);
  }
  return numbers;
}

/** Records that a part of a region has arrived. */
void Note(const int part[6], const int region[6], std::vector<bool>& isThere)
{
  for (int k = part[4]; k <= part[5]; ++k)
  {
    for (int j = part[2]; j <= part[3]; ++j)
    {
      const int row[6] = { region[0], region[1], region[2], region[3], region[4], k - 1 };
      const vtkIdType first = CountOf(row) +
        (vtkIdType{ region[1] } - region[0] + 1) * (j - region[2]) + (part[0] - region[0]);
      std::fill_n(isThere.begin() + first, part[1] - part[0] + 1, true);
    }
  }
}

HapticPieceGather::HapticPieceGather(
  vtkMultiProcessController* controller, int arrayType, int components, std::string arrayName)
  : Controller(controller)
  , ArrayType(arrayType)
  , Components(components)
  , ArrayName(std::move(arrayName))
{
}

void HapticPieceGather::GatherSamples(
  const int whole[6], std::vector<VolumeHaptics::NoiseSamples>& samples) const
{
  samples.resize(static_cast<std::size_t>(this->Components));
  for (VolumeHaptics::NoiseSamples& component : samples)
  {
    for (int a = 0; a < 3; ++a)
    {
      component.Dimensions[a] = std::int64_t{ whole[2 * a + 1] } - whole[2 * a] + 1;
    }
    if (this->Controller->GetLocalProcessId() > 0)
    {
      SendNumbers(this->Controller, component.Indices, 0);
      SendNumbers(this->Controller, component.Values, 0);
      SendNumbers(this->Controller,
        std::vector<double>{
          component.Range[0], component.Range[1], component.Inside[0], component.Inside[1] },
        0);
      continue;
    }
    for (int from = 1; from < this->Controller->GetNumberOfProcesses(); ++from)
    {
      VolumeHaptics::NoiseSamples other;
      other.Indices = ReceiveNumbers<std::int64_t>(this->Controller, from);
      other.Values = ReceiveNumbers<double>(this->Controller, from);
      const std::vector<double> ranges = ReceiveNumbers<double>(this->Controller, from);
      std::copy(ranges.begin(), ranges.begin() + 2, other.Range);
      std::copy(ranges.begin() + 2, ranges.end(), other.Inside);
      component.Merge(other);
    }
  }
}

void HapticPieceGather::ShareParts(
  const std::vector<int>& part, std::vector<std::vector<int>>& others) const
{
  if (this->Controller->GetLocalProcessId() > 0)
  {
    SendNumbers(this->Controller, part, 0);
    return;
  }
  for (int from = 1; from < this->Controller->GetNumberOfProcesses(); ++from)
  {
    others.push_back(ReceiveNumbers<int>(this->Controller, from));
  }
}

bool HapticPieceGather::GatherRegion(vtkImageData* piece, vtkDataArray* array, const int region[6],
  SampleCopier copySamples, vtkImageData* output, std::string& error) const
{
  int both[6] = { 0, -1, 0, -1, 0, -1 };
  const bool hasPart = array && Intersect(piece->GetExtent(), region, both);
  const bool isFirst = this->Controller->GetLocalProcessId() == 0;
  // Allocate before sending, so that a process without memory reports it before others wait for its
  // part.
  std::vector<std::vector<int>> parts;
  vtkSmartPointer<vtkDataArray> whole;
  vtkSmartPointer<vtkDataArray> part;
  std::vector<bool> isThere;
  int isShort = 0;
  this->ShareParts(std::vector<int>(both, both + (hasPart ? 6 : 0)), parts);
  try
  {
    vtkIdType largest = hasPart && !isFirst ? CountOf(both) : 0;
    for (const std::vector<int>& extent : parts)
    {
      largest = std::max(largest, extent.empty() ? 0 : CountOf(extent.data()));
    }
    part = VolumeHaptics::NewArray(this->ArrayType, this->Components, largest);
    if (isFirst)
    {
      whole = VolumeHaptics::NewArray(this->ArrayType, this->Components, CountOf(region));
      isThere.resize(static_cast<std::size_t>(CountOf(region)));
    }
  }
  catch (const std::exception&)
  {
    isShort = 1;
  }
  int isAnyShort = 0;
  this->Controller->AllReduce(&isShort, &isAnyShort, 1, vtkCommunicator::MAX_OP);
  if (isAnyShort)
  {
    throw std::bad_alloc();
  }
  if (!isFirst)
  {
    if (hasPart)
    {
      copySamples(array, piece->GetExtent(), part, both);
      this->Controller->Send(static_cast<const char*>(part->GetVoidPointer(0)),
        part->GetDataSize() * part->GetDataTypeSize(), 0, PieceTag);
    }
    output->Initialize();
    return true;
  }
  if (hasPart)
  {
    copySamples(array, piece->GetExtent(), whole, region);
    Note(both, region, isThere);
  }
  for (int from = 1; from < this->Controller->GetNumberOfProcesses(); ++from)
  {
    const std::vector<int>& extent = parts[static_cast<std::size_t>(from - 1)];
    if (!extent.empty())
    {
      this->Controller->Receive(static_cast<char*>(part->GetVoidPointer(0)),
        CountOf(extent.data()) * this->Components * part->GetDataTypeSize(), from, PieceTag);
      copySamples(part, extent.data(), whole, region);
      Note(extent.data(), region, isThere);
    }
  }
  if (std::find(isThere.begin(), isThere.end(), false) != isThere.end())
  {
    error = "The server's processes do not hold all of the volume between them: its source gave "
            "only a part of what was asked for.";
    return false;
  }
  whole->SetName(this->ArrayName.c_str());
  output->GetPointData()->SetScalars(whole);
  return true;
}

} // namespace
} // namespace VolumeHapticsLive

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
  // Arrays of bits can't be sent, because a bit has no size in bytes.
  const bool hasArray = array && association == vtkDataObject::FIELD_ASSOCIATION_POINTS &&
    array->GetDataTypeSize() > 0 && array->GetNumberOfTuples() == piece->GetNumberOfPoints();
  const bool isPart = hasArray && !isEmpty;
  const std::string name = isPart && array->GetName() ? array->GetName() : "";
  // Compute maxima over all processes: whether there is a fault, the array's kind, and the number
  // of a process that has a part of it.
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
  // Request only this process's existing piece, so that nothing is read again.
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

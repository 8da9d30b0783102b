// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticPieceGather.h"

#include "Core/Field/NoiseSamples.h"
#include "VTK/Base/ArrayMemory.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <exception>
#include <new>
#include <utility>

namespace VolumeHapticsLive
{
namespace
{

constexpr int PieceTag = 78232;

/** The intersection of two boxes; false if it is empty. */
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

} // namespace

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
  // A process without memory must report this before others wait for its part.
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

} // namespace VolumeHapticsLive

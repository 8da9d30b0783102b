// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Playback/TimeStepMesher.h"

#include "VTK/Baking/HapticSurface.h"
#include "VTK/Base/ArrayMemory.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace VolumeHaptics
{
namespace
{

/** Copies one component of each tuple. `Number` is any type of the same size as the values. */
template <typename Number>
void CopyStrided(vtkDataArray* from, int component, vtkDataArray* to)
{
  const vtkIdType stride = from->GetNumberOfComponents();
  const Number* const source = static_cast<const Number*>(from->GetVoidPointer(0)) + component;
  Number* const target = static_cast<Number*>(to->GetVoidPointer(0));
  vtkSMPTools::For(0, to->GetNumberOfTuples(),
    [=](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        target[i] = source[i * stride];
      }
    });
}

vtkSmartPointer<vtkDataArray> ExtractComponent(vtkDataArray* from, int component)
{
  auto to = NewArray(from->GetDataType(), 1, from->GetNumberOfTuples());
  to->SetName(from->GetName());
  if (!from->HasStandardMemoryLayout())
  {
    to->CopyComponent(0, from, component);
    return to;
  }
  switch (from->GetDataTypeSize())
  {
    case 1:
      CopyStrided<std::uint8_t>(from, component, to);
      break;
    case 2:
      CopyStrided<std::uint16_t>(from, component, to);
      break;
    case 4:
      CopyStrided<std::uint32_t>(from, component, to);
      break;
    default:
      CopyStrided<std::uint64_t>(from, component, to);
  }
  return to;
}

} // namespace

void TimeStepImage::Clear()
{
  this->Image = nullptr;
  this->Array = nullptr;
}

vtkImageData* TimeStepImage::Show(
  const ImageTimeStep& timeStep, bool isComponent, vtkImageData* shape)
{
  const bool isSame = this->Image && this->Array == timeStep.Array &&
    this->Changed == timeStep.Array->GetMTime() && this->Component == timeStep.Component;
  if (!isSame)
  {
    this->Array = timeStep.Array;
    this->Changed = timeStep.Array->GetMTime();
    this->Component = timeStep.Component;
    this->Image = vtkSmartPointer<vtkImageData>::New();
    this->Image->CopyStructure(shape);
    this->Image->GetPointData()->SetScalars(
      isComponent ? ExtractComponent(timeStep.Array, timeStep.Component) : timeStep.Array);
  }
  return this->Image;
}

bool TimeStepMesher::Poll(std::vector<VolumeTimeStep>& timeSteps,
  const std::vector<int>& components, double value, const Affine3& indexToWorld)
{
  for (std::size_t i = 0; i < timeSteps.size() && (i + 1 < timeSteps.size() || i == 0); ++i)
  {
    if (timeSteps[i].Mesh)
    {
      continue;
    }
    const std::size_t after = std::min(i + 1, timeSteps.size() - 1);
    const auto make = [timeStep = timeSteps[i], next = timeSteps[after], component = components[i],
                        value, indexToWorld]
    { return MeshTimeStep(timeStep, next, component, value, indexToWorld); };
    // Copy the values of an array with another memory layout now: later, VTK would convert them
    // into one copy that all threads share. Samples owns its vtkDataArray: see ShareArray() of the
    // model's builder.
    auto* const scalars = static_cast<vtkDataArray*>(const_cast<void*>(timeSteps[i].Samples.get()));
    if (!scalars->HasStandardMemoryLayout())
    {
      timeSteps[i].Mesh = make();
      continue;
    }
    const Key key{ timeSteps[i].Samples.get(), timeSteps[after].Samples.get(), components[i] };
    if (!this->Meshing.IsOf(key) && this->Meshing.IsUnderWay())
    {
      this->Meshing.Abandon(); // cancels without waiting
      return false;
    }
    const auto* const made =
      this->Meshing.Poll(key, [make](WorkMonitor&) { return std::optional(make()); });
    if (!made)
    {
      return false;
    }
    timeSteps[i].Mesh = *made;
    this->Meshing.Forget(); // later time steps may get the same address, which is part of the key
  }
  return true;
}

} // namespace VolumeHaptics

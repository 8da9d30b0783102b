// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Playback/FrameMesher.h"

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

/** Extracts a component of tuples; `Number` is a type of the numbers' size. */
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

void FrameImage::Clear()
{
  this->Image = nullptr;
  this->Array = nullptr;
}

vtkImageData* FrameImage::Show(const HapticFrame& frame, bool isComponent, vtkImageData* shape)
{
  const bool isSame = this->Image && this->Array == frame.Array &&
    this->Changed == frame.Array->GetMTime() && this->Component == frame.Component;
  if (!isSame)
  {
    this->Array = frame.Array;
    this->Changed = frame.Array->GetMTime();
    this->Component = frame.Component;
    this->Image = vtkSmartPointer<vtkImageData>::New();
    this->Image->CopyStructure(shape);
    this->Image->GetPointData()->SetScalars(
      isComponent ? ExtractComponent(frame.Array, frame.Component) : frame.Array);
  }
  return this->Image;
}

bool FrameMesher::Follow(std::vector<VolumeFrame>& frames, const std::vector<int>& components,
  double value, const Affine3& indexToWorld)
{
  for (std::size_t i = 0; i < frames.size() && (i + 1 < frames.size() || i == 0); ++i)
  {
    if (frames[i].Mesh)
    {
      continue;
    }
    const std::size_t after = std::min(i + 1, frames.size() - 1);
    const auto make =
      [frame = frames[i], next = frames[after], component = components[i], value, indexToWorld]
    { return MeshFrame(frame, next, component, value, indexToWorld); };
    // Arrays of other layouts copy their values for readers, into one copy for all threads. See
    // ShareArray() of the model's builder.
    auto* const scalars = static_cast<vtkDataArray*>(const_cast<void*>(frames[i].Samples.get()));
    if (!scalars->HasStandardMemoryLayout())
    {
      frames[i].Mesh = make();
      continue;
    }
    const Key key{ frames[i].Samples.get(), frames[after].Samples.get(), components[i] };
    if (!this->Meshing.IsOf(key) && this->Meshing.IsUnderWay())
    {
      this->Meshing.Abandon(); // ends without waiting
      return false;
    }
    const auto* const made =
      this->Meshing.Follow(key, [make](WorkMonitor&) { return std::optional(make()); });
    if (!made)
    {
      return false;
    }
    frames[i].Mesh = *made;
    this->Meshing.Forget(); // other frames may get the same address
  }
  return true;
}

} // namespace VolumeHaptics

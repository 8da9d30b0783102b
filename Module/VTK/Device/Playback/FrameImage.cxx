// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/Playback/FrameImage.h"

#include "VTK/Base/ArrayMemory.h"

#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <cstdint>

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

} // namespace VolumeHaptics

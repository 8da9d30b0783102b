// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticViewProps.h"

#include "vtkHapticDevice.h"
#include "vtkImageData.h"
#include "vtkVolumeHapticsFilter.h"

namespace VolumeHaptics
{
namespace
{
/// The proxy's radius and the arrow of one newton, in parts of the volume's diagonal.
constexpr double RadiusPart = 0.006;
constexpr double NewtonPart = 0.04;
} // namespace

HapticViewProps::HapticViewProps(
  vtkRenderer* renderer, vtkHapticDevice* device, vtkVolumeHapticsFilter* filter)
  : Renderer(renderer)
{
  this->Representation->SetDevice(device);
  this->Display->SetDevice(device);
  renderer->AddViewProp(this->Representation);
  renderer->AddViewProp(this->Display);
  auto* const image = filter && filter->GetNumberOfInputConnections(0) > 0
    ? vtkImageData::SafeDownCast(filter->GetInputDataObject(0, 0))
    : nullptr;
  if (image && image->GetLength() > 0.0)
  {
    this->Representation->SetRadius(RadiusPart * image->GetLength());
    this->Representation->SetForceScale(1.0 / (NewtonPart * image->GetLength()));
    const double unit = filter->GetMetersPerWorldUnit();
    this->Representation->SetWorldUnitName(unit == 0.001 ? "mm" : unit == 1.0 ? "m" : "units");
  }
}

HapticViewProps::~HapticViewProps()
{
  this->Renderer->RemoveViewProp(this->Representation);
  this->Renderer->RemoveViewProp(this->Display);
}

} // namespace VolumeHaptics

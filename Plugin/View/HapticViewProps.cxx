// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticViewProps.h"

#include "vtkHapticDevice.h"
#include "vtkImageData.h"
#include "vtkVolumeHapticsFilter.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{
/// The proxy's radius and the arrow of one newton, as fractions of the volume's diagonal.
constexpr double RadiusPart = 0.006;
constexpr double NewtonPart = 0.05;

/// The largest of 1, 2 or 5 times a power of ten that is not above a length.
double RoundLength(double length)
{
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  const double part = length / power;
  return power * (part < 2.0 ? 1.0 : part < 5.0 ? 2.0 : 5.0);
}
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
    this->Representation->SetForceScale(1.0 / RoundLength(NewtonPart * image->GetLength()));
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

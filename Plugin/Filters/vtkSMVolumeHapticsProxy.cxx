// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMVolumeHapticsProxy.h"

#include "vtkCommand.h"
#include "vtkHapticProperty.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkSMPropertyHelper.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
/** Surface strengths (N) from this value on are impenetrable, so the scale need not cover them. */
constexpr double Impenetrable = 1e4;

/**
 * Returns the smallest scale of 1, 2 or 5 times a power of ten that covers all values of the
 * function.
 */
double ChooseScale(vtkPiecewiseFunction* function)
{
  double most = 0.0;
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    most = node[1] < Impenetrable ? std::max(most, node[1]) : most;
  }
  if (!(most > 0.0))
  {
    return 1.0;
  }
  const double decade = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : { 1.0, 2.0, 5.0 })
  {
    if (most <= step * decade)
    {
      return step * decade;
    }
  }
  return 10.0 * decade;
}
} // namespace

vtkStandardNewMacro(vtkSMVolumeHapticsProxy);

//------------------------------------------------------------------------------
vtkSMVolumeHapticsProxy::vtkSMVolumeHapticsProxy()
{
  this->AddObserver(
    vtkCommand::UpdatePropertyEvent, this, &vtkSMVolumeHapticsProxy::OnPropertyUpdated);
}

//------------------------------------------------------------------------------
vtkSMVolumeHapticsProxy::~vtkSMVolumeHapticsProxy() = default;

//------------------------------------------------------------------------------
void vtkSMVolumeHapticsProxy::OnPropertyUpdated(vtkObject*, unsigned long, void* name)
{
  if (name && std::string(static_cast<const char*>(name)) == "CopyPreset")
  {
    this->CopyPreset();
  }
}

//------------------------------------------------------------------------------
void vtkSMVolumeHapticsProxy::CopyPreset()
{
  const std::string preset = vtkSMPropertyHelper(this, "Preset").GetAsString();
  vtkNew<vtkHapticProperty> property;
  if (preset == "Custom" || !property->ApplyPreset(preset.c_str()))
  {
    return;
  }
  // Request the scale from the server, which has the image to which the preset is fitted.
  this->UpdatePropertyInformation(this->GetProperty("PresetScale"));
  const std::vector<double> fitted = vtkSMPropertyHelper(this, "PresetScale").GetDoubleArray();
  const bool isFitted = fitted.size() == 2 && fitted[1] > 0.0;
  const double values = isFitted ? fitted[0] : 1.0;
  this->CopyFunction("Stiffness", property->GetStiffness(), values);
  this->CopyFunction("Friction", property->GetFriction(), values);
  this->CopyFunction("Viscosity", property->GetViscosity(), values);
  this->CopyFunction("SurfaceStrength", property->GetSurfaceStrength(), values);
  this->CopyFunction("Distinctness", property->GetDistinctness(), isFitted ? fitted[1] : 1.0);
  const bool isFromNoise = property->GetDistinctness()->GetSize() == 0;
  vtkSMPropertyHelper(this, "DistinctnessFromNoise").Set(isFromNoise);
  vtkSMPropertyHelper(this, "DistinctnessPerMillimeter")
    .Set(property->GetDistinctnessPerMillimeter() && !isFitted);
  vtkSMPropertyHelper(this, "ScalarsAreLabels").Set(property->GetScalarsAreLabels());
  vtkSMPropertyHelper(this, "SolidFromImage").Set(property->GetSolidFromImage());
  vtkSMPropertyHelper(this, "ShiftFromImage").Set(property->GetShiftFromImage());
  vtkSMPropertyHelper(this, "SurfaceSide").Set(property->GetSurfaceSide());
  vtkSMPropertyHelper(this, "Preset").Set("Custom");
  this->UpdateVTKObjects();
}

//------------------------------------------------------------------------------
void vtkSMVolumeHapticsProxy::CopyFunction(
  const char* name, vtkPiecewiseFunction* function, double stretch)
{
  vtkSMProxy* const target = vtkSMPropertyHelper(this, name).GetAsProxy();
  if (!target)
  {
    return;
  }
  // Distinctness has no scale property, because its values are already between 0 and 1.
  const std::string scaleName = std::string(name) + "Scale";
  const bool isScaled = this->GetProperty(scaleName.c_str()) != nullptr;
  const double scale = isScaled ? ChooseScale(function) : 1.0;
  if (isScaled)
  {
    vtkSMPropertyHelper(this, scaleName.c_str()).Set(scale);
  }
  std::vector<double> points(4 * function->GetSize());
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double* const node = &points[4 * i];
    function->GetNodeValue(i, node);
    node[0] *= stretch;
    node[1] /= scale;
  }
  vtkSMPropertyHelper helper(target, "Points");
  helper.Set(points.data(), static_cast<unsigned int>(points.size()));
  target->UpdateVTKObjects();
}

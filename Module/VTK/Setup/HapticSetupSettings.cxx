// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Setup/HapticSetupSettings.h"

#include "Core/Model/HapticModel.h"
#include "VTK/Baking/HapticPlacement.h"
#include "VTK/Base/PassSettings.h"
#include "VTK/Filter/HapticFilterSettings.h"
#include "VTK/Material/HapticSetupFunctions.h"
#include "VTK/Material/HapticSetupMaterials.h"
#include "VTK/Setup/HapticSetupLabels.h"
#include "VTK/Setup/HapticSetupModes.h"
#include "VTK/Setup/HapticSetupTool.h"

#include "vtkCamera.h"
#include "vtkHapticProperty.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <cmath>
#include <limits>

// Passes a setting of an object under VTK's name.
#define PassNumberMacro(node, object, name, range)       \
  (node).Number(                                         \
    #name, range, [=] { return (object)->Get##name(); }, \
    [=](double number) { (object)->Set##name(number); })
// Passes a component's setting under VTK's name.
#define PassComponentMacro(node, object, component, name, range)  \
  (node).Number(                                                  \
    #name, range, [=] { return (object)->Get##name(component); }, \
    [=](double number) { (object)->Set##name(component, number); })

namespace VolumeHaptics
{
namespace
{

void PassProperty(SetupNode& node, vtkVolumeHapticsFilter* filter, vtkVolumeProperty* visible)
{
  PassMaterials(node, [filter] { return filter->GetProperty(); });
  // This setup could not restore the visibility from another volume property.
  if (!node.IsWriting() || !filter->GetProperty()->GetVisibilityFrom() ||
    filter->GetProperty()->GetVisibilityFrom() == visible)
  {
    node.Flag(
      "HideInvisible", [=] { return filter->GetProperty()->GetVisibilityFrom() != nullptr; },
      [=](bool hide)
      {
        vtkHapticProperty* const property = filter->GetProperty();
        vtkVolumeProperty* const now = property->GetVisibilityFrom();
        if (visible && (hide || now == visible))
        {
          property->SetVisibilityFrom(hide ? visible : nullptr);
        }
      });
  }
}

/**
 * Sets the view up of a camera to the digits in the file. vtkCamera normalizes the vector that it
 * is given, which changes the last digit of most unit vectors; the file has a normalized one, so
 * its digits are set directly.
 */
struct CameraAccess : vtkCamera
{
  static void SetViewUp(vtkCamera* camera, const NumberRow& wanted)
  {
    constexpr double rounding = 4.0 * std::numeric_limits<double>::epsilon();
    camera->SetViewUp(wanted.data());
    double(vtkCamera::*const up)[3] = &CameraAccess::ViewUp;
    if (std::equal(wanted.begin(), wanted.end(), camera->*up,
          [](double a, double b) { return std::abs(a - b) <= rounding; }))
    {
      std::copy(wanted.begin(), wanted.end(), camera->*up);
      camera->Modified();
      (camera->*(&CameraAccess::ComputeViewTransform))();
    }
  }
};

NumberRow ToRow(const double x[3])
{
  return { x[0], x[1], x[2] };
}

} // namespace

//------------------------------------------------------------------------------
void PassHaptics(SetupNode node, vtkVolumeHapticsFilter* filter, vtkVolumeProperty* visible)
{
  if (!node.IsWriting() && node.Has("ContactAlignment") && !node.Has("MaterialPlacement"))
  {
    // The file is a whole setup from before this setting.
    node.Then([=] { filter->SetMaterialPlacementToKernel(); });
  }
  PassSettings(node, static_cast<vtkVolumeHapticsFilter*>(filter), FilterSettings);
  PassSettings(node, static_cast<vtkVolumeHapticsFilter*>(filter), FilterTexts);
  PassProperty(node, filter, visible);
  PassModes(node, filter);
  PassTool(node, filter);
  PassLabels(node, filter);
}

//------------------------------------------------------------------------------
void PassVolume(SetupNode node, vtkVolumeProperty* property)
{
  node.Choice(
    "InterpolationType", { "Nearest", "Linear" }, [=] { return property->GetInterpolationType(); },
    [=](int type) { property->SetInterpolationType(type); });
  node.Flag(
    "IndependentComponents", [=] { return property->GetIndependentComponents() != 0; },
    [=](bool on) { property->SetIndependentComponents(on); });
  for (int c = 0; c < VTK_MAX_VRCOMP; ++c)
  {
    SetupNode part = node.Child("Component" + std::to_string(c));
    PassFunction(
      part.Child("ScalarOpacity"), AnyNumber(), [=] { return property->GetScalarOpacity(c); });
    part.Flag(
      "DisableGradientOpacity", [=] { return property->GetDisableGradientOpacity(c) != 0; },
      [=](bool on) { property->SetDisableGradientOpacity(c, on); });
    // Passes the stored function: while gradient opacity is disabled, the getter returns a
    // different function.
    PassFunction(part.Child("GradientOpacity"), AnyNumber(),
      [=]
      {
        if (!property->GetStoredGradientOpacity(c))
        {
          const int disabled = property->GetDisableGradientOpacity(c);
          property->SetDisableGradientOpacity(c, 0);
          property->GetGradientOpacity(c); // creates the function
          property->SetDisableGradientOpacity(c, disabled);
        }
        return property->GetStoredGradientOpacity(c);
      });
    if (part.IsWriting() ? property->GetColorChannels(c) == 1 : part.Has("Gray"))
    {
      PassFunction(
        part.Child("Gray"), AnyNumber(), [=] { return property->GetGrayTransferFunction(c); });
      part.Then([=] { property->SetColor(c, property->GetGrayTransferFunction(c)); });
    }
    else if (part.IsWriting() || part.Has("Color"))
    {
      PassColors(part.Child("Color"), [=] { return property->GetRGBTransferFunction(c); });
      part.Then([=] { property->SetColor(c, property->GetRGBTransferFunction(c)); });
    }
    PassComponentMacro(
      part, property, c, ScalarOpacityUnitDistance, (NumberRange{ 1e-300, 1e300 }));
    part.Flag(
      "Shade", [=] { return property->GetShade(c) != 0; },
      [=](bool on) { property->SetShade(c, on); });
    PassComponentMacro(part, property, c, Ambient, AnyNumber());
    PassComponentMacro(part, property, c, Diffuse, AnyNumber());
    PassComponentMacro(part, property, c, Specular, AnyNumber());
    PassComponentMacro(part, property, c, SpecularPower, AnyNumber());
  }
}

//------------------------------------------------------------------------------
void PassCamera(SetupNode node, vtkCamera* camera)
{
  NumberRow position = node.Row(
    "Position", 3, [=] { return ToRow(camera->GetPosition()); },
    [=](const NumberRow& x) { camera->SetPosition(x.data()); });
  NumberRow focus = node.Row(
    "FocalPoint", 3, [=] { return ToRow(camera->GetFocalPoint()); },
    [=](const NumberRow& x) { camera->SetFocalPoint(x.data()); });
  position = position.empty() ? ToRow(camera->GetPosition()) : position;
  focus = focus.empty() ? ToRow(camera->GetFocalPoint()) : focus;
  node.Require("Position", position != focus, "another place than FocalPoint");
  node.Require("FocalPoint", position != focus, "another place than Position");
  const NumberRow up = node.Row(
    "ViewUp", 3, [=] { return ToRow(camera->GetViewUp()); },
    [=](const NumberRow& x) { CameraAccess::SetViewUp(camera, x); });
  node.Require("ViewUp", up != NumberRow(3, 0.0), "a direction, with a number other than 0");
  PassNumberMacro(node, camera, ViewAngle, (NumberRange{ 1e-8, 179.9 }));
  node.Flag(
    "ParallelProjection", [=] { return camera->GetParallelProjection() != 0; },
    [=](bool on) { camera->SetParallelProjection(on); });
  PassNumberMacro(node, camera, ParallelScale, (NumberRange{ 1e-300, 1e300 }));
}

//------------------------------------------------------------------------------
void PassDeviceToWorld(SetupNode& root, vtkMatrix4x4* matrix)
{
  constexpr std::size_t size = 16;
  const NumberRow read = root.Row(
    "DeviceToWorld", size, [=] { return NumberRow(matrix->GetData(), matrix->GetData() + size); },
    [=](const NumberRow& elements) { matrix->DeepCopy(elements.data()); });
  if (!read.empty())
  {
    vtkNew<vtkMatrix4x4> checked;
    checked->DeepCopy(read.data());
    Affine3 map;
    std::string error;
    root.Require("DeviceToWorld", ReadSimilarity(checked, map, error),
      "a rotation, a translation and one uniform, positive scale, row by row");
  }
}

} // namespace VolumeHaptics

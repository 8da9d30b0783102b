// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/ColoredTubes.h"

#include "VTK/Scene/Hand/SceneMarker.h"

#include "vtkBoundingBox.h"
#include "vtkProperty.h"

namespace VolumeHaptics
{

ColoredTubes::ColoredTubes(int sides)
{
  this->Tubes->SetInputData(this->Lines);
  this->Tubes->SetNumberOfSides(sides);
  this->Tubes->CappingOn();
  this->Mapper->SetInputConnection(this->Tubes->GetOutputPort());
  this->Mapper->SetScalarModeToUseCellData();
  this->Mapper->SetColorModeToDirectScalars();
  this->Solid->SetMapper(this->Mapper);
  this->Solid->GetProperty()->SetAmbient(0.3);
  this->Solid->GetProperty()->SetDiffuse(0.7);
  this->Ghost->SetMapper(this->Mapper);
  this->Ghost->GetProperty()->LightingOff();
  this->Ghost->GetProperty()->SetOpacity(HiddenOpacity);
  // The overlay pass, in which vtkHapticRepresentation draws the ghost, does not sort translucent
  // objects.
  this->Ghost->ForceOpaqueOn();
}

vtkSmartPointer<vtkUnsignedCharArray> ColoredTubes::NewColors()
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("Colors");
  colors->SetNumberOfComponents(3);
  return colors;
}

void ColoredTubes::RenderOpaque(vtkViewport* viewport)
{
  if (this->AreShown())
  {
    this->Solid->RenderOpaqueGeometry(viewport);
  }
}

void ColoredTubes::RenderHidden(vtkViewport* viewport)
{
  if (this->AreShown())
  {
    this->Ghost->RenderOpaqueGeometry(viewport);
  }
}

void ColoredTubes::Release(vtkWindow* window)
{
  this->Solid->ReleaseGraphicsResources(window);
  this->Ghost->ReleaseGraphicsResources(window);
}

void ColoredTubes::AddTo(vtkBoundingBox& box)
{
  if (this->AreShown())
  {
    box.AddBounds(this->Lines->GetBounds());
  }
}

} // namespace VolumeHaptics

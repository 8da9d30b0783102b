// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticMeasurementRepresentation.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Base/vtkVolumeHapticsCompat.h"
#include "VTK/Scene/Base/HapticDrawing.h"
#include "VTK/Scene/Display/HapticMeasurementViewSettings.h"
#include "VTK/Scene/Display/MeasuredLabels.h"
#include "VTK/Scene/Display/MeasuredShapes.h"

#include "vtkBoundingBox.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticMeasurements.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include VOLUME_HAPTICS_OPENGL_HEADER

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkHapticMeasurementRepresentation);

using namespace VolumeHaptics;

namespace
{

/** Position of a label: at a point, between two, at the corner, at the end of a path. */
Vector3 FindPlace(int kind, vtkPolyData* shape)
{
  const vtkIdType count = shape->GetNumberOfPoints();
  const auto at = [shape](vtkIdType i) { return FromArray(shape->GetPoint(i)); };
  switch (kind)
  {
    case vtkHapticMeasurements::DISTANCE:
      return 0.5 * (at(0) + at(1));
    case vtkHapticMeasurements::ANGLE:
      return at(1);
    case vtkHapticMeasurements::AREA:
    {
      // Take the point nearest to the middle: the middle itself may be inside the body.
      const double* const b = shape->GetBounds();
      const Vector3 middle{ 0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]) };
      Vector3 nearest = at(0);
      for (vtkIdType i = 1; i < count; ++i)
      {
        nearest = Norm(at(i) - middle) < Norm(nearest - middle) ? at(i) : nearest;
      }
      return nearest;
    }
    default:
      return at(count - 1);
  }
}

} // namespace

//------------------------------------------------------------------------------
struct vtkHapticMeasurementRepresentation::vtkInternals
{
  vtkSmartPointer<vtkHapticMeasurements> List;
  vtkSmartPointer<vtkHapticHeadUpDisplay> Display;
  MeasuredShapes Shapes{ 0.25, 0.95, 1.0 };
  MeasuredShapes Unfinished{ 1.0, 1.0, 1.0 };
  MeasuredLabels Writing;
  std::vector<MeasuredLabels::Label> Labels;
  vtkMTimeType Built = 0;
  double BuiltRadius = 0.0;
  int Shown = 0;
  vtkBoundingBox Box;
  double Bounds[6];
};

//------------------------------------------------------------------------------
vtkHapticMeasurementRepresentation::vtkHapticMeasurementRepresentation()
  : Internals(new vtkInternals)
{
  this->PickableOff();
}

//------------------------------------------------------------------------------
vtkHapticMeasurementRepresentation::~vtkHapticMeasurementRepresentation() = default;

//------------------------------------------------------------------------------
void vtkHapticMeasurementRepresentation::SetMeasurements(vtkHapticMeasurements* measurements)
{
  if (this->Internals->List != measurements)
  {
    this->Internals->List = measurements;
    this->Internals->Built = 0;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticMeasurements* vtkHapticMeasurementRepresentation::GetMeasurements()
{
  return this->Internals->List;
}

//------------------------------------------------------------------------------
void vtkHapticMeasurementRepresentation::SetHeadUpDisplay(vtkHapticHeadUpDisplay* display)
{
  if (this->Internals->Display != display)
  {
    this->Internals->Display = display;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticHeadUpDisplay* vtkHapticMeasurementRepresentation::GetHeadUpDisplay()
{
  return this->Internals->Display;
}

//------------------------------------------------------------------------------
int vtkHapticMeasurementRepresentation::GetNumberOfShownLabels()
{
  return this->Internals->Shown;
}

//------------------------------------------------------------------------------
void vtkHapticMeasurementRepresentation::Build()
{
  auto& d = *this->Internals;
  const vtkMTimeType time = d.List ? d.List->GetMTime() : 1;
  if (time == d.Built && this->Radius == d.BuiltRadius)
  {
    return;
  }
  d.Built = time;
  d.BuiltRadius = this->Radius;
  d.Shapes.Clear(this->Radius);
  d.Unfinished.Clear(this->Radius);
  d.Labels.clear();
  if (!d.List)
  {
    return;
  }
  vtkNew<vtkPolyData> shape;
  for (vtkIdType i = 0; i < d.List->GetNumberOfMeasurements(); ++i)
  {
    const int kind = d.List->GetKind(i);
    d.List->GetShape(i, shape);
    d.Shapes.Add(kind, shape);
    d.Labels.push_back({ d.List->GetText(i), FindPlace(kind, shape) });
  }
  d.List->GetUnfinished(shape);
  d.Unfinished.Add(d.List->GetUnfinishedKind(), shape);
}

//------------------------------------------------------------------------------
double* vtkHapticMeasurementRepresentation::GetBounds()
{
  auto& d = *this->Internals;
  this->Build();
  d.Box.Reset();
  d.Shapes.AddTo(d.Box);
  d.Unfinished.AddTo(d.Box);
  if (!d.Box.IsValid())
  {
    return nullptr;
  }
  d.Box.Inflate(this->Radius);
  d.Box.GetBounds(d.Bounds);
  return d.Bounds;
}

//------------------------------------------------------------------------------
int vtkHapticMeasurementRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  if (!VolumeHaptics::IsDrawing(viewport))
  {
    return 0;
  }
  this->Build();
  this->Internals->Shapes.RenderOpaque(viewport);
  this->Internals->Unfinished.RenderOpaque(viewport);
  return 1;
}

//------------------------------------------------------------------------------
int vtkHapticMeasurementRepresentation::RenderOverlay(vtkViewport* viewport)
{
  auto& d = *this->Internals;
  d.Shown = 0;
  vtkRenderer* const renderer = vtkRenderer::SafeDownCast(viewport);
  if (!renderer || !VolumeHaptics::IsDrawing(viewport))
  {
    return 0;
  }
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (this->HiddenVisibility && window)
  {
    vtkOpenGLState* const state = window->GetState();
    const vtkOpenGLState::ScopedglEnableDisable depth(state, GL_DEPTH_TEST);
    const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    d.Shapes.RenderHidden(viewport);
    d.Unfinished.RenderHidden(viewport);
  }
  if (this->LabelVisibility)
  {
    const auto isTaken = [&d](const MeasuredLabels::Box& box)
    {
      const double sides[4] = { box.Left, box.Right, box.Bottom, box.Top };
      return d.Display && d.Display->Covers(sides);
    };
    d.Shown = d.Writing.Render(renderer, d.Labels, isTaken);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHapticMeasurementRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Shapes.Release(window);
  this->Internals->Unfinished.Release(window);
  this->Internals->Writing.Release(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkHapticMeasurementRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Measurements: " << this->GetMeasurements() << "\n";
  os << indent << "HeadUpDisplay: " << this->GetHeadUpDisplay() << "\n";
  PrintSettings(os, indent, this, MeasurementViewSettings);
}

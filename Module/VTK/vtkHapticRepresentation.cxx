// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticRepresentation.h"

#include "VTK/Charts/HapticDrawing.h"
#include "VTK/Charts/HapticModeColors.h"
#include "VTK/Charts/HapticTextLook.h"
#include "VTK/Scene/FollowedScene.h"
#include "VTK/Scene/HapticSceneSettings.h"
#include "VTK/Scene/LandingRing.h"
#include "VTK/Scene/SceneMarker.h"
#include "vtkHapticStateSource.h"
#include "vtkVolumeHapticsCompat.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkHapticDevice.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"

#include VOLUME_HAPTICS_OPENGL_HEADER

#include <sstream>

vtkStandardNewMacro(vtkHapticRepresentation);

using namespace VolumeHaptics;

struct vtkHapticRepresentation::vtkInternals
{
  vtkNew<vtkHapticStateSource> Source;
  SceneMarker Markers[8] = { { SceneMarker::Sphere, 0.97, 0.97, 0.97 },
    { SceneMarker::Sphere, 0.6, 0.6, 0.6 }, { SceneMarker::Sphere, 0.95, 0.85, 0.2 },
    { SceneMarker::Sphere, 0.2, 0.8, 0.8 }, { SceneMarker::Rod, 0.75, 0.75, 0.75 },
    { SceneMarker::Arrow, 0.97, 0.97, 0.97 }, { SceneMarker::Arrow, 0.15, 0.5, 0.95 },
    { SceneMarker::Arrow, 0.95, 0.5, 0.05 } };
  /// The second heads of arrows that are not as long as their forces, in the order of the arrows.
  SceneMarker SecondHeads[3] = { { SceneMarker::Arrow, 0.97, 0.97, 0.97 },
    { SceneMarker::Arrow, 0.15, 0.5, 0.95 }, { SceneMarker::Arrow, 0.95, 0.5, 0.05 } };
  FollowedScene Followed{ ModeColors, ModeColorCount };
  SceneMarker Stylus{ SceneMarker::Stylus, 1.0, 1.0, 1.0 };
  LandingRing Landing;
  bool HasState = false;
  vtkSmartPointer<vtkPolyData> Trail;
  vtkNew<vtkPolyDataMapper> TrailMapper;
  vtkNew<vtkLookupTable> BlueToRed;
  vtkNew<vtkActor> TrailActor;
  vtkNew<vtkTextActor> ScaleText;
  vtkBoundingBox Box;
  double Bounds[6];
};

namespace
{
/// Of the stylus: its length, when StylusLength is 0, in radii of the proxy.
constexpr double StylusRadii = 25.0;
/// Of arrows: the longest one, when MaximumArrowLength is 0, in radii of the proxy.
constexpr double ArrowRadii = 30.0;
/// Where a second head ends, in parts of its arrow.
constexpr double SecondHead = 0.8;
/// By contact; the colour-blind can tell them apart, too.
const double ContactColors[4][3] = { { 0.62, 0.64, 0.67 }, { 1.0, 0.72, 0.1 }, { 0.1, 0.75, 0.45 },
  { 0.85, 0.2, 0.65 } };
/** Whether forces are shown: always, but for the hand of a virtual device that is not armed. */
bool IsFelt(vtkHapticDevice* device)
{
  const int status = device->GetStatus();
  return device->GetDeviceId() != "virtual" || status == vtkHapticDevice::ARMED ||
    status == vtkHapticDevice::ACTIVE;
}
} // namespace

//------------------------------------------------------------------------------
vtkHapticRepresentation::vtkHapticRepresentation()
  : Internals(new vtkInternals)
{
  auto& d = *this->Internals;
  d.BlueToRed->SetHueRange(2.0 / 3.0, 0.0);
  d.TrailMapper->SetLookupTable(d.BlueToRed);
  d.TrailActor->SetMapper(d.TrailMapper);
  d.TrailActor->GetProperty()->SetLineWidth(3.0f);
  d.TrailActor->GetProperty()->LightingOff();
  vtkTextProperty* const text = d.ScaleText->GetTextProperty();
  text->SetFontSize(13);
  text->SetJustificationToRight();
  d.ScaleText->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  d.ScaleText->GetPositionCoordinate()->SetValue(0.98, 0.02);
  this->PickableOff();
}

//------------------------------------------------------------------------------
vtkHapticRepresentation::~vtkHapticRepresentation() = default;

//------------------------------------------------------------------------------
void vtkHapticRepresentation::SetDevice(vtkHapticDevice* device)
{
  if (this->GetDevice() != device)
  {
    this->Internals->Source->SetDevice(device);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkHapticRepresentation::GetDevice()
{
  return this->Internals->Source->GetDevice();
}

//------------------------------------------------------------------------------
void vtkHapticRepresentation::SetTrail(vtkPolyData* trace)
{
  if (this->Internals->Trail != trace)
  {
    this->Internals->Trail = trace;
    this->Internals->TrailMapper->SetInputData(trace);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkPolyData* vtkHapticRepresentation::GetTrail()
{
  return this->Internals->Trail;
}

//------------------------------------------------------------------------------
void vtkHapticRepresentation::SetTrailLookupTable(vtkScalarsToColors* table)
{
  auto& d = *this->Internals;
  d.TrailMapper->SetLookupTable(table ? table : d.BlueToRed.GetPointer());
  d.TrailMapper->SetUseLookupTableScalarRange(table != nullptr);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHapticRepresentation::UpdateMarkers()
{
  using Source = vtkHapticStateSource;
  auto& d = *this->Internals;
  d.Source->SetForceScale(this->ForceScale);
  d.Source->Update();
  vtkPolyData* const state = d.Source->GetOutput();
  d.HasState = state->GetNumberOfPoints() > 0;
  const auto at = [&](vtkIdType point)
  {
    const double* const x = state->GetPoint(point);
    return Vector3{ x[0], x[1], x[2] };
  };
  for (int i = 0; i < 8; ++i)
  {
    d.Markers[i].Show(d.HasState);
  }
  for (SceneMarker& head : d.SecondHeads)
  {
    head.Show(false);
  }
  if (d.HasState)
  {
    const auto contact =
      static_cast<int>(state->GetFieldData()->GetArray("Contact")->GetComponent(0, 0));
    d.Markers[Source::PROXY].SetColor(ContactColors[contact & 3]);
    const double radii[4] = { 0.6, 1.0, 0.35, 0.35 };
    for (int i = Source::TIP; i <= Source::MEDIUM_POSITION; ++i)
    {
      d.Markers[i].PlaceSphere(at(i), radii[i] * this->Radius);
    }
    // A hand that has let go feels nothing, though the tip may still be in a surface.
    const bool isFelt = IsFelt(this->GetDevice());
    const bool shown[4] = { isFelt && this->SpringVisibility, isFelt && this->ForceVisibility,
      isFelt && this->NormalForceVisibility, isFelt && this->FrictionForceVisibility };
    for (int line = 0; line < 4; ++line)
    {
      const vtkIdType point = Source::SPRING + 2 * line;
      SceneMarker& marker = d.Markers[Source::SPRING + line];
      marker.Show(shown[line]);
      if (line == 0)
      {
        marker.PlaceAlong(at(point), at(point + 1), 0.18 * this->Radius);
        continue;
      }
      const double longest =
        this->MaximumArrowLength > 0.0 ? this->MaximumArrowLength : ArrowRadii * this->Radius;
      const Vector3 from = at(point);
      const Vector3 whole = at(point + 1) - from;
      const bool isTooLong = Norm(whole) > longest;
      const Vector3 arrow = isTooLong ? (longest / Norm(whole)) * whole : whole;
      marker.PlaceAlong(from, from + arrow, 0.3 * this->Radius);
      d.SecondHeads[line - 1].Show(shown[line] && isTooLong);
      d.SecondHeads[line - 1].PlaceAlong(from, from + SecondHead * arrow, 0.3 * this->Radius);
    }
    d.Markers[Source::SURFACE_POSITION].Show(this->MarkerVisibility);
    d.Markers[Source::MEDIUM_POSITION].Show(this->MarkerVisibility);
  }
  this->UpdateStylus();
  d.Followed.Update(this->FollowedVisibility && d.HasState ? this->GetDevice() : nullptr,
    this->FollowedReach, this->Radius);
  std::ostringstream text;
  text << "1 N = " << 1.0 / this->ForceScale << " " << this->WorldUnitName;
  d.ScaleText->SetInput(text.str().c_str());
}

//------------------------------------------------------------------------------
void vtkHapticRepresentation::UpdateStylus()
{
  auto& d = *this->Internals;
  d.Stylus.Show(false);
  if (!d.HasState || !this->StylusVisibility)
  {
    return;
  }
  vtkPolyData* const state = d.Source->GetOutput();
  double q[4];
  state->GetFieldData()->GetArray("Orientation")->GetTuple(0, q);
  const Quaternion orientation{ q[0], q[1], q[2], q[3] };
  const double* const proxy = state->GetPoint(vtkHapticStateSource::PROXY);
  d.Stylus.Show(SquaredNorm(orientation) > 0.0);
  d.Stylus.PlaceTurned({ proxy[0], proxy[1], proxy[2] }, orientation,
    this->StylusLength > 0.0 ? this->StylusLength : StylusRadii * this->Radius);
}

//------------------------------------------------------------------------------
void vtkHapticRepresentation::UpdateTrail()
{
  auto& d = *this->Internals;
  vtkDataArray* const array =
    d.Trail ? d.Trail->GetPointData()->GetArray(this->TrailArrayName.c_str()) : nullptr;
  d.TrailMapper->SetScalarVisibility(array != nullptr);
  if (array)
  {
    d.TrailMapper->SetScalarModeToUsePointFieldData();
    d.TrailMapper->SelectColorArray(this->TrailArrayName.c_str());
    // Vectors count by their length.
    const int component = array->GetNumberOfComponents() > 1 ? -1 : 0;
    d.TrailMapper->SetColorModeToMapScalars();
    d.TrailMapper->GetLookupTable()->SetVectorModeToMagnitude();
    double range[2];
    array->GetRange(range, component);
    d.TrailMapper->SetScalarRange(range);
  }
}

//------------------------------------------------------------------------------
double* vtkHapticRepresentation::GetBounds()
{
  auto& d = *this->Internals;
  this->UpdateMarkers();
  d.Box.Reset();
  for (SceneMarker& marker : d.Markers)
  {
    marker.AddTo(d.Box);
  }
  d.Stylus.AddTo(d.Box);
  d.Followed.AddTo(d.Box);
  d.Landing.AddTo(d.Box);
  if (d.Trail && d.Trail->GetNumberOfPoints() > 0)
  {
    d.Box.AddBounds(d.Trail->GetBounds());
  }
  if (!d.Box.IsValid())
  {
    return nullptr;
  }
  d.Box.GetBounds(d.Bounds);
  return d.Bounds;
}

//------------------------------------------------------------------------------
int vtkHapticRepresentation::RenderOpaqueGeometry(vtkViewport* viewport)
{
  if (!VolumeHaptics::IsDrawing(viewport))
  {
    return 0;
  }
  auto& d = *this->Internals;
  this->UpdateMarkers();
  for (SceneMarker& marker : d.Markers)
  {
    marker.RenderOpaque(viewport);
  }
  for (SceneMarker& head : d.SecondHeads)
  {
    head.RenderOpaque(viewport);
  }
  d.Stylus.RenderOpaque(viewport);
  d.Followed.RenderOpaque(viewport);
  const bool hasLanding = this->LandingVisibility && d.HasState && IsFelt(this->GetDevice());
  d.Landing.Update(vtkRenderer::SafeDownCast(viewport), hasLanding ? this->GetDevice() : nullptr,
    this->Radius, this->WorldUnitName);
  d.Landing.RenderOpaque(viewport);
  if (d.Trail && d.Trail->GetNumberOfPoints() > 0)
  {
    this->UpdateTrail();
    d.TrailActor->RenderOpaqueGeometry(viewport);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHapticRepresentation::RenderOverlay(vtkViewport* viewport)
{
  if (!VolumeHaptics::IsDrawing(viewport))
  {
    return 0;
  }
  auto& d = *this->Internals;
  vtkRenderer* const renderer = vtkRenderer::SafeDownCast(viewport);
  auto* const window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (d.Followed.HasFronts() && window)
  {
    vtkOpenGLState* const state = window->GetState();
    const vtkOpenGLState::ScopedglEnableDisable depth(state, GL_DEPTH_TEST);
    const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    d.Followed.RenderFronts(viewport);
  }
  if (this->HiddenVisibility && window)
  {
    vtkOpenGLState* const state = window->GetState();
    const vtkOpenGLState::ScopedglEnableDisable depth(state, GL_DEPTH_TEST);
    const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    state->vtkglDisable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    d.Followed.RenderHidden(viewport);
    d.Landing.RenderHidden(viewport);
    d.Stylus.RenderHidden(viewport); // first, so that it covers no marker
    for (SceneMarker& marker : d.Markers)
    {
      marker.RenderHidden(viewport);
    }
    for (SceneMarker& head : d.SecondHeads)
    {
      head.RenderHidden(viewport);
    }
  }
  d.Landing.RenderText(viewport);
  if (this->ScaleTextVisibility && d.HasState)
  {
    SetLook(d.ScaleText->GetTextProperty(), 0.93, 0.95, 0.98, viewport);
    d.ScaleText->RenderOpaqueGeometry(viewport); // draws the letters into the texture shown next
    d.ScaleText->RenderOverlay(viewport);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHapticRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  auto& d = *this->Internals;
  for (SceneMarker& marker : d.Markers)
  {
    marker.Release(window);
  }
  for (SceneMarker& head : d.SecondHeads)
  {
    head.Release(window);
  }
  d.Stylus.Release(window);
  d.Followed.Release(window);
  d.Landing.Release(window);
  d.TrailActor->ReleaseGraphicsResources(window);
  d.ScaleText->ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkHapticRepresentation::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device: " << this->GetDevice() << "\n";
  PrintSettings(os, indent, this, RepresentationSettings);
  os << indent << "WorldUnitName: " << this->WorldUnitName << "\n";
  os << indent << "Trail: " << this->GetTrail() << "\n";
  os << indent << "TrailArrayName: " << this->TrailArrayName << "\n";
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticRepresentation.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Base/vtkVolumeHapticsCompat.h"
#include "VTK/Scene/Base/HapticDrawing.h"
#include "VTK/Scene/Base/HapticModeColors.h"
#include "VTK/Scene/Base/HapticOverlays.h"
#include "VTK/Scene/Base/HapticTextLook.h"
#include "VTK/Scene/Base/HapticViewRay.h"
#include "VTK/Scene/Hand/DrawnTool.h"
#include "VTK/Scene/Hand/FollowedScene.h"
#include "VTK/Scene/Hand/HapticRepresentationSettings.h"
#include "VTK/Scene/Hand/LandingRing.h"
#include "VTK/Scene/Hand/SceneMarker.h"
#include "VTK/Scene/Hand/SpringCoil.h"

#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkHapticDevice.h"
#include "vtkHapticState.h"
#include "vtkLookupTable.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarsToColors.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include VOLUME_HAPTICS_OPENGL_HEADER

#include <algorithm>
#include <sstream>
#include <utility>

vtkStandardNewMacro(vtkHapticRepresentation);

using namespace VolumeHaptics;

namespace
{
/// Position of the lower right corner of the scale text, as fractions of the viewport.
constexpr double ScaleRight = 0.98;
constexpr double ScaleBottom = 0.02;
} // namespace

struct vtkHapticRepresentation::vtkInternals
{
  vtkSmartPointer<vtkHapticDevice> Device;
  vtkNew<vtkPolyData> State; ///< geometry of the state; empty without a state
  /// Spheres, in the order of vtkHapticState's parts from TIP on.
  SceneMarker Spheres[4] = { { SceneMarker::Sphere, 0.97, 0.97, 0.97 },
    { SceneMarker::Sphere, 0.6, 0.6, 0.6 }, { SceneMarker::Sphere, 0.95, 0.85, 0.2 },
    { SceneMarker::Sphere, 0.2, 0.8, 0.8 } };
  SpringCoil Spring;
  /// Arrows, in the order of vtkHapticState's parts from FORCE on.
  SceneMarker Arrows[3] = { { SceneMarker::Arrow, 0.97, 0.97, 0.97 },
    { SceneMarker::Arrow, 0.15, 0.5, 0.95 }, { SceneMarker::Arrow, 0.95, 0.5, 0.05 } };
  /// Second arrow heads, which mark arrows that are shorter than their forces; in the order of
  /// Arrows.
  SceneMarker SecondHeads[3] = { { SceneMarker::Arrow, 0.97, 0.97, 0.97 },
    { SceneMarker::Arrow, 0.15, 0.5, 0.95 }, { SceneMarker::Arrow, 0.95, 0.5, 0.05 } };
  FollowedScene Followed{ ModeColors, ModeColorCount };
  DrawnNeedle Needle;
  DrawnTool Tool;
  SceneMarker Stylus{ SceneMarker::Stylus, 1.0, 1.0, 1.0 };
  /// Orientation of the stylus for a device that measures none, computed from the camera of the
  /// last frame.
  Quaternion Leaning = NoOrientation;
  double MostLength = VTK_DOUBLE_MAX;
  LandingRing Landing;
  /// Draw markers over a volume with coarse rays, in which they would otherwise leave holes.
  bool IsOverVolumes = false;
  bool HasState = false;
  bool HadState = false; ///< whether there was a state in the last frame
  bool WasFelt = false;  ///< whether forces were shown in the last frame
  bool HasLetGo = false; ///< whether the tip has stayed in place since it was last felt
  Vector3 LetGoAt;
  vtkSmartPointer<vtkPolyData> Trail;
  vtkNew<vtkPolyDataMapper> TrailMapper;
  vtkNew<vtkLookupTable> BlueToRed;
  vtkNew<vtkActor> TrailActor;
  vtkNew<vtkTextActor> ScaleText;
  vtkBoundingBox Box;
  double Bounds[6];

  ///@{
  /** Draw the markers on the free side of a touched surface, or those inside it. */
  void RenderOutside(vtkViewport* viewport)
  {
    this->Spheres[vtkHapticState::PROXY].RenderOpaque(viewport);
    for (int i = 1; i < 3; ++i)
    {
      this->Arrows[i].RenderOpaque(viewport);
      this->SecondHeads[i].RenderOpaque(viewport);
    }
    this->Stylus.RenderOpaque(viewport);
    this->Needle.RenderOpaque(viewport);
    this->Tool.RenderOpaque(viewport);
    this->Landing.RenderOpaque(viewport);
  }
  void RenderInside(vtkViewport* viewport)
  {
    for (const int i :
      { vtkHapticState::TIP, vtkHapticState::SURFACE_POSITION, vtkHapticState::MEDIUM_POSITION })
    {
      this->Spheres[i].RenderOpaque(viewport);
    }
    this->Spring.RenderOpaque(viewport);
    this->Arrows[0].RenderOpaque(viewport);
    this->SecondHeads[0].RenderOpaque(viewport);
  }
  ///@}
};

namespace
{
/** Returns whether any volume is drawn with fewer rays than pixels. */
bool AreRaysCoarse(vtkRenderer* renderer)
{
  vtkVolumeCollection* const volumes = renderer->GetVolumes();
  vtkCollectionSimpleIterator next;
  volumes->InitTraversal(next);
  while (vtkVolume* const volume = volumes->GetNextVolume(next))
  {
    vtkAbstractVolumeMapper* const mapper = volume->GetVisibility() ? volume->GetMapper() : nullptr;
    auto* const cpu = vtkFixedPointVolumeRayCastMapper::SafeDownCast(mapper);
    auto* const gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper);
    auto* const smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
    if ((cpu && cpu->GetImageSampleDistance() > 1.0f) ||
      (gpu && gpu->GetImageSampleDistance() > 1.0f) ||
      (smart && smart->GetLastUsedRenderMode() == vtkSmartVolumeMapper::RayCastRenderMode &&
        renderer->GetRenderWindow()->GetDesiredUpdateRate() > 1.0))
    {
      return true;
    }
  }
  return false;
}

/// Length of the stylus if StylusLength is 0, in radii of the proxy.
constexpr double StylusRadii = 25.0;
/// Direction of a leaning stylus's handle, as a unit vector: right, up and towards the viewer.
constexpr double LeanRight = 0.48;
constexpr double LeanUp = 0.6;
constexpr double LeanBack = 0.64;
/// Length of the longest arrow if MaximumArrowLength is 0, in radii of the proxy.
constexpr double ArrowRadii = 30.0;
/// Position of the second head's end, as a fraction of the arrow's length.
constexpr double SecondHead = 0.8;
/// Colours of contacts, which people with colour blindness can distinguish, too.
const double SecondHandColor[3] = { 0.80, 0.62, 1.0 };
const double White[3] = { 0.97, 0.97, 0.97 };
const double StylusColor[3] = { 1.0, 1.0, 1.0 };
const double ContactColors[4][3] = { { 0.62, 0.64, 0.67 }, { 1.0, 0.72, 0.1 }, { 0.1, 0.75, 0.45 },
  { 0.85, 0.2, 0.65 } };
/** Returns whether the proxy is on the viewer's side of the touched surface, and so is visible. */
bool IsSeen(vtkRenderer* renderer, vtkHapticDevice* device)
{
  const Vector3 sight = LineOfSight(renderer, FromArray(device->GetState()->GetProxyPosition()));
  return device->GetState()->GetContact() == 0 ||
    Dot(FromArray(device->GetState()->GetNormal()), sight) > 0.0;
}
/** Returns whether to show forces: always, unless the device is virtual and not armed. */
bool IsFelt(vtkHapticDevice* device)
{
  const int status = device->GetStatus();
  return !device->GetVirtualHand()->MayMouseLead() || status == vtkHapticDevice::ARMED ||
    status == vtkHapticDevice::ACTIVE;
}

/** Returns the position of the device's origin in the world. */
Vector3 GetOrigin(vtkHapticDevice* device)
{
  vtkMatrix4x4* const placement = device->GetDeviceToWorld();
  return placement ? Vector3{ placement->GetElement(0, 3), placement->GetElement(1, 3),
    placement->GetElement(2, 3) }
                   : Vector3{};
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
  d.ScaleText->GetPositionCoordinate()->SetValue(ScaleRight, ScaleBottom);
  this->PickableOff();
}

//------------------------------------------------------------------------------
vtkHapticRepresentation::~vtkHapticRepresentation() = default;

//------------------------------------------------------------------------------
void vtkHapticRepresentation::SetDevice(vtkHapticDevice* device)
{
  if (this->GetDevice() != device)
  {
    this->Internals->Device = device;
    this->Internals->HadState = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkHapticRepresentation::GetDevice()
{
  return this->Internals->Device;
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
  using State = vtkHapticState;
  auto& d = *this->Internals;
  d.State->Initialize();
  if (d.Device)
  {
    d.Device->GetState()->GetGeometry(d.State, this->ForceScale);
  }
  vtkPolyData* const state = d.State;
  d.HasState = state->GetNumberOfPoints() > 0;
  const auto at = [&](vtkIdType point) { return FromArray(state->GetPoint(point)); };
  // After the hand has let go, it feels nothing, even with the tip inside a surface; then show no
  // markers until the application moves the tip. Before the first touch, show none at the device's
  // origin, where the tip is until the mouse or a program moves it.
  const bool isFelt = d.HasState && IsFelt(this->GetDevice());
  const Vector3 tip = d.HasState ? at(State::TIP) : Vector3{};
  const bool isFirst = d.HasState && !std::exchange(d.HadState, d.HasState) &&
    Norm(tip - GetOrigin(this->GetDevice())) < this->Radius;
  if ((std::exchange(d.WasFelt, isFelt) || isFirst) && !isFelt)
  {
    d.HasLetGo = true;
    d.LetGoAt = tip;
  }
  d.HasLetGo = d.HasLetGo && !isFelt && Norm(tip - d.LetGoAt) < this->Radius;
  for (SceneMarker& sphere : d.Spheres)
  {
    sphere.Show(d.HasState && !d.HasLetGo);
  }
  d.Spring.Show(false);
  for (SceneMarker& arrow : d.Arrows)
  {
    arrow.Show(false);
  }
  for (SceneMarker& head : d.SecondHeads)
  {
    head.Show(false);
  }
  const double* const color = this->SecondHand ? SecondHandColor : White;
  d.Spheres[State::TIP].SetColor(color);
  d.Arrows[0].SetColor(color);
  d.SecondHeads[0].SetColor(color);
  d.Stylus.SetColor(this->SecondHand ? SecondHandColor : StylusColor);
  d.Stylus.SetPainted(!this->SecondHand);
  if (d.HasState)
  {
    const auto contact =
      static_cast<int>(state->GetFieldData()->GetArray("Contact")->GetComponent(0, 0));
    const bool isLilac = this->SecondHand && contact == 0;
    d.Spheres[State::PROXY].SetColor(isLilac ? SecondHandColor : ContactColors[contact & 3]);
    d.Landing.SetColor(ContactColors[contact & 3]);
    const double radii[4] = { 0.6, 1.0, 0.35, 0.35 };
    for (int i = State::TIP; i <= State::MEDIUM_POSITION; ++i)
    {
      d.Spheres[i].PlaceSphere(at(i), radii[i] * this->Radius);
    }
    if (isFelt && this->SpringVisibility)
    {
      d.Spring.Show(true);
      d.Spring.Place(
        at(State::PROXY), at(State::TIP), this->GetDevice()->GetState()->GetSlack(), this->Radius);
    }
    const bool shown[3] = { isFelt && this->ForceVisibility, isFelt && this->NormalForceVisibility,
      isFelt && this->FrictionForceVisibility };
    const double longest =
      this->MaximumArrowLength > 0.0 ? this->MaximumArrowLength : ArrowRadii * this->Radius;
    for (int i = 0; i < 3; ++i)
    {
      // The points of the spring precede the points of the arrows in the state's geometry.
      const vtkIdType point = State::SPRING + 2 + 2 * i;
      const Vector3 from = at(point);
      const Vector3 whole = at(point + 1) - from;
      const bool isTooLong = Norm(whole) > longest;
      const Vector3 arrow = isTooLong ? (longest / Norm(whole)) * whole : whole;
      d.Arrows[i].Show(shown[i]);
      d.Arrows[i].PlaceAlong(from, from + arrow, 0.3 * this->Radius);
      d.SecondHeads[i].Show(shown[i] && isTooLong);
      d.SecondHeads[i].PlaceAlong(from, from + SecondHead * arrow, 0.3 * this->Radius);
    }
    d.Spheres[State::SURFACE_POSITION].Show(this->MarkerVisibility && !d.HasLetGo);
    d.Spheres[State::MEDIUM_POSITION].Show(this->MarkerVisibility && !d.HasLetGo);
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
  vtkHapticDevice* const device =
    this->StylusVisibility && d.HasState ? this->GetDevice() : nullptr;
  d.Tool.Update(device, d.Leaning);
  d.Stylus.Show(false);
  if (!d.HasState || !this->StylusVisibility || d.Tool.IsShown())
  {
    d.Needle.Update(device, this->Radius, this->ComputeStylusLength(), {});
    return;
  }
  vtkPolyData* const state = d.State;
  const Quaternion measured = ReadQuaternion(state->GetFieldData()->GetArray("Orientation"), 0);
  const bool isMeasured = SquaredNorm(measured) > 0.0;
  const Quaternion orientation = isMeasured || !IsFelt(this->GetDevice()) ? measured : d.Leaning;
  const bool isFitted = !isMeasured && !(this->StylusLength > 0.0);
  const double whole = this->ComputeStylusLength();
  const double length = isFitted ? std::min(whole, d.MostLength) : whole;
  const bool isKnown = SquaredNorm(orientation) > 0.0;
  const Vector3 handle = ToMatrix(orientation) * Vector3{ 0.0, 0.0, 1.0 };
  d.Needle.Update(device, this->Radius, length, isKnown ? handle : Vector3{});
  d.Stylus.Show(isKnown && !d.Needle.IsShown());
  d.Stylus.PlaceTurned(FromArray(state->GetPoint(vtkHapticState::PROXY)), orientation, length);
}

//------------------------------------------------------------------------------
double vtkHapticRepresentation::ComputeStylusLength()
{
  return this->StylusLength > 0.0 ? this->StylusLength : StylusRadii * this->Radius;
}

//------------------------------------------------------------------------------
void vtkHapticRepresentation::Lean(vtkViewport* viewport)
{
  auto& d = *this->Internals;
  vtkRenderer* const renderer = vtkRenderer::SafeDownCast(viewport);
  if (!renderer || !this->GetDevice())
  {
    return;
  }
  const Vector3 proxy = FromArray(this->GetDevice()->GetState()->GetProxyPosition());
  vtkCamera* const camera = renderer->GetActiveCamera();
  const Vector3 back = -1.0 * LineOfSight(renderer, proxy);
  const Vector3 across = Cross(FromArray(camera->GetViewUp()), back);
  if (!(Norm(across) > 0.0))
  {
    return;
  }
  const Vector3 right = (1.0 / Norm(across)) * across;
  const Vector3 up = Cross(back, right);
  const Vector3 handle = LeanRight * right + LeanUp * up + LeanBack * back; // unit
  const Vector3 open = back - Dot(back, handle) * handle;
  const Vector3 button = (1.0 / Norm(open)) * open;
  d.Leaning = ToQuaternion(Matrix3::FromColumns(Cross(button, handle), button, handle));
  d.MostLength = camera->GetParallelProjection()
    ? VTK_DOUBLE_MAX
    : Norm(FromArray(camera->GetPosition()) - proxy) / 3.0;
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
    // Colour vectors by their magnitude.
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
  for (SceneMarker& sphere : d.Spheres)
  {
    sphere.AddTo(d.Box);
  }
  for (SceneMarker& arrow : d.Arrows)
  {
    arrow.AddTo(d.Box);
  }
  d.Spring.AddTo(d.Box);
  d.Stylus.AddTo(d.Box);
  d.Needle.AddTo(d.Box);
  d.Tool.AddTo(d.Box);
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
  this->Lean(viewport);
  this->UpdateMarkers();
  vtkRenderer* const renderer = vtkRenderer::SafeDownCast(viewport);
  const bool hasLanding = this->LandingVisibility && d.HasState && IsFelt(this->GetDevice());
  d.Landing.Update(
    renderer, hasLanding ? this->GetDevice() : nullptr, this->Radius, this->WorldUnitName);
  d.IsOverVolumes =
    d.HasState && renderer && IsSeen(renderer, this->GetDevice()) && AreRaysCoarse(renderer);
  if (!d.IsOverVolumes)
  {
    d.RenderInside(viewport);
    d.RenderOutside(viewport);
  }
  d.Followed.RenderOpaque(viewport);
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
  if (!VolumeHaptics::IsDrawing(viewport) || VolumeHaptics::IsGivenUp(viewport))
  {
    return 0;
  }
  auto& d = *this->Internals;
  vtkRenderer* const renderer = vtkRenderer::SafeDownCast(viewport);
  auto* const window =
    renderer ? vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow()) : nullptr;
  if (window)
  {
    vtkOpenGLState* const state = window->GetState();
    const vtkOpenGLState::ScopedglEnableDisable depth(state, GL_DEPTH_TEST);
    const vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglEnable(GL_BLEND);
    if (d.Followed.HasFronts())
    {
      d.Followed.RenderFronts(viewport);
    }
    d.Landing.RenderPatch(viewport);
    if (d.IsOverVolumes)
    {
      const vtkOpenGLState::ScopedglDepthMask mask(state);
      state->vtkglDepthMask(GL_TRUE);
      d.RenderOutside(viewport);
    }
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
    d.Needle.RenderHidden(viewport);
    d.Tool.RenderHidden(viewport);
    d.Stylus.RenderHidden(viewport); // first, so that it covers no marker
    for (SceneMarker& sphere : d.Spheres)
    {
      sphere.RenderHidden(viewport);
    }
    d.Spring.RenderHidden(viewport);
    for (int i = 0; i < 3; ++i)
    {
      d.Arrows[i].RenderHidden(viewport);
      d.SecondHeads[i].RenderHidden(viewport);
    }
  }
  d.Landing.RenderText(viewport);
  if (this->ScaleTextVisibility && !this->SecondHand && d.HasState)
  {
    SetLook(d.ScaleText->GetTextProperty(), 0.93, 0.95, 0.98, viewport);
    const int* const view = viewport->GetSize();
    double size[2];
    d.ScaleText->GetSize(viewport, size);
    const double right = ScaleRight * view[0];
    const double bottom = ScaleBottom * view[1];
    const ViewportBox at =
      MoveOff(viewport, { right - size[0], right, bottom, bottom + size[1] }, -1, 1);
    d.ScaleText->GetPositionCoordinate()->SetValue(at[1] / view[0], at[2] / view[1]);
    d.ScaleText->RenderOpaqueGeometry(viewport); // renders the text into the texture that is drawn
                                                 // next
    d.ScaleText->RenderOverlay(viewport);
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkHapticRepresentation::ReleaseGraphicsResources(vtkWindow* window)
{
  auto& d = *this->Internals;
  for (SceneMarker& sphere : d.Spheres)
  {
    sphere.Release(window);
  }
  d.Spring.Release(window);
  for (int i = 0; i < 3; ++i)
  {
    d.Arrows[i].Release(window);
    d.SecondHeads[i].Release(window);
  }
  d.Stylus.Release(window);
  d.Needle.Release(window);
  d.Tool.Release(window);
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

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Scene/VolumeCut.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkBoxRepresentation.h"
#include "vtkCamera.h"
#include "vtkCellPicker.h"
#include "vtkImageData.h"
#include "vtkImplicitPlaneRepresentation.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkTransform.h"
#include "vtkVolumeMapper.h"
#include "vtkVolumeProperty.h"
#include "vtkWidgetEvent.h"
#include "vtkWidgetEventTranslator.h"

#include <algorithm>
#include <cmath>

namespace Explore
{
/// A plane whose handles alone respond to the mouse: the ball pushes the plane along its normal,
/// the arrow rotates it. Elsewhere the scene receives the mouse events.
class PlaneHandles : public vtkImplicitPlaneRepresentation
{
public:
  static PlaneHandles* New();
  vtkTypeMacro(PlaneHandles, vtkImplicitPlaneRepresentation);

  int ComputeInteractionState(int x, int y, int modify = 0) override;

protected:
  PlaneHandles();
  ~PlaneHandles() override = default;

private:
  PlaneHandles(const PlaneHandles&) = delete;
  void operator=(const PlaneHandles&) = delete;
};

vtkStandardNewMacro(PlaneHandles);

PlaneHandles::PlaneHandles()
{
  constexpr double pixels = 9.0;
  constexpr double line = 0.85; // brightness of handles that are not grabbed
  this->SetPlaceFactor(1.0);
  this->SetHandleSize(pixels);
  this->SetDrawPlane(0);
  this->SetDrawOutline(0);
  this->SetTubing(0);
  this->OutlineTranslationOff();
  this->ScaleEnabledOff();
  this->SetEdgeColor(line, line, line);
  this->GetEdgesProperty()->SetLineWidth(1.5f);
  this->GetNormalProperty()->SetColor(0.35, 0.65, 0.95);
  this->GetSelectedNormalProperty()->SetColor(1.0, 0.75, 0.2);
  this->Picker->DeletePickList(this->CutActor);
  // Search the pickable parts for the outline, because the name of its accessor differs between
  // versions of VTK.
  vtkPropCollection* const picked = this->Picker->GetPickList();
  for (int i = picked->GetNumberOfItems(); i-- > 0;)
  {
    auto* const actor = vtkActor::SafeDownCast(picked->GetItemAsObject(i));
    if (actor && actor->GetProperty() == this->GetOutlineProperty())
    {
      this->Picker->DeletePickList(actor);
    }
  }
}

int PlaneHandles::ComputeInteractionState(int x, int y, int modify)
{
  if (this->Superclass::ComputeInteractionState(x, y, modify) == MovingOrigin)
  {
    this->InteractionState = Pushing;
    this->SetRepresentationState(Pushing);
  }
  return this->InteractionState;
}
} // namespace Explore

namespace
{
constexpr int KEPT_INSIDE = VTK_CROP_SUBVOLUME;
constexpr int KEPT_OUTSIDE = 0x7ffffff & ~VTK_CROP_SUBVOLUME;

/// Makes a widget respond only to the left button, and only on a handle. The scene receives all
/// other mouse events.
void UseLeftButton(vtkAbstractWidget* widget, vtkRenderer* renderer)
{
  vtkWidgetEventTranslator* const events = widget->GetEventTranslator();
  events->ClearEvents();
  events->SetTranslation(vtkCommand::LeftButtonPressEvent, vtkWidgetEvent::Select);
  events->SetTranslation(vtkCommand::LeftButtonReleaseEvent, vtkWidgetEvent::EndSelect);
  events->SetTranslation(vtkCommand::MouseMoveEvent, vtkWidgetEvent::Move);
  widget->ManagesCursorOff(); // otherwise each motion over a handle would draw a frame
  widget->KeyPressActivationOff();
  widget->SetDefaultRenderer(renderer);
}

/// Computes the bounds of points after a transformation.
void BoundsIn(vtkMatrix4x4* toAxes, vtkPoints* points, vtkIdType count, double bounds[6])
{
  vtkBoundingBox box;
  for (vtkIdType i = 0; i < count; ++i)
  {
    double x[4] = { 0.0, 0.0, 0.0, 1.0 };
    points->GetPoint(i, x);
    toAxes->MultiplyPoint(x, x);
    box.AddPoint(x);
  }
  box.GetBounds(bounds);
}

/// Computes the matrix from the world to coordinates along the axes of an image's data, in which
/// VTK defines cropping regions.
void MakeWorldToData(vtkImageData* image, vtkMatrix4x4* toData)
{
  const double* const origin = image->GetOrigin();
  for (int row = 0; row < 3; ++row)
  {
    double shift = origin[row];
    for (int column = 0; column < 3; ++column)
    {
      // The inverse of the direction matrix is its transpose, because the matrix is orthogonal.
      const double element = image->GetDirectionMatrix()->GetElement(column, row);
      toData->SetElement(row, column, element);
      shift -= element * origin[column];
    }
    toData->SetElement(row, 3, shift);
  }
}
} // namespace

namespace Explore
{
VolumeCut::VolumeCut()
{
  constexpr double pixels = 7.0;
  this->PlaneWidget->SetRepresentation(this->PlaneShape);
  this->BoxShape->SetPlaceFactor(1.0);
  this->BoxShape->SetHandleSize(pixels);
  this->BoxShape->OutlineCursorWiresOff();
  this->BoxShape->GetHandleProperty()->SetColor(0.35, 0.65, 0.95);
  this->BoxShape->GetSelectedHandleProperty()->SetColor(1.0, 0.75, 0.2);
  this->BoxShape->GetSelectedFaceProperty()->SetOpacity(0.1);
  this->BoxShape->GetOutlineProperty()->SetColor(0.85, 0.85, 0.85);
  this->BoxShape->GetOutlineProperty()->SetLineWidth(1.5f);
  this->BoxWidget->SetRepresentation(this->BoxShape);
  this->BoxWidget->RotationEnabledOff();
  this->BoxWidget->ScalingEnabledOff();
  this->DragObserver->SetClientData(this);
  this->DragObserver->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<VolumeCut*>(self)->Apply(); });
  this->PlaneWidget->AddObserver(vtkCommand::InteractionEvent, this->DragObserver);
  this->BoxWidget->AddObserver(vtkCommand::InteractionEvent, this->DragObserver);
}

VolumeCut::~VolumeCut()
{
  this->SetInteractor(nullptr);
}

void VolumeCut::SetScene(vtkVolume* volume, vtkVolumeHapticsFilter* filter, vtkRenderer* handles,
  const double body[6], bool hasRegions)
{
  volume->ComputeMatrix();
  this->Volume = volume;
  this->Filter = filter;
  this->Renderer = handles;
  this->HasBox = hasRegions;
  std::copy(body, body + 6, this->Body);
  UseLeftButton(this->PlaneWidget, handles);
  UseLeftButton(this->BoxWidget, handles);
}

void VolumeCut::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  if (this->Interactor)
  {
    this->PlaneWidget->EnabledOff();
    this->BoxWidget->EnabledOff();
  }
  this->Interactor = interactor;
  this->PlaneWidget->SetInteractor(interactor);
  this->BoxWidget->SetInteractor(interactor);
  if (interactor)
  {
    this->ShowHandles();
  }
}

void VolumeCut::AddCommands(CommandTable& table)
{
  const auto add = [&](const char* text, CutKind kind)
  {
    table.Add(this,
      { "Cut", text, "", [this, kind] { this->SetKind(kind); },
        [this, kind] { return this->Kind == kind; },
        [this, kind] { return kind != CutKind::Box || this->HasBox; } });
  };
  add("no cut", CutKind::None);
  add("by a plane", CutKind::Plane);
  add("by a box", CutKind::Box);
  const auto next = [this]
  {
    this->SetKind(this->Kind == CutKind::None          ? CutKind::Plane
        : this->Kind == CutKind::Plane && this->HasBox ? CutKind::Box
                                                       : CutKind::None);
  };
  table.Add(this, { "Cut", "plane; box; none", "x", next, nullptr, nullptr });
  table.Add(this,
    { "Cut", "swap the kept and the hidden part", "e", [this] { this->TurnOver(); }, nullptr,
      nullptr });
  table.Add(this,
    { "Cut", "feel the cut faces: on; off", "z",
      [this] { this->Filter->SetFeelCutFaces(!this->Filter->GetFeelCutFaces()); },
      [this] { return this->Filter->GetFeelCutFaces() != 0; }, nullptr });
}

void VolumeCut::SetKind(CutKind kind)
{
  vtkAbstractVolumeMapper* const mapper = this->Volume->GetMapper();
  if (this->Kind == CutKind::Plane)
  {
    mapper->RemoveClippingPlane(this->Plane);
    this->Filter->RemoveClippingPlane(this->Plane);
  }
  else if (this->Kind == CutKind::Box)
  {
    vtkVolumeMapper::SafeDownCast(mapper)->CroppingOff();
    this->Filter->CroppingOff();
  }
  this->Kind = kind;
  this->IsTurned = false;
  this->Volume->GetProperty()->SetDisableGradientOpacity(kind == CutKind::None); // see VolumeLook.h
  if (kind == CutKind::Plane)
  {
    this->PlacePlane();
    mapper->AddClippingPlane(this->Plane);
    this->Filter->AddClippingPlane(this->Plane);
  }
  else if (kind == CutKind::Box)
  {
    this->PlaceBox();
  }
  this->Apply();
  this->ShowHandles();
}

void VolumeCut::TurnOver()
{
  if (this->Kind == CutKind::None)
  {
    return; // the key was handled even so; otherwise VTK's own key e would close the window
  }
  if (this->Kind == CutKind::Plane)
  {
    double normal[3];
    this->PlaneShape->GetNormal(normal);
    this->PlaneShape->SetNormal(-normal[0], -normal[1], -normal[2]);
  }
  this->IsTurned = !this->IsTurned;
  this->Apply();
}

void VolumeCut::GetAxis(int axis, double direction[3]) const
{
  for (int row = 0; row < 3; ++row)
  {
    direction[row] = this->Volume->GetMatrix()->GetElement(row, axis);
  }
  vtkMath::Normalize(direction);
}

void VolumeCut::PlacePlane()
{
  double sight[3];
  this->Renderer->GetActiveCamera()->GetDirectionOfProjection(sight);
  double normal[3] = { 0.0, 0.0, 0.0 };
  for (int axis = 0; axis < 3; ++axis)
  {
    double direction[3];
    this->GetAxis(axis, direction);
    if (std::abs(vtkMath::Dot(direction, sight)) > std::abs(vtkMath::Dot(normal, sight)))
    {
      std::copy(direction, direction + 3, normal);
    }
  }
  vtkMath::MultiplyScalar(normal, vtkMath::Dot(normal, sight) < 0.0 ? -1.0 : 1.0);
  double centre[3];
  vtkBoundingBox(this->Body).GetCenter(centre);
  this->PlaneShape->PlaceWidget(this->Body);
  this->PlaneShape->SetOrigin(centre);
  this->PlaneShape->SetNormal(normal);
}

void VolumeCut::PlaceBox()
{
  // margin of the box in front of the body, as a fraction of the body's size
  constexpr double margin = 0.02;
  vtkNew<vtkMatrix4x4> toVolume;
  vtkMatrix4x4::Invert(this->Volume->GetMatrix(), toVolume);
  vtkNew<vtkPoints> corners;
  for (int corner = 0; corner < 8; ++corner)
  {
    corners->InsertNextPoint(
      this->Body[corner & 1], this->Body[2 + (corner >> 1 & 1)], this->Body[4 + (corner >> 2 & 1)]);
  }
  double box[6];
  BoundsIn(toVolume, corners, 8, box);
  double sight[3];
  this->Renderer->GetActiveCamera()->GetDirectionOfProjection(sight);
  for (int axis = 0; axis < 3; ++axis)
  {
    double direction[3];
    this->GetAxis(axis, direction);
    double* const ends = box + 2 * axis;
    const double middle = 0.5 * (ends[0] + ends[1]);
    const double more = margin * (ends[1] - ends[0]);
    const bool isLow = vtkMath::Dot(direction, sight) > 0.0;
    ends[0] = isLow ? ends[0] - more : middle;
    ends[1] = isLow ? middle : ends[1] + more;
  }
  vtkNew<vtkTransform> place;
  place->SetMatrix(this->Volume->GetMatrix());
  this->BoxShape->PlaceWidget(box);
  this->BoxShape->SetTransform(place);
}

void VolumeCut::ShowHandles()
{
  if (this->Interactor)
  {
    this->PlaneWidget->SetEnabled(this->Kind == CutKind::Plane);
    this->BoxWidget->SetEnabled(this->Kind == CutKind::Box);
  }
}

void VolumeCut::Apply()
{
  if (this->Kind == CutKind::Plane)
  {
    this->PlaneShape->GetPlane(this->Plane);
  }
  else if (this->Kind == CutKind::Box)
  {
    this->ApplyBox();
  }
}

void VolumeCut::ApplyBox()
{
  auto* const mapper = vtkVolumeMapper::SafeDownCast(this->Volume->GetMapper());
  vtkImageData* const touched = this->Filter->GetTouchedImage();
  vtkNew<vtkPolyData> box;
  this->BoxShape->GetPolyData(box);
  vtkNew<vtkMatrix4x4> toAxes;
  double planes[6];
  vtkMatrix4x4::Invert(this->Volume->GetMatrix(), toAxes);
  BoundsIn(toAxes, box->GetPoints(), 8, planes);
  const int flags = this->IsTurned ? KEPT_INSIDE : KEPT_OUTSIDE;
  mapper->SetCroppingRegionPlanes(planes);
  mapper->SetCroppingRegionFlags(flags);
  mapper->CroppingOn();
  if (touched)
  {
    toAxes->Identity();
    MakeWorldToData(touched, toAxes);
    BoundsIn(toAxes, box->GetPoints(), 8, planes);
    this->Filter->SetCroppingRegionPlanes(planes);
    this->Filter->SetCroppingRegionFlags(flags);
    this->Filter->CroppingOn();
  }
}

} // namespace Explore

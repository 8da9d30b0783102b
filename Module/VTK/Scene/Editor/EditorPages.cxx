// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/EditorPages.h"

#include "VTK/Scene/Base/HapticPixels.h"

#include "vtkCommand.h"
#include "vtkHapticFunctionEditor.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVariant.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

using Editor = vtkHapticFunctionEditor;

struct EditedPage
{
  EditedQuantity Quantity;
  vtkPiecewiseFunction* (vtkHapticProperty::*Get)();
};

// An empty function means the same as in vtkHapticProperty.
const EditedPage Pages[] = {
  { { "Stiffness (N/m)", 500.0, 1000.0, 1e5 }, &vtkHapticProperty::GetStiffness },
  { { "Friction coefficient", 0.0, 1.0, 10.0 }, &vtkHapticProperty::GetFriction },
  { { "Viscosity (N)", 0.0, 1.0, 100.0 }, &vtkHapticProperty::GetViscosity },
  { { "Surface strength (N)", 2.0, 5.0, 100.0 }, &vtkHapticProperty::GetSurfaceStrength },
  { { "Opacity", 0.0, 1.0, 1.0 }, nullptr },
  { { "Materials of labels", 0.0, 1.0, 1.0 }, nullptr },
  { { "Materials of tissues", 0.0, 1.0, 1.0 }, nullptr },
};

/** The lag (m) at which a drag gives a warning: twice the lag of presets. */
constexpr double LongDrag = 0.01;

/** The value of a function at a position; an empty function is constant. */
double Evaluate(vtkPiecewiseFunction* function, double x, double empty)
{
  return function->GetSize() > 0 ? function->GetValue(x) : empty;
}

/** The nodes of two functions, in ascending order. */
std::vector<double> FindNodes(vtkPiecewiseFunction* a, vtkPiecewiseFunction* b)
{
  std::vector<double> places;
  for (vtkPiecewiseFunction* const function : { a, b })
  {
    for (int i = 0; i < function->GetSize(); ++i)
    {
      double node[4];
      function->GetNodeValue(i, node);
      places.push_back(node[0]);
    }
  }
  std::sort(places.begin(), places.end());
  return places;
}

constexpr int SheetWidth = 270;      // pixels: width of tissues beside a chart
constexpr int LeastChartWidth = 330; // pixels: the least width of the chart beside them
constexpr int LeastSheetHeight = 150;

} // namespace

//------------------------------------------------------------------------------
bool EditorPages::IsSheetPage() const
{
  return this->Page == Editor::LABELS || this->Page == Editor::TISSUES;
}

bool EditorPages::Has(int page) const
{
  switch (page)
  {
    case Editor::OPACITY:
      return this->VolumeProperty != nullptr;
    case Editor::LABELS:
      return this->LabelList.Table != nullptr;
    case Editor::TISSUES:
      return this->TissueList.GetNumberOfRows() > 0;
    default:
      return this->Proposed.Property != nullptr;
  }
}

const char* EditorPages::GetTitle() const
{
  return Pages[this->Page].Quantity.Title;
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* EditorPages::GetFunction() const
{
  if (this->Page == Editor::OPACITY)
  {
    return this->GetEdited().Opacity;
  }
  const auto get = Pages[this->Page].Get;
  return this->Proposed.Property && get ? (this->Proposed.Property.Get()->*get)() : nullptr;
}

//------------------------------------------------------------------------------
EditedObjects EditorPages::GetEdited() const
{
  // Choose it as vtkHapticProperty::SetVisibilityFrom does.
  const int component = this->VolumeProperty && this->VolumeProperty->GetIndependentComponents()
    ? std::min(this->Proposed.GetComponent(), VTK_MAX_VRCOMP - 1)
    : 0;
  return { this->Proposed.Property,
    this->VolumeProperty ? this->VolumeProperty->GetScalarOpacity(component) : nullptr,
    this->LabelList.Table };
}

//------------------------------------------------------------------------------
EditedObjects EditorPages::GetEditable() const
{
  const EditedObjects all = this->GetEdited();
  return this->Page == Editor::LABELS ? EditedObjects{ nullptr, nullptr, all.Labels }
                                      : EditedObjects{ all.Property, all.Opacity, nullptr };
}

//------------------------------------------------------------------------------
std::string EditorPages::FindWarning() const
{
  vtkHapticProperty* const property = this->Proposed.Property;
  if (!property || (this->Page != Editor::STIFFNESS && this->Page != Editor::VISCOSITY))
  {
    return {};
  }
  vtkPiecewiseFunction* const stiffness = property->GetStiffness();
  vtkPiecewiseFunction* const viscosity = property->GetViscosity();
  const auto k = [&](double x)
  { return Evaluate(stiffness, x, Pages[Editor::STIFFNESS].Quantity.EmptyValue); };
  const auto drag = [&](double x)
  { return Evaluate(viscosity, x, Pages[Editor::VISCOSITY].Quantity.EmptyValue); };
  // Noise can read one end of a ramp in place of the other.
  const std::vector<double> places = FindNodes(stiffness, viscosity);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double a = places[i];
    const double b = places[std::min(i + 1, places.size() - 1)];
    const double soft = k(a) < k(b) ? a : b;
    if (std::max(drag(a), drag(b)) > LongDrag * std::max(0.0, k(soft)))
    {
      return "too soft for its drag at " + vtkVariant(soft).ToString();
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void EditorPages::ScaleValues()
{
  // Opacities depend on scalars.
  vtkHapticProperty* const property =
    this->Page == Editor::OPACITY ? nullptr : this->Proposed.Property.Get();
  this->Chart.ScaleValues(property
      ? ValueScale{ property->GetScalarShift() + property->GetFoundShift(),
          property->GetScalarScale() }
      : ValueScale{});
}

//------------------------------------------------------------------------------
vtkMTimeType EditorPages::GetEditTime() const
{
  const EditedObjects objects = this->GetEdited();
  vtkMTimeType time = 0;
  for (vtkObject* const object :
    std::initializer_list<vtkObject*>{ objects.Property, objects.Opacity, objects.Labels })
  {
    time = object ? std::max(time, object->GetMTime()) : time;
  }
  return time;
}

//------------------------------------------------------------------------------
bool EditorPages::IsCounted() const
{
  return this->IsSheetPage()
    ? (this->Page == Editor::TISSUES || this->LabelList.IsCounted())
    : this->Chart.ShowsData(this->Proposed.Image, this->Proposed.GetComponent());
}

void EditorPages::Count()
{
  if (this->Page == Editor::LABELS)
  {
    this->LabelList.Count();
  }
  else if (this->Page != Editor::TISSUES)
  {
    this->Chart.ShowData(this->Proposed.Image, this->Proposed.GetComponent());
  }
}

void EditorPages::FollowCounts()
{
  this->Chart.FollowCount();
  this->LabelList.FollowCount();
}

double EditorPages::GetCountedShare() const
{
  const double counted = this->Page == Editor::LABELS ? this->LabelList.GetCountedShare()
    : this->Page == Editor::TISSUES                   ? 1.0
                                                      : this->Chart.GetCountedShare();
  return std::min(counted, this->Proposed.GetProgress());
}

void EditorPages::EndOtherCounts()
{
  this->Chart.EndCountUnless(this->Proposed.Image);
  this->LabelList.EndOtherCount();
  this->Proposed.EndOtherSearch();
}

//------------------------------------------------------------------------------
HapticMaterialSheet* EditorPages::GetSheet()
{
  return this->Page == Editor::LABELS                ? &this->Labels
    : this->Page == Editor::TISSUES || this->HasBoth ? &this->Tissues
                                                     : nullptr;
}

//------------------------------------------------------------------------------
void EditorPages::Show(const int rectangle[4], bool isDragged, double scale)
{
  const int sheet = ScalePixels(scale, SheetWidth);
  this->HasBoth = !this->IsSheetPage() && this->Has(Editor::TISSUES) &&
    rectangle[2] >= ScalePixels(scale, LeastChartWidth) + sheet &&
    rectangle[3] >= ScalePixels(scale, LeastSheetHeight);
  const int sheetWidth = this->HasBoth ? sheet : this->IsSheetPage() ? rectangle[2] : 0;
  this->Split = rectangle[0] + rectangle[2] - sheetWidth;
  if (HapticMaterialSheet* const shown = this->GetSheet())
  {
    const int place[4] = { this->Split, rectangle[1], sheetWidth, rectangle[3] };
    shown->Place(place, scale);
  }
  if (this->IsSheetPage())
  {
    return;
  }
  const int place[4] = { rectangle[0], rectangle[1], rectangle[2] - sheetWidth, rectangle[3] };
  vtkPiecewiseFunction* const function = this->GetFunction();
  this->Chart.Place(place, scale);
  this->ScaleValues();
  this->Proposed.ShowFunction(Pages[this->Page].Get);
  this->Chart.NoteWarning(this->FindWarning());
  this->Chart.ShowFunction(function, Pages[this->Page].Quantity, isDragged);
  this->Chart.ShowTissues(this->Proposed.Property);
  if (!function)
  {
    this->Chart.ShowNothing(
      this->Page == Editor::OPACITY ? "No volume property to edit" : "No haptic property to edit");
  }
}

//------------------------------------------------------------------------------
std::vector<vtkContextActor*> EditorPages::GetActors()
{
  std::vector<vtkContextActor*> actors;
  if (!this->IsSheetPage())
  {
    actors.push_back(this->Chart.GetActor());
  }
  if (HapticMaterialSheet* const sheet = this->GetSheet())
  {
    actors.push_back(sheet->GetActor());
  }
  return actors;
}

std::vector<vtkContextActor*> EditorPages::GetAllActors()
{
  return { this->Chart.GetActor(), this->Labels.GetActor(), this->Tissues.GetActor() };
}

//------------------------------------------------------------------------------
bool EditorPages::IsOnSheet(int x) const
{
  return this->IsSheetPage() || (this->HasBoth && x >= this->Split);
}

void EditorPages::SendMouse(int event, int button, int x, int y)
{
  if (event == vtkCommand::LeftButtonPressEvent || event == vtkCommand::LeftButtonDoubleClickEvent)
  {
    this->HoldsSheet = this->IsOnSheet(x);
  }
  const bool isHeld = button != 0;
  HapticMaterialSheet* const sheet = this->GetSheet();
  if (sheet && (isHeld ? this->HoldsSheet : this->IsOnSheet(x)))
  {
    sheet->SendMouse(event, button, x, y);
  }
  else if (!this->IsSheetPage())
  {
    this->Chart.SendMouse(event, button, x, y);
  }
}

void EditorPages::Turn(int x, int y, double steps)
{
  HapticMaterialSheet* const sheet = this->GetSheet();
  if (sheet && this->IsOnSheet(x))
  {
    sheet->Turn(x, y, steps);
  }
  else
  {
    this->Chart.Turn(x, y, steps);
  }
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/EditorPages.h"

#include "VTK/Material/HapticProposal.h"
#include "VTK/Scene/Base/HapticChartText.h"
#include "VTK/Scene/Base/HapticHistogram.h"
#include "VTK/Scene/Base/HapticPixels.h"
#include "VTK/Scene/Editor/HapticFunctionChart.h"

#include "vtkCommand.h"
#include "vtkHapticFunctionEditor.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVariant.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{
namespace
{

struct LabelAccess
{
  void (vtkHapticLabelTable::*Set)(int, double);
  double (vtkHapticLabelTable::*Get)(int); ///< getter; -1: the functions determine the value
};

constexpr LabelAccess LabelQuantities[HapticMaterialList::Quantities] = {
  { &vtkHapticLabelTable::SetStiffness, &vtkHapticLabelTable::GetStiffness },
  { &vtkHapticLabelTable::SetFriction, &vtkHapticLabelTable::GetFriction },
  { &vtkHapticLabelTable::SetViscosity, &vtkHapticLabelTable::GetViscosity },
  { &vtkHapticLabelTable::SetSurfaceStrength, &vtkHapticLabelTable::GetSurfaceStrength },
};

using Editor = vtkHapticFunctionEditor;

struct EditedPage
{
  EditedQuantity Quantity;
  vtkPiecewiseFunction* (vtkHapticProperty::*Get)();
};

// For each page: title, value of an empty function (as in vtkHapticProperty), usual and largest top
// of the axis.
const EditedPage Pages[] = {
  { { "Stiffness (N/m)", 500.0, 1000.0, 1e5 }, &vtkHapticProperty::GetStiffness },
  { { "Friction coefficient", 0.0, 1.0, 10.0 }, &vtkHapticProperty::GetFriction },
  { { "Viscosity (N)", 0.0, 1.0, 100.0 }, &vtkHapticProperty::GetViscosity },
  { { "Surface strength (N)", 2.0, 5.0, 100.0 }, &vtkHapticProperty::GetSurfaceStrength },
  { { "Opacity", 0.0, 1.0, 1.0 }, nullptr },
  { { "Materials of labels", 0.0, 1.0, 1.0 }, nullptr },
  { { "Materials of tissues", 0.0, 1.0, 1.0 }, nullptr },
};

/**
 * Largest lag (m) of the proxy without a warning that the drag is too strong: twice the lag of the
 * presets.
 */
constexpr double LongDrag = 0.01;

/** Returns the value of a function at x; `empty` for a function without points. */
double Evaluate(vtkPiecewiseFunction* function, double x, double empty)
{
  return function->GetSize() > 0 ? function->GetValue(x) : empty;
}

/** Returns the positions of the nodes of two functions, in ascending order. */
std::vector<double> CollectNodes(vtkPiecewiseFunction* a, vtkPiecewiseFunction* b)
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

constexpr int SheetWidth = 270;      // pixels: width of the tissues beside a chart
constexpr int LeastChartWidth = 330; // pixels: smallest width of a chart beside the tissues
constexpr int LeastSheetHeight = 150;

} // namespace

//------------------------------------------------------------------------------
bool HapticLabelList::IsCounted() const
{
  return this->Image == this->CountedImage &&
    (!this->Image || this->Image->GetMTime() < this->CountTime);
}

void HapticLabelList::Count()
{
  this->CountedImage = this->Image;
  this->CountTime.Modified();
  this->Counting.Forget();
  this->Present.clear();
  this->Counted = this->Image ? this->Image->GetPointData()->GetScalars() : nullptr;
  if (this->Counted && IsQuicklySwept(this->Counted))
  {
    this->Present = CollectPresentLabels(this->Counted, [](double) { return true; });
    this->Counted = nullptr;
  }
  else if (this->Counted)
  {
    this->Present = CollectSpreadLabels(this->Counted);
    this->PollCount();
  }
}

//------------------------------------------------------------------------------
void HapticLabelList::PollCount()
{
  if (!this->Counted)
  {
    return;
  }
  const vtkSmartPointer<vtkDataArray> labels = this->Counted;
  const std::vector<int>* const present = this->Counting.Poll(this->CountTime.GetMTime(),
    [labels](WorkMonitor& monitor) -> std::optional<std::vector<int>>
    {
      std::vector<int> found = CollectPresentLabels(
        labels, [&monitor](double fraction) { return monitor.GoesOn(fraction); });
      return monitor.IsCancelled() ? std::nullopt : std::optional(std::move(found));
    });
  if (present)
  {
    this->Present = *present;
    this->ScrollTo(this->GetFirstRow());
  }
  if (!this->Counting.IsUnderWay())
  {
    this->Counted = nullptr;
    this->Counting.Forget();
  }
}

//------------------------------------------------------------------------------
void HapticLabelList::EndOtherCount()
{
  if (this->Image != this->CountedImage)
  {
    this->Counting.Forget();
    this->Counted = nullptr;
  }
}

//------------------------------------------------------------------------------
double HapticLabelList::GetCountedFraction() const
{
  return this->Counted ? this->Counting.GetProgress() : 1.0;
}

//------------------------------------------------------------------------------
vtkIdType HapticLabelList::GetNumberOfRows() const
{
  return !this->Table ? 0
    : this->Image     ? static_cast<vtkIdType>(this->Present.size())
                      : this->Table->GetNumberOfLabels();
}

int HapticLabelList::GetKey(vtkIdType row) const
{
  return this->Image ? this->Present[static_cast<std::size_t>(row)] : this->Table->GetLabel(row);
}

vtkObject* HapticLabelList::GetEdited() const
{
  return this->Table;
}

//------------------------------------------------------------------------------
std::string HapticLabelList::GetTitle() const
{
  const vtkIdType labels = this->GetNumberOfRows();
  return labels > 0 ? "Labels (" + std::to_string(labels) + ")" +
      DescribeFraction(this->GetCountedFraction(), "counted")
    : this->Table ? "There are no labels to edit"
                  : "There is no label table to edit";
}

std::array<double, 3> HapticLabelList::GetColor(int label) const
{
  const double* const color = this->Table->GetColor(label);
  return { color[0], color[1], color[2] };
}

//------------------------------------------------------------------------------
bool HapticLabelList::IsFelt(int label) const
{
  return this->Table->GetFelt(label);
}

bool HapticLabelList::IsForbidden(int label) const
{
  return this->Table->GetForbidden(label);
}

void HapticLabelList::ToggleFelt(int label)
{
  this->Table->SetFelt(label, !this->Table->GetFelt(label));
}

void HapticLabelList::ToggleForbidden(int label)
{
  this->Table->SetForbidden(label, !this->Table->GetForbidden(label));
}

//------------------------------------------------------------------------------
bool HapticLabelList::HasMaterial(int label) const
{
  return this->Table->HasMaterial(label);
}

void HapticLabelList::RemoveMaterial(int label)
{
  this->Table->RemoveMaterial(label);
}

//------------------------------------------------------------------------------
double HapticLabelList::ReadValue(int label, int quantity) const
{
  return (this->Table->*LabelQuantities[quantity].Get)(label);
}

void HapticLabelList::WriteValue(int label, int quantity, double value)
{
  (this->Table->*LabelQuantities[quantity].Set)(label, value);
}

//------------------------------------------------------------------------------
std::string HapticLabelList::Describe(int label) const
{
  const std::string name = this->Table->GetLabelName(label);
  return std::to_string(label) + (name.empty() ? "" : " ") + name;
}

/**
 * Returns the property whose edges are shown: the pending proposal, or the edited property if it
 * has an accepted proposal. Returns null if there are no edges.
 */
vtkHapticProperty* HapticProposalView::GetProposed() const
{
  vtkHapticProperty* const any = this->Proposal ? this->Proposal : this->Property;
  return this->Image && any && any->GetProposedBoundaries() ? any : nullptr;
}

/**
 * Returns the data to search for edges. First shows the data's histogram, because it determines the
 * range of values.
 */
SearchedData HapticProposalView::GetSearched()
{
  this->Chart.ShowData(this->Image, this->GetComponent());
  SearchedData data;
  data.Image = this->Image;
  data.Component = this->GetComponent();
  std::copy_n(this->Chart.GetDataRange(), 2, data.Values);
  vtkHapticProperty* const proposed = this->GetProposed();
  data.SlopeScale = proposed ? proposed->GetScalarScale() : 1.0;
  return data;
}

void HapticProposalView::Show(const FoundFunctions& found)
{
  if (found.Proposal)
  {
    this->Proposal = vtkSmartPointer<vtkHapticProperty>::New();
    if (this->Property)
    {
      this->Proposal->SetScalarShift(this->Property->GetScalarShift());
      this->Proposal->SetScalarScale(this->Property->GetScalarScale());
      this->Proposal->NoteShift(this->Property->GetFoundShift());
    }
    FillFromProposal(*found.Proposal, this->Proposal);
    this->Show(found.Edges);
  }
}

void HapticProposalView::Show(const EdgeHistogram& edges)
{
  this->Boundaries = this->GetProposed()->GetProposedBoundaries();
  this->EdgeTime.Modified();
  this->Chart.ShowEdges(edges, this->GetProposed());
}

FoundFunctions HapticProposalView::SearchNow()
{
  this->Search.Drop();
  FoundFunctions found = FunctionSearch::SearchNow(this->GetSearched());
  this->Show(found);
  return found;
}

bool HapticProposalView::Begin(std::string& error)
{
  return this->IsUnderWay() || this->Search.Begin(this->GetSearched(), error);
}

std::optional<FoundFunctions> HapticProposalView::Poll()
{
  if (!this->IsUnderWay())
  {
    return std::nullopt;
  }
  std::optional<FoundFunctions> found = this->Search.Poll(this->GetSearched());
  if (found)
  {
    this->Show(*found);
  }
  return found;
}

bool HapticProposalView::Apply()
{
  const auto proposal = std::exchange(this->Proposal, nullptr);
  const bool isTaken = proposal && this->Property;
  if (isTaken)
  {
    CopyProposal(proposal, this->Property);
  }
  return isTaken;
}

bool HapticProposalView::Drop()
{
  const bool wasThere = std::exchange(this->Proposal, nullptr) != nullptr || this->IsUnderWay();
  if (wasThere)
  {
    this->Search.Drop();
  }
  return wasThere;
}

bool HapticProposalView::ShowsEdges() const
{
  vtkHapticProperty* const proposed = this->GetProposed();
  return proposed ? this->Boundaries == proposed->GetProposedBoundaries() &&
      this->EdgeTime > this->Image->GetMTime()
                  : !this->Chart.ShowsEdges();
}

void HapticProposalView::PollEdges()
{
  if (this->ShowsEdges())
  {
    return;
  }
  vtkHapticProperty* const proposed = this->GetProposed();
  if (!proposed)
  {
    this->Boundaries = nullptr;
    this->Chart.HideEdges();
  }
  else if (const EdgeHistogram* const edges = this->Search.PollEdges(this->GetSearched(),
             proposed->GetProposedBoundaries(), proposed->GetProposedKernelRadius()))
  {
    this->Show(*edges);
  }
}

void HapticProposalView::ShowFunction(vtkPiecewiseFunction* (vtkHapticProperty::*get)())
{
  this->Chart.ShowSearch(this->GetProgress());
  this->Chart.ShowProposed(this->Proposal && get ? (this->Proposal.Get()->*get)() : nullptr);
  if (vtkHapticProperty* const felt = this->GetProposed())
  {
    const double* const range = felt->GetDistinctness()->GetRange();
    const double scale = felt->GetScalarScale();
    this->Chart.ShowDistinctness(range[0] / scale, range[1] / scale);
  }
}

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
  // Choose the component in the same way as vtkHapticProperty::SetVisibilityFrom.
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
std::string EditorPages::GetWarning() const
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
  // Compare the larger drag with the smaller stiffness of both ends of a ramp, because noise can
  // give a voxel on it the value of either end.
  const std::vector<double> places = CollectNodes(stiffness, viscosity);
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
  // Show unscaled scalars for an opacity function, because they are its argument.
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

void EditorPages::PollCounts()
{
  this->Chart.PollCount();
  this->LabelList.PollCount();
}

double EditorPages::GetCountedFraction() const
{
  const double counted = this->Page == Editor::LABELS ? this->LabelList.GetCountedFraction()
    : this->Page == Editor::TISSUES                   ? 1.0
                                                      : this->Chart.GetCountedFraction();
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
  this->Chart.ShowWarning(this->GetWarning());
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

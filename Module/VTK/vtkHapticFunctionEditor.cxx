// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticFunctionEditor.h"

#include "VTK/Charts/HapticDrawing.h"
#include "VTK/Charts/HapticFunctionChart.h"
#include "VTK/Charts/HapticLabelSheet.h"
#include "VTK/Charts/HapticProposalView.h"

#include "vtkCommand.h"
#include "vtkContextDevice2D.h"
#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <algorithm>

vtkStandardNewMacro(vtkHapticFunctionEditor);

namespace
{

using VolumeHaptics::EditedQuantity;

struct Choice
{
  EditedQuantity Quantity;
  vtkPiecewiseFunction* (vtkHapticProperty::*Get)();
};

// An empty function means the same as in vtkHapticProperty.
const Choice Choices[] = {
  { { "Stiffness (N/m)", 500.0, 1000.0, 1e5 }, &vtkHapticProperty::GetStiffness },
  { { "Friction coefficient", 0.0, 1.0, 10.0 }, &vtkHapticProperty::GetFriction },
  { { "Viscosity (N)", 0.0, 1.0, 100.0 }, &vtkHapticProperty::GetViscosity },
  { { "Surface strength (N)", 2.0, 5.0, 100.0 }, &vtkHapticProperty::GetSurfaceStrength },
  { { "Opacity", 0.0, 1.0, 1.0 }, nullptr },
  { { "Materials of labels", 0.0, 1.0, 1.0 }, nullptr },
};

} // namespace

//------------------------------------------------------------------------------
struct vtkHapticFunctionEditor::vtkInternals
{
  vtkSmartPointer<vtkVolumeProperty> VolumeProperty;
  vtkWeakPointer<vtkRenderer> Renderer; // that shows the editor
  VolumeHaptics::HapticFunctionChart Chart;
  VolumeHaptics::HapticProposalView Proposed{ Chart };
  VolumeHaptics::HapticLabelSheet Labels;
  int Held = 0;     // the button, between press and release
  int CanDraw = -1; // not known yet
  bool IsCounting = false;
  bool WaitsForProposal = false;

  /** No work goes on with an image that was taken away. */
  void EndOtherCounts()
  {
    this->Chart.EndCountUnless(this->Proposed.Image);
    this->Labels.List.EndOtherCount();
    this->Proposed.EndOtherSearch();
  }

  /** From the display to the viewport. */
  void ToViewport(int& x, int& y) const
  {
    if (this->Renderer)
    {
      const int* const origin = this->Renderer->GetOrigin();
      x -= origin[0];
      y -= origin[1];
    }
  }

  /** From the viewport to the display. */
  void ToDisplay(double position[2]) const
  {
    int origin[2] = { 0, 0 };
    this->ToViewport(origin[0], origin[1]);
    position[0] -= origin[0];
    position[1] -= origin[1];
  }

  /**
   * Does work of the editor between StartEvent and EndEvent. Observers may render meanwhile, which
   * shows the chart as it is, and may release the editor.
   */
  template <typename WorkType>
  void DoLongWork(vtkHapticFunctionEditor* editor, const WorkType& work)
  {
    const vtkSmartPointer<vtkHapticFunctionEditor> self(editor);
    this->IsCounting = true;
    editor->InvokeEvent(vtkCommand::StartEvent);
    work();
    this->IsCounting = false;
    editor->InvokeEvent(vtkCommand::EndEvent);
  }
};

//------------------------------------------------------------------------------
vtkHapticFunctionEditor::vtkHapticFunctionEditor()
  : Internals(new vtkInternals)
{
}

vtkHapticFunctionEditor::~vtkHapticFunctionEditor() = default;

//------------------------------------------------------------------------------
#define vtkHapticEditorObjectMacro(name, type, member)  \
  void vtkHapticFunctionEditor::Set##name(type* object) \
  {                                                     \
    if (this->Internals->member != object)              \
    {                                                   \
      this->Internals->member = object;                 \
      this->Internals->EndOtherCounts();                \
      this->Modified();                                 \
    }                                                   \
  }                                                     \
  type* vtkHapticFunctionEditor::Get##name()            \
  {                                                     \
    return this->Internals->member;                     \
  }

vtkHapticEditorObjectMacro(Property, vtkHapticProperty, Proposed.Property);
vtkHapticEditorObjectMacro(VolumeProperty, vtkVolumeProperty, VolumeProperty);
vtkHapticEditorObjectMacro(InputData, vtkImageData, Proposed.Image);
vtkHapticEditorObjectMacro(LabelTable, vtkHapticLabelTable, Labels.List.Table);
vtkHapticEditorObjectMacro(LabelData, vtkImageData, Labels.List.Image);

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::SetFunction(int function)
{
  const int valid = std::clamp<int>(function, STIFFNESS, LABELS);
  if (valid != this->Function)
  {
    this->Function = valid;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::NextFunction()
{
  const int before = this->Function;
  do
  {
    this->SetFunction(this->Function == LABELS ? STIFFNESS : this->Function + 1);
  } while (this->Function != before && !this->GetPiecewiseFunction() &&
    !(this->Function == LABELS && this->GetLabelTable()));
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::SetRectangle(int x, int y, int width, int height)
{
  constexpr int most = 16384; // as wide as a texture may be, and any display is
  const int rectangle[4] = { std::clamp(x, -most, most), std::clamp(y, -most, most),
    std::clamp(width, 1, most), std::clamp(height, 1, most) };
  if (!std::equal(rectangle, rectangle + 4, this->Rectangle))
  {
    std::copy(rectangle, rectangle + 4, this->Rectangle);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::SetRectangle(const int rectangle[4])
{
  if (!rectangle)
  {
    vtkErrorMacro("Rectangle needs four numbers, but got a null pointer; it stays as it was.");
    return;
  }
  this->SetRectangle(rectangle[0], rectangle[1], rectangle[2], rectangle[3]);
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticFunctionEditor::GetNumberOfListedLabels()
{
  VolumeHaptics::HapticLabelList& list = this->Internals->Labels.List;
  if (!list.IsCounted())
  {
    list.Count();
  }
  return list.GetNumberOfLabels();
}

//------------------------------------------------------------------------------
int vtkHapticFunctionEditor::GetListedLabel(vtkIdType index)
{
  const vtkIdType labels = this->GetNumberOfListedLabels();
  if (index < 0 || index >= labels)
  {
    vtkErrorMacro(<< "There is no label with the index " << index << " in a list of " << labels
                  << " labels.");
    return 0;
  }
  return this->Internals->Labels.List.GetLabel(index);
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::SelectLabel(int label)
{
  return this->GetNumberOfListedLabels() > 0 && this->Internals->Labels.List.Select(label);
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::HasSelectedLabel()
{
  return this->GetNumberOfListedLabels() > 0 &&
    this->Internals->Labels.List.GetSelected().has_value();
}

//------------------------------------------------------------------------------
int vtkHapticFunctionEditor::GetSelectedLabel()
{
  return this->HasSelectedLabel() ? *this->Internals->Labels.List.GetSelected() : 0;
}

//------------------------------------------------------------------------------
std::string vtkHapticFunctionEditor::GetTitle()
{
  return Choices[this->Function].Quantity.Title;
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticFunctionEditor::GetPiecewiseFunction()
{
  auto& d = *this->Internals;
  if (this->Function == OPACITY)
  {
    // As vtkHapticProperty::SetVisibilityFrom chooses it.
    const int component = d.VolumeProperty && d.VolumeProperty->GetIndependentComponents()
      ? std::min(d.Proposed.GetComponent(), VTK_MAX_VRCOMP - 1)
      : 0;
    return d.VolumeProperty ? d.VolumeProperty->GetScalarOpacity(component) : nullptr;
  }
  const auto get = Choices[this->Function].Get;
  return d.Proposed.Property && get ? (d.Proposed.Property.Get()->*get)() : nullptr;
}

//------------------------------------------------------------------------------
double vtkHapticFunctionEditor::EstimateUpdateTime()
{
  constexpr double proposing = 1.0; // s, measured on a desktop computer of 2023
  return this->Internals->WaitsForProposal ? proposing : 0.0;
}

//------------------------------------------------------------------------------
double vtkHapticFunctionEditor::GetCountedShare()
{
  const auto& d = *this->Internals;
  const double counted =
    this->Function == LABELS ? d.Labels.List.GetCountedShare() : d.Chart.GetCountedShare();
  return std::min(counted, d.Proposed.GetProgress());
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::CanPropose()
{
  const auto& d = *this->Internals;
  const bool isComplete = d.Proposed.Property && d.Proposed.Image && !d.IsCounting;
  if (!isComplete)
  {
    vtkErrorMacro("There is nothing to propose functions from: call SetProperty and SetInputData.");
  }
  return isComplete;
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::Propose()
{
  auto& d = *this->Internals;
  if (!this->CanPropose())
  {
    return false;
  }
  const vtkSmartPointer<vtkHapticFunctionEditor> self(this); // observers may release it
  VolumeHaptics::FoundFunctions found;
  d.WaitsForProposal = true;
  d.DoLongWork(this,
    [&]
    {
      found = d.Proposed.FindNow();
      if (found.Proposal)
      {
        this->Modified();
      }
      d.WaitsForProposal = false;
    });
  if (!found.Proposal)
  {
    vtkErrorMacro(<< found.Error);
  }
  return found.Proposal.has_value();
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::BeginProposal()
{
  auto& d = *this->Internals;
  if (!this->CanPropose())
  {
    return false;
  }
  std::string error;
  if (!d.Proposed.Begin(error))
  {
    vtkErrorMacro(<< error);
    return false;
  }
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::IsProposing()
{
  return this->Internals->Proposed.IsUnderWay();
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::FollowProposal()
{
  if (const auto found = this->Internals->Proposed.Follow())
  {
    this->Modified();
    if (!found->Proposal)
    {
      vtkErrorMacro(<< found->Error);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::HasProposal()
{
  return this->Internals->Proposed.IsThere();
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::TakeProposal()
{
  const bool isTaken = this->Internals->Proposed.Take();
  if (isTaken)
  {
    this->Modified();
    this->InvokeEvent(vtkCommand::InteractionEvent);
  }
  return isTaken;
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::DropProposal()
{
  const bool wasThere = this->Internals->Proposed.Drop();
  if (wasThere)
  {
    this->Modified();
  }
  return wasThere;
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::Update()
{
  auto& d = *this->Internals;
  if (d.IsCounting)
  {
    return;
  }
  d.Chart.FollowCount();
  d.Labels.List.FollowCount();
  if (this->Function == LABELS)
  {
    if (!d.Labels.List.IsCounted())
    {
      d.DoLongWork(this, [&d] { d.Labels.List.Count(); });
    }
  }
  else if (!d.Chart.ShowsData(d.Proposed.Image, d.Proposed.GetComponent()))
  {
    d.DoLongWork(this, [&d] { d.Chart.ShowData(d.Proposed.Image, d.Proposed.GetComponent()); });
  }
  this->FollowProposal();
  d.Proposed.FollowEdges();
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::UpdateChart()
{
  auto& d = *this->Internals;
  this->Update();
  if (this->Function == LABELS)
  {
    d.Labels.Place(this->Rectangle);
    return;
  }
  vtkPiecewiseFunction* const function = this->GetPiecewiseFunction();
  d.Chart.Place(this->Rectangle);
  d.Proposed.ShowFunction(Choices[this->Function].Get);
  d.Chart.ShowFunction(function, Choices[this->Function].Quantity, d.Held != 0);
  if (!function)
  {
    d.Chart.ShowNothing(
      this->Function == OPACITY ? "No volume property to edit" : "No haptic property to edit");
  }
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::Contains(int x, int y)
{
  this->Internals->ToViewport(x, y);
  const int* const r = this->Rectangle;
  return this->GetVisibility() && x >= r[0] && x < r[0] + r[2] && y >= r[1] && y < r[1] + r[3];
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::Send(int event, int button, int x, int y)
{
  auto& d = *this->Internals;
  const bool starts =
    event == vtkCommand::LeftButtonPressEvent || event == vtkCommand::LeftButtonDoubleClickEvent;
  if (d.Held == 0 ? !this->Contains(x, y) : starts && d.Held != button)
  {
    return d.Held != 0; // a second button during a drag is taken, and does nothing
  }
  if (event == vtkCommand::LeftButtonReleaseEvent && d.Held != button)
  {
    return d.Held != 0;
  }
  this->UpdateChart();
  vtkObject* const edited = this->Function == LABELS
    ? static_cast<vtkObject*>(this->GetLabelTable())
    : this->GetPiecewiseFunction();
  const vtkMTimeType before = edited ? edited->GetMTime() : 0;
  d.ToViewport(x, y);
  d.Held = starts ? button : d.Held;
  const int sent = event == vtkCommand::MouseMoveEvent ? d.Held : button;
  if (this->Function == LABELS)
  {
    d.Labels.SendMouse(event, sent, x, y);
  }
  else
  {
    d.Chart.SendMouse(event, sent, x, y);
  }
  d.Held = event == vtkCommand::LeftButtonReleaseEvent ? 0 : d.Held;
  if (edited && edited->GetMTime() > before)
  {
    this->InvokeEvent(vtkCommand::InteractionEvent);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::TurnWheel(double steps, int x, int y)
{
  auto& d = *this->Internals;
  if (this->Function != LABELS || !this->Contains(x, y))
  {
    return false;
  }
  this->UpdateChart();
  if (vtkHapticLabelTable* const table = d.Labels.List.Table)
  {
    const vtkMTimeType before = table->GetMTime();
    d.ToViewport(x, y);
    d.Labels.Turn(x, y, steps);
    if (table->GetMTime() > before)
    {
      this->InvokeEvent(vtkCommand::InteractionEvent);
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::MouseMove(int x, int y)
{
  return this->Send(vtkCommand::MouseMoveEvent, 0, x, y);
}

bool vtkHapticFunctionEditor::ButtonPress(int button, int x, int y)
{
  return this->Send(vtkCommand::LeftButtonPressEvent, button, x, y);
}

bool vtkHapticFunctionEditor::ButtonRelease(int button, int x, int y)
{
  return this->Send(vtkCommand::LeftButtonReleaseEvent, button, x, y);
}

bool vtkHapticFunctionEditor::DoubleClick(int button, int x, int y)
{
  return this->Send(vtkCommand::LeftButtonDoubleClickEvent, button, x, y);
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::GetDisplayPosition(
  double value, double functionValue, double position[2])
{
  if (!position)
  {
    vtkErrorMacro("GetDisplayPosition() needs an array of two numbers, but got a null pointer.");
    return;
  }
  this->Internals->Chart.GetPosition(value, functionValue, position);
  this->Internals->ToDisplay(position);
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::GetLabelPosition(int label, int part, double position[2])
{
  using VolumeHaptics::LabelPart;
  const auto& d = *this->Internals;
  const auto kind = part == LABEL_NAME ? LabelPart::Name
    : part == LABEL_FELT               ? LabelPart::Felt
                                       : LabelPart::Forbidden;
  const bool isShown = position && d.Labels.GetLabelPosition(label, kind, position);
  if (isShown)
  {
    d.ToDisplay(position);
  }
  return isShown;
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::GetSliderPosition(int function, double value, double position[2])
{
  const auto& d = *this->Internals;
  const bool isShown = position && function >= STIFFNESS && function <= SURFACE_STRENGTH &&
    d.Labels.GetSliderPosition(function, value, position);
  if (isShown)
  {
    d.ToDisplay(position);
  }
  return isShown;
}

//------------------------------------------------------------------------------
int vtkHapticFunctionEditor::RenderOverlay(vtkViewport* viewport)
{
  auto& d = *this->Internals;
  if (!VolumeHaptics::IsDrawing(viewport))
  {
    return 0;
  }
  d.Renderer = vtkRenderer::SafeDownCast(viewport);
  if (d.CanDraw == -1)
  {
    // A chart that has no device to draw on would crash.
    const auto device = vtkSmartPointer<vtkContextDevice2D>::Take(vtkContextDevice2D::New());
    d.CanDraw = device ? 1 : 0;
    if (!device)
    {
      vtkErrorMacro(
        "VTK has nothing to draw charts with. Link VTK::RenderingContextOpenGL2, with "
        "vtk_module_autoinit, or in Python import vtkmodules.vtkRenderingContextOpenGL2.");
    }
  }
  if (d.CanDraw == 0)
  {
    return 0;
  }
  this->UpdateChart();
  vtkContextActor* const shown =
    this->Function == LABELS ? d.Labels.GetActor() : d.Chart.GetActor();
  return shown->RenderOverlay(viewport);
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Chart.GetActor()->ReleaseGraphicsResources(window);
  this->Internals->Labels.GetActor()->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto& d = *this->Internals;
  os << indent << "Property: " << d.Proposed.Property.Get() << "\n";
  os << indent << "VolumeProperty: " << d.VolumeProperty.Get() << "\n";
  os << indent << "InputData: " << d.Proposed.Image.Get() << "\n";
  os << indent << "LabelTable: " << d.Labels.List.Table.Get() << "\n";
  os << indent << "LabelData: " << d.Labels.List.Image.Get() << "\n";
  os << indent << "Proposal: " << (d.Proposed.IsThere() ? "to be taken" : "(none)") << "\n";
  os << indent << "Function: " << this->GetTitle() << "\n";
  os << indent << "Rectangle: " << this->Rectangle[0] << ", " << this->Rectangle[1] << ", "
     << this->Rectangle[2] << ", " << this->Rectangle[3] << "\n";
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticFunctionEditor.h"

#include "VTK/Scene/Base/HapticDrawing.h"
#include "VTK/Scene/Base/HapticPixels.h"
#include "VTK/Scene/Editor/EditHistory.h"
#include "VTK/Scene/Editor/EditorDock.h"
#include "VTK/Scene/Editor/EditorPages.h"
#include "VTK/Scene/Editor/EditorProbe.h"
#include "VTK/Scene/Editor/HapticEditorSettings.h"

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

#include <algorithm>
#include <optional>
#include <vector>

vtkStandardNewMacro(vtkHapticFunctionEditor);

using namespace VolumeHaptics;

//------------------------------------------------------------------------------
struct vtkHapticFunctionEditor::vtkInternals
{
  explicit vtkInternals(vtkHapticFunctionEditor* editor)
    : Dock(editor, [editor](vtkViewport* viewport) { return editor->Draw(viewport); })
  {
  }

  EditorPages Pages;
  EditHistory History;
  EditorDock Dock;
  int Held = 0;       // pressed button; 0 if none
  int CanDraw = -1;   // 1 if charts can be drawn, 0 if not, -1 if not known yet
  double Scale = 1.0; // pixels per point
  bool IsCounting = false;
  bool WaitsForProposal = false;

  /** Returns the list of labels, after updating it to the current image. */
  HapticLabelList& CountLabels()
  {
    if (!this->Pages.LabelList.IsCounted())
    {
      this->Pages.LabelList.Count();
    }
    return this->Pages.LabelList;
  }

  /**
   * Runs work of the editor between StartEvent and EndEvent. Observers of these events may render,
   * which shows the chart without the work's results, and may release the editor.
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
  : Internals(new vtkInternals(this))
{
}

vtkHapticFunctionEditor::~vtkHapticFunctionEditor() = default;

//------------------------------------------------------------------------------
// Defines the setter of an object. Setting another object clears its edits by `forget`; images have
// no edits.
#define vtkHapticEditorObjectMacro(name, type, member, forget) \
  void vtkHapticFunctionEditor::Set##name(type* object)        \
  {                                                            \
    if (this->Internals->Pages.member != object)               \
    {                                                          \
      this->Internals->Pages.member = object;                  \
      this->Internals->Pages.EndOtherCounts();                 \
      forget;                                                  \
      this->Modified();                                        \
    }                                                          \
  }                                                            \
  type* vtkHapticFunctionEditor::Get##name()                   \
  {                                                            \
    return this->Internals->Pages.member;                      \
  }

vtkHapticEditorObjectMacro(
  Property, vtkHapticProperty, Proposed.Property, this->Internals->History.Forget());
vtkHapticEditorObjectMacro(
  VolumeProperty, vtkVolumeProperty, VolumeProperty, this->Internals->History.Forget());
vtkHapticEditorObjectMacro(
  LabelTable, vtkHapticLabelTable, LabelList.Table, this->Internals->History.Forget());
vtkHapticEditorObjectMacro(InputData, vtkImageData, Proposed.Image, );
vtkHapticEditorObjectMacro(LabelData, vtkImageData, LabelList.Image, );

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::SetFunction(int function)
{
  const int valid = std::clamp<int>(function, STIFFNESS, TISSUES);
  if (valid != this->Function)
  {
    this->Function = valid;
    this->Internals->Pages.SetPage(valid);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::NextFunction()
{
  const int before = this->Function;
  do
  {
    this->SetFunction(this->Function == TISSUES ? STIFFNESS : this->Function + 1);
  } while (this->Function != before && !this->Internals->Pages.Has(this->Function));
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::SetRectangle(int x, int y, int width, int height)
{
  constexpr int most = 16384; // largest texture; no display is wider
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
bool vtkHapticFunctionEditor::SelectLabel(int label)
{
  HapticLabelList& list = this->Internals->CountLabels();
  return list.GetNumberOfRows() > 0 && list.Select(label);
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::TakeBack(bool hasChanged)
{
  if (hasChanged)
  {
    this->Modified();
    this->InvokeEvent(vtkCommand::InteractionEvent);
  }
  return hasChanged;
}

bool vtkHapticFunctionEditor::Undo()
{
  auto& d = *this->Internals;
  return this->TakeBack(d.Held == 0 && d.History.Undo(d.Pages.GetEdited()));
}

bool vtkHapticFunctionEditor::Redo()
{
  auto& d = *this->Internals;
  return this->TakeBack(d.Held == 0 && d.History.Redo(d.Pages.GetEdited()));
}

bool vtkHapticFunctionEditor::Reset()
{
  auto& d = *this->Internals;
  return this->TakeBack(d.Held == 0 && d.History.Reset(d.Pages.GetEdited()));
}

//------------------------------------------------------------------------------
std::string vtkHapticFunctionEditor::GetTitle()
{
  return this->Internals->Pages.GetTitle();
}

//------------------------------------------------------------------------------
std::string vtkHapticFunctionEditor::GetWarning()
{
  return this->Internals->Pages.GetWarning();
}

//------------------------------------------------------------------------------
vtkPiecewiseFunction* vtkHapticFunctionEditor::GetPiecewiseFunction()
{
  return this->Internals->Pages.GetFunction();
}

//------------------------------------------------------------------------------
double vtkHapticFunctionEditor::EstimateUpdateTime()
{
  constexpr double proposing = 1.0; // s: time of Propose() on a desktop computer of 2023
  return this->Internals->WaitsForProposal ? proposing : 0.0;
}

//------------------------------------------------------------------------------
double vtkHapticFunctionEditor::GetCountedFraction()
{
  return this->Internals->Pages.GetCountedFraction();
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::CanPropose()
{
  const auto& d = *this->Internals;
  const bool isComplete = d.Pages.Proposed.Property && d.Pages.Proposed.Image && !d.IsCounting;
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
  // Keep a reference, because observers may release the editor.
  const vtkSmartPointer<vtkHapticFunctionEditor> self(this);
  FoundFunctions found;
  d.WaitsForProposal = true;
  d.DoLongWork(this,
    [&]
    {
      found = d.Pages.Proposed.SearchNow();
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
  if (!d.Pages.Proposed.Begin(error))
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
  return this->Internals->Pages.Proposed.IsUnderWay();
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::PollProposal()
{
  if (const auto found = this->Internals->Pages.Proposed.Poll())
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
  return this->Internals->Pages.Proposed.IsThere();
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::TakeProposal()
{
  auto& d = *this->Internals;
  const bool isDragging = d.Held != 0;
  if (isDragging)
  {
    d.History.End(d.Pages.GetEdited()); // records the drag so far as a separate step
  }
  d.History.Begin({ d.Pages.Proposed.Property, nullptr, nullptr });
  const bool isTaken = d.Pages.Proposed.Apply();
  d.History.End(d.Pages.GetEdited());
  if (isDragging)
  {
    d.History.Begin(d.Pages.GetEditable());
  }
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
  const bool wasThere = this->Internals->Pages.Proposed.Drop();
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
  d.Pages.PollCounts();
  if (!d.Pages.IsCounted())
  {
    d.DoLongWork(this, [&d] { d.Pages.Count(); });
  }
  this->PollProposal();
  d.Pages.Proposed.PollEdges();
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::UpdatePage()
{
  auto& d = *this->Internals;
  this->Update();
  d.Pages.Show(d.Dock.GetRectangle().data(), d.Held != 0, d.Scale);
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::Contains(int x, int y)
{
  return this->Internals->Dock.Contains(x, y);
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::Send(int event, int button, int x, int y)
{
  auto& d = *this->Internals;
  if (d.Dock.MoveBorder(event, button == LEFT_BUTTON, d.Held == 0, x, y))
  {
    return true;
  }
  const bool starts =
    event == vtkCommand::LeftButtonPressEvent || event == vtkCommand::LeftButtonDoubleClickEvent;
  if (d.Held == 0 ? !this->Contains(x, y) : starts && d.Held != button)
  {
    return d.Held != 0; // during a drag, a second button is ignored, but its event counts as used
  }
  const bool ends = event == vtkCommand::LeftButtonReleaseEvent;
  if (ends && d.Held != button)
  {
    return d.Held != 0;
  }
  this->UpdatePage();
  if (starts)
  {
    d.History.Begin(d.Pages.GetEditable());
  }
  const vtkMTimeType before = d.Pages.GetEditTime();
  d.Dock.ToViewport(x, y);
  d.Held = starts ? button : d.Held;
  const int sent = event == vtkCommand::MouseMoveEvent ? d.Held : button;
  d.Pages.SendMouse(event, sent, x, y);
  d.Held = ends ? 0 : d.Held;
  if (ends)
  {
    d.History.End(d.Pages.GetEdited());
  }
  if (d.Pages.GetEditTime() > before)
  {
    this->InvokeEvent(vtkCommand::InteractionEvent);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::TurnWheel(double steps, int x, int y)
{
  auto& d = *this->Internals;
  if (!this->Contains(x, y))
  {
    return false;
  }
  this->UpdatePage();
  d.Dock.ToViewport(x, y);
  if (d.Held != 0)
  {
    return true;
  }
  d.History.Begin(d.Pages.GetEditable());
  const vtkMTimeType before = d.Pages.GetEditTime();
  d.Pages.Turn(x, y, steps);
  d.History.End(d.Pages.GetEdited());
  if (d.Pages.GetEditTime() > before)
  {
    this->InvokeEvent(vtkCommand::InteractionEvent);
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
std::vector<int> EditorProbe::ListLabels(vtkHapticFunctionEditor* editor)
{
  HapticLabelList& list = editor->Internals->CountLabels();
  std::vector<int> labels(static_cast<std::size_t>(list.GetNumberOfRows()));
  vtkIdType row = 0;
  std::generate(labels.begin(), labels.end(), [&] { return list.GetKey(row++); });
  return labels;
}

std::optional<int> EditorProbe::GetSelectedLabel(vtkHapticFunctionEditor* editor)
{
  HapticLabelList& list = editor->Internals->CountLabels();
  return list.GetNumberOfRows() > 0 ? list.GetSelected() : std::nullopt;
}

std::optional<int> EditorProbe::GetSelectedTissue(vtkHapticFunctionEditor* editor)
{
  return editor->Internals->Pages.TissueList.GetSelected();
}

bool EditorProbe::SelectTissue(vtkHapticFunctionEditor* editor, int tissue)
{
  return editor->Internals->Pages.TissueList.Select(tissue);
}

//------------------------------------------------------------------------------
void EditorProbe::GetPosition(
  vtkHapticFunctionEditor* editor, double value, double functionValue, double position[2])
{
  editor->Internals->Pages.Chart.GetPosition(value, functionValue, position);
  editor->Internals->Dock.ToDisplay(position);
}

bool EditorProbe::GetLabelPosition(
  vtkHapticFunctionEditor* editor, int label, LabelPart part, double position[2])
{
  auto& d = *editor->Internals;
  const auto kind = part == LabelName ? MaterialPart::Name
    : part == LabelFelt               ? MaterialPart::Felt
                                      : MaterialPart::Forbidden;
  const bool isShown = d.Pages.GetLabels().GetRowPosition(label, kind, position);
  if (isShown)
  {
    d.Dock.ToDisplay(position);
  }
  return isShown;
}

bool EditorProbe::GetTissuePosition(vtkHapticFunctionEditor* editor, int tissue, double position[2])
{
  auto& d = *editor->Internals;
  const bool isShown = d.Pages.GetSheet() == &d.Pages.GetTissues() &&
    d.Pages.GetTissues().GetRowPosition(tissue, MaterialPart::Name, position);
  if (isShown)
  {
    d.Dock.ToDisplay(position);
  }
  return isShown;
}

bool EditorProbe::GetSliderPosition(
  vtkHapticFunctionEditor* editor, int function, double value, double position[2])
{
  auto& d = *editor->Internals;
  const HapticMaterialSheet* const sheet = d.Pages.GetSheet();
  const bool isShown = sheet && sheet->GetSliderPosition(function, value, position);
  if (isShown)
  {
    d.Dock.ToDisplay(position);
  }
  return isShown;
}

//------------------------------------------------------------------------------
int vtkHapticFunctionEditor::RenderOverlay(vtkViewport* viewport)
{
  auto& d = *this->Internals;
  d.Dock.SetHost(vtkRenderer::SafeDownCast(viewport));
  return d.Dock.IsTaken() ? 0 : this->Draw(viewport);
}

//------------------------------------------------------------------------------
int vtkHapticFunctionEditor::Draw(vtkViewport* viewport)
{
  auto& d = *this->Internals;
  if (!IsDrawing(viewport))
  {
    return 0;
  }
  if (d.CanDraw == -1)
  {
    // Check first whether a class can draw charts: without one, a chart crashes.
    const auto device = vtkSmartPointer<vtkContextDevice2D>::Take(vtkContextDevice2D::New());
    d.CanDraw = device ? 1 : 0;
    if (!device)
    {
      vtkErrorMacro(
        "VTK has no back end that draws charts. Link VTK::RenderingContextOpenGL2, with "
        "vtk_module_autoinit, and include vtkRenderingContext2DModule.h in a source; or in Python "
        "import vtkmodules.vtkRenderingContextOpenGL2.");
    }
  }
  if (d.CanDraw == 0)
  {
    return 0;
  }
  d.Scale = PixelsPerPoint(viewport);
  this->UpdatePage();
  int drawn = 0;
  for (vtkContextActor* const actor : d.Pages.GetActors())
  {
    drawn += actor->RenderOverlay(viewport);
  }
  return drawn;
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::ReleaseGraphicsResources(vtkWindow* window)
{
  for (vtkContextActor* const actor : this->Internals->Pages.GetAllActors())
  {
    actor->ReleaseGraphicsResources(window);
  }
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto& d = *this->Internals;
  os << indent << "Property: " << d.Pages.Proposed.Property.Get() << "\n";
  os << indent << "VolumeProperty: " << d.Pages.VolumeProperty.Get() << "\n";
  os << indent << "InputData: " << d.Pages.Proposed.Image.Get() << "\n";
  os << indent << "LabelTable: " << d.Pages.LabelList.Table.Get() << "\n";
  os << indent << "LabelData: " << d.Pages.LabelList.Image.Get() << "\n";
  os << indent << "Proposal: " << (d.Pages.Proposed.IsThere() ? "to be taken" : "(none)") << "\n";
  os << indent << "Function: " << this->GetTitle() << "\n";
  os << indent << "Rectangle: " << this->Rectangle[0] << ", " << this->Rectangle[1] << ", "
     << this->Rectangle[2] << ", " << this->Rectangle[3] << "\n";
  PrintSettings(os, indent, this, EditorSettings);
}

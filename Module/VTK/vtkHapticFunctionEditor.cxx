// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticFunctionEditor.h"

#include "VTK/Charts/HapticDrawing.h"
#include "VTK/Charts/HapticFunctionChart.h"
#include "VTK/Charts/HapticHistogram.h"
#include "VTK/Proposal/EdgeHistogram.h"
#include "VTK/Proposal/HapticProposal.h"

#include "vtkCommand.h"
#include "vtkContextDevice2D.h"
#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTimeStamp.h"
#include "vtkVolumeProperty.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <utility>

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
};

} // namespace

//------------------------------------------------------------------------------
struct vtkHapticFunctionEditor::vtkInternals
{
  vtkSmartPointer<vtkHapticProperty> Property;
  vtkSmartPointer<vtkVolumeProperty> VolumeProperty;
  vtkSmartPointer<vtkImageData> Image;
  vtkWeakPointer<vtkRenderer> Renderer; // that shows the editor
  VolumeHaptics::HapticFunctionChart Chart;
  int Held = 0;     // the button, between press and release
  int CanDraw = -1; // not known yet
  bool IsCounting = false;
  bool IsProposing = false;
  vtkSmartPointer<vtkHapticProperty> Proposal; // not taken yet
  vtkSmartPointer<vtkTable> Boundaries;        // that the chart shows
  vtkTimeStamp EdgeTime;

  int GetComponent() const { return this->Property ? this->Property->GetComponent() : 0; }

  /** The property whose edges are to be shown: the proposal, or one that was proposed before. */
  vtkHapticProperty* GetProposed() const
  {
    vtkHapticProperty* const any = this->Proposal ? this->Proposal : this->Property;
    return this->Image && any && any->GetProposedBoundaries() ? any : nullptr;
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
      this->Modified();                                 \
    }                                                   \
  }                                                     \
  type* vtkHapticFunctionEditor::Get##name()            \
  {                                                     \
    return this->Internals->member;                     \
  }

vtkHapticEditorObjectMacro(Property, vtkHapticProperty, Property);
vtkHapticEditorObjectMacro(VolumeProperty, vtkVolumeProperty, VolumeProperty);
vtkHapticEditorObjectMacro(InputData, vtkImageData, Image);

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::SetFunction(int function)
{
  const int valid = std::clamp<int>(function, STIFFNESS, OPACITY);
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
    this->SetFunction(this->Function == OPACITY ? STIFFNESS : this->Function + 1);
  } while (!this->GetPiecewiseFunction() && this->Function != before);
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
    const int component =
      d.Property && d.VolumeProperty && d.VolumeProperty->GetIndependentComponents()
      ? std::min(d.Property->GetComponent(), VTK_MAX_VRCOMP - 1)
      : 0;
    return d.VolumeProperty ? d.VolumeProperty->GetScalarOpacity(component) : nullptr;
  }
  return d.Property ? (d.Property->*Choices[this->Function].Get)() : nullptr;
}

//------------------------------------------------------------------------------
double vtkHapticFunctionEditor::EstimateUpdateTime()
{
  auto& d = *this->Internals;
  constexpr double proposing = 1.0; // s, measured on a desktop computer of 2023
  vtkHapticProperty* const proposed = d.GetProposed();
  return (d.IsProposing ? proposing : 0.0) +
    (d.Chart.ShowsData(d.Image, d.GetComponent()) ? 0.0
                                                  : VolumeHaptics::EstimateHistogramTime(d.Image)) +
    (this->ShowsEdges() || !proposed
        ? 0.0
        : VolumeHaptics::EstimateEdgeTime(proposed->GetProposedKernelRadius()));
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::Propose()
{
  auto& d = *this->Internals;
  if (!d.Property || !d.Image || d.IsCounting)
  {
    vtkErrorMacro("There is nothing to propose functions from: call SetProperty and SetInputData.");
    return false;
  }
  const vtkSmartPointer<vtkHapticFunctionEditor> self(this); // observers may release it
  const vtkSmartPointer<vtkImageData> image(d.Image);
  VolumeHaptics::MaterialProposal proposal;
  std::string error;
  d.IsCounting = d.IsProposing = true;
  this->InvokeEvent(vtkCommand::StartEvent);
  const bool isThere = VolumeHaptics::ProposeFromVolume(image, d.GetComponent(), proposal, error);
  if (isThere)
  {
    d.Proposal = vtkSmartPointer<vtkHapticProperty>::New();
    VolumeHaptics::FillFromProposal(proposal, d.Proposal);
    d.Chart.ShowData(d.Image, d.GetComponent());
    this->UpdateEdges();
    this->Modified();
  }
  d.IsCounting = d.IsProposing = false;
  this->InvokeEvent(vtkCommand::EndEvent);
  if (!isThere)
  {
    vtkErrorMacro(<< error);
  }
  return isThere;
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::HasProposal()
{
  return this->Internals->Proposal != nullptr;
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::TakeProposal()
{
  auto& d = *this->Internals;
  const auto proposal = std::exchange(d.Proposal, nullptr);
  if (!proposal || !d.Property)
  {
    return false;
  }
  VolumeHaptics::CopyProposal(proposal, d.Property);
  this->Modified();
  this->InvokeEvent(vtkCommand::InteractionEvent);
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::DropProposal()
{
  const bool isThere = std::exchange(this->Internals->Proposal, nullptr) != nullptr;
  if (isThere)
  {
    this->Modified();
  }
  return isThere;
}

//------------------------------------------------------------------------------
bool vtkHapticFunctionEditor::ShowsEdges()
{
  const auto& d = *this->Internals;
  vtkHapticProperty* const proposed = d.GetProposed();
  return proposed
    ? d.Boundaries == proposed->GetProposedBoundaries() && d.EdgeTime > d.Image->GetMTime()
    : !d.Chart.ShowsEdges();
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::UpdateEdges()
{
  auto& d = *this->Internals;
  vtkHapticProperty* const proposed = d.GetProposed();
  d.Boundaries = proposed ? proposed->GetProposedBoundaries() : nullptr;
  d.EdgeTime.Modified();
  if (!proposed)
  {
    d.Chart.HideEdges();
    return;
  }
  constexpr double room = 1.25;
  VolumeHaptics::EdgeHistogram histogram;
  std::copy_n(d.Chart.GetDataRange(), 2, histogram.Values);
  double range[2];
  vtkDataArray::SafeDownCast(d.Boundaries->GetColumnByName("Slope"))->GetRange(range);
  histogram.MostSlope = room * range[1];
  VolumeHaptics::CountEdges(
    d.Image, d.GetComponent(), proposed->GetProposedKernelRadius(), histogram);
  d.Chart.ShowEdges(histogram, d.Boundaries);
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::Update()
{
  auto& d = *this->Internals;
  const vtkSmartPointer<vtkHapticFunctionEditor> self(this); // observers may release it
  // Observers may render during the work: that shows the chart as it is.
  const bool showsData = d.Chart.ShowsData(d.Image, d.GetComponent());
  if (!d.IsCounting && !(showsData && this->ShowsEdges()))
  {
    d.IsCounting = true;
    this->InvokeEvent(vtkCommand::StartEvent);
    d.Chart.ShowData(d.Image, d.GetComponent());
    this->UpdateEdges();
    d.IsCounting = false;
    this->InvokeEvent(vtkCommand::EndEvent);
  }
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::UpdateChart()
{
  auto& d = *this->Internals;
  vtkPiecewiseFunction* const function = this->GetPiecewiseFunction();
  d.Chart.Place(this->Rectangle);
  this->Update();
  const auto get = Choices[this->Function].Get;
  d.Chart.ShowProposed(d.Proposal && get ? (d.Proposal.Get()->*get)() : nullptr);
  if (vtkHapticProperty* const felt = d.GetProposed())
  {
    vtkPiecewiseFunction* const distinctness = felt->GetDistinctness();
    const double* const range = distinctness->GetRange();
    d.Chart.ShowDistinctness(range[0], range[1]);
  }
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
  vtkPiecewiseFunction* const function = this->GetPiecewiseFunction();
  const vtkMTimeType before = function ? function->GetMTime() : 0;
  d.ToViewport(x, y);
  d.Held = starts ? button : d.Held;
  d.Chart.SendMouse(event, event == vtkCommand::MouseMoveEvent ? d.Held : button, x, y);
  d.Held = event == vtkCommand::LeftButtonReleaseEvent ? 0 : d.Held;
  if (function && function->GetMTime() > before)
  {
    this->InvokeEvent(vtkCommand::InteractionEvent);
  }
  return true;
}

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
  int origin[2] = { 0, 0 };
  this->Internals->ToViewport(origin[0], origin[1]);
  position[0] -= origin[0];
  position[1] -= origin[1];
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
  return d.Chart.GetActor()->RenderOverlay(viewport);
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Chart.GetActor()->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkHapticFunctionEditor::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto& d = *this->Internals;
  os << indent << "Property: " << d.Property.Get() << "\n";
  os << indent << "VolumeProperty: " << d.VolumeProperty.Get() << "\n";
  os << indent << "InputData: " << d.Image.Get() << "\n";
  os << indent << "Proposal: " << (d.Proposal ? "to be taken" : "(none)") << "\n";
  os << indent << "Function: " << this->GetTitle() << "\n";
  os << indent << "Rectangle: " << this->Rectangle[0] << ", " << this->Rectangle[1] << ", "
     << this->Rectangle[2] << ", " << this->Rectangle[3] << "\n";
}

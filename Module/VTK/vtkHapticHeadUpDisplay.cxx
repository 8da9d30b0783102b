// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticHeadUpDisplay.h"

#include "HapticForceHistory.h"

#include "vtkAxis.h"
#include "vtkBlockItem.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextDevice2D.h"
#include "vtkContextScene.h"
#include "vtkDataArray.h"
#include "vtkHapticDevice.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkViewport.h"

#include <algorithm>
#include <iomanip>
#include <sstream>
#include <vector>

vtkStandardNewMacro(vtkHapticHeadUpDisplay);

using namespace VolumeHaptics;

namespace
{
struct Tissue
{
  std::string Name;
  double From;
  double To;
};

struct Curve
{
  const char* Label;
  unsigned char Color[3];
  float Width;
};
// In the order in which they are drawn: the whole force behind the others.
const Curve Curves[] = { { "normal", { 80, 165, 255 }, 1.8f },
  { "friction", { 255, 160, 60 }, 1.8f }, { "drag", { 70, 215, 150 }, 1.8f },
  { "whole", { 165, 170, 178 }, 3.5f } };
const int DrawingOrder[] = { 3, 0, 1, 2 };

void SetFont(vtkTextProperty* text, int size)
{
  text->SetFontSize(size);
  text->SetColor(0.90, 0.92, 0.95);
  text->BoldOff();
  text->ItalicOff();
}

void SetAxis(vtkAxis* axis, const char* title)
{
  axis->SetTitle(title);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetNotation(vtkAxis::STANDARD_NOTATION);
  SetFont(axis->GetTitleProperties(), 11);
  SetFont(axis->GetLabelProperties(), 10);
  axis->GetPen()->SetColor(170, 176, 186);
  axis->GetGridPen()->SetColor(70, 76, 86);
}
} // namespace

struct vtkHapticHeadUpDisplay::vtkInternals
{
  vtkSmartPointer<vtkHapticDevice> Device;
  std::vector<Tissue> Tissues;
  HapticForceHistory History;
  vtkNew<vtkBlockItem> Panel;
  vtkNew<vtkChartXY> Chart;
  vtkNew<vtkContextActor> Plot;
  vtkNew<vtkTextActor> Text;
  int CanDraw = -1; // not known yet

  void MakeChart()
  {
    // Not the chart's own background, which VTK 9.1 draws in the wrong place.
    this->Panel->SetAutoComputeDimensions(false);
    this->Panel->GetBrush()->SetColor(15, 18, 24, 150);
    this->Panel->GetMouseOverBrush()->SetColor(15, 18, 24, 150);
    this->Panel->GetPen()->SetOpacity(0);
    this->Plot->GetScene()->AddItem(this->Panel);
    this->Plot->GetScene()->AddItem(this->Chart);
    this->Chart->SetAutoSize(false);
    this->Chart->SetShowLegend(true);
    SetAxis(this->Chart->GetAxis(vtkAxis::BOTTOM), "Time (s)");
    SetAxis(this->Chart->GetAxis(vtkAxis::LEFT), "Force (N)");
    vtkChartLegend* const legend = this->Chart->GetLegend();
    SetFont(legend->GetLabelProperties(), 10);
    legend->SetHorizontalAlignment(vtkChartLegend::LEFT);
    legend->SetVerticalAlignment(vtkChartLegend::TOP);
    legend->GetPen()->SetOpacity(0);
    legend->GetBrush()->SetOpacity(0);
  }
  void AddCurves(vtkTable* table)
  {
    for (const int c : DrawingOrder)
    {
      vtkPlot* const line = this->Chart->AddPlot(vtkChart::LINE);
      line->SetInputData(table, 0, 1 + c);
      line->SetLabel(Curves[c].Label);
      line->SetColor(Curves[c].Color[0], Curves[c].Color[1], Curves[c].Color[2], 255);
      line->SetWidth(Curves[c].Width);
    }
  }
};

//------------------------------------------------------------------------------
vtkHapticHeadUpDisplay::vtkHapticHeadUpDisplay()
  : Internals(new vtkInternals)
{
  auto& d = *this->Internals;
  SetFont(d.Text->GetTextProperty(), 14);
  d.Text->GetTextProperty()->SetShadow(1);
  d.Text->GetTextProperty()->SetVerticalJustificationToTop();
  d.Text->GetTextProperty()->SetLineSpacing(1.15);
  d.Text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  d.Text->GetPositionCoordinate()->SetValue(0.02, 0.975);
  this->PickableOff();
}

//------------------------------------------------------------------------------
vtkHapticHeadUpDisplay::~vtkHapticHeadUpDisplay() = default;

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::SetDevice(vtkHapticDevice* device)
{
  if (this->Internals->Device != device)
  {
    this->Internals->Device = device;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkHapticHeadUpDisplay::GetDevice()
{
  return this->Internals->Device;
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::AddStates(vtkTable* states)
{
  static const char* const names[] = { "Time", "NormalForce", "FrictionForce", "DragForce",
    "Command" };
  vtkDataArray* columns[5];
  for (int c = 0; c < 5; ++c)
  {
    columns[c] = states ? vtkDataArray::SafeDownCast(states->GetColumnByName(names[c])) : nullptr;
    if (!columns[c] || columns[c]->GetNumberOfComponents() != (c == 4 ? 3 : 1))
    {
      vtkErrorMacro("The states have no column \"" << names[c]
                                                   << "\" as vtkHapticDevice::DrainStates gives "
                                                      "it. Pass its table as it is.");
      return;
    }
  }
  for (vtkIdType i = 0; i < states->GetNumberOfRows(); ++i)
  {
    double command[3];
    columns[4]->GetTuple(i, command);
    this->Internals->History.Add({ columns[0]->GetComponent(i, 0),
                                   { columns[1]->GetComponent(i, 0), columns[2]->GetComponent(i, 0),
                                     columns[3]->GetComponent(i, 0), vtkMath::Norm(command) } },
      this->TimeSpan);
  }
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::Clear()
{
  this->Internals->History.Clear();
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::AddTissue(const char* name, double from, double to)
{
  this->Internals->Tissues.push_back({ name ? name : "", from, to });
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::RemoveAllTissues()
{
  this->Internals->Tissues.clear();
  this->Modified();
}

//------------------------------------------------------------------------------
std::string vtkHapticHeadUpDisplay::GetTissueName(double value)
{
  const auto& all = this->Internals->Tissues;
  const auto found = std::find_if(
    all.begin(), all.end(), [&](const Tissue& t) { return value >= t.From && value < t.To; });
  return found == all.end() ? std::string() : found->Name;
}

//------------------------------------------------------------------------------
vtkIdType vtkHapticHeadUpDisplay::GetNumberOfStates()
{
  return static_cast<vtkIdType>(this->Internals->History.GetSize());
}

//------------------------------------------------------------------------------
vtkTable* vtkHapticHeadUpDisplay::GetPlotTable()
{
  return this->Internals->History.Plot(this->TimeSpan);
}

//------------------------------------------------------------------------------
double vtkHapticHeadUpDisplay::GetForceRange()
{
  return this->Internals->History.GetRange();
}

//------------------------------------------------------------------------------
std::string vtkHapticHeadUpDisplay::GetText()
{
  vtkHapticDevice* const device = this->Internals->Device;
  if (!device)
  {
    return "No device";
  }
  std::string status = device->GetStatusText();
  if (!device->IsRunning())
  {
    return status;
  }
  const bool isFault = device->GetStatus() == vtkHapticDevice::FAULT;
  // A fault with its cure, over two lines; else the first sentence says enough.
  const std::size_t sentence = status.find(". ");
  if (sentence != std::string::npos)
  {
    status = isFault ? status.substr(0, sentence + 1) + "\n" + status.substr(sentence + 2)
                     : status.substr(0, sentence + 1);
  }
  static const char* const contacts[] = { "free", "sticking", "sliding", "penetrating" };
  const double value = device->GetSurfaceValue();
  const std::string tissue = this->GetTissueName(value);
  std::ostringstream text;
  text << status << "\n"
       << std::fixed << std::setprecision(0) << device->GetTickRate() << " ticks/s, "
       << device->GetMissedTicks() << " missed\n"
       << std::setprecision(2) << vtkMath::Norm(device->GetForce()) << " N, "
       << contacts[device->GetContact() & 3] << "\n"
       << (tissue.empty() ? "" : tissue + ", ") << "value " << std::setprecision(0) << value;
  return text.str();
}

//------------------------------------------------------------------------------
int vtkHapticHeadUpDisplay::RenderOverlay(vtkViewport* viewport)
{
  auto& d = *this->Internals;
  int drawn = 0;
  if (this->TextVisibility)
  {
    const bool isFault = d.Device && d.Device->GetStatus() == vtkHapticDevice::FAULT;
    d.Text->GetTextProperty()->SetColor(
      isFault ? 1.0 : 0.90, isFault ? 0.55 : 0.92, isFault ? 0.45 : 0.95);
    d.Text->SetInput(this->GetText().c_str());
    d.Text->RenderOpaqueGeometry(viewport); // draws the letters into the texture that is shown next
    drawn += d.Text->RenderOverlay(viewport);
  }
  if (!this->PlotVisibility)
  {
    return drawn;
  }
  if (d.CanDraw == -1)
  {
    // A chart without a device to draw on would crash.
    const auto context = vtkSmartPointer<vtkContextDevice2D>::Take(vtkContextDevice2D::New());
    d.CanDraw = context ? 1 : 0;
    if (context)
    {
      d.MakeChart();
      d.AddCurves(this->GetPlotTable());
    }
    else
    {
      vtkErrorMacro(
        "VTK has nothing to draw charts with. Link VTK::RenderingContextOpenGL2, with "
        "vtk_module_autoinit, or in Python import vtkmodules.vtkRenderingContextOpenGL2.");
    }
  }
  if (d.CanDraw == 0)
  {
    return drawn;
  }
  const int* const size = viewport->GetSize();
  this->GetPlotTable();
  d.Chart->GetAxis(vtkAxis::BOTTOM)->SetRange(-this->TimeSpan, 0.0);
  d.Chart->GetAxis(vtkAxis::LEFT)->SetRange(0.0, this->GetForceRange());
  const float width = static_cast<float>(std::min(size[0] - 20, 620));
  const float height = static_cast<float>(std::clamp(size[1] * 3 / 10, 130, 220));
  d.Panel->SetDimensions(10.0f, 10.0f, width, height);
  d.Chart->SetSize(vtkRectf(10.0f, 10.0f, width - 10.0f, height - 6.0f));
  return drawn + d.Plot->RenderOverlay(viewport);
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Plot->ReleaseGraphicsResources(window);
  this->Internals->Text->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device: " << this->GetDevice() << "\n";
  os << indent << "TimeSpan: " << this->TimeSpan << " s\n";
  os << indent << "PlotVisibility: " << this->PlotVisibility << "\n";
  os << indent << "TextVisibility: " << this->TextVisibility << "\n";
  os << indent << "States: " << this->GetNumberOfStates() << "\n";
  os << indent << "Tissues: " << this->Internals->Tissues.size() << "\n";
}

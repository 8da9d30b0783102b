// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticHeadUpDisplay.h"

#include "VTK/Charts/HapticDrawing.h"
#include "VTK/Charts/HapticForceChart.h"
#include "VTK/Charts/HapticForceHistory.h"
#include "VTK/Charts/HapticModeList.h"
#include "VTK/Charts/HapticOverlayPicture.h"
#include "VTK/Scene/HapticSceneSettings.h"
#include "VTK/Scene/TouchedLabel.h"

#include "vtkContextActor.h"
#include "vtkContextDevice2D.h"
#include "vtkDataArray.h"
#include "vtkHapticDevice.h"
#include "vtkHapticMode.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkViewport.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <chrono>
#include <cmath>
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

/** VTK's clamp lets NaN through; it then becomes the default. */
double GetShownSpan(double span)
{
  return std::isnan(span) ? 5.0 : span;
}

/** The filter whose modes are felt; null for other methods. */
vtkVolumeHapticsFilter* FindModes(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  return filter && filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES ? filter : nullptr;
}

/** The names of all modes, each another one. */
std::vector<std::string> NameModes(vtkHapticDevice* device)
{
  std::vector<std::string> names;
  vtkVolumeHapticsFilter* const filter = FindModes(device);
  for (int i = 0; filter && i < filter->GetNumberOfModes(); ++i)
  {
    names.push_back(std::to_string(i + 1) + " " + filter->GetMode(i)->GetText());
  }
  return names;
}

/** A line for each mode, with its force. */
std::vector<ModeLine> DescribeModeForces(vtkHapticDevice* device)
{
  std::vector<ModeLine> lines;
  for (const std::string& name : NameModes(device))
  {
    const auto mode = static_cast<int>(lines.size());
    const bool isActive = FindModes(device)->GetMode(mode)->GetActive();
    std::ostringstream text;
    text << name << ": " << std::fixed << std::setprecision(2);
    isActive ? text << vtkMath::Norm(device->GetModeForce(mode)) << " N" : text << "off";
    lines.push_back({ text.str(), isActive });
  }
  return lines;
}

/** A line on the time of a volume that moves; empty without one. */
std::string DescribeTime(vtkHapticDevice* device)
{
  if (!device->HasFrames())
  {
    return {};
  }
  static const char* const ends[] = { "once", "in a loop", "to and fro" };
  std::ostringstream text;
  text << "\nTime " << std::setprecision(4) << device->GetDataTime() << ", shown "
       << device->GetFrameTime() << ", ";
  if (device->IsPlaying())
  {
    text << "played " << ends[device->GetPlayback()];
    if (device->GetPlaybackSpeed() != 1.0)
    {
      text << ", speed " << device->GetPlaybackSpeed();
    }
  }
  else
  {
    text << "held";
  }
  return text.str();
}
} // namespace

struct vtkHapticHeadUpDisplay::vtkInternals
{
  vtkSmartPointer<vtkHapticDevice> Device;
  std::vector<Tissue> Tissues;
  HapticForceHistory History;
  HapticForceChart Chart{ HapticForceChart::Ground::Panel };
  HapticOverlayPicture Picture;
  std::chrono::steady_clock::time_point Drawn; // the time of the last picture
  vtkNew<vtkTextActor> Text;
  HapticModeList Modes;
  vtkNew<vtkTable> PlotTable; // the table for the caller
  int CanDraw = -1;           // not known yet

  std::string GetStatus(vtkHapticHeadUpDisplay& self);
};

//------------------------------------------------------------------------------
vtkHapticHeadUpDisplay::vtkHapticHeadUpDisplay()
  : Internals(new vtkInternals)
{
  auto& d = *this->Internals;
  d.Text->GetTextProperty()->SetFontSize(14);
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
  auto* const modes = vtkDataArray::SafeDownCast(states->GetColumnByName("ModeForces"));
  const vtkIdType rows = columns[0]->GetNumberOfTuples();
  for (vtkIdType i = 0; i < rows; ++i)
  {
    const auto isShort = [i](vtkDataArray* column) { return column->GetNumberOfTuples() <= i; };
    if (!std::isfinite(columns[0]->GetComponent(i, 0)) ||
      std::any_of(columns, columns + 5, isShort))
    {
      vtkErrorMacro(<< "The table of states lacks a column or a finite Time in row " << i
                    << ". Pass the table of vtkHapticDevice::DrainStates as it is.");
      return;
    }
    double command[3];
    columns[4]->GetTuple(i, command);
    HapticForceHistory::State state{ columns[0]->GetComponent(i, 0),
      { columns[1]->GetComponent(i, 0), columns[2]->GetComponent(i, 0),
        columns[3]->GetComponent(i, 0), vtkMath::Norm(command) } };
    for (int c = 0; modes && i < modes->GetNumberOfTuples() && c < modes->GetNumberOfComponents() &&
         HapticForceTable::Curves + c < HapticForceHistory::Curves;
         ++c)
    {
      state.Forces[HapticForceTable::Curves + c] = modes->GetComponent(i, c);
    }
    this->Internals->History.Add(state, GetShownSpan(this->TimeSpan));
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
  // Not the table that is drawn, which has to stay unchanged.
  auto& d = *this->Internals;
  d.History.SetModes(NameModes(d.Device));
  d.PlotTable->DeepCopy(d.History.Plot(GetShownSpan(this->TimeSpan)));
  return d.PlotTable;
}

//------------------------------------------------------------------------------
double vtkHapticHeadUpDisplay::GetForceRange()
{
  return this->Internals->History.GetRange();
}

//------------------------------------------------------------------------------
std::string vtkHapticHeadUpDisplay::GetPlotTitle()
{
  vtkHapticDevice* const device = this->Internals->Device;
  return device ? device->GetMethodText() : std::string();
}

//------------------------------------------------------------------------------
std::string vtkHapticHeadUpDisplay::GetText()
{
  const std::string status = this->Internals->GetStatus(*this);
  return this->Notice.empty() ? status : status + "\n" + this->Notice;
}

//------------------------------------------------------------------------------
std::string vtkHapticHeadUpDisplay::vtkInternals::GetStatus(vtkHapticHeadUpDisplay& self)
{
  vtkHapticDevice* const device = this->Device;
  if (!device)
  {
    return "No device";
  }
  std::string status = device->GetStatusText();
  if (!device->IsRunning())
  {
    return status;
  }
  const int code = device->GetStatus();
  const bool asksHand = code == vtkHapticDevice::FAULT || code == vtkHapticDevice::HOMING ||
    code == vtkHapticDevice::FIRMWARE;
  // A request to the hand, or a fault with its cure, takes two lines; otherwise the first sentence
  // is enough.
  const std::size_t sentence = status.find(". ");
  if (sentence != std::string::npos)
  {
    status = asksHand ? status.substr(0, sentence + 1) + "\n" + status.substr(sentence + 2)
                      : status.substr(0, sentence + 1);
  }
  static const char* const contacts[] = { "free", "sticking", "sliding", "penetrating" };
  const double value = device->GetSurfaceValue();
  const std::string label = NameLabelAt(device->GetVolumeHaptics(), device->GetSurfacePosition());
  const std::string tissue = label.empty() ? self.GetTissueName(value) : label;
  std::ostringstream text;
  text << status << "\n"
       << std::fixed << std::setprecision(0) << device->GetTickRate() << " ticks/s, "
       << device->GetMissedTicks() << " missed\n"
       << std::setprecision(2) << vtkMath::Norm(device->GetForce()) << " N, "
       << contacts[device->GetContact() & 3] << "\n"
       << (tissue.empty() ? "" : tissue + ", ") << "value " << std::setprecision(0) << value
       << DescribeTime(device);
  return text.str();
}

//------------------------------------------------------------------------------
int vtkHapticHeadUpDisplay::FindMode(int x, int y)
{
  auto& d = *this->Internals;
  return this->GetVisibility() && this->TextVisibility && FindModes(d.Device) ? d.Modes.Find(x, y)
                                                                              : -1;
}

//------------------------------------------------------------------------------
int vtkHapticHeadUpDisplay::RenderOverlay(vtkViewport* viewport)
{
  if (!VolumeHaptics::IsDrawing(viewport))
  {
    return 0;
  }
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
    double size[2] = { 0.0, 0.0 };
    d.Text->GetSize(viewport, size);
    const int* const view = viewport->GetSize();
    constexpr double top = 0.975; // of the text
    constexpr double gap = 8.0;
    drawn += d.Modes.Render(
      DescribeModeForces(d.Device), static_cast<int>(top * view[1] - size[1] - gap), viewport);
  }
  else
  {
    d.Modes.Hide();
  }
  if (!this->PlotVisibility)
  {
    return drawn;
  }
  if (d.CanDraw == -1)
  {
    // A chart that has no device to draw on would crash.
    const auto context = vtkSmartPointer<vtkContextDevice2D>::Take(vtkContextDevice2D::New());
    d.CanDraw = context ? 1 : 0;
    if (context)
    {
      d.Chart.Build();
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
  d.Chart.Fit(size[0], size[1]);
  // With a software renderer the chart costs some milliseconds, its picture a tenth of one.
  const auto now = std::chrono::steady_clock::now();
  const bool isDue = now - d.Drawn >= std::chrono::milliseconds(50);
  const double span = GetShownSpan(this->TimeSpan);
  const std::vector<std::string> modes = NameModes(d.Device);
  d.History.SetModes(modes);
  d.Chart.SetModes(modes);
  const bool isStale = isDue &&
    d.Chart.Show(d.History.Plot(span), { -span, 0.0, this->GetForceRange() }, this->GetPlotTitle());
  if (isStale)
  {
    d.Drawn = now;
  }
  return drawn + d.Picture.Render(viewport, d.Chart.GetActor(), d.Chart.GetCorner(), isStale);
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Picture.ReleaseGraphicsResources(window);
  this->Internals->Modes.Release(window);
  this->Internals->Chart.GetActor()->ReleaseGraphicsResources(window);
  this->Internals->Text->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device: " << this->GetDevice() << "\n";
  PrintSettings(os, indent, this, DisplaySettings);
  os << indent << "Notice: " << this->Notice << "\n";
  os << indent << "States: " << this->GetNumberOfStates() << "\n";
  os << indent << "Tissues: " << this->Internals->Tissues.size() << "\n";
}

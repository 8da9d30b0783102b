// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticSliceView.h"

#include "VTK/Scene/Base/RendererAspect.h"
#include "VTK/Scene/Base/WindowDock.h"
#include "VTK/Scene/Display/DisplayText.h"
#include "VTK/Scene/Slices/HapticSliceViewSettings.h"
#include "VTK/Scene/Slices/SlicePanel.h"

#include "vtkCallbackCommand.h"
#include "vtkHapticDevice.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkImageProperty.h"
#include "vtkLookupTable.h"
#include "vtkObjectFactory.h"
#include "vtkRenderWindow.h"
#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkHapticSliceView);

using namespace VolumeHaptics;

namespace
{

using SliceColor = std::array<unsigned char, 3>;
using SliceIndex = std::array<double, 3>;

/** Colours of the axial, coronal and sagittal slice: those of 3D Slicer, but lighter. */
constexpr std::array<SliceColor, 3> PanelColors = { { { 240, 110, 96 }, { 118, 196, 108 },
  { 232, 208, 96 } } };

/** Distance (voxels along an axis) that the tip has to move before the slices follow. */
constexpr double LeastTipMotion = 0.5;

std::string WriteSliceValue(double number)
{
  std::ostringstream text;
  const bool isWhole = number == std::round(number) && std::abs(number) < 1e9;
  text.precision(isWhole ? 10 : 4);
  text << number;
  return text.str();
}

} // namespace

struct vtkHapticSliceView::vtkInternals
{
  vtkSmartPointer<vtkHapticDevice> Device;
  vtkSmartPointer<vtkImageData> Image;
  vtkSmartPointer<vtkHapticHeadUpDisplay> Display;
  vtkWeakPointer<vtkRenderWindow> Window;
  vtkNew<vtkCallbackCommand> StartObserver;
  SliceImage Shown;
  std::array<SlicePanel, 3> Panels;
  WindowDock Dock;
  vtkNew<vtkImageProperty> Look;
  vtkNew<vtkLookupTable> Grey;
  std::array<double, 2> Usual{ { 0.0, 1.0 } };
  SliceIndex Position{}; ///< position of the crosshair
  SliceIndex Tip{};      ///< tip position at which the slices last followed it
  bool HasTip = false;
  bool HasUsual = false;    ///< whether Usual was computed from this or a previous image
  vtkMTimeType Updated = 0; ///< time when the settings were last applied

  std::vector<vtkRenderer*> GetColumn() const
  {
    return { this->Panels[0].GetRenderer(), this->Panels[1].GetRenderer(),
      this->Panels[2].GetRenderer() };
  }
  void LeaveWindow();
  bool UpdateImage();
  bool PollTip();
  void ShowPosition(bool isOther, bool anatomical);
  void Show(vtkHapticSliceView* self);
  std::string DescribePosition(vtkHapticSliceView* self);
  std::string NameSlice(int slice) const;
  std::string DescribeLook(vtkHapticSliceView* self);
};

//------------------------------------------------------------------------------
void vtkHapticSliceView::vtkInternals::LeaveWindow()
{
  if (this->Window)
  {
    this->Window->RemoveObserver(this->StartObserver);
    for (vtkRenderer* const renderer : this->GetColumn())
    {
      this->Window->RemoveRenderer(renderer);
    }
  }
  this->Dock.GiveBack();
}

//------------------------------------------------------------------------------
vtkHapticSliceView::vtkHapticSliceView()
  : Internals(new vtkInternals)
{
  auto& d = *this->Internals;
  d.StartObserver->SetClientData(this);
  d.StartObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<vtkHapticSliceView*>(self)->Update(); });
  d.Grey->SetHueRange(0.0, 0.0);
  d.Grey->SetSaturationRange(0.0, 0.0);
  d.Grey->SetValueRange(0.0, 1.0);
  d.Grey->SetRampToLinear();
  d.Grey->Build();
  d.Look->SetLookupTable(d.Grey);
  d.Look->UseLookupTableScalarRangeOff();
  d.Look->SetInterpolationTypeToLinear();
  for (int slice = 0; slice < 3; ++slice)
  {
    d.Panels[slice].SetColor(PanelColors[slice]);
  }
}

//------------------------------------------------------------------------------
vtkHapticSliceView::~vtkHapticSliceView()
{
  this->Internals->LeaveWindow();
}

//------------------------------------------------------------------------------
void vtkHapticSliceView::SetDevice(vtkHapticDevice* device)
{
  if (this->Internals->Device != device)
  {
    this->Internals->Device = device;
    this->Internals->HasTip = false;
    this->Internals->HasUsual = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkHapticSliceView::GetDevice()
{
  return this->Internals->Device;
}

//------------------------------------------------------------------------------
void vtkHapticSliceView::SetImage(vtkImageData* image)
{
  if (this->Internals->Image != image)
  {
    this->Internals->Image = image;
    this->Internals->HasUsual = false;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkImageData* vtkHapticSliceView::GetImage()
{
  return this->Internals->Image;
}

//------------------------------------------------------------------------------
void vtkHapticSliceView::SetHeadUpDisplay(vtkHapticHeadUpDisplay* display)
{
  if (this->Internals->Display != display)
  {
    this->Internals->Display = display;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticHeadUpDisplay* vtkHapticSliceView::GetHeadUpDisplay()
{
  return this->Internals->Display;
}

//------------------------------------------------------------------------------
void vtkHapticSliceView::SetRenderWindow(vtkRenderWindow* window)
{
  auto& d = *this->Internals;
  if (d.Window == window)
  {
    return;
  }
  d.LeaveWindow();
  d.Window = window;
  if (window)
  {
    for (vtkRenderer* const renderer : d.GetColumn())
    {
      window->AddRenderer(renderer);
      ComputeAspect(renderer);
    }
    window->AddObserver(vtkCommand::StartEvent, d.StartObserver);
  }
  this->Modified();
  this->Update(); // needed now, because the mouse may be used before the first frame
}

//------------------------------------------------------------------------------
vtkRenderWindow* vtkHapticSliceView::GetRenderWindow()
{
  return this->Internals->Window;
}

//------------------------------------------------------------------------------
vtkRenderer* vtkHapticSliceView::GetRenderer(int slice)
{
  return slice >= 0 && slice < 3 ? this->Internals->Panels[slice].GetRenderer() : nullptr;
}

//------------------------------------------------------------------------------
void vtkHapticSliceView::SetPosition(const double position[3])
{
  auto& d = *this->Internals;
  this->Update();
  if (d.Shown.HasSamples())
  {
    d.Position = d.Shown.ComputeIndex(position);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkHapticSliceView::GetPosition(double position[3])
{
  auto& d = *this->Internals;
  this->Update();
  std::fill_n(position, 3, 0.0);
  if (d.Shown.HasSamples())
  {
    d.Shown.ComputeWorld(d.Position, position);
  }
}

//------------------------------------------------------------------------------
int vtkHapticSliceView::FindSlice(int x, int y)
{
  auto& d = *this->Internals;
  for (int slice = 0; slice < 3 && this->Visibility && d.Window; ++slice)
  {
    if (d.Panels[slice].Contains(x, y))
    {
      return slice;
    }
  }
  return -1;
}

//------------------------------------------------------------------------------
bool vtkHapticSliceView::FindPosition(int slice, int x, int y, double position[3])
{
  auto& d = *this->Internals;
  if (slice < 0 || slice > 2 || !d.Shown.HasSamples() || !d.Window)
  {
    return false;
  }
  d.Panels[slice].Fit();
  d.Shown.ComputeWorld(d.Shown.Clamp(d.Panels[slice].ComputeIndex(x, y)), position);
  return true;
}

//------------------------------------------------------------------------------
bool vtkHapticSliceView::MoveAcross(int slice, double voxels, double position[3])
{
  auto& d = *this->Internals;
  if (slice < 0 || slice > 2 || !d.Shown.HasSamples())
  {
    return false;
  }
  const SignedAxis across = d.Panels[slice].GetAxes().Through;
  SliceIndex index = d.Shown.ComputeIndex(position);
  index[across.Axis] += across.Sign * voxels;
  d.Shown.ComputeWorld(d.Shown.Clamp(index), position);
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticSliceView::GetShownWindowLevel(double windowLevel[2])
{
  const auto& d = *this->Internals;
  const bool isChosen = this->ColorWindow > 0.0;
  const double usual = d.Usual[1] - d.Usual[0];
  windowLevel[0] = isChosen ? this->ColorWindow : (usual > 0.0 ? usual : 1.0);
  windowLevel[1] = isChosen ? this->ColorLevel : 0.5 * (d.Usual[0] + d.Usual[1]);
}

//------------------------------------------------------------------------------
std::string vtkHapticSliceView::GetText(int slice)
{
  auto& d = *this->Internals;
  this->Update();
  if (slice < 0 || slice > 2 || !d.Shown.HasSamples())
  {
    return {};
  }
  const std::string title = d.NameSlice(slice);
  return slice == 0 ? title + "\n" + d.DescribePosition(this)
                    : (slice == 2 ? title + "\n" + d.DescribeLook(this) : title);
}

//------------------------------------------------------------------------------
std::string vtkHapticSliceView::vtkInternals::NameSlice(int slice) const
{
  const SliceAxes& axes = this->Panels[slice].GetAxes();
  const std::string number = std::to_string(std::lround(this->Position[axes.Through.Axis]));
  const bool isIndex = axes.Name[1] == '\0';
  return axes.Name + std::string(isIndex ? " = " : " ") + number;
}

//------------------------------------------------------------------------------
std::string vtkHapticSliceView::vtkInternals::DescribePosition(vtkHapticSliceView* self)
{
  double world[3];
  this->Shown.ComputeWorld(this->Position, world);
  const double value = this->Shown.GetValue(this->Position);
  std::string text = this->Shown.DescribeComponents() + WriteSliceValue(value);
  text += self->Unit.empty() ? "" : " " + self->Unit;
  const std::string tissue = this->Display ? this->Display->GetTissueName(value) : std::string();
  const std::string label =
    this->Device ? NameLabelAt(this->Device->GetVolumeHaptics(), world) : std::string();
  for (const std::string& name : { label, tissue })
  {
    text += name.empty() ? "" : "\n" + name;
  }
  return text;
}

//------------------------------------------------------------------------------
std::string vtkHapticSliceView::vtkInternals::DescribeLook(vtkHapticSliceView* self)
{
  double shown[2];
  self->GetShownWindowLevel(shown);
  std::ostringstream text;
  text.precision(4);
  text << "W " << shown[0] << "  L " << shown[1];
  return text.str();
}

//------------------------------------------------------------------------------
bool vtkHapticSliceView::vtkInternals::PollTip()
{
  vtkHapticDevice* const device = this->Device;
  if (!device || !device->IsRunning() || !this->Shown.HasSamples())
  {
    this->HasTip = false;
    return false;
  }
  const SliceIndex tip = this->Shown.ComputeIndex(device->GetState()->GetTipPosition());
  double motion = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    motion = std::max(motion, std::abs(tip[axis] - this->Tip[axis]));
  }
  // Before the first touch, ignore the position where the tip rests.
  const int status = device->GetStatus();
  const bool isArmed = status == vtkHapticDevice::ARMED || status == vtkHapticDevice::ACTIVE;
  const bool follows = this->HasTip ? motion >= LeastTipMotion : isArmed;
  if (follows || !this->HasTip)
  {
    this->Tip = tip;
    this->HasTip = true;
  }
  if (follows)
  {
    this->Position = tip;
  }
  return follows;
}

//------------------------------------------------------------------------------
bool vtkHapticSliceView::vtkInternals::UpdateImage()
{
  const bool hadSamples = this->Shown.HasSamples();
  double world[3] = {};
  if (hadSamples)
  {
    this->Shown.ComputeWorld(this->Position, world);
  }
  if (!this->Shown.Update(this->Device, this->Image))
  {
    return false;
  }
  if (!this->Shown.HasSamples())
  {
    return true;
  }
  const bool stays = hadSamples && this->HasUsual;
  this->Position = stays ? this->Shown.ComputeIndex(world) : this->Shown.GetCentre();
  const std::array<double, 2> usual = this->Shown.EstimateUsualValues();
  // Only widen the usual range, so that the brightness does not jump between time steps of a moving
  // volume or regions of a large volume.
  this->Usual[0] = this->HasUsual ? std::min(this->Usual[0], usual[0]) : usual[0];
  this->Usual[1] = this->HasUsual ? std::max(this->Usual[1], usual[1]) : usual[1];
  this->HasUsual = true;
  return true;
}

//------------------------------------------------------------------------------
void vtkHapticSliceView::vtkInternals::ShowPosition(bool isOther, bool anatomical)
{
  if (isOther)
  {
    const auto all = this->Shown.ComputeAxes(anatomical);
    this->Shown.UsesMagnitude() ? this->Grey->SetVectorModeToMagnitude()
                                : this->Grey->SetVectorModeToComponent();
    this->Grey->SetVectorComponent(this->Shown.GetComponent());
    for (int slice = 0; slice < 3; ++slice)
    {
      this->Panels[slice].SetImage(this->Shown.GetPlain(), all[slice], this->Look);
    }
  }
  std::array<SliceColor, 3> colors;
  for (int slice = 0; slice < 3; ++slice)
  {
    colors[this->Panels[slice].GetAxes().Through.Axis] = PanelColors[slice];
  }
  for (SlicePanel& panel : this->Panels)
  {
    panel.Show(this->Position, colors);
    const int through = panel.GetAxes().Through.Axis;
    panel.SetLayer(
      this->Shown.GetLayer(through, static_cast<int>(std::lround(this->Position[through]))));
  }
}

//------------------------------------------------------------------------------
void vtkHapticSliceView::vtkInternals::Show(vtkHapticSliceView* self)
{
  if (self->AutoLayout)
  {
    this->Dock.Place(this->Window, DockEdge::Right, self->Share, this->GetColumn());
  }
  if (!this->Shown.HasSamples())
  {
    return;
  }
  double look[2];
  self->GetShownWindowLevel(look);
  this->Look->SetColorWindow(look[0]);
  this->Look->SetColorLevel(look[1]);
  for (int slice = 0; slice < 3; ++slice)
  {
    this->Panels[slice].SetTexts(this->NameSlice(slice),
      slice == 0 ? this->DescribePosition(self) : "", slice == 2 ? this->DescribeLook(self) : "");
    this->Panels[slice].Fit();
  }
}

//------------------------------------------------------------------------------
bool vtkHapticSliceView::Update()
{
  auto& d = *this->Internals;
  const bool isSet = this->GetMTime() > d.Updated;
  const bool isOther = d.UpdateImage();
  const bool isCarved = d.Shown.PollRemoval(d.Device);
  const bool hasMoved = d.PollTip();
  d.Updated = this->GetMTime();
  const bool hasSamples = d.Shown.HasSamples();
  if (hasSamples && (isSet || isOther || isCarved || hasMoved))
  {
    d.ShowPosition(isSet || isOther, this->Anatomical);
  }
  for (SlicePanel& panel : d.Panels)
  {
    if (!hasSamples)
    {
      panel.Hide();
    }
  }
  for (vtkRenderer* const renderer : d.GetColumn())
  {
    renderer->SetDraw(this->Visibility);
  }
  if (!this->Visibility || !this->AutoLayout)
  {
    d.Dock.GiveBack();
  }
  if (this->Visibility && d.Window)
  {
    d.Show(this);
  }
  return isSet || isOther || isCarved || hasMoved;
}

//------------------------------------------------------------------------------
void vtkHapticSliceView::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto& d = *this->Internals;
  os << indent << "Device: " << d.Device.GetPointer() << "\n";
  os << indent << "Image: " << d.Image.GetPointer() << "\n";
  os << indent << "RenderWindow: " << d.Window.GetPointer() << "\n";
  os << indent << "HeadUpDisplay: " << d.Display.GetPointer() << "\n";
  PrintSettings(os, indent, this, SliceViewSettings);
  os << indent << "Unit: " << this->Unit << "\n";
}

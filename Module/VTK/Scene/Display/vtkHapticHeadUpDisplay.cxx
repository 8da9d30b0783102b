// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticHeadUpDisplay.h"

#include "VTK/Base/vtkVolumeHapticsCompat.h"
#include "VTK/Scene/Base/HapticDrawing.h"
#include "VTK/Scene/Base/HapticOverlays.h"
#include "VTK/Scene/Base/HapticPixels.h"
#include "VTK/Scene/Base/HapticTextLook.h"
#include "VTK/Scene/Display/DisplayProbe.h"
#include "VTK/Scene/Display/DisplayText.h"
#include "VTK/Scene/Display/HapticDisplaySettings.h"
#include "VTK/Scene/Display/HapticForceChart.h"
#include "VTK/Scene/Display/HapticForceTable.h"
#include "VTK/Scene/Display/HapticKeySheet.h"
#include "VTK/Scene/Display/HapticModeList.h"
#include "VTK/Scene/Display/HapticWrappedText.h"

#include "vtkContextActor.h"
#include "vtkContextDevice2D.h"
#include "vtkContextScene.h"
#include "vtkDataArray.h"
#include "vtkHapticDevice.h"
#include "vtkHapticMeasurements.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextureObject.h"
#include "vtkViewport.h"
#include "vtkVolumeHapticsFilter.h"

#include VOLUME_HAPTICS_OPENGL_HEADER

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <vector>

class vtkWindow;

namespace VolumeHaptics
{
namespace
{

/**
 * Caches the image of an overlay prop in a texture, and draws the texture in every frame. This is
 * faster, because a chart has dozens of small pieces, while the texture is one.
 */
class HapticOverlayPicture
{
public:
  /**
   * Draws the prop's texture, after updating it if it is stale, if the viewport has changed, or if
   * there is none yet. Draws the lower left part of the texture, with the size `extent` (pixels).
   * If the window does not use OpenGL or is drawn in tiles, draws the prop directly. Returns the
   * result of vtkProp::RenderOverlay.
   */
  int Render(vtkViewport* viewport, vtkProp* prop, const int extent[2], bool isStale);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkOpenGLFramebufferObject> Target;
  vtkNew<vtkTextureObject> Picture;
  vtkWindow* Window = nullptr; ///< window that owns the graphics resources
  int Size[2] = { 0, 0 };      ///< pixels
  int Origin[2] = { 0, 0 };    ///< origin of the viewport (pixels)
};

int HapticOverlayPicture::Render(
  vtkViewport* viewport, vtkProp* prop, const int extent[2], bool isStale)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(viewport->GetVTKWindow());
  if (!window || window->GetTileScale()[0] > 1 || window->GetTileScale()[1] > 1)
  {
    return prop->RenderOverlay(viewport);
  }
  vtkOpenGLState* const state = window->GetState();
  int origin[2] = { 0, 0 };
  int size[2] = { 0, 0 };
  viewport->GetTiledSizeAndOrigin(size, size + 1, origin, origin + 1);
  if (size[0] < 1 || size[1] < 1)
  {
    return 0;
  }
  // Keep the viewport's position in the texture the same as in the window, because charts clip
  // their curves by it.
  const int width = origin[0] + size[0];
  const int height = origin[1] + size[1];
  if (this->Window && this->Window != window)
  {
    this->ReleaseGraphicsResources(this->Window);
  }
  if (width != this->Size[0] || height != this->Size[1])
  {
    this->ReleaseGraphicsResources(window);
    this->Picture->SetContext(window);
    this->Picture->Allocate2D(width, height, 4, VTK_UNSIGNED_CHAR);
    this->Target->SetContext(window);
    this->Window = window;
    this->Size[0] = width;
    this->Size[1] = height;
    isStale = true;
  }
  if (origin[0] != this->Origin[0] || origin[1] != this->Origin[1])
  {
    std::copy(origin, origin + 2, this->Origin);
    isStale = true;
  }
  int drawn = 1;
  vtkOpenGLState::ScopedglViewport keepViewport(state);
  vtkOpenGLState::ScopedglScissor keepScissor(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate keepBlending(state);
  vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable keepBlend(state, GL_BLEND);
  if (isStale)
  {
    vtkOpenGLState::ScopedglClearColor keepColor(state);
    vtkOpenGLState::ScopedglColorMask keepMask(state);
    state->PushFramebufferBindings();
    this->Target->Bind();
    this->Target->AddColorAttachment(0, this->Picture);
    this->Target->ActivateDrawBuffer(0);
    state->vtkglViewport(origin[0], origin[1], size[0], size[1]);
    state->vtkglScissor(0, 0, width, height);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    drawn = prop->RenderOverlay(viewport);
    state->PopFramebufferBindings();
  }
  // The colours in the texture are premultiplied by their opacity, because they were drawn over an
  // empty background.
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const int end[2] = { origin[0] + std::min(extent[0], size[0]) - 1,
    origin[1] + std::min(extent[1], size[1]) - 1 };
  this->Picture->Activate();
  this->Picture->CopyToFrameBuffer(origin[0], origin[1], end[0], end[1], origin[0], origin[1],
    end[0], end[1], window->GetSize()[0], window->GetSize()[1], nullptr, nullptr);
  this->Picture->Deactivate();
  return drawn;
}

void HapticOverlayPicture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Target->ReleaseGraphicsResources(window);
  this->Picture->ReleaseGraphicsResources(window);
  this->Window = nullptr;
  this->Size[0] = 0;
  this->Size[1] = 0;
}

} // namespace
} // namespace VolumeHaptics

vtkStandardNewMacro(vtkHapticHeadUpDisplay);

using namespace VolumeHaptics;

namespace
{
constexpr double TextTop = 0.975; ///< top of the text as a fraction of the viewport
constexpr double TextLeft = 0.02;
constexpr int TextGap = 8; ///< gap below the text (pixels)
/** Pause between two updates of the chart, as a multiple of the time that an update takes. */
constexpr int ChartPause = 25;

struct TissueRange
{
  std::string Name;
  double From;
  double To;
};

/**
 * Returns the time span to show (s). Maps NaN, which VTK's clamp does not detect, to the default.
 */
double GetShownSpan(double span)
{
  return std::isnan(span) ? 5.0 : span;
}
/** Returns the lower left corner (pixels) of the panel with its left and lower margins. */
std::array<int, 2> ComputePlotCorner(
  int corner, vtkViewport* viewport, const std::array<int, 2>& panel)
{
  constexpr int scaleHeight = 30; // pixels of the scale "1 N = 10 mm" at the lower right
  switch (corner)
  {
    case vtkHapticHeadUpDisplay::LOWER_LEFT_CORNER:
      return { 0, 0 };
    case vtkHapticHeadUpDisplay::LOWER_RIGHT_CORNER:
      return { viewport->GetSize()[0] - panel[0] - TextGap,
        ScalePixels(PixelsPerPoint(viewport), scaleHeight) };
    default:
      return FindFreeCorner(viewport, panel[0], panel[1]);
  }
}

/**
 * Returns the name of the touched tissue, from its label or else from the value below the surface.
 */
std::string NameTouched(vtkHapticHeadUpDisplay& display, vtkHapticDevice* device)
{
  const std::string label =
    NameLabelAt(device->GetVolumeHaptics(), device->GetState()->GetSurfacePosition());
  // The shape that a mode touches has no value that could identify a tissue.
  const bool isByValue = label.empty() && !GetModesFilter(device);
  return isByValue ? display.GetTissueName(ComputeTissueValue(device)) : label;
}

} // namespace

struct vtkHapticHeadUpDisplay::vtkInternals
{
  vtkSmartPointer<vtkHapticDevice> Device;
  vtkSmartPointer<vtkHapticDevice> Second;
  std::vector<TissueRange> Tissues;
  HapticForceHistory History;
  LateSlide Slide;
  std::array<double, 3> Proxy{}; // proxy in the last row (world)
  HapticForceChart Chart{ HapticForceChart::Ground::Panel };
  HapticOverlayPicture Picture;
  std::chrono::steady_clock::time_point Due; // earliest time of the next chart update
  vtkNew<vtkTextActor> Text;
  HapticWrappedText Wrapped;
  HapticTextPace TextPace;
  double TextHeight = 0.0; // pixels
  vtkNew<vtkTextActor> Hint;
  vtkNew<HapticKeySheet> Keys;
  vtkNew<vtkContextActor> Help;
  HapticModeList Modes;
  int CanDraw = -1; // 1 if charts can be drawn, 0 if not, -1 if not known yet
  vtkSmartPointer<vtkHapticMeasurements> Measurements;
  // Boxes drawn in the last frame, for Covers().
  std::vector<std::array<double, 4>> Covered;

  std::string GetPlotTitle() const
  {
    return this->Device ? this->Device->GetMethodText() : std::string();
  }
  /** Returns the distance (m) between the proxies of a row and of the row before. */
  double MeasureStep(vtkDataArray* proxies, vtkIdType row);
  std::string GetStatus(vtkHapticHeadUpDisplay& self);
  std::string GetSecondStatus(vtkHapticHeadUpDisplay& self) const;
  int RenderText(vtkHapticHeadUpDisplay& self, vtkViewport* viewport);
  int RenderHint(vtkHapticHeadUpDisplay& self, vtkViewport* viewport);
  /** Returns the lower end of the text (pixels). */
  int ComputeTextEnd(vtkHapticHeadUpDisplay& self, vtkViewport* viewport) const;
  int RenderPlot(vtkHapticHeadUpDisplay& self, vtkViewport* viewport);
  int RenderHelp(vtkHapticHeadUpDisplay& self, vtkViewport* viewport);
  /** Returns whether charts can be drawn. If not, reports an error once. */
  bool DetectContext(vtkHapticHeadUpDisplay& self);
};

//------------------------------------------------------------------------------
vtkHapticHeadUpDisplay::vtkHapticHeadUpDisplay()
  : Internals(new vtkInternals)
{
  auto& d = *this->Internals;
  d.Text->GetTextProperty()->SetVerticalJustificationToTop();
  d.Text->GetTextProperty()->SetLineSpacing(1.15);
  d.Text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  d.Text->GetPositionCoordinate()->SetValue(TextLeft, TextTop);
  vtkTextProperty* const hint = d.Hint->GetTextProperty();
  hint->SetColor(1.0, 1.0, 1.0);
  hint->SetBackgroundColor(0.06, 0.07, 0.09);
  hint->SetFrame(1);
  hint->SetFrameColor(0.06, 0.07, 0.09);
  hint->SetFrameWidth(4);
  hint->SetLineSpacing(1.25);
  hint->SetJustificationToCentered();
  hint->SetVerticalJustificationToTop();
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
void vtkHapticHeadUpDisplay::SetSecondDevice(vtkHapticDevice* device)
{
  if (this->Internals->Second != device)
  {
    this->Internals->Second = device;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticDevice* vtkHapticHeadUpDisplay::GetSecondDevice()
{
  return this->Internals->Second;
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::SetMeasurements(vtkHapticMeasurements* measurements)
{
  if (this->Internals->Measurements != measurements)
  {
    this->Internals->Measurements = measurements;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
vtkHapticMeasurements* vtkHapticHeadUpDisplay::GetMeasurements()
{
  return this->Internals->Measurements;
}

//------------------------------------------------------------------------------
bool vtkHapticHeadUpDisplay::Covers(const double box[4])
{
  const auto& all = this->Internals->Covered;
  const auto overlaps = [box](const std::array<double, 4>& drawn)
  { return box[0] < drawn[1] && drawn[0] < box[1] && box[2] < drawn[3] && drawn[2] < box[3]; };
  const bool isHelp = this->HelpVisibility && !this->HelpText.empty();
  return this->GetVisibility() && (isHelp || std::any_of(all.begin(), all.end(), overlaps));
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
                                                   << "\" as vtkHapticState::Drain gives "
                                                      "it. Pass its table as it is.");
      return;
    }
  }
  auto* const contacts = vtkDataArray::SafeDownCast(states->GetColumnByName("Contact"));
  auto* const modes = vtkDataArray::SafeDownCast(states->GetColumnByName("ModeForces"));
  auto* const armed = vtkDataArray::SafeDownCast(states->GetColumnByName("Armed"));
  auto* const proxies = vtkDataArray::SafeDownCast(states->GetColumnByName("Proxy"));
  const vtkIdType rows = columns[0]->GetNumberOfTuples();
  for (vtkIdType i = 0; i < rows; ++i)
  {
    const auto isShort = [i](vtkDataArray* column) { return column->GetNumberOfTuples() <= i; };
    if (!std::isfinite(columns[0]->GetComponent(i, 0)) ||
      std::any_of(columns, columns + 5, isShort))
    {
      vtkErrorMacro(<< "The table of states lacks a column or a finite Time in row " << i
                    << ". Pass the table of vtkHapticState::Drain as it is.");
      return;
    }
    double command[3];
    columns[4]->GetTuple(i, command);
    // While the device is not armed, no force is felt, even with the tip inside a surface.
    const double share =
      armed && i < armed->GetNumberOfTuples() && armed->GetComponent(i, 0) == 0.0 ? 0.0 : 1.0;
    HapticForceHistory::State state{ columns[0]->GetComponent(i, 0),
      { share * columns[1]->GetComponent(i, 0), share * columns[2]->GetComponent(i, 0),
        share * columns[3]->GetComponent(i, 0), vtkMath::Norm(command) } };
    for (int c = 0; modes && i < modes->GetNumberOfTuples() && c < modes->GetNumberOfComponents() &&
         HapticForceTable::Curves + c < HapticForceHistory::Curves;
         ++c)
    {
      state.Forces[HapticForceTable::Curves + c] = share * modes->GetComponent(i, c);
    }
    this->Internals->History.Add(state, GetShownSpan(this->TimeSpan));
    if (contacts && i < contacts->GetNumberOfTuples())
    {
      this->Internals->Slide.Add(state.Time, static_cast<int>(contacts->GetComponent(i, 0)),
        this->Internals->MeasureStep(proxies, i));
    }
  }
}

//------------------------------------------------------------------------------
double vtkHapticHeadUpDisplay::vtkInternals::MeasureStep(vtkDataArray* proxies, vtkIdType row)
{
  if (!proxies || proxies->GetNumberOfComponents() != 3 || row >= proxies->GetNumberOfTuples())
  {
    return 1.0; // the distance is unknown, so let the contact alone decide whether the proxy slides
  }
  const std::array<double, 3> before = this->Proxy;
  proxies->GetTuple(row, this->Proxy.data());
  vtkVolumeHapticsFilter* const filter = this->Device ? this->Device->GetVolumeHaptics() : nullptr;
  const double meters = filter ? filter->GetMetersPerWorldUnit() : 0.001;
  return meters * std::sqrt(vtkMath::Distance2BetweenPoints(before.data(), this->Proxy.data()));
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::Clear()
{
  this->Internals->History.Clear();
  this->Internals->Slide.Clear();
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
  vtkHapticDevice* const device = this->Internals->Device;
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  if (all.empty() && filter)
  {
    return NameTissue(filter->GetProperty(), value);
  }
  const auto found = std::find_if(
    all.begin(), all.end(), [&](const TissueRange& t) { return value >= t.From && value < t.To; });
  return found == all.end() ? std::string() : found->Name;
}

//------------------------------------------------------------------------------
vtkIdType DisplayProbe::CountStates(vtkHapticHeadUpDisplay* display)
{
  return static_cast<vtkIdType>(display->Internals->History.GetSize());
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTable> DisplayProbe::CopyPlot(vtkHapticHeadUpDisplay* display)
{
  auto& d = *display->Internals;
  d.History.SetModes(NameModes(d.Device));
  auto copy = vtkSmartPointer<vtkTable>::New();
  copy->DeepCopy(d.History.Plot(GetShownSpan(display->TimeSpan)));
  return copy;
}

//------------------------------------------------------------------------------
double DisplayProbe::GetForceRange(vtkHapticHeadUpDisplay* display)
{
  return display->Internals->History.GetRange();
}

//------------------------------------------------------------------------------
std::string DisplayProbe::GetPlotTitle(vtkHapticHeadUpDisplay* display)
{
  return display->Internals->GetPlotTitle();
}

//------------------------------------------------------------------------------
std::string vtkHapticHeadUpDisplay::GetTouchedTissue()
{
  vtkHapticDevice* const device = this->Internals->Device;
  return device && device->IsRunning() ? NameTouched(*this, device) : std::string();
}

//------------------------------------------------------------------------------
std::string vtkHapticHeadUpDisplay::GetText()
{
  auto& d = *this->Internals;
  // The list of keys replaces the measurements.
  const bool isListed = d.Measurements && this->MeasurementsVisibility && !this->HelpVisibility;
  std::string text;
  const std::string recorded =
    this->RecordingText.empty() ? "" : "Recording " + this->RecordingText;
  const std::string compared = this->SettingsText.empty() ? "" : "Settings " + this->SettingsText;
  for (const std::string& part : { recorded, compared, d.GetStatus(*this), d.GetSecondStatus(*this),
         isListed ? ListMeasurements(d.Measurements) : std::string(), this->Notice })
  {
    text += text.empty() || part.empty() ? part : "\n" + part;
  }
  return text;
}

//------------------------------------------------------------------------------
std::string vtkHapticHeadUpDisplay::vtkInternals::GetSecondStatus(
  vtkHapticHeadUpDisplay& self) const
{
  vtkHapticDevice* const device = this->Second;
  if (!device)
  {
    return {};
  }
  if (!device->IsRunning())
  {
    return "Second hand: " + device->GetStatusText();
  }
  const std::string status = DescribeStatus(device);
  const std::string touch =
    DescribeTouch(device, NameTouched(self, device), device->GetState()->GetContact() == 2);
  const std::string text = status + (status.empty() || touch.empty() ? "" : " ") + touch;
  return "Second hand: " + (text.empty() ? std::string("touches nothing") : text);
}

//------------------------------------------------------------------------------
std::string vtkHapticHeadUpDisplay::vtkInternals::GetStatus(vtkHapticHeadUpDisplay& self)
{
  vtkHapticDevice* const device = this->Device;
  if (!device)
  {
    return "No device";
  }
  if (!device->IsRunning())
  {
    return device->GetStatusText();
  }
  std::string text;
  for (const std::string& line : { DescribeStatus(device),
         DescribeTouch(
           device, NameTouched(self, device), this->Slide.Is(device->GetState()->GetContact())),
         DescribeCut(device), DescribeTime(device),
         self.DetailsVisibility ? DescribeDetails(device) : std::string() })
  {
    text += text.empty() || line.empty() ? line : "\n" + line;
  }
  return text;
}

//------------------------------------------------------------------------------
bool vtkHapticHeadUpDisplay::ScrollHelp(int lines)
{
  return this->GetVisibility() && this->HelpVisibility && !this->HelpText.empty() &&
    this->Internals->Keys->Scroll(lines);
}

//------------------------------------------------------------------------------
int vtkHapticHeadUpDisplay::FindMode(int x, int y)
{
  auto& d = *this->Internals;
  return this->GetVisibility() && this->TextVisibility && GetModesFilter(d.Device)
    ? d.Modes.Find(x, y)
    : -1;
}

//------------------------------------------------------------------------------
int vtkHapticHeadUpDisplay::RenderOverlay(vtkViewport* viewport)
{
  if (!VolumeHaptics::IsDrawing(viewport) || VolumeHaptics::IsGivenUp(viewport))
  {
    return 0;
  }
  auto& d = *this->Internals;
  d.Modes.Hide();
  d.Covered.clear();
  const int drawn = this->TextVisibility ? d.RenderText(*this, viewport) : 0;
  // The list of keys replaces the plot and the hint.
  if (this->HelpVisibility && !this->HelpText.empty() && d.DetectContext(*this))
  {
    return drawn + d.RenderHelp(*this, viewport);
  }
  const bool isHintShown = this->HintVisibility && !this->Hint.empty();
  return drawn +
    (this->PlotVisibility && d.DetectContext(*this) ? d.RenderPlot(*this, viewport) : 0) +
    (isHintShown ? d.RenderHint(*this, viewport) : 0);
}

//------------------------------------------------------------------------------
int vtkHapticHeadUpDisplay::vtkInternals::RenderText(
  vtkHapticHeadUpDisplay& self, vtkViewport* viewport)
{
  const auto hasFault = [](vtkHapticDevice* device)
  { return device && device->GetStatus() == vtkHapticDevice::FAULT; };
  const bool isFault = hasFault(this->Device) || hasFault(this->Second);
  SetLook(this->Text->GetTextProperty(), isFault ? 1.0 : 0.90, isFault ? 0.55 : 0.92,
    isFault ? 0.45 : 0.95, viewport);
  const std::chrono::duration<double> now = std::chrono::steady_clock::now().time_since_epoch();
  const std::string& text =
    this->TextPace.Choose(self.GetText(), VolumeHaptics::IsMoving(viewport), now.count());
  int drawn = 0;
  double size[2] = { 0.0, 0.0 };
  if (!text.empty())
  {
    const int* const view = viewport->GetSize();
    const std::array<int, 2> panel =
      HapticForceChart::PanelSize(view[0], view[1], PixelsPerPoint(viewport));
    const int plot =
      self.PlotVisibility ? ComputePlotCorner(self.PlotCorner, viewport, panel)[1] + panel[1] : 0;
    this->Wrapped.Fit(this->Text, text, FindRoom(viewport, TextLeft, TextTop, plot + TextGap));
    this->Text->GetSize(viewport, size);
    const double left = TextLeft * view[0];
    const double top = TextTop * view[1];
    const ViewportBox at = MoveOff(viewport, { left, left + size[0], top - size[1], top }, 1, -1);
    this->Text->GetPositionCoordinate()->SetValue(at[0] / view[0], at[3] / view[1]);
    this->Text->RenderOpaqueGeometry(viewport); // renders the text into the texture that is drawn
                                                // next
    drawn += this->Text->RenderOverlay(viewport);
    this->Covered.push_back(
      { at[0] - left, at[1] + TextGap, at[2] - TextGap, at[3] + view[1] - top });
    size[1] = top - at[2];
  }
  this->TextHeight = size[1];
  return drawn +
    this->Modes.Render(
      DescribeModeForces(this->Device), this->ComputeTextEnd(self, viewport) - TextGap, viewport);
}

//------------------------------------------------------------------------------
int vtkHapticHeadUpDisplay::vtkInternals::ComputeTextEnd(
  vtkHapticHeadUpDisplay& self, vtkViewport* viewport) const
{
  const double height = self.TextVisibility ? this->TextHeight : 0.0;
  return static_cast<int>(TextTop * viewport->GetSize()[1] - height);
}

//------------------------------------------------------------------------------
int vtkHapticHeadUpDisplay::vtkInternals::RenderHint(
  vtkHapticHeadUpDisplay& self, vtkViewport* viewport)
{
  constexpr int largest = 16; // points
  constexpr int smallest = 7;
  const int* const view = viewport->GetSize();
  // Centre the hint, and end it before the area where other renderers draw at the right.
  const double room = 2.0 * ComputeTextRight(viewport) - view[0];
  this->Hint->SetInput(self.Hint.c_str());
  this->Hint->GetTextProperty()->SetBackgroundOpacity(IsOnLight(viewport) ? 0.95 : 0.75);
  double size[2];
  for (int letters = largest; letters >= smallest; --letters)
  {
    this->Hint->GetTextProperty()->SetFontSize(letters);
    this->Hint->GetSize(viewport, size);
    if (size[0] + 2 * TextGap <= room)
    {
      break;
    }
  }
  const double left = 0.5 * (view[0] - size[0]) - TextGap;
  const double end =
    std::min(this->ComputeTextEnd(self, viewport), this->Modes.FindLow(static_cast<int>(left))) -
    TextGap;
  const ViewportBox at = MoveOff(viewport,
    { left, 0.5 * (view[0] + size[0]) + TextGap, end - size[1] - TextGap, end + TextGap }, 0, -1);
  // This position, like all boxes here, is relative to the viewport.
  this->Hint->SetPosition(view[0] / 2, static_cast<int>(at[3] - TextGap));
  this->Covered.push_back(at);
  this->Hint->RenderOpaqueGeometry(viewport);
  return this->Hint->RenderOverlay(viewport);
}

//------------------------------------------------------------------------------
bool vtkHapticHeadUpDisplay::vtkInternals::DetectContext(vtkHapticHeadUpDisplay& self)
{
  if (this->CanDraw == -1)
  {
    // Check first whether a class can draw charts: without one, a chart crashes.
    const auto context = vtkSmartPointer<vtkContextDevice2D>::Take(vtkContextDevice2D::New());
    this->CanDraw = context ? 1 : 0;
    if (context)
    {
      this->Chart.Build();
      this->Help->GetScene()->AddItem(this->Keys);
    }
    else
    {
      vtkErrorWithObjectMacro(&self,
        "VTK has no back end that draws charts. Link VTK::RenderingContextOpenGL2, with "
        "vtk_module_autoinit, and include vtkRenderingContext2DModule.h in a source; or in Python "
        "import vtkmodules.vtkRenderingContextOpenGL2.");
    }
  }
  return this->CanDraw == 1;
}

//------------------------------------------------------------------------------
int vtkHapticHeadUpDisplay::vtkInternals::RenderPlot(
  vtkHapticHeadUpDisplay& self, vtkViewport* viewport)
{
  const int* const size = viewport->GetSize();
  const double scale = PixelsPerPoint(viewport);
  const std::array<int, 2> panel = HapticForceChart::PanelSize(size[0], size[1], scale);
  const std::array<int, 2> from = ComputePlotCorner(self.PlotCorner, viewport, panel);
  const bool isOther = this->Chart.SetOnLight(IsOnLight(viewport));
  const bool isMoved = this->Chart.Fit(size[0], size[1], from, scale) || isOther;
  // Limit how often the chart is updated: with a software renderer, drawing it takes some
  // milliseconds, but drawing its texture only a tenth of a millisecond.
  const auto now = std::chrono::steady_clock::now();
  const bool isDue = now >= this->Due;
  const double span = GetShownSpan(self.TimeSpan);
  const std::vector<std::string> modes = NameModes(this->Device);
  this->History.SetModes(modes);
  this->Chart.SetModes(NameActiveModes(this->Device));
  const bool isStale = isDue &&
    this->Chart.Show(
      this->History.Plot(span), { -span, 0.0, this->History.GetRange() }, this->GetPlotTitle());
  const int* const corner = this->Chart.GetCorner();
  this->Covered.push_back({ static_cast<double>(from[0]), static_cast<double>(corner[0]),
    static_cast<double>(from[1]), static_cast<double>(corner[1]) });
  const int drawn =
    this->Picture.Render(viewport, this->Chart.GetActor(), corner, isStale || isMoved);
  if (isStale)
  {
    // Limit the pause, because the first update takes longer than later ones.
    const std::chrono::nanoseconds pause = ChartPause * (std::chrono::steady_clock::now() - now);
    this->Due = now +
      std::clamp<std::chrono::nanoseconds>(
        pause, std::chrono::milliseconds(50), std::chrono::milliseconds(250));
  }
  return drawn;
}

//------------------------------------------------------------------------------
int vtkHapticHeadUpDisplay::vtkInternals::RenderHelp(
  vtkHapticHeadUpDisplay& self, vtkViewport* viewport)
{
  // Place the list below the text, unless that leaves less than half of the height.
  const int* const size = viewport->GetSize();
  const int below = this->ComputeTextEnd(self, viewport) - TextGap;
  this->Keys->Show(
    self.HelpText, size[0], 2 * below > size[1] ? below : size[1], PixelsPerPoint(viewport));
  return this->Help->RenderOverlay(viewport);
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Internals->Picture.ReleaseGraphicsResources(window);
  this->Internals->Modes.Release(window);
  this->Internals->Chart.GetActor()->ReleaseGraphicsResources(window);
  this->Internals->Text->ReleaseGraphicsResources(window);
  this->Internals->Hint->ReleaseGraphicsResources(window);
  this->Internals->Help->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

//------------------------------------------------------------------------------
void vtkHapticHeadUpDisplay::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Device: " << this->GetDevice() << "\n";
  os << indent << "SecondDevice: " << this->GetSecondDevice() << "\n";
  PrintSettings(os, indent, this, DisplaySettings);
  os << indent << "Measurements: " << this->GetMeasurements() << "\n";
  os << indent << "Notice: " << this->Notice << "\n";
  os << indent << "RecordingText: " << this->RecordingText << "\n";
  os << indent << "SettingsText: " << this->SettingsText << "\n";
  os << indent << "Hint: " << this->Hint << "\n";
  os << indent << "HelpText: " << this->HelpText << "\n";
  os << indent << "States: " << this->Internals->History.GetSize() << "\n";
  os << indent << "Tissues: " << this->Internals->Tissues.size() << "\n";
}

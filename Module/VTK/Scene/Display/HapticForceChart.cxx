// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/HapticForceChart.h"

#include "VTK/Scene/Base/HapticChartText.h"
#include "VTK/Scene/Base/HapticPixels.h"

#include "vtkAxis.h"
#include "vtkBlockItem.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContext2D.h"
#include "vtkContextActor.h"
#include "vtkContextItem.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkStdString.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <tuple>
#include <vector>

namespace
{
/** Line spacing and gap, relative to the size of letters. */
constexpr float NameLineHeight = 1.5f;
constexpr float NameGap = 0.9f;
constexpr double TitleInk[3] = { 0.90, 0.92, 0.95 };
} // namespace

/**
 * Draws a title, and below it the names of curves in their colours. They are above a small chart,
 * because a legend would cover its curves.
 */
class HapticCurveNames : public vtkContextItem
{
public:
  static HapticCurveNames* New();
  vtkTypeMacro(HapticCurveNames, vtkContextItem);

  struct Name
  {
    std::string Text;
    std::array<unsigned char, 3> Color;
  };
  void SetTitle(const std::string& title) { this->Title = title; }
  void SetNames(const std::vector<Name>& names) { this->Names = names; }
  /**
   * Sets the left end and the upper edge of the first letter (pixels), and the size of letters
   * (points).
   */
  void Place(float left, float top, int letters, float scale = 1.0f);
  /** Returns the height (pixels) of the title and the line of names together. */
  static float GetHeight(int letters);

  bool Paint(vtkContext2D* painter) override;

protected:
  HapticCurveNames();
  ~HapticCurveNames() override;

private:
  HapticCurveNames(const HapticCurveNames&) = delete;
  void operator=(const HapticCurveNames&) = delete;

  std::string Title;
  std::vector<Name> Names;
  float Left = 0.0f;
  float Top = 0.0f;
  int Letters = 10;
  float Scale = 1.0f; ///< pixels per point
};

vtkStandardNewMacro(HapticCurveNames);

//------------------------------------------------------------------------------
HapticCurveNames::HapticCurveNames() = default;

//------------------------------------------------------------------------------
HapticCurveNames::~HapticCurveNames() = default;

//------------------------------------------------------------------------------
void HapticCurveNames::Place(float left, float top, int letters, float scale)
{
  this->Left = left;
  this->Top = top;
  this->Letters = letters;
  this->Scale = scale;
}

//------------------------------------------------------------------------------
float HapticCurveNames::GetHeight(int letters)
{
  return 2.0f * NameLineHeight * static_cast<float>(letters);
}

//------------------------------------------------------------------------------
bool HapticCurveNames::Paint(vtkContext2D* painter)
{
  vtkTextProperty* const look = painter->GetTextProp();
  look->SetFontSize(this->Letters);
  look->BoldOff();
  look->ItalicOff();
  look->SetOrientation(0.0);
  look->SetJustificationToLeft();
  look->SetVerticalJustificationToTop();
  if (!this->Title.empty())
  {
    look->SetColor(TitleInk[0], TitleInk[1], TitleInk[2]);
    painter->DrawString(this->Left, this->Top, this->Title);
  }
  const float size = this->Scale * static_cast<float>(this->Letters);
  float x = this->Left;
  for (const Name& name : this->Names)
  {
    look->SetColor(name.Color[0] / 255.0, name.Color[1] / 255.0, name.Color[2] / 255.0);
    painter->DrawString(x, this->Top - NameLineHeight * size, name.Text);
    float bounds[4]; // x and y of the lower left corner, width, height
    painter->ComputeStringBounds(name.Text, bounds);
    x += bounds[2] + NameGap * size;
  }
  return true;
}

namespace VolumeHaptics
{
namespace
{

constexpr int ChartMargin = 10;   // pixels around a panel
constexpr int PanelOpacity = 150; // opacity, of at most 255
constexpr int PanelOpacityOnLight = 240;
constexpr int LeftTop = 3; // vtkChartXY's index of the corner with the left and the top axis

struct Colour
{
  unsigned char Red, Green, Blue;
};

/** Colours of the chart on a dark panel or on a white page. */
struct Look
{
  double Text[3];
  Colour Axis;
  Colour Grid;
  Colour Curves[HapticForceTable::Curves];
  const char* WholeLabel; ///< short on a panel, whose legend is small
  float WholeWidth;
  bool HasUprightGrid;
};
// The whole force is grey. People with colour blindness can distinguish the other curves: blue,
// orange and green.
const Look PanelLook = { { 0.90, 0.92, 0.95 }, { 170, 176, 186 }, { 70, 76, 86 },
  { { 80, 165, 255 }, { 255, 160, 60 }, { 70, 215, 150 }, { 165, 170, 178 } }, "whole", 3.5f,
  false };
const Look PageLook = { { 0.12, 0.13, 0.15 }, { 90, 95, 105 }, { 228, 231, 236 },
  { { 0, 92, 175 }, { 222, 110, 0 }, { 0, 140, 95 }, { 165, 170, 178 } }, "whole force", 4.5f,
  true };

const Look& GetLook(HapticForceChart::Ground ground)
{
  return ground == HapticForceChart::Ground::Panel ? PanelLook : PageLook;
}

const char* const PartLabels[] = { "normal", "friction", "drag" };
constexpr int Whole = 3;
const int DrawingOrder[] = { Whole, 0, 1, 2 }; // the whole force first, behind the other curves

/** Sets the title of an axis. With a unit, each number on the axis is followed by it. */
void SetAxis(vtkAxis* axis, const char* title, const char* unit, const Look& look)
{
  axis->SetTitle(title);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetNotation(vtkAxis::STANDARD_NOTATION);
  if (*unit)
  {
    axis->SetNotation(vtkAxis::PRINTF_NOTATION);
    axis->SetLabelFormat(std::string("%g ") + unit);
  }
  axis->GetPen()->SetColor(look.Axis.Red, look.Axis.Green, look.Axis.Blue);
  axis->GetGridPen()->SetColor(look.Grid.Red, look.Grid.Green, look.Grid.Blue);
}

/**
 * Copies only the points that are needed to draw a curve to within an error, because wide lines
 * cost a software renderer microseconds per point. From each copied point on, narrows the range of
 * slopes that pass all later points, until the range is empty (swinging door algorithm).
 */
void Simplify(vtkFloatArray* time, vtkFloatArray* force, double error, vtkTable* line)
{
  auto* const x = vtkFloatArray::SafeDownCast(line->GetColumn(0));
  auto* const y = vtkFloatArray::SafeDownCast(line->GetColumn(1));
  x->SetNumberOfValues(0);
  y->SetNumberOfValues(0);
  const auto keep = [&](vtkIdType i)
  {
    x->InsertNextValue(time->GetValue(i));
    y->InsertNextValue(force->GetValue(i));
  };
  const vtkIdType last = time->GetNumberOfValues() - 1;
  double low = -VTK_DOUBLE_MAX;
  double high = VTK_DOUBLE_MAX;
  vtkIdType from = 0;
  for (vtkIdType i = 0; i <= last; ++i)
  {
    const double run = time->GetValue(i) - time->GetValue(from);
    const double rise = force->GetValue(i) - force->GetValue(from);
    const bool isStep = run <= 0.0 && i > 0 && std::abs(rise) > error;
    if (i == 0 || isStep || (run > 0.0 && (rise < low * run || rise > high * run)))
    {
      // A straight line ends at the point before this one; a step begins at this point.
      from = i == 0 || isStep ? i : i - 1;
      keep(from);
      low = -VTK_DOUBLE_MAX;
      high = VTK_DOUBLE_MAX;
    }
    const double width = time->GetValue(i) - time->GetValue(from);
    if (width > 0.0)
    {
      const double height = force->GetValue(i) - force->GetValue(from);
      low = std::max(low, (height - error) / width);
      high = std::min(high, (height + error) / width);
    }
  }
  if (last > from)
  {
    keep(last);
  }
  line->Modified();
}

} // namespace

HapticForceChart::HapticForceChart(Ground ground)
  : On(ground)
{
}

HapticForceChart::~HapticForceChart() = default;

void HapticForceChart::Build()
{
  const Look& look = GetLook(this->On);
  vtkChartLegend* const legend = this->Chart->GetLegend();
  if (this->On == Ground::Panel)
  {
    // Don't use the chart's own background, which VTK 9.1 draws in the wrong place.
    this->Panel->SetAutoComputeDimensions(false);
    this->Panel->GetBrush()->SetColor(15, 18, 24, PanelOpacity);
    this->Panel->GetMouseOverBrush()->SetColor(15, 18, 24, PanelOpacity);
    this->Panel->GetPen()->SetOpacity(0);
    this->Actor->GetScene()->AddItem(this->Panel);
    this->Actor->GetScene()->AddItem(this->Names);
  }
  this->Actor->GetScene()->AddItem(this->Chart);
  this->Chart->SetAutoSize(false);
  const bool isPage = this->On == Ground::Page;
  this->Chart->SetShowLegend(isPage);
  SetAxis(this->Chart->GetAxis(vtkAxis::BOTTOM), isPage ? "Time (s)" : "", isPage ? "" : "s", look);
  SetAxis(this->Chart->GetAxis(vtkAxis::LEFT), isPage ? "Force (N)" : "", isPage ? "" : "N", look);
  SetAxis(this->Chart->GetAxis(vtkAxis::TOP), "", "", look);
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetGridVisible(look.HasUprightGrid);
  legend->SetHorizontalAlignment(vtkChartLegend::LEFT);
  legend->SetVerticalAlignment(vtkChartLegend::TOP);
  legend->GetPen()->SetOpacity(0);
  for (const int c : DrawingOrder)
  {
    vtkPlot* const line = this->AddLine(c);
    line->SetLabel(c == Whole ? look.WholeLabel : PartLabels[c]);
    line->SetColor(look.Curves[c].Red, look.Curves[c].Green, look.Curves[c].Blue, 255);
    line->SetWidth(c == Whole ? look.WholeWidth : 1.8f);
  }
  this->NameCurves();
}

void HapticForceChart::NameCurves()
{
  // Skip the names of modes, which are in a list beside the panel.
  const Look& look = GetLook(this->On);
  std::vector<HapticCurveNames::Name> names;
  for (const int c : DrawingOrder)
  {
    if (c == Whole || this->Modes.empty())
    {
      const Colour& colour = look.Curves[c];
      names.push_back({ c == Whole ? look.WholeLabel : PartLabels[c],
        { colour.Red, colour.Green, colour.Blue } });
    }
  }
  this->Names->SetNames(names);
}

void HapticForceChart::SetTitle(const std::string& title)
{
  this->ShownTitle = title;
  if (this->On == Ground::Panel)
  {
    this->Names->SetTitle(title);
    return;
  }
  this->Chart->SetTitle(title);
  this->Chart->RecalculateBounds();
}

vtkPlot* HapticForceChart::AddLine(int curve)
{
  vtkPlot* const line = this->Chart->AddPlot(vtkChart::LINE);
  vtkNew<vtkFloatArray> time;
  vtkNew<vtkFloatArray> force;
  time->SetName("Time");
  force->SetName("Force");
  this->Lines[curve]->AddColumn(time);
  this->Lines[curve]->AddColumn(force);
  line->SetInputData(this->Lines[curve], 0, 1);
  this->Plots[curve] = line;
  return line;
}

void HapticForceChart::SetModes(const std::vector<std::string>& names)
{
  if (names == this->Modes)
  {
    return;
  }
  this->Modes = names;
  this->Shown = nullptr; // makes Show() draw all curves again
  const auto& colors = this->On == Ground::Panel ? ModeColors : ModePageColors;
  for (std::size_t mode = 0; mode < ModeColorCount; ++mode)
  {
    const int c = HapticForceTable::Curves + static_cast<int>(mode);
    const bool isNamed = mode < names.size() && !names[mode].empty();
    if (isNamed)
    {
      vtkPlot* const line = this->Plots[c] ? this->Plots[c] : this->AddLine(c);
      line->SetLabel(names[mode]);
      line->SetColor(colors[mode][0], colors[mode][1], colors[mode][2], 255);
      line->SetWidth(1.8f);
    }
    if (this->Plots[c])
    {
      this->Plots[c]->SetVisible(isNamed);
      this->Plots[c]->SetLegendVisibility(isNamed);
    }
  }
  // With modes, hide the parts of the force, but not the whole force.
  for (int c = 0; c < Whole; ++c)
  {
    this->Plots[c]->SetVisible(names.empty());
    this->Plots[c]->SetLegendVisibility(names.empty());
  }
  this->NameCurves();
}

void HapticForceChart::SetLetters(int size)
{
  // On a page, use larger titles and legends, since there is space for them.
  const bool isPage = this->On == Ground::Page;
  const double(&colour)[3] = GetLook(this->On).Text;
  SetChartText(this->Chart->GetTitleProperties(), size + (isPage ? 3 : 1), colour);
  for (const int axis : { vtkAxis::BOTTOM, vtkAxis::LEFT, vtkAxis::TOP })
  {
    SetChartText(this->Chart->GetAxis(axis)->GetTitleProperties(), size, colour);
    SetChartText(this->Chart->GetAxis(axis)->GetLabelProperties(),
      size - (axis == vtkAxis::TOP ? 2 : 1), colour);
  }
  SetChartText(this->Chart->GetLegend()->GetLabelProperties(), size - (isPage ? 0 : 1), colour);
}

std::array<int, 2> HapticForceChart::PanelSize(int width, int height, double scale)
{
  // Limit the size, so that the panel covers nothing in the middle of the viewport.
  const auto fit = [scale](int pixels, int least, int most)
  { return std::clamp(pixels, ScalePixels(scale, least), ScalePixels(scale, most)); };
  return { ChartMargin + std::min(width - 2 * ChartMargin, fit(width * 3 / 10, 210, 330)),
    ChartMargin + fit(height * 22 / 100, 120, 180) };
}

bool HapticForceChart::SetOnLight(bool isOnLight)
{
  if (isOnLight == this->IsOnLight)
  {
    return false;
  }
  this->IsOnLight = isOnLight;
  const int opacity = isOnLight ? PanelOpacityOnLight : PanelOpacity;
  this->Panel->GetBrush()->SetOpacity(static_cast<unsigned char>(opacity));
  this->Panel->GetMouseOverBrush()->SetOpacity(static_cast<unsigned char>(opacity));
  return true;
}

bool HapticForceChart::Fit(int width, int height, const std::array<int, 2>& from, double scale)
{
  if (width == this->Viewport[0] && height == this->Viewport[1] && from == this->From &&
    scale == this->Scale)
  {
    return false; // unchanged: setting the size again would make the chart repeat its layout
  }
  this->Viewport[0] = width;
  this->Viewport[1] = height;
  this->From = from;
  this->Scale = scale;
  if (this->On == Ground::Page)
  {
    this->SetLetters(std::max(9, height / 36));
    this->Chart->SetSize(
      vtkRectf(0.0f, 0.0f, static_cast<float>(width), static_cast<float>(height)));
    this->Height = height;
    std::copy(this->Viewport, this->Viewport + 2, this->Corner);
    return true;
  }
  const std::array<int, 2> size = HapticForceChart::PanelSize(width, height, scale);
  const auto across = static_cast<float>(size[0] - ChartMargin);
  const auto up = static_cast<float>(size[1] - ChartMargin);
  const auto left = static_cast<float>(from[0] + ChartMargin);
  const auto bottom = static_cast<float>(from[1] + ChartMargin);
  constexpr int letters = 10;
  const auto pixels = static_cast<float>(scale);
  const float gap = 6.0f * pixels;
  const float names = HapticCurveNames::GetHeight(letters) * pixels;
  this->SetLetters(letters);
  this->Panel->SetDimensions(left, bottom, across, up);
  this->Names->Place(left + 2.0f * gap, bottom + up - gap, letters, pixels);
  // VTK leaves a wide border above the chart. The names may cover it, except for the half of the
  // axis's upper number inside it.
  const float border = 15.0f - 5.0f * pixels;
  this->Height = up - names + border;
  this->Chart->SetSize(vtkRectf(left, bottom, across, static_cast<float>(this->Height)));
  this->Corner[0] = from[0] + size[0];
  this->Corner[1] = from[1] + size[1];
  return true;
}

bool HapticForceChart::Show(vtkTable* table, const Extent& extent, const std::string& title)
{
  const auto numbers = [](const Extent& e) { return std::make_tuple(e.From, e.To, e.Force); };
  if (table == this->Shown && table->GetMTime() == this->ShownTime &&
    numbers(extent) == numbers(this->ShownExtent) && title == this->ShownTitle)
  {
    return false;
  }
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetRange(extent.From, extent.To);
  this->Chart->GetAxis(vtkAxis::TOP)->SetRange(extent.From, extent.To);
  this->Chart->GetAxis(vtkAxis::LEFT)->SetRange(0.0, extent.Force);
  this->Shown = table;
  this->ShownTime = table->GetMTime();
  this->ShownExtent = extent;
  if (title != this->ShownTitle)
  {
    this->SetTitle(title);
  }
  const double pixel = extent.Force / this->Height; // force (N) per pixel
  const auto modes = static_cast<int>(std::min(this->Modes.size(), ModeColorCount));
  for (int c = 0; c < HapticForceTable::Curves + modes; ++c)
  {
    if (!this->Plots[c])
    {
      continue; // a mode that was never active has no curve
    }
    Simplify(vtkFloatArray::SafeDownCast(table->GetColumn(0)),
      vtkFloatArray::SafeDownCast(table->GetColumn(1 + c)), 0.25 * pixel, this->Lines[c]);
    if (this->Lines[c]->GetNumberOfRows() < 2)
    {
      // Draw a line at 0 over the whole time span: VTK reports errors for lines of fewer than two
      // points, and draws no axes without lines.
      for (const double t : { extent.From, extent.To })
      {
        vtkFloatArray::SafeDownCast(this->Lines[c]->GetColumn(0))
          ->InsertNextValue(static_cast<float>(t));
        vtkFloatArray::SafeDownCast(this->Lines[c]->GetColumn(1))->InsertNextValue(0.0f);
      }
    }
  }
  return true;
}

void HapticForceChart::ShowPhases(const std::vector<Phase>& phases)
{
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> names;
  for (const Phase& phase : phases)
  {
    positions->InsertNextValue(0.5 * (phase.From + phase.To));
    std::string name = phase.Name;
    std::replace(name.begin(), name.end(), ' ', '\n');
    names->InsertNextValue(name);
    if (&phase == phases.data())
    {
      continue;
    }
    vtkNew<vtkTable> ends;
    vtkNew<vtkFloatArray> time;
    vtkNew<vtkFloatArray> force;
    time->SetName("Time");
    force->SetName("Force");
    for (const double end : { 0.0, this->ShownExtent.Force })
    {
      time->InsertNextValue(static_cast<float>(phase.From));
      force->InsertNextValue(static_cast<float>(end));
    }
    ends->AddColumn(time);
    ends->AddColumn(force);
    vtkPlot* const line = this->Chart->AddPlot(vtkChart::LINE);
    this->Chart->SetPlotCorner(line, LeftTop); // needed because VTK shows an axis only if a plot
                                               // uses it
    line->SetInputData(ends, 0, 1);
    line->SetLegendVisibility(false);
    line->SetSelectable(false);
    line->GetPen()->SetLineType(vtkPen::DASH_LINE);
    line->SetColor(170, 176, 186, 255);
    line->SetWidth(1.0f);
  }
  vtkAxis* const axis = this->Chart->GetAxis(vtkAxis::TOP);
  axis->SetVisible(!phases.empty());
  axis->SetGridVisible(false);
  axis->SetTicksVisible(false);
  axis->SetCustomTickPositions(positions, names);
}

} // namespace VolumeHaptics

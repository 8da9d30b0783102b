// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Charts/HapticForceChart.h"

#include "VTK/Charts/HapticChartText.h"

#include "vtkAxis.h"
#include "vtkBlockItem.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkFloatArray.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

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

constexpr double LightText[3] = { 0.90, 0.92, 0.95 };

void SetAxis(vtkAxis* axis, const char* title)
{
  axis->SetTitle(title);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetNotation(vtkAxis::STANDARD_NOTATION);
  SetChartText(axis->GetTitleProperties(), 11, LightText);
  SetChartText(axis->GetLabelProperties(), 10, LightText);
  axis->GetPen()->SetColor(170, 176, 186);
  axis->GetGridPen()->SetColor(70, 76, 86);
}

/**
 * The points of a curve that are needed to draw it to within an error: from each of them on, those
 * slopes are kept that pass all later points, until there are none (swinging door). Wide lines cost
 * a renderer in software microseconds for each point.
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
      // The one before is the last that a straight line reaches; a step needs its own end.
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

HapticForceChart::HapticForceChart() = default;
HapticForceChart::~HapticForceChart() = default;

void HapticForceChart::Build()
{
  // Not the chart's own background, which VTK 9.1 draws in the wrong place.
  this->Panel->SetAutoComputeDimensions(false);
  this->Panel->GetBrush()->SetColor(15, 18, 24, 150);
  this->Panel->GetMouseOverBrush()->SetColor(15, 18, 24, 150);
  this->Panel->GetPen()->SetOpacity(0);
  this->Actor->GetScene()->AddItem(this->Panel);
  this->Actor->GetScene()->AddItem(this->Chart);
  this->Chart->SetAutoSize(false);
  this->Chart->SetShowLegend(true);
  SetChartText(this->Chart->GetTitleProperties(), 12, LightText);
  SetAxis(this->Chart->GetAxis(vtkAxis::BOTTOM), "Time (s)");
  SetAxis(this->Chart->GetAxis(vtkAxis::LEFT), "Force (N)");
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetGridVisible(false);
  vtkChartLegend* const legend = this->Chart->GetLegend();
  SetChartText(legend->GetLabelProperties(), 10, LightText);
  legend->SetHorizontalAlignment(vtkChartLegend::LEFT);
  legend->SetVerticalAlignment(vtkChartLegend::TOP);
  legend->GetPen()->SetOpacity(0);
  legend->GetBrush()->SetOpacity(0);
  for (const int c : DrawingOrder)
  {
    vtkPlot* const line = this->Chart->AddPlot(vtkChart::LINE);
    vtkNew<vtkFloatArray> time;
    vtkNew<vtkFloatArray> force;
    time->SetName("Time");
    force->SetName("Force");
    this->Lines[c]->AddColumn(time);
    this->Lines[c]->AddColumn(force);
    line->SetInputData(this->Lines[c], 0, 1);
    line->SetLabel(Curves[c].Label);
    line->SetColor(Curves[c].Color[0], Curves[c].Color[1], Curves[c].Color[2], 255);
    line->SetWidth(Curves[c].Width);
  }
}

void HapticForceChart::Fit(int width, int height)
{
  if (width == this->Viewport[0] && height == this->Viewport[1])
  {
    return; // a chart that is given its size lays itself out anew
  }
  this->Viewport[0] = width;
  this->Viewport[1] = height;
  constexpr float margin = 10.0f;
  const auto across = static_cast<float>(std::min(width - 20, 620));
  const auto up = static_cast<float>(std::clamp(height * 3 / 10, 130, 220));
  this->Panel->SetDimensions(margin, margin, across, up);
  this->Chart->SetSize(vtkRectf(margin, margin, across - 10.0f, up - 6.0f));
  this->Height = up;
  this->Extent[0] = static_cast<int>(margin + across);
  this->Extent[1] = static_cast<int>(margin + up);
}

bool HapticForceChart::Show(vtkTable* table, double span, double force, const std::string& title)
{
  if (table == this->Shown && table->GetMTime() == this->ShownTime && force == this->ShownForce &&
    span == this->ShownSpan && title == this->ShownTitle)
  {
    return false;
  }
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetRange(-span, 0.0);
  this->Chart->GetAxis(vtkAxis::LEFT)->SetRange(0.0, force);
  this->Shown = table;
  this->ShownTime = table->GetMTime();
  this->ShownForce = force;
  this->ShownSpan = span;
  if (title != this->ShownTitle)
  {
    this->ShownTitle = title;
    this->Chart->SetTitle(title);
    this->Chart->RecalculateBounds();
  }
  const double pixel = force / this->Height; // N
  for (int i = 0; i < HapticForceHistory::Curves; ++i)
  {
    const int c = DrawingOrder[i];
    Simplify(vtkFloatArray::SafeDownCast(table->GetColumn(0)),
      vtkFloatArray::SafeDownCast(table->GetColumn(1 + c)), 0.25 * pixel, this->Lines[c]);
    if (this->Lines[c]->GetNumberOfRows() < 2)
    {
      // VTK complains of lines with fewer points, and draws no axes without lines.
      for (const double t : { -span, 0.0 })
      {
        vtkFloatArray::SafeDownCast(this->Lines[c]->GetColumn(0))
          ->InsertNextValue(static_cast<float>(t));
        vtkFloatArray::SafeDownCast(this->Lines[c]->GetColumn(1))->InsertNextValue(0.0f);
      }
    }
  }
  return true;
}

} // namespace VolumeHaptics

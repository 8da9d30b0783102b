// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticForceChart.h"

#include "vtkAxis.h"
#include "vtkBlockItem.h"
#include "vtkBrush.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>

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

HapticForceChart::HapticForceChart() = default;
HapticForceChart::~HapticForceChart() = default;

void HapticForceChart::Build(vtkTable* table)
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
  SetAxis(this->Chart->GetAxis(vtkAxis::BOTTOM), "Time (s)");
  SetAxis(this->Chart->GetAxis(vtkAxis::LEFT), "Force (N)");
  vtkChartLegend* const legend = this->Chart->GetLegend();
  SetFont(legend->GetLabelProperties(), 10);
  legend->SetHorizontalAlignment(vtkChartLegend::LEFT);
  legend->SetVerticalAlignment(vtkChartLegend::TOP);
  legend->GetPen()->SetOpacity(0);
  legend->GetBrush()->SetOpacity(0);
  for (const int c : DrawingOrder)
  {
    vtkPlot* const line = this->Chart->AddPlot(vtkChart::LINE);
    line->SetInputData(table, 0, 1 + c);
    line->SetLabel(Curves[c].Label);
    line->SetColor(Curves[c].Color[0], Curves[c].Color[1], Curves[c].Color[2], 255);
    line->SetWidth(Curves[c].Width);
  }
}

void HapticForceChart::SetRanges(double span, double force)
{
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetRange(-span, 0.0);
  this->Chart->GetAxis(vtkAxis::LEFT)->SetRange(0.0, force);
}

void HapticForceChart::ShowCurves(bool shown)
{
  for (vtkIdType i = 0; i < this->Chart->GetNumberOfPlots(); ++i)
  {
    this->Chart->GetPlot(i)->SetVisible(shown);
  }
}

void HapticForceChart::Fit(int width, int height)
{
  constexpr float margin = 10.0f;
  const auto across = static_cast<float>(std::min(width - 20, 620));
  const auto up = static_cast<float>(std::clamp(height * 3 / 10, 130, 220));
  this->Panel->SetDimensions(margin, margin, across, up);
  this->Chart->SetSize(vtkRectf(margin, margin, across - 10.0f, up - 6.0f));
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Report/ForceChart.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
using Explore::ChartOptions;
using Explore::Phase;

constexpr int LEFT_TOP = 3; // vtkChartXY's number for a plot on the left and the top axis

struct Curve
{
  const char* Array;
  const char* Label;
  unsigned char Colour[3];
  float Width;
};

// Blue, orange and green that remain apart for the colour-blind; the sum behind them in grey.
const Curve CURVES[] = {
  { "Force", "whole force", { 165, 170, 178 }, 4.5f },
  { "NormalForce", "normal", { 0, 92, 175 }, 1.8f },
  { "FrictionForce", "friction", { 222, 110, 0 }, 1.8f },
  { "DragForce", "drag", { 0, 140, 95 }, 1.8f },
};

/// Time and one column a curve.
vtkSmartPointer<vtkTable> MakeTable(vtkPolyData* trace, double& largest)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkPointData* arrays = trace->GetPointData();
  vtkNew<vtkDoubleArray> time;
  time->DeepCopy(arrays->GetArray("Time"));
  table->AddColumn(time);
  for (const Curve& curve : CURVES)
  {
    vtkDataArray* source = arrays->GetArray(curve.Array);
    vtkNew<vtkDoubleArray> column;
    column->SetName(curve.Label);
    column->SetNumberOfTuples(source->GetNumberOfTuples());
    for (vtkIdType i = 0; i < source->GetNumberOfTuples(); ++i)
    {
      const double value = source->GetNumberOfComponents() == 3
        ? vtkMath::Norm(source->GetTuple3(i))
        : source->GetComponent(i, 0);
      column->SetValue(i, value);
      largest = std::max(largest, value);
    }
    table->AddColumn(column);
  }
  return table;
}

void SetFont(vtkTextProperty* text, int size)
{
  text->SetFontSize(size);
  text->SetColor(0.12, 0.13, 0.15);
  text->BoldOff();
  text->ItalicOff();
}

void SetAxis(vtkAxis* axis, const char* title, double from, double to, int fontSize)
{
  axis->SetTitle(title);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(from, to);
  axis->SetNotation(vtkAxis::STANDARD_NOTATION);
  SetFont(axis->GetTitleProperties(), fontSize);
  SetFont(axis->GetLabelProperties(), fontSize - 1);
  axis->GetGridPen()->SetColor(228, 231, 236);
  axis->GetPen()->SetColor(90, 95, 105);
}

/// Labels a second time axis with what the hand was doing.
void SetPhaseAxis(vtkAxis* axis, const std::vector<Phase>& phases, vtkDataArray* time, int fontSize)
{
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const Phase& phase : phases)
  {
    const double from = time->GetComponent(phase.First, 0);
    const double to = time->GetComponent(phase.Last - 1, 0);
    positions->InsertNextValue(0.5 * (from + to));
    std::string name = phase.Name;
    std::replace(name.begin(), name.end(), ' ', '\n');
    labels->InsertNextValue(name);
  }
  axis->SetVisible(true);
  axis->SetGridVisible(false);
  axis->SetTicksVisible(false);
  axis->SetCustomTickPositions(positions, labels);
  SetFont(axis->GetLabelProperties(), fontSize - 2);
}

/// Thin upright lines between the phases.
void AddPhaseLines(
  vtkChartXY* chart, const std::vector<Phase>& phases, vtkDataArray* time, double top)
{
  for (std::size_t i = 1; i < phases.size(); ++i)
  {
    vtkNew<vtkTable> table;
    vtkNew<vtkDoubleArray> x, y;
    x->SetName("x");
    y->SetName("y");
    for (const double end : { 0.0, top })
    {
      x->InsertNextValue(time->GetComponent(phases[i].First, 0));
      y->InsertNextValue(end);
    }
    table->AddColumn(x);
    table->AddColumn(y);
    vtkPlot* line = chart->AddPlot(vtkChart::LINE);
    chart->SetPlotCorner(line, LEFT_TOP); // a chart shows an axis only if a plot belongs to it
    line->SetInputData(table, 0, 1);
    line->SetLegendVisibility(false);
    line->SetSelectable(false);
    line->GetPen()->SetLineType(vtkPen::DASH_LINE);
    line->SetColor(170, 176, 186, 255);
    line->SetWidth(1.0f);
  }
}
} // namespace

namespace Explore
{
void BuildForceChart(ForceChart& chart, vtkPolyData* trace, const std::vector<Phase>& phases,
  const ChartOptions& options)
{
  const int fontSize = std::max(9, options.Height / 36);
  double largest = 0.0;
  vtkSmartPointer<vtkTable> table = MakeTable(trace, largest);
  vtkDataArray* time = trace->GetPointData()->GetArray("Time");
  const double end = time->GetComponent(time->GetNumberOfTuples() - 1, 0);
  const double top = std::max(0.1, 1.08 * largest);

  vtkNew<vtkChartXY> plot;
  plot->SetTitle(options.Title);
  SetFont(plot->GetTitleProperties(), fontSize + 3);
  plot->SetShowLegend(true);
  for (int i = 0; i < 4; ++i)
  {
    vtkPlot* line = plot->AddPlot(vtkChart::LINE);
    line->SetInputData(table, 0, i + 1);
    line->SetLabel(CURVES[i].Label);
    line->SetColor(CURVES[i].Colour[0], CURVES[i].Colour[1], CURVES[i].Colour[2], 255);
    line->SetWidth(CURVES[i].Width);
  }
  SetAxis(plot->GetAxis(vtkAxis::BOTTOM), "Time (s)", 0.0, end, fontSize);
  SetAxis(plot->GetAxis(vtkAxis::LEFT), "Force (N)", 0.0, top, fontSize);
  SetAxis(plot->GetAxis(vtkAxis::TOP), "", 0.0, end, fontSize);
  if (!phases.empty())
  {
    AddPhaseLines(plot, phases, time, top);
    SetPhaseAxis(plot->GetAxis(vtkAxis::TOP), phases, time, fontSize);
  }
  vtkChartLegend* legend = plot->GetLegend();
  SetFont(legend->GetLabelProperties(), fontSize);
  legend->SetHorizontalAlignment(vtkChartLegend::LEFT);
  legend->SetVerticalAlignment(vtkChartLegend::TOP);
  legend->GetPen()->SetOpacity(0);

  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(plot);
  chart.Renderer->SetBackground(1.0, 1.0, 1.0);
  chart.Renderer->AddActor(actor);
  chart.Window->SetOffScreenRendering(1);
  chart.Window->SetMultiSamples(0);
  chart.Window->SetSize(options.Width, options.Height);
  chart.Window->AddRenderer(chart.Renderer);
}
} // namespace Explore

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPen.h"
#include "vtkPlot.h"
#include "vtkPlotPoints.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkWindowToImageFilter.h"

namespace evaluation
{
namespace
{
// Colours for colour-blind readers: orange for the paper, blue for this project, paler variants of
// both, and grey; then green and purple, which are used only on request.
constexpr unsigned char Colours[][3] = { { 222, 110, 0 }, { 0, 92, 175 }, { 245, 185, 120 },
  { 120, 175, 225 }, { 140, 145, 152 }, { 0, 140, 95 }, { 130, 70, 165 } };
constexpr int ColoursInTurn = 5;

void SetFont(vtkTextProperty* text, int size)
{
  text->SetFontSize(size);
  text->SetColor(0.12, 0.13, 0.15);
  text->BoldOff();
  text->ItalicOff();
}

void SetAxis(vtkAxis* axis, const std::string& title)
{
  axis->SetTitle(title);
  SetFont(axis->GetTitleProperties(), 14);
  SetFont(axis->GetLabelProperties(), 13);
  axis->GetGridPen()->SetColor(228, 231, 236);
  axis->GetPen()->SetColor(90, 95, 105);
}

void SetTicks(vtkAxis* axis, const std::vector<std::pair<double, std::string>>& ticks)
{
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  for (const auto& [position, label] : ticks)
  {
    positions->InsertNextValue(position);
    labels->InsertNextValue(label);
  }
  axis->SetCustomTickPositions(positions, labels);
}

vtkSmartPointer<vtkTable> MakeTable(const Curve& curve)
{
  auto table = vtkSmartPointer<vtkTable>::New();
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  x->SetName("x");
  y->SetName(curve.Name.c_str());
  for (std::size_t i = 0; i < curve.X.size(); ++i)
  {
    x->InsertNextValue(curve.X[i]);
    y->InsertNextValue(curve.Y[i]);
  }
  table->AddColumn(x);
  table->AddColumn(y);
  return table;
}
} // namespace

void DrawPlot(const Plot& plot, const std::string& folder)
{
  vtkNew<vtkChartXY> chart;
  chart->SetTitle(plot.Title);
  SetFont(chart->GetTitleProperties(), 16);
  chart->SetShowLegend(true);
  SetFont(chart->GetLegend()->GetLabelProperties(), 13);
  chart->GetLegend()->SetHorizontalAlignment(
    plot.Legend == LegendPlace::TopLeft ? vtkChartLegend::LEFT : vtkChartLegend::RIGHT);
  chart->GetLegend()->SetVerticalAlignment(
    plot.Legend == LegendPlace::Right ? vtkChartLegend::CENTER : vtkChartLegend::TOP);
  SetAxis(chart->GetAxis(vtkAxis::BOTTOM), plot.XLabel);
  SetAxis(chart->GetAxis(vtkAxis::LEFT), plot.YLabel);
  if (!plot.XTicks.empty())
  {
    SetTicks(chart->GetAxis(vtkAxis::BOTTOM), plot.XTicks);
  }
  int next = 0;
  for (const Curve& curve : plot.Curves)
  {
    vtkPlot* const line = chart->AddPlot(curve.IsMarked ? vtkChart::POINTS : vtkChart::LINE);
    const vtkSmartPointer<vtkTable> table = MakeTable(curve);
    line->SetInputData(table, 0, 1);
    const int index = curve.Colour < 0 ? next++ % ColoursInTurn : curve.Colour;
    const unsigned char* const colour = Colours[index];
    line->SetColor(colour[0], colour[1], colour[2], 255);
    line->SetWidth(curve.Width);
    if (auto* const points = curve.IsMarked ? vtkPlotPoints::SafeDownCast(line) : nullptr)
    {
      points->SetMarkerStyle(vtkPlotPoints::CIRCLE);
      points->SetMarkerSize(9.0f);
    }
  }
  vtkNew<vtkContextActor> actor;
  actor->GetScene()->AddItem(chart);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(1.0, 1.0, 1.0);
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(760, 440);
  window->SetMultiSamples(4);
  window->AddRenderer(renderer);
  window->Render();
  vtkNew<vtkWindowToImageFilter> picture;
  picture->SetInput(window);
  picture->ReadFrontBufferOff();
  picture->ShouldRerenderOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName((folder + "/" + plot.File + ".png").c_str());
  writer->SetInputConnection(picture->GetOutputPort());
  writer->Write();
}

} // namespace evaluation

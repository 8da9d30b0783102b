// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TransferCharts.h"

#include "Table.h"

#include "vtkAxis.h"
#include "vtkChartLegend.h"
#include "vtkChartXY.h"
#include "vtkColorTransferFunction.h"
#include "vtkContextScene.h"
#include "vtkDoubleArray.h"
#include "vtkHapticProperty.h"
#include "vtkNew.h"
#include "vtkPen.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlot.h"
#include "vtkPlotBar.h"
#include "vtkTable.h"
#include "vtkTextProperty.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

namespace evaluation
{
namespace
{
/** Title and range of an axis. */
struct Extent
{
  const char* Title;
  double Low;
  double High;
};

constexpr Extent Values{ "scalar value (HU)", -1200.0, 1200.0 };
constexpr Extent Gradients{ "gradient magnitude (HU/mm)", 0.0, 100.0 };
/** A device's largest force. The device can't penetrate a stronger surface. */
constexpr double StrongestForce = 4.0; // N

/** Margins (pixels) around a chart's axes. */
constexpr struct
{
  double Left = 62.0;
  double Right = 22.0;
  double Bottom = 52.0;
  double Top = 34.0;
} Margins;

void SetAxis(vtkAxis* axis, const Extent& extent)
{
  axis->SetTitle(extent.Title);
  axis->SetBehavior(vtkAxis::FIXED);
  axis->SetRange(extent.Low, extent.High);
  for (vtkTextProperty* text : { axis->GetTitleProperties(), axis->GetLabelProperties() })
  {
    text->SetFontSize(13);
    text->SetColor(0.12, 0.13, 0.15);
    text->BoldOff();
  }
  axis->GetGridPen()->SetColor(228, 231, 236);
  axis->GetPen()->SetColor(90, 95, 105);
}

vtkNew<vtkChartXY> MakeChart(const char* title, const Extent& x, const Extent& y)
{
  vtkNew<vtkChartXY> chart;
  chart->SetTitle(title);
  chart->GetTitleProperties()->SetFontSize(15);
  chart->GetTitleProperties()->BoldOn();
  chart->GetTitleProperties()->SetColor(0.12, 0.13, 0.15);
  SetAxis(chart->GetAxis(vtkAxis::BOTTOM), x);
  SetAxis(chart->GetAxis(vtkAxis::LEFT), y);
  return chart;
}

void AddCurve(vtkChartXY* chart, vtkPiecewiseFunction* function, const Extent& extent,
  const std::string& name, const unsigned char (&colour)[3], double scale = 1.0)
{
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  x->SetName("x");
  y->SetName(name.c_str());
  const double top = chart->GetAxis(vtkAxis::LEFT)->GetMaximum();
  constexpr int steps = 1000;
  for (int i = 0; i <= steps; ++i)
  {
    x->InsertNextValue(extent.Low + (extent.High - extent.Low) * i / steps);
    y->InsertNextValue(std::min(top, scale * function->GetValue(x->GetValue(i))));
  }
  vtkNew<vtkTable> table;
  table->AddColumn(x);
  table->AddColumn(y);
  vtkPlot* const line = chart->AddPlot(vtkChart::LINE);
  line->SetInputData(table, 0, 1);
  line->SetColor(colour[0], colour[1], colour[2], 255);
  line->SetWidth(2.5f);
}

/** Adds a coloured bar for every few HU. */
void AddColours(vtkChartXY* chart, vtkColorTransferFunction* colours)
{
  vtkNew<vtkDoubleArray> x;
  vtkNew<vtkDoubleArray> y;
  x->SetName("value");
  y->SetName("colour");
  for (double value = Values.Low; value <= Values.High; value += 8.0)
  {
    x->InsertNextValue(value);
    y->InsertNextValue(1.0);
  }
  vtkNew<vtkTable> table;
  table->AddColumn(x);
  table->AddColumn(y);
  auto* const bars = vtkPlotBar::SafeDownCast(chart->AddPlot(vtkChart::BAR));
  bars->SetInputData(table, 0, 1);
  bars->SetLookupTable(colours);
  bars->SelectColorArray("value");
  bars->ScalarVisibilityOn();
  bars->GetPen()->SetLineType(vtkPen::NO_PEN);
  chart->SetBarWidthFraction(1.0f);
}

constexpr unsigned char Dark[] = { 60, 65, 75 };
constexpr unsigned char Orange[] = { 222, 110, 0 };
constexpr unsigned char Blue[] = { 0, 92, 175 };
constexpr unsigned char Green[] = { 0, 140, 95 };

/** Returns the function's largest value, or 1 if the function is empty or zero. */
double LargestOf(vtkPiecewiseFunction* function)
{
  double largest = 0.0;
  for (double value = Values.Low; value <= Values.High; value += 1.0)
  {
    largest = std::max(largest, function->GetValue(value));
  }
  return largest > 0.0 ? largest : 1.0;
}

/**
 * Adds a function as a fraction of its largest value, so that three quantities fit in one chart.
 * The curve's name states the largest value.
 */
void AddShare(vtkChartXY* chart, vtkPiecewiseFunction* function, const std::string& name,
  const std::string& unit, const unsigned char (&colour)[3])
{
  const double largest = LargestOf(function);
  AddCurve(
    chart, function, Values, name + ", 1 is " + Number(largest) + unit, colour, 1.0 / largest);
}

void SetLegend(vtkChartXY* chart)
{
  chart->SetShowLegend(true);
  chart->GetLegend()->GetLabelProperties()->SetFontSize(12);
  chart->GetLegend()->SetHorizontalAlignment(vtkChartLegend::LEFT);
  chart->GetLegend()->SetVerticalAlignment(vtkChartLegend::TOP);
}
} // namespace

void AddTransferCharts(vtkContextScene* scene, vtkVolumeProperty* look, vtkHapticProperty* feel,
  double width, double height)
{
  const auto place = [&](vtkChartXY* chart, int row, int column)
  {
    // Align the axes from row to row, regardless of the width of their labels.
    chart->SetAutoSize(false);
    chart->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
    const double cell[] = { 0.5 * width, height / 3.0 };
    chart->SetSize(vtkRectf(static_cast<float>(cell[0] * column + Margins.Left),
      static_cast<float>(cell[1] * (2 - row) + Margins.Bottom),
      static_cast<float>(cell[0] - Margins.Left - Margins.Right),
      static_cast<float>(cell[1] - Margins.Bottom - Margins.Top)));
    scene->AddItem(chart);
  };

  const auto colour = MakeChart("Seen: scalar value to colour", Values, { "", 0.0, 1.0 });
  AddColours(colour, look->GetRGBTransferFunction());
  colour->GetAxis(vtkAxis::LEFT)->SetLabelsVisible(false);
  place(colour, 0, 0);

  const auto opacity =
    MakeChart("Seen: scalar value to opacity", Values, { "opacity of 4 mm", 0.0, 1.05 });
  AddCurve(opacity, look->GetScalarOpacity(), Values, "opacity", Dark);
  place(opacity, 1, 0);

  const auto gradient = MakeChart(
    "Seen: gradient magnitude to opacity", Gradients, { "share of the opacity", 0.0, 1.05 });
  AddCurve(gradient, look->GetGradientOpacity(), Gradients, "opacity", Dark);
  place(gradient, 2, 0);

  const auto material =
    MakeChart("Felt: scalar value to material", Values, { "share of the largest", 0.0, 1.8 });
  AddShare(material, feel->GetStiffness(), "stiffness", " N/m", Orange);
  AddShare(material, feel->GetFriction(), "friction", "", Blue);
  AddShare(material, feel->GetViscosity(), "viscosity", " N", Green);
  SetLegend(material);
  place(material, 0, 1);

  const auto strength = MakeChart("Felt: scalar value to surface penetrability", Values,
    { "surface strength (N)", 0.0, StrongestForce });
  AddCurve(strength, feel->GetSurfaceStrength(), Values, "bone: no limit", Orange);
  SetLegend(strength);
  place(strength, 1, 1);

  const auto distinctness =
    MakeChart("Felt: gradient magnitude to distinctness", Gradients, { "distinctness", 0.0, 1.05 });
  AddCurve(distinctness, feel->GetDistinctness(), Gradients, "distinctness", Orange);
  place(distinctness, 2, 1);
}

} // namespace evaluation

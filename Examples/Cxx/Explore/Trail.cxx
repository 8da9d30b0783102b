// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Trail.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkScalarBarActor.h"
#include "vtkTextProperty.h"
#include "vtkTubeFilter.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double TUBE_RADIUS = 0.0012; // m
constexpr double SPACING = 0.0006;     // m between the points of the tube
constexpr const char* FORCE_NAME = "Force (N)";

/// A polyline with a point every SPACING: the trace itself stands still for many ticks, and a tube
/// cannot. Each point has the largest force since the one before.
vtkSmartPointer<vtkPolyData> Thin(vtkPolyData* trace, double spacing)
{
  vtkDataArray* force = trace->GetPointData()->GetArray("Force");
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> line;
  vtkNew<vtkDoubleArray> magnitude;
  magnitude->SetName(FORCE_NAME);
  line->InsertNextCell(0);
  double last[3] = { 0, 0, 0 }, largest = 0.0;
  for (vtkIdType i = 0; i < trace->GetNumberOfPoints(); ++i)
  {
    double position[3], newtons[3];
    trace->GetPoint(i, position);
    force->GetTuple(i, newtons);
    largest = std::max(largest, vtkMath::Norm(newtons));
    if (i == 0 || vtkMath::Distance2BetweenPoints(position, last) >= spacing * spacing)
    {
      line->InsertCellPoint(points->InsertNextPoint(position));
      magnitude->InsertNextValue(largest);
      std::copy_n(position, 3, last);
      largest = 0.0;
    }
  }
  line->UpdateCellCount(static_cast<int>(points->GetNumberOfPoints()));
  auto thinned = vtkSmartPointer<vtkPolyData>::New();
  thinned->SetPoints(points);
  thinned->SetLines(line);
  thinned->GetPointData()->SetScalars(magnitude);
  return thinned;
}

/// From blue (free) by green and yellow to red; clear of the colours of skin and bone.
vtkSmartPointer<vtkColorTransferFunction> ForceColours(double largest)
{
  const double stops[][3] = { { 0.16, 0.30, 0.85 }, { 0.10, 0.66, 0.95 }, { 0.10, 0.85, 0.62 },
    { 0.55, 0.93, 0.22 }, { 0.98, 0.80, 0.10 }, { 0.97, 0.42, 0.05 }, { 0.75, 0.05, 0.05 } };
  auto colours = vtkSmartPointer<vtkColorTransferFunction>::New();
  for (int i = 0; i < 7; ++i)
  {
    colours->AddRGBPoint(largest * i / 6.0, stops[i][0], stops[i][1], stops[i][2]);
  }
  return colours;
}

/// The end of the scale: the largest force, rounded up to a number that reads well.
double RoundUp(double largest)
{
  const double unit = std::pow(10.0, std::floor(std::log10(std::max(largest, 0.01))));
  for (const double factor : { 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0 })
  {
    if (largest <= factor * unit)
    {
      return factor * unit;
    }
  }
  return 10.0 * unit;
}

void AddScalarBar(vtkRenderer* renderer, vtkScalarsToColors* colours, int pictureHeight)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colours);
  bar->SetTitle(FORCE_NAME);
  bar->SetNumberOfLabels(5);
  bar->SetLabelFormat("%.1f");
  bar->UnconstrainedFontSizeOn();
  bar->SetPosition(0.86, 0.22);
  bar->SetWidth(0.11);
  bar->SetHeight(0.56);
  bar->SetBarRatio(0.28);
  bar->SetTitleRatio(0.5);
  bar->SetVerticalTitleSeparation(std::max(4, pictureHeight / 70));
  for (vtkTextProperty* text : { bar->GetTitleTextProperty(), bar->GetLabelTextProperty() })
  {
    text->SetFontSize(std::max(9, pictureHeight / 42));
    text->SetColor(0.93, 0.95, 0.98);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
  }
  renderer->AddActor2D(bar);
}
}

namespace Explore
{
void AddTrail(
  vtkRenderer* renderer, vtkPolyData* trace, double metersPerWorldUnit, int pictureHeight)
{
  vtkSmartPointer<vtkPolyData> thinned = Thin(trace, SPACING / metersPerWorldUnit);
  double range[2];
  thinned->GetPointData()->GetScalars()->GetRange(range);
  auto colours = ForceColours(RoundUp(range[1]));

  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(thinned);
  tube->SetRadius(TUBE_RADIUS / metersPerWorldUnit);
  tube->SetNumberOfSides(14);
  tube->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tube->GetOutputPort());
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  mapper->InterpolateScalarsBeforeMappingOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.75);
  actor->GetProperty()->SetSpecular(0.25);
  actor->GetProperty()->SetSpecularPower(25.0);
  renderer->AddActor(actor);
  AddScalarBar(renderer, colours, pictureHeight);
}
}

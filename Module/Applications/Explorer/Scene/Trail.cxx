// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Scene/Trail.h"

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

/// A polyline with a point every SPACING: the trace stands still for many ticks, and a tube can't.
/// Each point has the largest force since the one before.
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

/// From blue (free) through green and yellow to red; distinct from the colours of skin and bone.
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

/// The scale's labels: 0, Step, 2 Step ... up to the largest force or just beyond.
struct Scale
{
  double Step;
  int Steps;
};

Scale ChooseScale(double largest)
{
  const double wanted = std::max(largest, 0.01) / 5.0;
  const double unit = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = 10.0 * unit;
  for (const double factor : { 5.0, 2.0, 1.0 })
  {
    step = wanted <= factor * unit ? factor * unit : step;
  }
  return { step, std::max(1, static_cast<int>(std::ceil(largest / step - 1e-6))) };
}

void AddScalarBar(
  vtkRenderer* renderer, vtkScalarsToColors* colours, const Scale& scale, int pictureHeight)
{
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colours);
  bar->SetTitle(FORCE_NAME);
  bar->SetNumberOfLabels(scale.Steps + 1);
  bar->SetLabelFormat(scale.Step < 0.1 ? "%.2f" : scale.Step < 1.0 ? "%.1f" : "%.0f");
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
  renderer->AddViewProp(bar);
}
} // namespace

namespace Explore
{
void AddTrail(vtkRenderer* renderer, vtkRenderer* overlay, vtkPolyData* trace,
  double metersPerWorldUnit, int pictureHeight)
{
  vtkSmartPointer<vtkPolyData> thinned = Thin(trace, SPACING / metersPerWorldUnit);
  double range[2];
  thinned->GetPointData()->GetScalars()->GetRange(range);
  const Scale scale = ChooseScale(range[1]);
  auto colours = ForceColours(scale.Step * scale.Steps);

  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(thinned);
  tube->SetRadius(TUBE_RADIUS / metersPerWorldUnit);
  tube->SetNumberOfSides(14);
  tube->CappingOn();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(tube->GetOutputPort());
  mapper->SetLookupTable(colours);
  mapper->UseLookupTableScalarRangeOn();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetAmbient(0.35);
  actor->GetProperty()->SetDiffuse(0.75);
  actor->GetProperty()->SetSpecular(0.25);
  actor->GetProperty()->SetSpecularPower(25.0);
  renderer->AddActor(actor);
  vtkNew<vtkActor> ghost;
  ghost->SetMapper(mapper);
  ghost->GetProperty()->LightingOff();
  ghost->GetProperty()->SetOpacity(0.3);
  overlay->AddActor(ghost);
  AddScalarBar(renderer, colours, scale, pictureHeight);
}
} // namespace Explore

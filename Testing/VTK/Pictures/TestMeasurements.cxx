// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders a point, a distance, an angle, a path and an area on a ball with their values, and the
// first end of an unfinished distance. The head-up display lists them, and no label covers the
// list.
#include "Factories.h"
#include "VTK/Scene/Display/DisplayProbe.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticMeasurementRepresentation.h>
#include <vtkHapticMeasurements.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRegressionTestImage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkSphereSource.h>

#include <array>
#include <cmath>
#include <iostream>

namespace
{
constexpr double Radius = 20.0;

/// Returns a point on the ball, seen from -y, by its angles to the right and upwards (degrees).
std::array<double, 3> On(double right, double up)
{
  const double u = 0.01745329252 * right;
  const double v = 0.01745329252 * up;
  return { Radius * std::sin(u) * std::cos(v), -Radius * std::cos(u) * std::cos(v),
    Radius * std::sin(v) };
}

vtkSmartPointer<vtkPolyData> MakePath(double from, double to, double up)
{
  vtkNew<vtkPoints> points;
  for (int i = 0; i <= 60; ++i)
  {
    points->InsertNextPoint(On(from + (to - from) * i / 60.0, up + 3.0 * std::sin(0.3 * i)).data());
  }
  auto path = vtkSmartPointer<vtkPolyData>::New();
  path->SetPoints(points);
  return path;
}
} // namespace

int TestMeasurements(int argc, char* argv[])
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(49, 49, 49);
  image->SetOrigin(-24.0, -24.0, -24.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* const x = image->GetPoint(i);
    image->GetPointData()->GetScalars()->SetTuple1(i, Radius - std::hypot(x[0], x[1], x[2]));
  }
  vtkNew<vtkHapticMeasurements> list;
  list->AddPoint(On(-10.0, 60.0).data(), "Apex");
  list->AddDistance(On(-45.0, 20.0).data(), On(35.0, 35.0).data());
  list->AddAngle(On(-60.0, -25.0).data(), On(-25.0, -50.0).data(), On(10.0, -25.0).data());
  list->AddMeasurement(vtkHapticMeasurements::PATH, MakePath(-55.0, 20.0, 0.0));
  list->AddPaintedArea(image, 0.0, MakePath(35.0, 60.0, -15.0), 3.0);
  vtkNew<vtkPolyData> begun;
  vtkNew<vtkPoints> end;
  end->InsertNextPoint(On(20.0, -45.0).data());
  begun->SetPoints(end);
  list->SetUnfinished(vtkHapticMeasurements::DISTANCE, begun);

  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(Radius - 0.05);
  sphere->SetThetaResolution(90);
  sphere->SetPhiResolution(90);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> ball;
  ball->SetMapper(mapper);
  ball->GetProperty()->SetColor(0.86, 0.62, 0.51);
  vtkNew<vtkHapticHeadUpDisplay> display;
  display->SetMeasurements(list);
  display->PlotVisibilityOff();
  vtkNew<vtkHapticMeasurementRepresentation> shown;
  shown->SetMeasurements(list);
  shown->SetHeadUpDisplay(display);
  shown->SetRadius(0.7);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.16, 0.19, 0.24);
  renderer->AddActor(ball);
  renderer->AddViewProp(display);
  renderer->AddViewProp(shown);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(500, 400);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(0.0, -90.0, 0.0);
  renderer->GetActiveCamera()->SetFocalPoint(-4.0, 0.0, 2.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  window->Render();
  if (VolumeHaptics::DisplayProbe::CountLabels(shown) != 5)
  {
    std::cerr << VolumeHaptics::DisplayProbe::CountLabels(shown) << " labels are shown, not 5.\n";
    return EXIT_FAILURE;
  }
  display->SetHelpText("Touch\nt\ttouch\n");
  display->HelpVisibilityOn();
  window->Render();
  if (VolumeHaptics::DisplayProbe::CountLabels(shown) != 0)
  {
    std::cerr << "Labels are over the list of keys.\n";
    return EXIT_FAILURE;
  }
  display->HelpVisibilityOff();
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tests points and data beyond the range of any axis: the editor must draw the visible part, and
// return.
#include "EditorMouse.h"
#include "Factories.h"

#include "VTK/Scene/Editor/EditorProbe.h"

#include "vtkDoubleArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <limits>

using namespace editortest;

int TestFunctionEditorFar(int, char*[])
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double most = std::numeric_limits<double>::max();
  const std::array<double, 2> pairs[] = { { 0.0, 1e308 }, { -1e308, 1e308 }, { -most, most },
    { 0.0, inf }, { -inf, inf }, { -inf, 5.0 }, { nan, 1.0 }, { 0.0, nan }, { 1e20, 1e20 + 1e5 },
    { 1e300, 1e300 }, { 0.0, 5e-324 }, { 0.0, 1e-310 }, { 1.0, 1.0 + 1e-15 }, { 3e38, 4e38 } };
  View view;
  vtkNew<vtkHapticProperty> property;
  vtkPiecewiseFunction* const stiffness = property->GetStiffness();
  view.Shown->SetProperty(property);

  // Use the numbers as positions and as values of points, with and without data on the axis of
  // values, first in pairs and then all together.
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 2);
  vtkNew<vtkDoubleArray> scalars;
  scalars->SetNumberOfTuples(8);
  image->GetPointData()->SetScalars(scalars);
  for (const auto& [a, b] : pairs)
  {
    scalars->Fill(a);
    scalars->SetValue(7, b);
    image->Modified();
    for (vtkImageData* data : { static_cast<vtkImageData*>(nullptr), image.Get() })
    {
      view.Shown->SetInputData(data);
      for (const bool isPlace : { true, false })
      {
        stiffness->RemoveAllPoints();
        isPlace ? stiffness->AddPoint(a, 1.0) : stiffness->AddPoint(0.0, a);
        isPlace ? stiffness->AddPoint(b, 2.0) : stiffness->AddPoint(1.0, b);
        view.Window->Render();
        double place[2];
        VolumeHaptics::EditorProbe::GetPosition(view.Shown, 0.5 * a + 0.5 * b, 1.0, place);
        view.Drag(Editor::LEFT_BUTTON, { 200, 100 }, { 210, 90 });
        view.Window->Render();
      }
    }
  }
  // After these numbers, the editor must still work.
  view.Shown->SetInputData(nullptr);
  stiffness->RemoveAllPoints();
  stiffness->AddPoint(0.0, 0.0);
  stiffness->AddPoint(50.0, 400.0);
  stiffness->AddPoint(100.0, 1000.0);
  view.Window->Render();
  view.Drag(Editor::LEFT_BUTTON, view.At(50, 400), view.At(70, 800));
  view.Check(IsNode(stiffness, 1, 70, 800, 1.0, 20.0), "a point moves again");

  // A point far outside must not compress the axis: it stays outside of the view, and unchanged.
  stiffness->AddPoint(1e308, 5.0);
  view.Window->Render();
  stiffness->AddPoint(inf, 7.0);
  view.Window->Render();
  view.Check(IsNode(stiffness, 3, 1e308, 5.0, 0.0, 0.0), "a point out of sight stays");
  return view.Passed ? EXIT_SUCCESS : EXIT_FAILURE;
}

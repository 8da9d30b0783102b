// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders slices beside a scene. The image is oblique with voxels of 1 x 1 x 2 mm. It has a ball of
// 12 mm, and a box towards the patient's left, back and head, so that wrong sides and proportions
// of a slice are visible.
#include "Factories.h"

#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticSliceView.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

int TestSliceView(int argc, char* argv[])
{
  // The index axes are parallel to x, -y and -z of the world, rotated by 15 degrees about z.
  const double angle = std::acos(-1.0) / 12.0;
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  const double direction[9] = { c, s, 0.0, s, -c, 0.0, 0.0, 0.0, -1.0 };
  vtkNew<vtkImageData> image;
  image->SetDimensions(40, 40, 20);
  image->SetSpacing(1.0, 1.0, 2.0);
  image->SetDirectionMatrix(direction);
  const double middle[3] = { -19.5 * (c + s), -19.5 * (s - c), 19.0 };
  image->SetOrigin(middle);
  image->AllocateScalars(VTK_SHORT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double x[3];
    image->GetPoint(i, x);
    const double radius = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    const double far =
      std::max({ std::abs(x[0] - 5.0), std::abs(x[1] - 5.0), std::abs(x[2] - 5.0) });
    image->GetPointData()->GetScalars()->SetTuple1(
      i, far < 2.5 ? 1000.0 : (radius < 12.0 ? 400.0 : 0.0));
  }
  vtkNew<vtkHapticHeadUpDisplay> display;
  display->AddTissue("bone", 900.0, 2000.0);
  vtkNew<vtkRenderer> scene;
  scene->SetBackground(0.16, 0.19, 0.24);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(400, 510);
  window->AddRenderer(scene);
  vtkNew<vtkHapticSliceView> slices;
  slices->SetImage(image);
  slices->SetHeadUpDisplay(display);
  slices->AnatomicalOn();
  slices->SetUnit("HU");
  slices->SetColorWindow(1200.0);
  slices->SetColorLevel(500.0);
  slices->SetShare(0.6);
  slices->SetRenderWindow(window);
  const double position[3] = { 5.0, 5.0, 5.0 };
  slices->SetPosition(position);
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

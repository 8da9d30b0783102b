// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders a status and modes, one of which is off, in a layer above a white background, as in
// PyVista. The letters must be readable.
#include "Factories.h"

#include "vtkHapticDevice.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticMode.h"
#include "vtkVolumeHapticsFilter.h"

#include "vtkNew.h"
#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

int TestHeadUpDisplayLight(int argc, char* argv[])
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  vtkNew<vtkHapticMode> follow;
  follow->SetArrayName("velocity");
  vtkNew<vtkHapticMode> vortex;
  vortex->SetKindToVortex();
  vtkNew<vtkHapticMode> ridge;
  ridge->SetKindToRidge();
  ridge->ActiveOff();
  filter->AddMode(follow);
  filter->AddMode(vortex);
  filter->AddMode(ridge);
  filter->SetMethodToPrimitives();
  vtkNew<vtkHapticDevice> device;
  device->Open("virtual");
  device->SetVolumeHaptics(filter);
  vtkNew<vtkHapticHeadUpDisplay> display;
  display->SetDevice(device);
  display->PlotVisibilityOff();
  vtkNew<vtkRenderer> scene;
  scene->SetBackground(1.0, 1.0, 1.0);
  vtkNew<vtkRenderer> overlay;
  overlay->SetLayer(1);
  overlay->AddViewProp(display);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(300, 120);
  window->SetNumberOfLayers(2);
  window->AddRenderer(scene);
  window->AddRenderer(overlay);
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

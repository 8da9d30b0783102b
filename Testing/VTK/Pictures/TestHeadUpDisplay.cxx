// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders the head-up display: a plot of a press, a slide and a release, the status of a waiting
// device, and a hint.
#include "Factories.h"
#include "Rigs/ScriptedStates.h"

#include "vtkHapticDevice.h"
#include "vtkHapticHeadUpDisplay.h"

#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolumeHapticsFilter.h"

int TestHeadUpDisplay(int argc, char* argv[])
{
  const auto press = [](double t)
  {
    const double hold = t < 1.0 ? 0.0 : (t < 1.5 ? 2.0 * (t - 1.0) : (t < 4.0 ? 1.0 : 0.0));
    return 1.6 * hold * (1.0 + 0.1 * std::sin(12.0 * t));
  };
  vtkNew<vtkVolumeHapticsFilter> filter; // its method is the title of the plot
  vtkNew<vtkHapticDevice> device;
  device->Open("virtual");
  device->SetVolumeHaptics(filter);
  vtkNew<vtkHapticHeadUpDisplay> display;
  display->SetDevice(device);
  display->AddStates(scenetest::MakeStates(0.0, 5.0, press));
  display->SetHint("Put the pointer on the volume and press t to touch it\n? shows all keys");
  vtkNew<vtkRenderer> renderer;
  renderer->GradientBackgroundOn();
  renderer->SetBackground(0.07, 0.09, 0.12);
  renderer->SetBackground2(0.24, 0.29, 0.36);
  renderer->AddViewProp(display);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(400, 300);
  window->AddRenderer(renderer);
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

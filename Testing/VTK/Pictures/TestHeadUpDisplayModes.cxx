// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders the head-up display with modes. Each mode has a curve and a line of text in its colour;
// one mode is off. The test locates the text lines.
#include "Factories.h"
#include "Rigs/ScriptedStates.h"

#include "vtkHapticDevice.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticMode.h"

#include "vtkRegressionTestImage.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolumeHapticsFilter.h"

#include <iostream>
#include <set>

int TestHeadUpDisplayModes(int argc, char* argv[])
{
  const auto whole = [](double t) { return 1.2 + 0.6 * std::sin(2.0 * t); };
  const auto states = scenetest::MakeStates(0.0, 5.0, whole);
  vtkNew<vtkDoubleArray> forces;
  forces->SetName("ModeForces");
  forces->SetNumberOfComponents(8);
  for (int i = 0; i < 5000; ++i)
  {
    const double part = 0.5 + 0.4 * std::sin(0.003 * i);
    const double force = whole(0.001 * i);
    const double parts[8] = { part * force, (1.0 - part) * force };
    forces->InsertNextTuple(parts);
  }
  states->AddColumn(forces);
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
  display->AddStates(states);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.12, 0.15, 0.19);
  renderer->AddViewProp(display);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(400, 300);
  window->AddRenderer(renderer);
  window->Render();
  std::set<int> found;
  int last = -1;
  for (int y = 299; y >= 0; --y)
  {
    const int mode = display->FindMode(30, y);
    if (mode >= 0 && mode < last)
    {
      std::cerr << "the modes are not in their order from above\n";
      return EXIT_FAILURE;
    }
    last = std::max(mode, last);
    found.insert(mode);
  }
  if (found != std::set<int>{ -1, 0, 1, 2 } || display->FindMode(390, 270) != -1)
  {
    std::cerr << "the lines of the modes are not found where they are\n";
    return EXIT_FAILURE;
  }
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

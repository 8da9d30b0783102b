// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Fixture with a virtual hand that touches modes, and the rendered lines and fronts that guide it.
 */
#ifndef FollowedHand_h
#define FollowedHand_h

#include "Factories.h"

#include <vtkCamera.h>
#include <vtkHapticDevice.h>
#include <vtkHapticRepresentation.h>
#include <vtkNew.h>
#include <vtkRegressionTestImage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVolumeHapticsFilter.h>

#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

namespace scenetest
{

inline bool Fail(const char* what, double is, double should)
{
  std::cerr << what << " is " << is << ", and should be " << should << ".\n";
  return false;
}

/// Moves a hand to a position, and waits for a few ticks. Returns false if the device does not run.
inline bool FeelAt(
  vtkVolumeHapticsFilter* filter, double x, double y, double z, vtkHapticDevice* device)
{
  device->SetVolumeHaptics(filter);
  device->Open("virtual");
  device->GetVirtualHand()->SetPosition(x, y, z);
  if (!device->Start())
  {
    return false;
  }
  while (device->GetState()->GetTick() < 20)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    device->UpdateState();
  }
  return true;
}

/// Compares a rendered image with its baseline: the hand and the shapes that guide it, within 20 mm
/// around the origin, seen from (x, y, z).
inline int CompareFollowed(
  vtkHapticDevice* device, double x, double y, double z, int argc, char* argv[])
{
  vtkNew<vtkHapticRepresentation> hand;
  hand->SetDevice(device);
  hand->SetScaleTextVisibility(false);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.16, 0.19, 0.24);
  renderer->AddViewProp(hand);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(300, 300);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(x, y, z);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 0.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange(-30.0, 30.0, -30.0, 30.0, -30.0, 30.0);
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

} // namespace scenetest

#endif

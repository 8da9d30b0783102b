// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// What is not seen is not felt: with the soft tissue made invisible, the hand that touched the skin
// goes through to the skull and rests there.
#include "TouchedHead.h"

#include "vtkPiecewiseFunction.h"
#include "vtkRegressionTestImage.h"

#include <iostream>

int TestTouchHidden(int argc, char* argv[])
{
  TouchedHead head(argc, argv, Explore::MapperChoice::GPU);
  vtkHapticDevice* const device = head.Touch.Device;
  head.Press(165, 160, 2);
  const double onSkin = device->GetSurfaceValue();
  if (device->GetContact() == 0)
  {
    std::cerr << "the skin is not touched\n";
    return EXIT_FAILURE;
  }
  vtkPiecewiseFunction* const opacity = head.Touch.Scene.Look->GetScalarOpacity();
  opacity->RemoveAllPoints();
  opacity->AddPoint(250.0, 0.0);
  opacity->AddPoint(600.0, 1.0);
  head.Run(20);
  if (device->GetContact() != 0)
  {
    std::cerr << "the skin is still felt\n";
    return EXIT_FAILURE;
  }
  for (int i = 0; i < 12 && device->GetContact() == 0; ++i)
  {
    head.Event(165, 160, vtkCommand::MouseWheelForwardEvent);
    head.Run(30);
  }
  if (device->GetContact() == 0 || device->GetSurfaceValue() < onSkin + 100.0)
  {
    std::cerr << "the skull is not felt: contact " << device->GetContact() << ", values " << onSkin
              << " and " << device->GetSurfaceValue() << "\n";
    return EXIT_FAILURE;
  }
  vtkRenderWindow* const window = head.Touch.Scene.Window;
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

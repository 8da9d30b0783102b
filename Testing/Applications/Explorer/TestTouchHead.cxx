// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Presses the tip through the skin of the forehead in the explorer's window. The proxy stays on the
// surface, and arrows show the force.
#include "TouchedHead.h"

#include "vtkRegressionTestImage.h"

#include <iostream>

int TestTouchHead(int argc, char* argv[])
{
  TouchedHead head(argc, argv, Explore::MapperChoice::GPU);
  head.TouchAt(165, 160, [&] { head.Press(165, 160, 3); });
  if (head.Touch.Device->GetState()->GetContact() == 0)
  {
    std::cerr << "nothing is touched\n";
    return EXIT_FAILURE;
  }
  vtkRenderWindow* const window = head.Touch.Scene.Window;
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Renders the scene of TestTouchHead in stereo, for red and cyan glasses.
#include "Applications/Explorer/View/StereoModes.h"
#include "TouchedHead.h"

#include "vtkRegressionTestImage.h"

int TestTouchStereo(int argc, char* argv[])
{
  TouchedHead head(argc, argv, Explore::MapperChoice::GPU);
  head.TouchAt(165, 160, [&] { head.Press(165, 160, 3); });
  vtkRenderWindow* const window = head.Touch.Scene.Window;
  Explore::SetStereo(window, "anaglyph");
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

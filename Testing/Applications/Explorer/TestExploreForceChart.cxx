// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Renders the plot of the force: three components and the norm, units on the axes, and the names of
// the phases at the top.
#include "Applications/Explorer/Report/ForcePicture.h"
#include "HeadExploration.h"

#include "vtkRegressionTestImage.h"

int TestExploreForceChart(int argc, char* argv[])
{
  const Explore::Exploration exploration = ExploreHead(argc, argv);
  Explore::ForcePictureOptions options;
  options.Width = 500;
  options.Height = 300;
  Explore::ForcePicture chart;
  Explore::BuildForcePicture(chart, exploration.Trace, exploration.Tip.Phases, options);
  chart.Window->Render();
  return vtkRegressionTestImage(chart.Window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

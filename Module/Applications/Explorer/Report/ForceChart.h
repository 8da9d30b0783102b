// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ForceChart_h
#define Explore_ForceChart_h

#include "Applications/Explorer/Path/TipPathPlanner.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <string>
#include <vector>

namespace Explore
{
struct ChartOptions
{
  int Width = 1000;
  int Height = 600;
  std::string Title = "Force on the hand";
};

/// A window with the parts of the force against time, and along the top what the hand was doing.
struct ForceChart
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
};

/// Fills the chart from the output of vtkVolumeHapticsFilter.
void BuildForceChart(ForceChart& chart, vtkPolyData* trace, const std::vector<Phase>& phases,
  const ChartOptions& options);
} // namespace Explore

#endif

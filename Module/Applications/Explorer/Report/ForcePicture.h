// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ForcePicture_h
#define Explore_ForcePicture_h

#include "Applications/Explorer/Path/TipPathPlanner.h"
#include "VTK/Scene/Display/HapticForceChart.h"
#include "VTK/Scene/Display/HapticForceTable.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace Explore
{
struct ForcePictureOptions
{
  int Width = 1000;
  int Height = 600;
  std::string Title = "Force on the hand";
  std::vector<std::string> Modes; // names of the trace's modes
};

/// A window that plots the components of the force over time, with the hand's movements along the
/// top.
struct ForcePicture
{
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  VolumeHaptics::HapticForceTable Forces;
  VolumeHaptics::HapticForceChart Chart{ VolumeHaptics::HapticForceChart::Ground::Page };
};

/// Fills the picture from the output of vtkVolumeHapticsFilter.
void BuildForcePicture(ForcePicture& picture, vtkPolyData* trace, const std::vector<Phase>& phases,
  const ForcePictureOptions& options);
} // namespace Explore

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ExplorerScene_h
#define Explore_ExplorerScene_h

#include "Applications/Explorer/Exploration/Exploration.h"
#include "Applications/Explorer/Scene/VolumeCut.h"

#include "vtkHapticRegionPicture.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <string>

namespace Explore
{
enum class MapperChoice
{
  // Chooses the GPU's mapper if the window and the volume allow it, else the CPU's. In a window for
  // touching, chooses the CPU's mapper also if OpenGL runs on the CPU.
  Auto,
  GPU,
  CPU
};

struct SceneOptions
{
  int Width = 900;
  int Height = 700;
  MapperChoice Mapper = MapperChoice::Auto;
  std::string Caption;
  bool Anatomical = true; // letters of the marker: the patient's sides instead of axes
  bool OffScreen = true;
  double SliceShare = 0.0;     // fraction of the width for slices beside the scene; 0: hidden
  CutKind Cut = CutKind::None; // the cut of the window at first
  bool Interactive = false;    // a window for touching, without the trail
};

/// A window that shows the volume, the proxy's trail coloured by force, the meaning of the colours,
/// and which way is up.
struct ExplorerScene
{
  vtkSmartPointer<vtkRenderWindow> Window = vtkSmartPointer<vtkRenderWindow>::New();
  vtkNew<vtkRenderer> Renderer; // volume and trail
  vtkNew<vtkRenderer> Overlay;  // the hidden parts of the trail, through the same camera
  vtkNew<vtkRenderer> Marker;   // the small cube in the corner
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkVolumeProperty> Look;
  vtkNew<vtkHapticRegionPicture> Refined; // shows a large volume finely around the hand
  std::string MapperName;
};

/// Fills the scene.
void BuildScene(ExplorerScene& scene, const Exploration& exploration, const SceneOptions& options);
} // namespace Explore

#endif

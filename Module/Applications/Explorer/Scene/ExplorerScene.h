// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ExplorerScene_h
#define Explore_ExplorerScene_h

#include "Applications/Explorer/Exploration/Exploration.h"
#include "Applications/Explorer/Scene/VolumeCut.h"

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
  // The GPU's mapper if the window and the volume permit it, otherwise the CPU's. A window for
  // touching also uses the CPU's mapper if OpenGL runs on the CPU.
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
  // whether the marker shows letters for the patient's sides instead of axes
  bool Anatomical = true;
  bool OffScreen = true;
  double SliceShare = 0.0;     // fraction of the width for slices beside the scene; 0: hidden
  CutKind Cut = CutKind::None; // initial cut in the window
  bool Interactive = false;    // whether this is a window for touching, without the trail
};

/// A window that shows the volume, the proxy's trail coloured by force, a colour scale, and an
/// orientation marker.
struct ExplorerScene
{
  vtkSmartPointer<vtkRenderWindow> Window = vtkSmartPointer<vtkRenderWindow>::New();
  vtkNew<vtkRenderer> Renderer; // volume and trail
  vtkNew<vtkRenderer> Overlay;  // hidden parts of the trail, drawn with the same camera
  vtkNew<vtkRenderer> Marker;   // occluded parts of the trail, drawn with the same camera
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkVolumeProperty> Look;
  std::string MapperName;
};

void BuildScene(ExplorerScene& scene, const Exploration& exploration, const SceneOptions& options);
} // namespace Explore

#endif

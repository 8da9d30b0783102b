// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Renders the standard exploration without a GPU, with other materials and another gradient
// estimator.
#include "Applications/Explorer/Scene/ExplorerScene.h"
#include "HeadExploration.h"

#include "vtkRegressionTestImage.h"

int TestExploreHeadCPU(int argc, char* argv[])
{
  Explore::Settings settings;
  settings.Preset = "CT physical";
  settings.Gradient = Explore::Estimator::CubicBSpline;
  const Explore::Exploration exploration = ExploreHead(argc, argv, settings);
  Explore::SceneOptions options;
  options.Width = 390;
  options.Height = 300;
  options.Mapper = Explore::MapperChoice::CPU;
  options.Caption = "Head phantom\nMaterials: CT physical";
  options.Anatomical = false;
  Explore::ExplorerScene scene;
  Explore::BuildScene(scene, exploration, options);
  scene.Window->Render();
  return vtkRegressionTestImage(scene.Window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Renders the standard exploration: the head upright and shaded, the trail on the skin and, beneath
// it, on the skull.
#include "Applications/Explorer/Scene/ExplorerScene.h"
#include "HeadExploration.h"

#include "vtkRegressionTestImage.h"

int TestExploreHead(int argc, char* argv[])
{
  const Explore::Exploration exploration = ExploreHead(argc, argv);
  Explore::SceneOptions options;
  options.Width = 390;
  options.Height = 300;
  options.Mapper = Explore::MapperChoice::GPU;
  options.Caption = "Head phantom";
  Explore::ExplorerScene scene;
  Explore::BuildScene(scene, exploration, options);
  scene.Window->Render();
  return vtkRegressionTestImage(scene.Window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

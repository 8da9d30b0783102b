// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LoadingScreen_h
#define Explore_LoadingScreen_h

#include "vtkActor2D.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"

#include <string>

namespace Explore
{
/// Shows the program's progress in a window until the scene is ready.
class LoadingScreen
{
public:
  /// Shows the progress in an existing window, whose size stays unchanged.
  explicit LoadingScreen(vtkRenderWindow* window);
  /// Removes the progress display, and leaves the window open and empty.
  ~LoadingScreen();
  LoadingScreen(const LoadingScreen&) = delete;
  LoadingScreen& operator=(const LoadingScreen&) = delete;

  /// Shows the name of a step at its beginning, and the fraction of the work that is done (0 to 1).
  void Report(const std::string& step, double fraction);

private:
  void AddBar(vtkPlaneSource* bar, double red, double green, double blue);

  vtkRenderWindow* const Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkTextActor> Text;
  vtkNew<vtkPlaneSource> Whole;
  vtkNew<vtkPlaneSource> Done;
};
} // namespace Explore

#endif

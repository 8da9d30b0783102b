// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/View/Display.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <vtksys/SystemTools.hxx>

#include <string>

namespace Explore
{
bool HasDisplay()
{
  vtkNew<vtkRenderWindow> window;
  const bool needsX = std::string(window->GetClassName()) == "vtkXOpenGLRenderWindow";
  std::string display;
  return !needsX || (vtksys::SystemTools::GetEnv("DISPLAY", display) && !display.empty());
}
} // namespace Explore

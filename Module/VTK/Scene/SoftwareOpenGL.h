// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Whether OpenGL runs on the processor.
 */
#ifndef SoftwareOpenGL_h
#define SoftwareOpenGL_h

#include "vtkRenderWindow.h"

#include <string>

namespace VolumeHaptics
{

/**
 * By the name of the renderer: those of Mesa and of Windows that run on the processor. False before
 * the window has rendered.
 */
inline bool IsSoftwareOpenGL(vtkRenderWindow* window)
{
  if (!window || window->GetNeverRendered())
  {
    return false;
  }
  const std::string capabilities = window->ReportCapabilities();
  const auto isNamed = [&](const char* name)
  { return capabilities.find(name) != std::string::npos; };
  return isNamed("llvmpipe") || isNamed("softpipe") || isNamed("Software Rasterizer") ||
    isNamed("GDI Generic") || isNamed("Microsoft Basic Render");
}

} // namespace VolumeHaptics

#endif

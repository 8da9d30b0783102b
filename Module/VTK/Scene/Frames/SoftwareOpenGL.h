// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects whether OpenGL runs on the processor.
 */
#ifndef SoftwareOpenGL_h
#define SoftwareOpenGL_h

#include "vtkRenderWindow.h"

#include <string>

namespace VolumeHaptics
{

/**
 * Returns whether a text from vtkRenderWindow::ReportCapabilities names a renderer of Mesa or
 * Windows that runs on the processor.
 */
inline bool NamesSoftwareOpenGL(const std::string& capabilities)
{
  const auto isNamed = [&](const char* name)
  { return capabilities.find(name) != std::string::npos; };
  return isNamed("llvmpipe") || isNamed("softpipe") || isNamed("Software Rasterizer") ||
    isNamed("GDI Generic") || isNamed("Microsoft Basic Render");
}

/**
 * Returns whether a window's OpenGL runs on the processor, judged by the name of its renderer.
 * Returns false before the first render.
 */
inline bool IsSoftwareOpenGL(vtkRenderWindow* window)
{
  return window && !window->GetNeverRendered() && NamesSoftwareOpenGL(window->ReportCapabilities());
}

} // namespace VolumeHaptics

#endif

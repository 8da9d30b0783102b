// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Initializes VTK's modules for charts and their text. VTK's test driver initializes only the
 * modules that render volumes.
 */
#ifndef Factories_h
#define Factories_h

#include <vtkAutoInit.h>

VTK_MODULE_INIT(vtkRenderingContextOpenGL2)
VTK_MODULE_INIT(vtkRenderingFreeType)

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The surface of a stylus: a metal point, a handle and a button.
 */
#ifndef StylusShape_h
#define StylusShape_h

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace VolumeHaptics
{

/**
 * The mesh has length 1, its point at the origin, its handle along +z and its button on the side of
 * +y (DeviceBackend.h); with normals, and colours as point scalars.
 */
vtkSmartPointer<vtkPolyData> MakeStylusShape();

} // namespace VolumeHaptics

#endif

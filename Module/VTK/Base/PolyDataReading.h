// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a .vtp without the messages of VTK's reader.
 */
#ifndef PolyDataReading_h
#define PolyDataReading_h

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

namespace VolumeHaptics
{

/** Reads what it can of the file; `failed` becomes true after an error. */
vtkSmartPointer<vtkPolyData> ReadXmlPolyData(const std::string& file, bool& failed);

} // namespace VolumeHaptics

#endif

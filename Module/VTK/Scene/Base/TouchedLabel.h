// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The label of the touched tissue, for displays.
 */
#ifndef TouchedLabel_h
#define TouchedLabel_h

#include <string>

class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/**
 * Returns the name of the label at a position (world): from the filter's label table, or "label 5"
 * if the table has no name for the label. Empty if there is no label image, if the position is
 * outside of it, or if the table does not know the label.
 */
std::string NameLabelAt(vtkVolumeHapticsFilter* filter, const double position[3]);

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_ModeChoice_h
#define Explore_ModeChoice_h

#include <string>
#include <vector>

class vtkImageData;
class vtkVolumeHapticsFilter;

namespace Explore
{
/// Lists the names that --mode accepts, such as "vector-follow", for messages.
std::string ListModes();

/// Lists the names of vtkVolumeHapticsFilter::GetModePresetNames(), which --mode also accepts, for
/// messages.
std::string ListModePresets();

/// Checks a value of --mode: the name of a mode, alone or as MODE:ARRAY, or the name of a preset.
/// Throws InputError for any other text, and for an array after a mode that uses none.
void CheckMode(const std::string& mode);

/// Adds modes to a filter, with strengths that suit the image. Without names, the hand follows the
/// vectors of the array `flow` or of the first array with vectors, otherwise the tensors, and
/// without tensors it feels the surfaces. Further modes of vectors and tensors are added, but not
/// activated. A file that guides the hand (GuideFile.h) is the first mode; without names it is the
/// only active one. Throws InputError if the image lacks the array of a mode.
void AddModes(const std::vector<std::string>& modes, const std::string& flow,
  const std::string& guide, vtkImageData* image, vtkVolumeHapticsFilter* filter);

/// Returns unique names of a filter's modes, if its method uses modes. The names of inactive modes
/// are empty.
std::vector<std::string> NameModes(vtkVolumeHapticsFilter* filter);
} // namespace Explore

#endif

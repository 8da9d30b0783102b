// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticRegionPicture, one row each: see HapticSetting.h.
 */
#ifndef HapticPictureSettings_h
#define HapticPictureSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticRegionPicture.h"

namespace VolumeHaptics
{

using PictureSetting = HapticSetting<vtkHapticRegionPicture>;

namespace PictureSettingRows
{
using Owner = vtkHapticRegionPicture;

inline constexpr PictureSetting All[] = {
  HapticIntegerMacro(MaximumVoxels, 1000, 1073741824, 262144, "", NotBaked,
    "The most voxels of the box, 1000 to 2^30. Default 262144."),
};
} // namespace PictureSettingRows

inline constexpr const auto& PictureSettings = PictureSettingRows::All;

} // namespace VolumeHaptics

#endif

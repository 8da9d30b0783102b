// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticRegionPlanner, vtkHapticRegionFilter and vtkHapticRegionSource, one row
 * each: see HapticSetting.h.
 */
#ifndef HapticRegionSettings_h
#define HapticRegionSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticRegionFilter.h"
#include "vtkHapticRegionPlanner.h"
#include "vtkHapticRegionSource.h"

namespace VolumeHaptics
{

using PlannerSetting = HapticSetting<vtkHapticRegionPlanner>;
using PlannerVector = HapticVectorSetting<vtkHapticRegionPlanner>;
using RegionFilterVector = HapticVectorSetting<vtkHapticRegionFilter>;
using RegionSourceSetting = HapticSetting<vtkHapticRegionSource>;
using RegionSourceVector = HapticVectorSetting<vtkHapticRegionSource>;

namespace PlannerSettingRows
{
using Owner = vtkHapticRegionPlanner;

inline constexpr PlannerVector Vectors[] = {
  HapticVectorMacro(WholeExtent, int, 6, -LargestInteger, LargestInteger, "",
    "The extent of the whole volume. Default (0, -1, 0, -1, 0, -1): none.", 0, -1, 0, -1, 0, -1),
  HapticVectorMacro(Origin, double, 3, -LargestNumber, LargestNumber, "",
    "The origin of the whole volume, as that of vtkImageData. Default (0, 0, 0).", 0.0, 0.0, 0.0),
  HapticVectorMacro(Spacing, double, 3, -LargestNumber, LargestNumber, "",
    "The spacing of the whole volume (world units). Default (1, 1, 1).", 1.0, 1.0, 1.0),
  HapticVectorMacro(Direction, double, 9, -LargestNumber, LargestNumber, "",
    "The direction of the whole volume: nine numbers, row by row. Default: the identity.", 1.0, 0.0,
    0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
};

inline constexpr PlannerSetting All[] = {
  HapticNumberMacro(
    MaximumSpeed, 0.0, 10.0, 0.5, "m/s", NotBaked, "v_max (m/s), 0 to 10. Default 0.5."),
  HapticNumberMacro(MetersPerWorldUnit, 1e-12, 1e12, 0.001, "", NotBaked,
    "Metres per world unit, 1e-12 to 1e12. Default 0.001."),
  HapticNumberMacro(SpringLength, 0.0, 1e12, 4.0, "", NotBaked,
    "T_N/k (world units), 0 to 1e12. Default 4. See UseSettingsOf."),
  HapticNumberMacro(Reach, 0.0, 1e12, 8.0, "", NotBaked,
    "r (world units), 0 to 1e12. Default 8. See UseSettingsOf."),
  HapticNumberMacro(Band, 0.0, 1e12, 4.0, "", NotBaked,
    "b (world units), 0 to 1e12. Default 4. See UseSettingsOf."),
  HapticIntegerMacro(MaximumVoxels, 4096, 134217728, 2097152, "", NotBaked,
    "The most voxels of a region, 4096 to 134217728 (512^3). Default 2097152, that is, 128^3."),
};
} // namespace PlannerSettingRows

namespace RegionFilterSettingRows
{
using Owner = vtkHapticRegionFilter;

inline constexpr RegionFilterVector Vectors[] = { HapticVectorMacro(Region, int, 6, -LargestInteger,
  LargestInteger, "",
  "The region (an extent, in the whole's indices); it is clipped to the whole. Default (0, -1, 0, "
  "-1, 0, -1): the whole.",
  0, -1, 0, -1, 0, -1) };
} // namespace RegionFilterSettingRows

namespace RegionSourceSettingRows
{
using Owner = vtkHapticRegionSource;

inline constexpr SettingChoice ByteOrderNames[] = { { "Little", "Little endian" },
  { "Big", "Big endian" } };

inline constexpr RegionSourceVector Vectors[] = {
  HapticVectorMacro(WholeExtent, int, 6, -LargestInteger, LargestInteger, "",
    "The extent of the whole volume. Default (0, -1, 0, -1, 0, -1): none.", 0, -1, 0, -1, 0, -1),
  HapticVectorMacro(Origin, double, 3, -LargestNumber, LargestNumber, "",
    "The origin of the whole volume, as that of vtkImageData. Default (0, 0, 0).", 0.0, 0.0, 0.0),
  HapticVectorMacro(Spacing, double, 3, -LargestNumber, LargestNumber, "",
    "The spacing of the whole volume (world units). Default (1, 1, 1).", 1.0, 1.0, 1.0),
  HapticVectorMacro(Direction, double, 9, -LargestNumber, LargestNumber, "",
    "The direction of the whole volume: nine numbers, row by row. Default: the identity.", 1.0, 0.0,
    0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0),
};

inline constexpr RegionSourceSetting All[] = {
  HapticIntegerMacro(ScalarType, -LargestInteger, LargestInteger, 4, "", NotBaked, // told when read
    "The type of the samples: VTK_SHORT (4, default), VTK_FLOAT (10) or another type of numbers."),
  HapticNumberMacro(HeaderSize, 0, 1099511627776.0, 0, "bytes", NotBaked,
    "The size (bytes) of the header of the file, which is left out. Default 0."),
  HapticChoiceMacro(ByteOrder, 0, NotBaked,
    "The byte order of the file: LITTLE (default), that is, least significant byte first, or BIG."),
  HapticNumberMacro(MemoryLimit, 4194304.0, 1099511627776.0, 67108864.0, "bytes", NotBaked,
    "The most memory (bytes) that regions take live, 4194304 (4 MiB) to 2^40. Default 67108864 (64 "
    "MiB)."),
};
} // namespace RegionSourceSettingRows

inline constexpr const auto& PlannerVectors = PlannerSettingRows::Vectors;
inline constexpr const auto& PlannerSettings = PlannerSettingRows::All;
inline constexpr const auto& RegionFilterVectors = RegionFilterSettingRows::Vectors;
inline constexpr const auto& RegionSourceVectors = RegionSourceSettingRows::Vectors;
inline constexpr const auto& RegionSourceSettings = RegionSourceSettingRows::All;

} // namespace VolumeHaptics

#endif

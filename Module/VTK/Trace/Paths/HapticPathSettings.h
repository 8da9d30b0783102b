// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticPathSource, but for its file: see HapticSetting.h.
 *
 * Numbers that only some shapes have are not clamped: one out of its range is an error of the
 * shapes that need it.
 */
#ifndef HapticPathSettings_h
#define HapticPathSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticPathSource.h"

namespace VolumeHaptics
{

using PathSetting = HapticSetting<vtkHapticPathSource>;
using PathVector = HapticVectorSetting<vtkHapticPathSource>;

inline constexpr SettingChoice ShapeNames[] = { { "Line", "Line" }, { "Circle", "Circle" },
  { "Spiral", "Spiral" }, { "PressAndSlide", "Press and slide" }, { "FromFile", "From file" } };
inline constexpr SettingChoice PressDirectionNames[] = { { "+X", "+X" }, { "-X", "-X" },
  { "+Y", "+Y" }, { "-Y", "-Y" }, { "+Z", "+Z" }, { "-Z", "-Z" } };

namespace PathSettingRows
{
using Owner = vtkHapticPathSource;

inline constexpr PathSetting All[] = {
  HapticChoiceMacro(Shape, Owner::LINE, NotBaked,
    "Line (default): from Point 1 to Point 2. Circle: around Center, across Normal. Spiral: in "
    "that plane, from Center out to Radius. Press and slide: comes down on a face of the box, "
    "presses in, slides across and lifts. From file: a .vtp or .csv, such as a recording of a "
    "haptic device."),
  HapticNumberMacro(Speed, 0.0, VTK_DOUBLE_MAX, 100.0, "world units/s", NotBaked,
    "Speed of the hand (world units per second), more than 0. Default 100: 0.1 m/s if a unit is a "
    "millimetre."),
  HapticNumberMacro(PointsPerSecond, 1.0, 1e5, 1000.0, "", NotBaked,
    "Points for each second, 1 to 100000. Default 1000: one for each tick of a servo of 1 kHz."),
  HapticNumberMacro(Radius, 0.0, VTK_DOUBLE_MAX, 20.0, "", NotBaked,
    "Radius of the circle, and the largest one of the spiral (world units), more than 0. Default "
    "20."),
  HapticNumberMacro(Turns, 0.0, 1e4, 3.0, "", NotBaked,
    "How often the circle or the spiral goes round, more than 0 and up to 10000; parts of a turn "
    "count. Default 3."),
  HapticChoiceMacro(PressDirection, Owner::MINUS_Z, NotBaked,
    "Where the hand presses. With -Z (default) it comes down on the face of the box with the "
    "largest z, and slides along the longer side of that face."),
  HapticNumberMacro(Depth, 0.0, VTK_DOUBLE_MAX, 3.0, "", NotBaked,
    "How far the hand presses into the box, 0 or more world units. Default 3."),
  HapticNumberMacro(Clearance, 0.0, VTK_DOUBLE_MAX, 10.0, "", NotBaked,
    "How far above the box the hand begins and ends, 0 or more world units. Default 10."),
};

inline constexpr PathVector Vectors[] = {
  HapticVectorMacro(Point1, double, 3, -LargestNumber, LargestNumber, "",
    "Where the line begins. Default (-50, 0, 0).", -50.0, 0.0, 0.0),
  HapticVectorMacro(Point2, double, 3, -LargestNumber, LargestNumber, "",
    "Where the line ends. Default (50, 0, 0).", 50.0, 0.0, 0.0),
  HapticVectorMacro(Center, double, 3, -LargestNumber, LargestNumber, "",
    "The middle of the circle or the spiral. Default (0, 0, 0).", 0.0, 0.0, 0.0),
  HapticVectorMacro(Normal, double, 3, -LargestNumber, LargestNumber, "",
    "The direction that the circle or the spiral is across, of any length but 0. Default (0, 0, "
    "1).",
    0.0, 0.0, 1.0),
  HapticVectorMacro(BoxCorner, double, 3, -LargestNumber, LargestNumber, "",
    "The corner of the box with the least coordinates. Default (-25, -25, -25).", -25.0, -25.0,
    -25.0),
  HapticVectorMacro(BoxSize, double, 3, 0.0, LargestNumber, "",
    "The size of the box along x, y and z, 0 or more. Default (50, 50, 50).", 50.0, 50.0, 50.0),
};
} // namespace PathSettingRows

inline constexpr const auto& PathSettings = PathSettingRows::All;
inline constexpr const auto& PathVectors = PathSettingRows::Vectors;

} // namespace VolumeHaptics

#endif

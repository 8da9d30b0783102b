// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticDevice, vtkHapticHardware, vtkHapticCalibration and
 * vtkHapticStateSource, one row each: see HapticSetting.h.
 */
#ifndef HapticDeviceSettings_h
#define HapticDeviceSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticCalibration.h"
#include "vtkHapticDevice.h"
#include "vtkHapticStateSource.h"

#include <algorithm>
#include <limits>

namespace VolumeHaptics
{

using DeviceSetting = HapticSetting<vtkHapticDevice>;
using HardwareSetting = HapticSetting<vtkHapticHardware>;
using HardwareVector = HapticVectorSetting<vtkHapticHardware>;
using CalibrationSetting = HapticSetting<vtkHapticCalibration>;
using StateSourceSetting = HapticSetting<vtkHapticStateSource>;

namespace DeviceSettingRows
{
using Owner = vtkHapticDevice;
inline constexpr double Unlimited = std::numeric_limits<double>::infinity();

inline constexpr DeviceSetting ServoRate = HapticNumberMacro(ServoRate, 100.0, 10000.0, 1000.0,
  "Hz", NotBaked, "Ticks per second (Hz), 100 to 10000. Default 1000.");
inline constexpr DeviceSetting MaximumForce = HapticNumberMacro(MaximumForce, 0.0, VTK_DOUBLE_MAX,
  0.0, "N", NotBaked, "Longest force (N) on the hand, at most the device's own maximum.");
inline constexpr DeviceSetting MaximumForceRate =
  HapticNumberMacro(MaximumForceRate, 1.0, Unlimited, 500.0, "N/s", NotBaked,
    "Largest growth of force (N/s), 1 or more. Default 500. Only growth is limited: a force that "
    "becomes smaller does so at once");
inline constexpr DeviceSetting MaximumTorque = HapticNumberMacro(MaximumTorque, 0.0, VTK_DOUBLE_MAX,
  0.0, "N m", NotBaked, "Largest torque (N m) on the hand, at most the device's own maximum.");
inline constexpr DeviceSetting AttentionTime = HapticNumberMacro(AttentionTime, 0.0, Unlimited, 2.0,
  "s", NotBaked, "How long (s) an armed device keeps its force if the program stands still");

inline constexpr DeviceSetting All[] = { ServoRate, MaximumForce, MaximumForceRate, MaximumTorque,
  AttentionTime };
} // namespace DeviceSettingRows

namespace HardwareSettingRows
{
using Owner = vtkHapticHardware;

inline constexpr HardwareSetting All[] = {
  HapticNumberMacro(HomingTime, 1.0, 3600.0, 120.0, "s", NotBaked,
    "How long (s) each step of homing by hand may take, 1 to 3600. Default 120."),
  HapticFlagMacro(UseGuard, true, NotBaked,
    "Whether a guard, a process of its own, talks to a device that has no watchdog: the Falcon, "
    "and a DualSense through hidapi. Default: on."),
};

inline constexpr HardwareVector NewtonsPerFullScale =
  HapticVectorMacro(NewtonsPerFullScale, double, 2, -100.0, 100.0, "N",
    "The force (N) of a force-feedback device at full scale, -100 to 100, along its axes x and y.",
    100.0, 100.0);

inline constexpr HardwareVector Vectors[] = { NewtonsPerFullScale };
} // namespace HardwareSettingRows

namespace CalibrationSettingRows
{
using Owner = vtkHapticCalibration;

inline constexpr CalibrationSetting All[] = { HapticNumberMacro(FixedScale, 0.0, VTK_DOUBLE_MAX,
  0.0, "", NotBaked,
  "World units per metre of the device, 0 or more. 0 (default): computed from the points.") };
} // namespace CalibrationSettingRows

namespace StateSourceSettingRows
{
using Owner = vtkHapticStateSource;

inline constexpr StateSourceSetting All[] = {
  HapticNumberMacro(ForceScale, 1e-9, VTK_DOUBLE_MAX, 0.1, "N per world unit", NotBaked,
    "Newtons per world unit in the output. Default 0.1: a line of 10 world units for 1 N."),
  HapticFlagMacro(ShowCommandedForce, false, NotBaked,
    "Whether the output shows the force that went to the device, or (default) what was computed, "
    "armed or not."),
};
} // namespace StateSourceSettingRows

inline constexpr const auto& DeviceSettings = DeviceSettingRows::All;
inline constexpr const auto& HardwareSettings = HardwareSettingRows::All;
inline constexpr const auto& HardwareVectors = HardwareSettingRows::Vectors;
inline constexpr const auto& CalibrationSettings = CalibrationSettingRows::All;
inline constexpr const auto& StateSourceSettings = StateSourceSettingRows::All;

/** The nearest value that a setting may have; the minimum, which is the safe one, for NaN. */
inline double Clamp(const SettingFacts& setting, double value)
{
  return value > setting.Minimum ? std::min(value, setting.Maximum) : setting.Minimum;
}

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The facts about each device in the user's file of devices: whether its signs were confirmed, and
 * how many newtons it really gives.
 *
 * The file is plain text, one line per device:
 *
 *   wooden:1234:0006:SN1 confirmed=2026-11-22 scale=0.83 calibrated=2026-11-22
 *
 * It is `volumehaptics/devices.txt` in $XDG_CONFIG_HOME, in ~/.config, or in %APPDATA% on Windows;
 * the environment variable VOLUMEHAPTICS_DEVICES names another file. Files are read and written
 * outside the servo loop only.
 */
#ifndef DeviceMemory_h
#define DeviceMemory_h

#include <string>

namespace VolumeHaptics
{

struct DeviceFacts
{
  ///@{
  /** Scales outside this range are mistakes. */
  static constexpr double LeastScale = 0.1;
  static constexpr double MostScale = 10.0;
  ///@}

  std::string Confirmed;  ///< the day on which the device's signs were confirmed; empty: never
  double Scale = 1.0;     ///< newtons given per newton asked for
  std::string Calibrated; ///< the day of the calibration; empty: never

  /** Describes the scale: "calibrated 0.83 on 2026-11-22" or "uncalibrated". */
  std::string DescribeScale() const;
};

class DeviceMemory
{
public:
  /** Returns the path of the file; empty if the environment names no folder for it. */
  static std::string FindFile();
  /** Returns the present day, as 2026-11-22. */
  static std::string GetToday();

  /**
   * Reads the facts of a device by its identity (DeviceBackend::GetIdentity); the last line of a
   * device counts. Returns no facts without a file, or if that line is damaged. `error` names the
   * file, and the cure, if the file can't be read or a line of this device is damaged; else it is
   * empty.
   */
  static DeviceFacts Read(const std::string& identity, std::string& error);
  /**
   * Replaces the facts of a device, and keeps all other lines. The file is replaced as a whole. If
   * this fails, returns false and writes the reason and the cure to `error`; the old file is
   * unchanged.
   */
  static bool Write(const std::string& identity, const DeviceFacts& facts, std::string& error);
};

} // namespace VolumeHaptics

#endif

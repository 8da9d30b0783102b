// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The user's file of devices. It stores for each device whether the signs of its force were
 * confirmed, and the ratio of the exerted force to the requested one.
 *
 * The file is plain text with one line for each device:
 *
 *   wooden:1234:0006:SN1 confirmed=2026-11-22 scale=0.83 calibrated=2026-11-22
 *
 * It is `volumehaptics/devices.txt` in $XDG_CONFIG_HOME, in ~/.config, or in %APPDATA% on Windows.
 * The environment variable VOLUMEHAPTICS_DEVICES names another file. Files are read and written
 * only outside the servo loop.
 */
#ifndef DeviceMemory_h
#define DeviceMemory_h

#include <string>

namespace VolumeHaptics
{

struct DeviceFacts
{
  ///@{
  /** Limits of a scale; values outside them are treated as mistakes. */
  static constexpr double LeastScale = 0.1;
  static constexpr double MostScale = 10.0;
  ///@}

  /** Day on which the device's signs were confirmed; empty if they never were. */
  std::string Confirmed;
  double Scale = 1.0;     ///< exerted newtons per requested newton
  std::string Calibrated; ///< day of the calibration; empty if the device was never calibrated

  /** Describes the scale, for example "calibrated 0.83 on 2026-11-22" or "uncalibrated". */
  std::string DescribeScale() const;
};

class DeviceMemory
{
public:
  /** Returns the path of the file, or an empty path if the environment names no folder for it. */
  static std::string FindFile();
  /** Returns the current date in the form 2026-11-22. */
  static std::string GetToday();

  /**
   * Reads the facts of a device, given its identity (DeviceBackend::GetIdentity). If the device has
   * several lines, the last one is valid. Returns default facts if there is no file or if that line
   * is damaged. `error` receives the file and the cure if the file can't be read or a line of this
   * device is damaged; otherwise it is empty.
   */
  static DeviceFacts Read(const std::string& identity, std::string& error);
  /**
   * Replaces the facts of a device, and keeps all other lines. The file is replaced atomically. On
   * failure, returns false, writes the reason and the cure to `error`, and leaves the old file
   * unchanged.
   */
  static bool Write(const std::string& identity, const DeviceFacts& facts, std::string& error);
};

} // namespace VolumeHaptics

#endif

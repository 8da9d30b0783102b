// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The command line of volumehaptics-device.
 */
#ifndef ToolOptions_h
#define ToolOptions_h

#include <string>
#include <vector>

struct ToolOptions
{
  enum class Command
  {
    Help,
    List,
    Monitor,
    Home,
    Confirm,
    Calibrate,
    Test,
    Record
  };
  Command What = Command::Help;
  std::string Id;
  std::string File; ///< file of the recording
  /// firmware file; empty: the file named by the environment variable
  std::string Firmware;
  /// folders of plug-ins; empty: the folders named by the environment variable
  std::string VendorPath;
  double Seconds = 0.0;             ///< s; 0: not given
  double HomingTime = 120.0;        ///< longest wait for each step of homing (s)
  double ServoRate = 1000.0;        ///< Hz
  double Newtons[2] = { 100, 100 }; ///< newtons of a stick that is fully deflected, along x and y
  bool HasNewtons = false;          ///< whether the user has given Newtons
  int Axis = -1; ///< axis of the wall's normal, or of the calibration; negative: the default of the
                 ///< device's kind
  bool IsAxisNegative = false; ///< whether the axis was given with a minus sign
  double Grams = 0.0;          ///< mass of the hung weight (g); 0: a scale is used instead
  bool HasScale = false;

  /** Returns whether the device is a stick or a wheel, whose first axis is x. */
  bool IsStick() const { return this->Id.rfind("pid", 0) == 0 || this->Id.rfind("wheel", 0) == 0; }
};

/// The usage of the program, for --help.
extern const char* const ToolUsage;

/// Reads the command line. Returns false, with the fault and the cure, for wrong usage.
bool ReadToolOptions(
  const std::vector<std::string>& arguments, ToolOptions& options, std::string& error);

/// Reads a number within a range (both ends included). Returns false if the text is anything else.
bool ReadNumberInRange(const std::string& text, double least, double most, double& number);

#endif

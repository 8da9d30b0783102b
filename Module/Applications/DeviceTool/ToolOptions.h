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
  std::string File;                 ///< the recording's
  std::string Firmware;             ///< empty: from the environment
  std::string VendorPath;           ///< empty: from the environment
  double Seconds = 0.0;             ///< 0: not given
  double HomingTime = 120.0;        ///< s, for each step
  double ServoRate = 1000.0;        ///< Hz
  double Newtons[2] = { 100, 100 }; ///< a stick's at full scale, along x and y
  bool HasNewtons = false;          ///< the user has given them
  int Axis = -1; ///< of the wall's normal, or to be calibrated; negative: by the kind of device
  bool IsAxisNegative = false; ///< the axis was given with a minus
  double Grams = 0.0;          ///< grams of the hung weight; 0: a scale is pressed
  bool HasScale = false;
};

/// The usage of the program, for --help.
extern const char* const ToolUsage;

/// False, with the fault and the cure.
bool ReadToolOptions(
  const std::vector<std::string>& arguments, ToolOptions& options, std::string& error);

/// A number that is the whole text and is within a range (both ends included).
bool ReadNumberInRange(const std::string& text, double least, double most, double& number);

#endif

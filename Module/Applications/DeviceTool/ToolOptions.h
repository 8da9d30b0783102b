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
    Test,
    Record
  };
  Command What = Command::Help;
  std::string Id;
  std::string File;                 ///< of a recording
  std::string Firmware;             ///< empty: by the environment
  double Seconds = 0.0;             ///< 0: until it is interrupted
  double HomingTime = 120.0;        ///< s, for each step
  double ServoRate = 1000.0;        ///< Hz
  double Newtons[2] = { 100, 100 }; ///< of a stick at full scale, along x and y
  bool HasNewtons = false;          ///< the user has given them
  int Axis = -1;                    ///< of the wall's normal; below zero: by the kind of device
};

/// The usage of the program, for --help.
extern const char* const ToolUsage;

/// False, with the fault and the cure.
bool ReadToolOptions(
  const std::vector<std::string>& arguments, ToolOptions& options, std::string& error);

#endif

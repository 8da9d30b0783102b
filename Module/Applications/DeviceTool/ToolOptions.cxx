// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/ToolOptions.h"

#include "Core/Math/NumberText.h"

#include <cmath>
#include <map>
#include <optional>

const char* const ToolUsage =
  R"(usage: volumehaptics-device list
       volumehaptics-device monitor ID [options]      live tip, force, rate and buttons; no force
       volumehaptics-device home ID [options]         find the zero of its encoders, by hand
       volumehaptics-device confirm ID [options]      find out whether it moves with the force, gently
       volumehaptics-device calibrate ID --weight GRAMS [options]
       volumehaptics-device calibrate ID --scale [options]
                                                      measure its force, with a weight or a scale
       volumehaptics-device test ID [options]         feel a wall of at most 1 N in its middle
       volumehaptics-device record ID FILE [options]  its path, to a .vtp or a .csv; no force

ID is what list shows: falcon[:N], wooden[:N], pid[:VVVV:PPPP], wheel[:N], haply[:ID], hfab[:PORT],
spacemouse[:N] (no force), vendor:PLUGIN[:N]; vibration, not force: vibration:pad[:N], vibration:bhaptics[:PLACE],
vibration:weart[:HAND], vibration:hapbeat:ADDRESS; also virtual, replay:FILE.

  --firmware FILE     the image for a Novint Falcon that has none (else $VOLUMEHAPTICS_FALCON_FIRMWARE)
  --vendor-path PATHS the folders of plug-ins for vendors' libraries (else $VOLUMEHAPTICS_VENDOR_PATH, by which list
                      looks)
  --homing-time S     how long each step of homing may take (120)
  --newtons X[,Y]     a force-feedback device's force at full scale along its axes, N; negative reverses it (100);
                      Y is 0 if only the first axis has a motor, as that of a wheel
  --axis [-]x|y|z     test: across which its wall stands (z; x for a stick or a wheel);
                      calibrate: the vertical axis, or with --scale where the scale is (-y; -x for a stick or a wheel)
  --rate HZ           ticks of the servo per second, 100 to 10000 (1000)
  --seconds S         end after that time (monitor, test: when interrupted; record: 10); calibrate: how long it
                      waits for the weight (60)

calibrate stores how many newtons the device gives for each one that it is asked for; forces and limits are then true
newtons. A device whose signs were never confirmed is confirmed first. It holds its handle with a soft spring, with at
most half of its force. Nothing is typed while there is force.
  --weight GRAMS      hang this weight on the handle when the tool asks for it, and take it off again; 5 to 5000
  --scale             the handle presses a kitchen scale with four forces; type what it shows after each
)";

namespace
{

bool ReadNumber(const std::string& text, double& number)
{
  const std::optional<double> read = VolumeHaptics::ParseNumber(text);
  number = read.value_or(0.0);
  return read && std::isfinite(number);
}

bool ReadNewtons(const std::string& text, double newtons[2])
{
  const std::size_t comma = text.find(',');
  if (!ReadNumberInRange(text.substr(0, comma), -100.0, 100.0, newtons[0]))
  {
    return false;
  }
  newtons[1] = newtons[0];
  return comma == std::string::npos ||
    ReadNumberInRange(text.substr(comma + 1), -100.0, 100.0, newtons[1]);
}

bool ReadAxis(const std::string& text, ToolOptions& options)
{
  options.IsAxisNegative = !text.empty() && text[0] == '-';
  const std::string name = text.substr(options.IsAxisNegative ? 1 : 0);
  const std::size_t found = std::string("xyz").find(name);
  options.Axis = static_cast<int>(found);
  return name.size() == 1 && found != std::string::npos;
}

/**
 * Reads the value of an option. If it is wrong, returns a description of the allowed values;
 * otherwise nullptr.
 */
const char* ReadOption(const std::string& name, const std::string& value, ToolOptions& options)
{
  if (name == "--firmware")
  {
    options.Firmware = value;
    return value.empty() ? "the name of a file" : nullptr;
  }
  if (name == "--vendor-path")
  {
    options.VendorPath = value;
    return value.empty() ? "folders, separated by colons" : nullptr;
  }
  if (name == "--homing-time")
  {
    return ReadNumberInRange(value, 1.0, 3600.0, options.HomingTime) ? nullptr
                                                                     : "seconds, 1 to 3600";
  }
  if (name == "--newtons")
  {
    options.HasNewtons = true;
    return ReadNewtons(value, options.Newtons) ? nullptr
                                               : "newtons, -100 to 100, such as 2.5 or 2.5,-2.5";
  }
  if (name == "--axis")
  {
    return ReadAxis(value, options) ? nullptr : "x, y or z";
  }
  if (name == "--weight")
  {
    return ReadNumberInRange(value, 5.0, 5000.0, options.Grams) ? nullptr : "grams, 5 to 5000";
  }
  if (name == "--rate")
  {
    return ReadNumberInRange(value, 100.0, 10000.0, options.ServoRate) ? nullptr
                                                                       : "Hz, 100 to 10000";
  }
  return ReadNumberInRange(value, 0.001, 1e6, options.Seconds) ? nullptr : "seconds, more than 0";
}

/** Returns the fault and the cure if the options don't fit the command; otherwise an empty text. */
std::string CheckOptions(const ToolOptions& options)
{
  using Command = ToolOptions::Command;
  const bool calibrates = options.What == Command::Calibrate;
  if (calibrates && options.HasScale == (options.Grams > 0.0))
  {
    return "calibrate takes either --weight GRAMS or --scale. Try --help.";
  }
  if (!calibrates && (options.HasScale || options.Grams > 0.0))
  {
    return "--weight and --scale are for calibrate. Try --help.";
  }
  return !calibrates && options.IsAxisNegative ? "--axis needs x, y or z." : "";
}

} // namespace

bool ReadNumberInRange(const std::string& text, double least, double most, double& number)
{
  return ReadNumber(text, number) && number >= least && number <= most;
}

bool ReadToolOptions(
  const std::vector<std::string>& arguments, ToolOptions& options, std::string& error)
{
  using Command = ToolOptions::Command;
  static const std::map<std::string, Command> commands = { { "list", Command::List },
    { "monitor", Command::Monitor }, { "home", Command::Home }, { "confirm", Command::Confirm },
    { "calibrate", Command::Calibrate }, { "test", Command::Test }, { "record", Command::Record },
    { "help", Command::Help }, { "--help", Command::Help }, { "-h", Command::Help } };
  static const std::string names =
    " --firmware --vendor-path --homing-time --newtons --axis --weight --rate --seconds ";

  const std::string first = arguments.empty() ? "" : arguments.front();
  const auto command = commands.find(first);
  if (command == commands.end())
  {
    error = first.empty() ? "No command was given. Try --help."
                          : "There is no command \"" + first + "\". Try --help.";
    return false;
  }
  options.What = command->second;
  std::vector<std::string> operands;
  for (std::size_t i = 1; i < arguments.size(); ++i)
  {
    const std::string& name = arguments[i];
    if (name.empty() || name[0] != '-')
    {
      operands.push_back(name);
      continue;
    }
    if (name == "--scale")
    {
      options.HasScale = true;
      continue;
    }
    if (name == "--help" || name == "-h")
    {
      options.What = Command::Help;
      return true;
    }
    if (names.find(" " + name + " ") == std::string::npos)
    {
      error = "There is no option \"" + name + "\". Try --help.";
      return false;
    }
    const char* const wanted =
      ReadOption(name, i + 1 < arguments.size() ? arguments[i + 1] : "", options);
    if (wanted)
    {
      error = name + " wants " + wanted + ".";
      return false;
    }
    ++i;
  }

  const std::size_t wanted = options.What == Command::Record         ? 2
    : options.What == Command::Help || options.What == Command::List ? 0
                                                                     : 1;
  if (operands.size() != wanted)
  {
    error = first + " takes " +
      (wanted == 0      ? "no operands"
          : wanted == 1 ? "the id of a device, as list shows it"
                        : "the id of a device, as list shows it, and a file named .vtp or .csv") +
      ". Try --help.";
    return false;
  }
  options.Id = wanted > 0 ? operands[0] : "";
  options.File = wanted > 1 ? operands[1] : "";
  error = CheckOptions(options);
  return error.empty();
}

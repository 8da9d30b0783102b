// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pad/EvdevPads.h"

#include "Devices/Pad/EvdevReader.h"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>

#include <dirent.h>
#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

constexpr const char* InputFolder = "/sys/class/input";

/** The first line of a file of sysfs; empty if there is none. */
std::string ReadAttribute(const std::string& path)
{
  char text[1024] = {};
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0)
  {
    return {};
  }
  const ssize_t size = read(file, text, sizeof(text) - 1);
  close(file);
  const std::string line(text, static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  return line.substr(0, line.find('\n'));
}

std::uint16_t ReadHexAttribute(const std::string& path)
{
  return static_cast<std::uint16_t>(std::strtoul(ReadAttribute(path).c_str(), nullptr, 16));
}

std::vector<int> FindNumbers()
{
  std::vector<int> numbers;
  DIR* const folder = opendir(InputFolder);
  for (const dirent* entry = nullptr; folder && (entry = readdir(folder)) != nullptr;)
  {
    if (std::strncmp(entry->d_name, "event", 5) == 0)
    {
      numbers.push_back(std::atoi(entry->d_name + 5));
    }
  }
  if (folder)
  {
    closedir(folder);
  }
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

} // namespace

const char* const NoRumbleText =
  "can't vibrate: its driver offers no rumble (FF_RUMBLE). Use a pad with motors; if this one has "
  "some, look for a driver or a newer kernel that knows them.";

std::vector<EvdevPad> FindEvdevPads()
{
  std::vector<EvdevPad> pads;
  for (const int number : FindNumbers())
  {
    const std::string event = "event" + std::to_string(number);
    const std::string device = std::string(InputFolder) + "/" + event + "/device";
    const std::string axes = ReadAttribute(device + "/capabilities/abs");
    if (!HasEvdevBit(ReadAttribute(device + "/capabilities/key"), BTN_GAMEPAD) ||
      !HasEvdevBit(axes, ABS_X) || !HasEvdevBit(axes, ABS_Y))
    {
      continue;
    }
    EvdevPad pad;
    pad.Path = "/dev/input/" + event;
    pad.Name = ReadAttribute(device + "/name");
    pad.Vendor = ReadHexAttribute(device + "/id/vendor");
    pad.Product = ReadHexAttribute(device + "/id/product");
    pad.Vibrates = HasEvdevBit(ReadAttribute(device + "/capabilities/ff"), FF_RUMBLE);
    pads.push_back(pad);
  }
  return pads;
}

std::string EvdevPad::GetLabel() const
{
  return (this->Name.empty() ? "A gamepad" : this->Name) + " (" + this->Path + ")";
}

std::string EvdevPad::Explain(int fault)
{
  switch (fault)
  {
    case EBUSY:
      return "in use: another program, such as Steam, has grabbed it. Close it there.";
    case EACCES:
    case EPERM:
      return "no permission. Log in at the computer itself, to whose user the system gives "
             "gamepads; "
             "or run \"sudo usermod -a -G input $USER\" and log in again.";
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return "not there any more. Plug it in, or switch it on.";
    default:
      return std::string("can't be opened: ") + std::strerror(fault) + ".";
  }
}

std::string EvdevPad::GetState() const
{
  if (!this->Vibrates)
  {
    return NoRumbleText;
  }
  const int node = open(this->Path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (node < 0)
  {
    return Explain(errno);
  }
  // For a moment: the only way to detect whether another program has grabbed it.
  const bool isFree = ioctl(node, EVIOCGRAB, 1) == 0;
  std::string state = isFree ? "available" : Explain(errno);
  ioctl(node, EVIOCGRAB, 0);
  close(node);
  return state;
}

} // namespace VolumeHaptics

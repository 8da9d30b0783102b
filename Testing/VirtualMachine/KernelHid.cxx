// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * EmulatedHid on a real kernel: the tests that are written for umockdev's run on it as they are.
 */
#include "EmulatedHid.h"

#include "EmulatedUsb.h"
#include "HidOverUsb.h"
#include "Waiting.h"

#include <filesystem>

namespace emulated
{
namespace
{
/** The first ports are those of the tests of USB devices. */
std::string PortOf(int number)
{
  return "1-" + std::to_string(number + 4);
}

/** The node of the device in a port; empty where the kernel has made none. */
std::filesystem::path FindNode(const std::string& port)
{
  std::error_code none;
  using Folder = std::filesystem::directory_iterator;
  for (const auto& device : Folder("/sys/bus/usb/devices/" + port + ":1.0", none))
  {
    for (const auto& node : Folder(device.path() / "hidraw", none))
    {
      const std::filesystem::path path = "/dev" / node.path().filename();
      return std::filesystem::exists(path) ? path : std::filesystem::path();
    }
  }
  return {};
}
} // namespace

struct EmulatedHid::Plug
{
  Plug(HidModel& model, int number)
    : Device(model)
    , Usb(this->Device, PortOf(number))
  {
  }

  HidOverUsb Device;
  EmulatedUsb Usb;
};

EmulatedHid::EmulatedHid(HidModel& model, int number)
  : Model(model)
  , Number(number)
  , Current(new Plug(model, number))
{
  this->PlugIn();
}

EmulatedHid::~EmulatedHid()
{
  this->Unplug();
  this->Model.Input = [](const std::uint8_t*, int) {};
  delete this->Current;
}

void EmulatedHid::PlugIn()
{
  if (FindNode(PortOf(this->Number)).empty())
  {
    this->Current->Device.Forget();
    this->Current->Usb.PlugIn();
  }
  EXPECT_TRUE(machinetest::Eventually([this] { return !FindNode(PortOf(this->Number)).empty(); }));
}

void EmulatedHid::Unplug()
{
  this->Current->Usb.Unplug();
}

void EmulatedHid::SetPermissions(unsigned mode)
{
  std::filesystem::permissions(
    FindNode(PortOf(this->Number)), static_cast<std::filesystem::perms>(mode));
}
} // namespace emulated

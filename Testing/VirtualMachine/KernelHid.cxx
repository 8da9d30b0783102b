// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Implements EmulatedHid on a real kernel, so that tests written for umockdev run unchanged.
 */
#include "Emulators/EmulatedHid.h"

#include "Emulators/EmulatedUsb.h"
#include "Emulators/HidOverUsb.h"
#include "Waiting.h"

#include <filesystem>

namespace emulated
{
namespace
{
/** Ports in use, one bit each. The first three ports belong to the tests of USB devices. */
unsigned int Taken = 7;

int ClaimPort()
{
  int port = 0;
  while ((Taken >> port & 1) != 0)
  {
    ++port;
  }
  Taken |= 1u << port;
  return port;
}

std::string NameOf(int port)
{
  return "1-" + std::to_string(port + 1);
}

/** Returns the node of the device in a port; empty if the kernel has made none. */
std::string FindNode(const std::string& port)
{
  std::error_code none;
  using Folder = std::filesystem::directory_iterator;
  for (const auto& device : Folder("/sys/bus/usb/devices/" + port + ":1.0", none))
  {
    for (const auto& node : Folder(device.path() / "hidraw", none))
    {
      const std::filesystem::path path = "/dev" / node.path().filename();
      return std::filesystem::exists(path) ? path.string() : std::string();
    }
  }
  return {};
}
} // namespace

struct EmulatedHid::Plug
{
  explicit Plug(HidModel& model)
    : Port(ClaimPort())
    , Device(model)
    , Usb(this->Device, NameOf(this->Port))
  {
    this->WaitForNode();
  }
  ~Plug() { Taken &= ~(1u << this->Port); }

  void WaitForNode()
  {
    EXPECT_TRUE(machinetest::Eventually(
      [this] { return !(this->Node = FindNode(NameOf(this->Port))).empty(); }))
      << "no driver of the kernel takes the device";
  }

  const int Port;
  HidOverUsb Device;
  EmulatedUsb Usb;
  std::string Node;
};

EmulatedHid::EmulatedHid(HidModel& model)
  : Model(model)
  , Current(new Plug(model))
{
}

EmulatedHid::~EmulatedHid()
{
  this->Unplug();
  this->Model.Input = [](const std::uint8_t*, int) {};
  delete this->Current;
}

void EmulatedHid::PlugIn()
{
  this->Current->Device.Forget();
  this->Current->Usb.PlugIn();
  this->Current->WaitForNode();
}

void EmulatedHid::Unplug()
{
  this->Current->Usb.Unplug();
}

const std::string& EmulatedHid::GetNode() const
{
  return this->Current->Node;
}

void EmulatedHid::SetPermissions(unsigned mode)
{
  std::filesystem::permissions(this->GetNode(), static_cast<std::filesystem::perms>(mode));
}
} // namespace emulated

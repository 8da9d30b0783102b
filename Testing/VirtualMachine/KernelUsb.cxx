// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Implements EmulatedUsb on a real kernel, so that tests written for umockdev run unchanged.
 */
#include "Emulators/EmulatedUsb.h"

#include "Emulators/VirtualUsb.h"
#include "Waiting.h"

#include <filesystem>
#include <fstream>

namespace emulated
{
namespace
{
const std::filesystem::path Devices = "/sys/bus/usb/devices";

std::filesystem::path InterfaceOf(const std::string& port)
{
  return Devices / (port + ":1.0");
}

std::string ReadLine(const std::filesystem::path& path)
{
  std::ifstream stream(path);
  std::string line;
  std::getline(stream, line);
  return line;
}

/**
 * Returns the driver that is bound to the interface: "usbfs" if a program has claimed it, "" for
 * none.
 */
std::string BoundTo(const std::string& port)
{
  std::error_code none;
  return std::filesystem::read_symlink(InterfaceOf(port) / "driver", none).filename().string();
}
} // namespace

class EmulatedUsb::Plug
{
public:
  Plug(UsbModel& model, const std::string& port)
    // "1-2" is the second port of the first bus, the virtual hub.
    : Port(model, std::stoi(port.substr(2)) - 1)
  {
  }

  VirtualUsb Port;
};

EmulatedUsb::EmulatedUsb(UsbModel& model, const std::string& port)
  : Model(model)
  , Port(port)
{
  this->Plugs.push_back(std::make_unique<Plug>(model, port));
  this->PlugIn();
}

EmulatedUsb::~EmulatedUsb()
{
  this->Unplug();
}

void EmulatedUsb::PlugIn()
{
  this->Plugs.back()->Port.Plug();
  EXPECT_TRUE(machinetest::Eventually(
    [this]
    {
      return std::filesystem::exists(InterfaceOf(this->Port)) &&
        std::filesystem::exists(this->GetNode());
    }))
    << "the kernel does not take the device";
}

void EmulatedUsb::Unplug()
{
  this->Plugs.back()->Port.Unplug();
  EXPECT_TRUE(
    machinetest::Eventually([this] { return !std::filesystem::exists(Devices / this->Port); }));
}

std::string EmulatedUsb::GetNode() const
{
  const auto number = [this](const char* file)
  {
    const std::string digits = ReadLine(Devices / this->Port / file);
    return std::string(3 - std::min<std::size_t>(digits.size(), 3), '0') + digits;
  };
  return "/dev/bus/usb/" + number("busnum") + "/" + number("devnum");
}

void EmulatedUsb::BindDriver(const std::string& name)
{
  const auto number = [this](const char* file) { return ReadLine(Devices / this->Port / file); };
  // Make the kernel's serial driver accept the device's numbers, which the driver does not know.
  const std::string drivers = "/sys/bus/usb-serial/drivers/" + name + "/new_id";
  if (!name.empty())
  {
    std::ofstream(drivers) << number("idVendor") << " " << number("idProduct") << std::endl;
    EXPECT_TRUE(machinetest::Eventually([&] { return BoundTo(this->Port) == name; }));
  }
}

std::string EmulatedUsb::GetDriver() const
{
  const std::string bound = BoundTo(this->Port);
  return bound == "usbfs" ? "" : bound;
}

bool EmulatedUsb::IsClaimed() const
{
  return BoundTo(this->Port) == "usbfs";
}
} // namespace emulated

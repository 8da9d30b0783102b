// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmulatedPlug.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <iterator>
#include <stdexcept>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace emulated
{
namespace
{

constexpr int PipeSize = 4096; // bytes: smallest size of a pipe

void Check(gboolean done, GError* error)
{
  if (!done)
  {
    throw std::runtime_error(error != nullptr ? error->message : "umockdev failed");
  }
}

std::string Format(const char* format, int bus, int address)
{
  char text[100];
  std::snprintf(text, sizeof(text), format, bus, address);
  return text;
}

} // namespace

EmulatedUsb::Plug::Plug(UsbModel& model, const std::string& port, int address)
  : Model(model)
  , Base(umockdev_ioctl_base_new())
{
  const int bus = std::stoi(port);
  this->Node = Format("/dev/bus/usb/%03d/%03d", bus, address);
  this->Path = "/sys/devices/usb" + std::to_string(bus) + "/" + port;
  g_signal_connect(this->Base, "handle-ioctl", G_CALLBACK(&Plug::OnIoctl), this);
  g_signal_connect(this->Base, "client-vanished", G_CALLBACK(&Plug::OnVanished), this);
  // Attach the ioctls before the device exists, so that umockdev does not query udev for it.
  GError* error = nullptr;
  Check(umockdev_testbed_attach_ioctl(Testbed(), this->Node.c_str(), this->Base, &error), error);
  this->AddDevice(port, address);
  this->ReplaceNode();
  umockdev_testbed_uevent(Testbed(), this->Path.c_str(), "add");
}

void EmulatedUsb::Plug::AddDevice(const std::string& port, int address)
{
  const int bus = std::stoi(port);
  const std::vector<std::uint8_t> descriptors = this->Model.GetDescriptors();
  std::string text = "P: " + this->Path.substr(4) + "\nN: " + this->Node.substr(5);
  text += "\nE: SUBSYSTEM=usb\nE: DRIVER=usb\nE: DEVTYPE=usb_device\nE: MAJOR=189";
  text += "\nE: MINOR=" + std::to_string((bus - 1) * 128 + address - 1);
  text += Format("\nE: BUSNUM=%03d\nE: DEVNUM=%03d", bus, address);
  text += "\nE: DEVNAME=" + this->Node + "\nA: bConfigurationValue=1\\n\nA: speed=12\\n";
  text += Format("\nA: busnum=%d\\n\nA: devnum=%d\\n\nH: descriptors=", bus, address);
  for (const std::uint8_t byte : descriptors)
  {
    text += Format("%X%X", byte >> 4, byte & 15);
  }
  GError* error = nullptr;
  Check(umockdev_testbed_add_from_string(Testbed(), (text + "\n").c_str(), &error), error);
}

/**
 * Replaces the node by a pipe, because poll() always succeeds on a plain file. The pipe is writable
 * only while it is not full.
 */
void EmulatedUsb::Plug::ReplaceNode()
{
  char* const root = umockdev_testbed_get_root_dir(Testbed());
  this->File = root + this->Node;
  g_free(root);
  unlink(this->File.c_str());
  Check(mkfifo(this->File.c_str(), 0666) == 0, nullptr);
  this->Pipe = open(this->File.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  Check(this->Pipe >= 0 && fcntl(this->Pipe, F_SETPIPE_SZ, PipeSize) == PipeSize, nullptr);
  this->SetReady(false);
}

void EmulatedUsb::Plug::SetReady(bool ready)
{
  std::array<char, PipeSize> page{};
  if (ready && this->Full)
  {
    while (read(this->Pipe, page.data(), page.size()) > 0)
    {
    }
  }
  else if (!ready && !this->Full)
  {
    while (write(this->Pipe, page.data(), page.size()) > 0)
    {
    }
  }
  this->Full = !ready;
}

void EmulatedUsb::Plug::Unplug()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Gone)
    {
      return;
    }
    this->Gone = true;
    this->PumpLocked();
  }
  umockdev_testbed_uevent(Testbed(), this->Path.c_str(), "remove");
  umockdev_testbed_remove_device(Testbed(), this->Path.c_str());
}

void EmulatedUsb::Plug::ForgetProgram()
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  if (this->Owner != nullptr)
  {
    this->Owner = nullptr;
    // Leak the ioctls: they belong to a client that may have ended, so they can't be released.
    this->Waiting.clear();
    this->Ended.clear();
    this->SetReady(false);
    this->Model.Released();
  }
}

EmulatedUsb::EmulatedUsb(UsbModel& model, const std::string& port)
  : Model(model)
  , Port(port)
{
  RememberConfirmed("falcon:port:" + port); // by its port, because the model has no serial number
  this->PlugIn();
}

EmulatedUsb::~EmulatedUsb()
{
  this->Model.Ready = [] {};
  this->Unplug();
  // Keep all plugs alive. A caller with an open handle would otherwise wait forever for an answer.
  static auto& kept = *new std::vector<std::unique_ptr<Plug>>;
  std::move(this->Plugs.begin(), this->Plugs.end(), std::back_inserter(kept));
}

void EmulatedUsb::PlugIn()
{
  // Use a new address, because the kernel does not immediately reuse the address of an unplugged
  // device.
  static int address = 1;
  this->Plugs.push_back(std::make_unique<Plug>(this->Model, this->Port, ++address));
  Plug* const plug = this->Plugs.back().get();
  this->Model.Ready = [plug] { plug->Pump(); };
}

void EmulatedUsb::Unplug()
{
  this->Plugs.back()->Unplug();
}

void EmulatedUsb::ForgetProgram()
{
  this->Plugs.back()->ForgetProgram();
}

std::string EmulatedUsb::GetNode() const
{
  return this->Plugs.back()->GetFile();
}

void EmulatedUsb::BindDriver(const std::string& name)
{
  const std::lock_guard<std::mutex> lock(this->Plugs.back()->Mutex);
  this->Plugs.back()->Driver = name;
}

std::string EmulatedUsb::GetDriver() const
{
  const std::lock_guard<std::mutex> lock(this->Plugs.back()->Mutex);
  return this->Plugs.back()->Driver;
}

bool EmulatedUsb::IsClaimed() const
{
  const std::lock_guard<std::mutex> lock(this->Plugs.back()->Mutex);
  return this->Plugs.back()->Owner != nullptr;
}

} // namespace emulated

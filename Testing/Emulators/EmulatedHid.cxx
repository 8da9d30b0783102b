// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EmulatedHid.h"

#include "Testbed.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <linux/hidraw.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace emulated
{

struct EmulatedHid::Plug
{
  HidModel& Model;
  UMockdevIoctlBase* Handler = nullptr;
  std::string Node;                  ///< as programs see it
  std::string File;                  ///< its path
  std::vector<std::string> SysPaths; ///< the innermost first
  int Fifo = -1;
  std::atomic<bool> Gone{ false };
};

namespace
{
using Plug = EmulatedHid::Plug;

/** Of ioctls: hidraw's own letter, and the numbers in linux/hidraw.h. */
enum HidIoctl
{
  DescriptorSize = 1,
  Descriptor = 2,
  Info = 3,
  Name = 4,
  SetFeature = 6,
  GetFeature = 7
};

void Require(bool holds, const char* what)
{
  if (!holds)
  {
    throw std::runtime_error(std::string(what) + ": " + std::strerror(errno));
  }
}

gboolean Answer(UMockdevIoctlClient* client, int result)
{
  umockdev_ioctl_client_complete(client, result < 0 ? -1 : result, result < 0 ? -result : 0);
  return TRUE;
}

gboolean OnWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data)
{
  auto* plug = static_cast<Plug*>(data);
  const UMockdevIoctlData* bytes = umockdev_ioctl_client_get_arg(client);
  return Answer(
    client, plug->Gone ? -EIO : plug->Model.Output(bytes->data, static_cast<int>(bytes->data_len)));
}

gboolean OnRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data)
{
  // Not handled: the FIFO is read.
  return static_cast<Plug*>(data)->Gone ? Answer(client, -EIO) : FALSE;
}

int Fill(const Plug& plug, unsigned long request, void* data)
{
  const std::vector<std::uint8_t> descriptor = plug.Model.GetReportDescriptor();
  const std::size_t size = _IOC_SIZE(request);
  auto* bytes = static_cast<std::uint8_t*>(data);
  switch (_IOC_NR(request))
  {
    case DescriptorSize:
      *static_cast<int*>(data) = static_cast<int>(descriptor.size());
      return 0;
    case Descriptor:
    {
      auto* whole = static_cast<hidraw_report_descriptor*>(data);
      whole->size = static_cast<std::uint32_t>(descriptor.size());
      std::memcpy(whole->value, descriptor.data(), descriptor.size());
      return 0;
    }
    case Info:
      *static_cast<hidraw_devinfo*>(data) = { 3, static_cast<__s16>(plug.Model.GetVendor()),
        static_cast<__s16>(plug.Model.GetProduct()) };
      return 0;
    case Name:
      return 1 + std::snprintf(static_cast<char*>(data), size, "%s", plug.Model.GetName().c_str());
    case SetFeature:
      return plug.Model.SetFeature(bytes, static_cast<int>(size));
    case GetFeature:
      return plug.Model.GetFeature(bytes, static_cast<int>(size));
    default:
      return -ENOTTY;
  }
}

gboolean OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer user)
{
  auto* plug = static_cast<Plug*>(user);
  const unsigned long request = umockdev_ioctl_client_get_request(client);
  if (_IOC_TYPE(request) != 'H')
  {
    return FALSE;
  }
  if (plug->Gone)
  {
    return Answer(client, -ENODEV);
  }
  const std::size_t size =
    _IOC_NR(request) == Descriptor ? sizeof(hidraw_report_descriptor) : _IOC_SIZE(request);
  UMockdevIoctlData* data =
    umockdev_ioctl_data_resolve(umockdev_ioctl_client_get_arg(client), 0, size, nullptr);
  if (data == nullptr)
  {
    return Answer(client, -EIO); // its program has ended meanwhile
  }
  const int result = Fill(*plug, request, data->data);
  g_object_unref(data);
  return Answer(client, result);
}

/** The entries of udev: a hidraw node of a HID device of an interface of a USB device. */
std::string Describe(const HidModel& model, int number, std::vector<std::string>& sysPaths)
{
  char usb[64];
  char hid[160];
  std::snprintf(usb, sizeof(usb), "/devices/usb1/1-%d", number + 1);
  std::snprintf(hid, sizeof(hid), "%s/1-%d:1.0/0003:%04X:%04X.%04X", usb, number + 1,
    model.GetVendor(), model.GetProduct(), number + 1);
  const std::string hidPath = std::string("/sys") + hid;
  sysPaths = { hidPath + "/hidraw/hidraw" + std::to_string(number), hidPath,
    hidPath.substr(0, hidPath.rfind('/')), std::string("/sys") + usb };
  std::string descriptor;
  for (const std::uint8_t byte : model.GetReportDescriptor())
  {
    char digits[3];
    std::snprintf(digits, sizeof(digits), "%02X", byte);
    descriptor += digits;
  }
  const std::string name = model.GetName();
  const std::string serial = model.TellsSerial ? "SN" + std::to_string(number) : std::string();
  char text[2000];
  std::snprintf(text, sizeof(text),
    "P: %s/hidraw/hidraw%d\nN: hidraw%d\nE: DEVNAME=/dev/hidraw%d\nE: SUBSYSTEM=hidraw\n"
    "E: MAJOR=244\nE: MINOR=%d\nL: device=../../../0003:%04X:%04X.%04X\nA: dev=244:%d\\n\n\n",
    hid, number, number, number, number, model.GetVendor(), model.GetProduct(), number + 1, number);
  std::string all = text;
  std::snprintf(text, sizeof(text),
    "P: %s\nE: SUBSYSTEM=hid\nE: DRIVER=hid-generic\nE: HID_ID=0003:%08X:%08X\nE: HID_NAME=%s\n"
    "E: HID_PHYS=usb/input0\nE: HID_UNIQ=%s\nH: report_descriptor=",
    hid, model.GetVendor(), model.GetProduct(), name.c_str(), serial.c_str());
  all += text + descriptor;
  std::snprintf(text, sizeof(text),
    "\n\nP: %s/1-%d:1.0\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_interface\nE: DRIVER=usbhid\n"
    "A: bInterfaceNumber=00\\n\nA: bInterfaceClass=03\\n\n\n"
    "P: %s\nN: bus/usb/001/%03d\nE: SUBSYSTEM=usb\nE: DEVTYPE=usb_device\nE: DRIVER=usb\n"
    "E: BUSNUM=001\nE: DEVNUM=%03d\nA: busnum=1\\n\nA: devnum=%d\\n\nA: speed=12\\n\n"
    "A: idVendor=%04x\\n\nA: idProduct=%04x\\n\nA: bcdDevice=0100\\n\nA: manufacturer=Emulated\\n\n"
    "A: product=%s\\n\n\n",
    usb, number + 1, usb, number + 10, number + 10, number + 10, model.GetVendor(),
    model.GetProduct(), name.c_str());
  return all + text;
}
} // namespace

EmulatedHid::EmulatedHid(HidModel& model)
  : Model(model)
{
  model.Input = [this](const std::uint8_t* report, int size)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (this->Current)
    {
      // If it is full, the report is lost.
      [[maybe_unused]] const auto written =
        write(this->Current->Fifo, report, static_cast<std::size_t>(size));
    }
  };
  this->PlugIn();
}

void EmulatedHid::PlugIn()
{
  auto* plug = new Plug{ this->Model };
  // The kernel gives numbers anew, but umockdev does not; the second one has two digits.
  static std::atomic<int> next{ 9 };
  const int number = next++;
  char identity[40];
  std::snprintf(identity, sizeof(identity), ":%04x:%04x:SN%d", this->Model.GetVendor(),
    this->Model.GetProduct(), number);
  for (const char* const reversed : { "", "-x", "-y", "-x-y" })
  {
    RememberConfirmed(std::string("pid") + identity + reversed);
  }
  RememberConfirmed(std::string("wooden") + identity);
  plug->Node = "/dev/hidraw" + std::to_string(number);
  char* root = umockdev_testbed_get_root_dir(Testbed());
  plug->File = root + plug->Node;
  g_free(root);
  plug->Handler = umockdev_ioctl_base_new();
  g_signal_connect(plug->Handler, "handle-ioctl", G_CALLBACK(OnIoctl), plug);
  g_signal_connect(plug->Handler, "handle-write", G_CALLBACK(OnWrite), plug);
  g_signal_connect(plug->Handler, "handle-read", G_CALLBACK(OnRead), plug);
  Require(
    umockdev_testbed_attach_ioctl(Testbed(), plug->Node.c_str(), plug->Handler, nullptr), "attach");
  const std::string text = Describe(this->Model, number, plug->SysPaths);
  Require(umockdev_testbed_add_from_string(Testbed(), text.c_str(), nullptr), "add");
  unlink(plug->File.c_str());
  Require(mkfifo(plug->File.c_str(), 0666) == 0, "mkfifo");
  // A FIFO can't be opened in packet mode, only be put into it.
  plug->Fifo = open(plug->File.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  Require(plug->Fifo >= 0 && fcntl(plug->Fifo, F_SETFL, O_NONBLOCK | O_DIRECT) == 0, "fifo");
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Current = plug;
}

void EmulatedHid::Unplug()
{
  Plug* const plug = this->Current;
  if (!plug)
  {
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    this->Current = nullptr;
  }
  plug->Gone = true;
  // A poll wakes up, and reads EIO.
  const std::uint8_t byte = 0;
  for (int i = 0; i < 4 && write(plug->Fifo, &byte, 1) == 1; ++i)
  {
  }
  umockdev_testbed_detach_ioctl(Testbed(), plug->Node.c_str(), nullptr);
  for (const std::string& path : plug->SysPaths)
  {
    umockdev_testbed_uevent(Testbed(), path.c_str(), "remove");
    umockdev_testbed_remove_device(Testbed(), path.c_str());
  }
  unlink(plug->File.c_str());
  this->Old.push_back(plug);
}

const std::string& EmulatedHid::GetNode() const
{
  return this->Current->Node;
}

void EmulatedHid::SetPermissions(unsigned mode)
{
  chmod(this->Current->File.c_str(), mode);
  // The rest is for everyone, the socket behind the node included.
  char* root = umockdev_testbed_get_root_dir(Testbed());
  const std::string ioctls = std::string(root) + "/ioctl";
  for (const std::string& path :
    { std::string(root), ioctls, ioctls + "/dev", ioctls + this->Current->Node })
  {
    chmod(path.c_str(), 0777);
  }
  g_free(root);
}

EmulatedHid::~EmulatedHid()
{
  this->Unplug();
  this->Model.Input = [](const std::uint8_t*, int) {};
  for (Plug* plug : this->Old)
  {
    close(plug->Fifo);
    g_object_unref(plug->Handler);
    delete plug;
  }
}

} // namespace emulated

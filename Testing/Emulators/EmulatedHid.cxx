// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

#include "EmulatedHid.h"

#include "FifoNode.h"
#include "Testbed.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include <linux/hidraw.h>
#include <sys/ioctl.h>

namespace emulated
{

struct EmulatedHid::Plug : public FifoNode
{
  using FifoNode::FifoNode;
};

namespace
{
/** Ioctls of hidraw, by their numbers in linux/hidraw.h. */
enum HidIoctl
{
  DescriptorSize = 1,
  Descriptor = 2,
  Info = 3,
  Name = 4,
  SetFeature = 6,
  GetFeature = 7
};

int Fill(HidModel& model, unsigned long request, std::uint8_t* bytes)
{
  const std::vector<std::uint8_t> descriptor = model.GetReportDescriptor();
  const std::size_t size = _IOC_SIZE(request);
  void* const data = bytes;
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
      *static_cast<hidraw_devinfo*>(data) = { 3, static_cast<__s16>(model.GetVendor()),
        static_cast<__s16>(model.GetProduct()) };
      return 0;
    case Name:
      return 1 + std::snprintf(static_cast<char*>(data), size, "%s", model.GetName().c_str());
    case SetFeature:
      return model.SetFeature(bytes, static_cast<int>(size));
    case GetFeature:
      return model.GetFeature(bytes, static_cast<int>(size));
    default:
      return -ENOTTY;
  }
}

int AnswerIoctl(HidModel& model, UMockdevIoctlClient* client, unsigned long request)
{
  const std::size_t size =
    _IOC_NR(request) == Descriptor ? sizeof(hidraw_report_descriptor) : _IOC_SIZE(request);
  return FifoNode::WithTarget(
    client, size, [&](std::uint8_t* bytes) { return Fill(model, request, bytes); });
}

/**
 * Returns udev's entries for a hidraw node of a HID device, which is an interface of a USB device.
 */
FifoNode::Device Describe(const HidModel& model, int number, int serialNumber)
{
  char usb[64];
  char hid[160];
  std::snprintf(usb, sizeof(usb), "/devices/usb1/1-%d", number + 1);
  const int bus = model.IsBluetooth ? 5 : 3;
  std::snprintf(hid, sizeof(hid), "%s/1-%d:1.0/%04X:%04X:%04X.%04X", usb, number + 1, bus,
    model.GetVendor(), model.GetProduct(), number + 1);
  const std::string hidPath = std::string("/sys") + hid;
  std::string descriptor;
  for (const std::uint8_t byte : model.GetReportDescriptor())
  {
    char digits[3];
    std::snprintf(digits, sizeof(digits), "%02X", byte);
    descriptor += digits;
  }
  const std::string name = model.GetName();
  const std::string serial =
    model.TellsSerial ? "SN" + std::to_string(serialNumber) : std::string();
  char text[2000];
  std::snprintf(text, sizeof(text),
    "P: %s/hidraw/hidraw%d\nN: hidraw%d\nE: DEVNAME=/dev/hidraw%d\nE: SUBSYSTEM=hidraw\n"
    "E: MAJOR=244\nE: MINOR=%d\nL: device=../../../%04X:%04X:%04X.%04X\nA: dev=244:%d\\n\n\n",
    hid, number, number, number, number, bus, model.GetVendor(), model.GetProduct(), number + 1,
    number);
  std::string all = text;
  std::snprintf(text, sizeof(text),
    "P: %s\nE: SUBSYSTEM=hid\nE: DRIVER=hid-generic\nE: HID_ID=%04X:%08X:%08X\nE: HID_NAME=%s\n"
    "E: HID_PHYS=usb/input0\nE: HID_UNIQ=%s\nH: report_descriptor=",
    hid, bus, model.GetVendor(), model.GetProduct(), name.c_str(), serial.c_str());
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
  return { all + text,
    { hidPath + "/hidraw/hidraw" + std::to_string(number), hidPath,
      hidPath.substr(0, hidPath.rfind('/')), std::string("/sys") + usb } };
}
} // namespace

EmulatedHid::EmulatedHid(HidModel& model, int serialNumber)
  : Model(model)
  , SerialNumber(serialNumber)
{
  model.Input = [this](const std::uint8_t* report, int size)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (this->Current)
    {
      this->Current->Send(report, static_cast<std::size_t>(size));
    }
  };
  this->PlugIn();
}

void EmulatedHid::PlugIn()
{
  // The kernel reuses numbers, but umockdev does not. Begin at 9, so that the second node's number
  // has two digits.
  static std::atomic<int> next{ 9 };
  const int number = next++;
  this->SerialNumber = this->SerialNumber == 0 ? number : this->SerialNumber;
  char identity[40];
  std::snprintf(identity, sizeof(identity), ":%04x:%04x:SN%d", this->Model.GetVendor(),
    this->Model.GetProduct(), this->SerialNumber);
  for (const char* const reversed : { "", "-x", "-y", "-x-y" })
  {
    RememberConfirmed(std::string("pid") + identity + reversed);
  }
  RememberConfirmed(std::string("wooden") + identity);
  FifoNode::Answers answers;
  answers.IoctlType = 'H';
  answers.GoneResult = -EIO;
  answers.Write = [&model = this->Model](const std::uint8_t* bytes, std::size_t size)
  { return model.Output(bytes, static_cast<int>(size)); };
  answers.Ioctl = [&model = this->Model](UMockdevIoctlClient* client, unsigned long request)
  { return AnswerIoctl(model, client, request); };
  auto* const plug = new Plug("/dev/hidraw" + std::to_string(number),
    Describe(this->Model, number, this->SerialNumber), answers);
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
  plug->Unplug();
  this->Old.push_back(plug);
}

const std::string& EmulatedHid::GetNode() const
{
  return this->Current->GetNode();
}

void EmulatedHid::SetPermissions(unsigned mode)
{
  this->Current->SetPermissions(mode);
}

EmulatedHid::~EmulatedHid()
{
  this->Unplug();
  this->Model.Input = [](const std::uint8_t*, int) {};
  for (Plug* plug : this->Old)
  {
    delete plug;
  }
}

} // namespace emulated

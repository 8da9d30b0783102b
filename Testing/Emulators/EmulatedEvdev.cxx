// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmulatedEvdev.h"

#include "Testbed.h"

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <stdexcept>

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace emulated
{

struct EmulatedEvdev::Plug
{
  PadModel& Model;
  UMockdevIoctlBase* Handler = nullptr;
  std::string Node; ///< as programs see it
  std::string File; ///< its path
  std::string SysPath;
  int Fifo = -1;
  std::atomic<bool> Gone{ false };
};

namespace
{
using Plug = EmulatedEvdev::Plug;

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

void SetBits(std::uint8_t* bytes, std::size_t size, const std::set<unsigned>& bits)
{
  for (const unsigned bit : bits)
  {
    if (bit / 8 < size)
    {
      bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] | 1U << bit % 8);
    }
  }
}

std::set<unsigned> AxesOf(const PadModel& model)
{
  std::set<unsigned> codes;
  for (const auto& [code, axis] : model.GetAxes())
  {
    codes.insert(code);
  }
  return codes;
}

gboolean OnWrite(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data)
{
  auto* plug = static_cast<Plug*>(data);
  const UMockdevIoctlData* bytes = umockdev_ioctl_client_get_arg(client);
  if (plug->Gone)
  {
    return Answer(client, -ENODEV);
  }
  const std::size_t count = bytes->data_len / sizeof(input_event);
  for (std::size_t i = 0; i < count; ++i)
  {
    input_event event;
    std::memcpy(&event, bytes->data + i * sizeof(event), sizeof(event));
    plug->Model.Write(event);
  }
  return Answer(client, count == 0 ? -EINVAL : static_cast<int>(count * sizeof(input_event)));
}

gboolean OnRead(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer data)
{
  // Not handled: the FIFO is read.
  return static_cast<Plug*>(data)->Gone ? Answer(client, -ENODEV) : FALSE;
}

int Fill(PadModel& model, const void* file, unsigned long request, std::uint8_t* bytes)
{
  const unsigned number = _IOC_NR(request);
  const std::size_t size = _IOC_SIZE(request);
  if (number == _IOC_NR(EVIOCSFF))
  {
    return model.Upload(file, *reinterpret_cast<ff_effect*>(bytes));
  }
  std::memset(bytes, 0, size);
  if (number == _IOC_NR(EVIOCGEFFECTS))
  {
    const int slots = model.GetSlots();
    std::memcpy(bytes, &slots, sizeof(slots));
    return 0;
  }
  if (number == _IOC_NR(EVIOCGKEY(0)))
  {
    for (const unsigned button : PadModel::GetButtons())
    {
      SetBits(
        bytes, size, model.IsPressed(button) ? std::set<unsigned>{ button } : std::set<unsigned>{});
    }
    return static_cast<int>(size);
  }
  if (number == _IOC_NR(EVIOCGBIT(EV_ABS, 0)))
  {
    SetBits(bytes, size, AxesOf(model));
    return static_cast<int>(size);
  }
  if (number >= _IOC_NR(EVIOCGABS(0)) && number < _IOC_NR(EVIOCGABS(0)) + ABS_CNT)
  {
    const unsigned code = number - _IOC_NR(EVIOCGABS(0));
    if (model.GetAxes().count(code) == 0)
    {
      return -EINVAL;
    }
    const input_absinfo axis = model.GetAxis(code);
    std::memcpy(bytes, &axis, sizeof(axis));
    return 0;
  }
  return -EINVAL;
}

gboolean OnIoctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer user)
{
  auto* plug = static_cast<Plug*>(user);
  const unsigned long request = umockdev_ioctl_client_get_request(client);
  if (_IOC_TYPE(request) != 'E')
  {
    return FALSE;
  }
  if (plug->Gone)
  {
    return Answer(client, -ENODEV);
  }
  UMockdevIoctlData* const argument = umockdev_ioctl_client_get_arg(client);
  if (_IOC_NR(request) == _IOC_NR(EVIOCGRAB) || _IOC_NR(request) == _IOC_NR(EVIOCRMFF))
  {
    // These have a value in the place of an address.
    unsigned long value = 0;
    std::memcpy(&value, argument->data, sizeof(value));
    return Answer(client,
      _IOC_NR(request) == _IOC_NR(EVIOCGRAB) ? plug->Model.Grab(client, value != 0)
                                             : plug->Model.Erase(client, static_cast<int>(value)));
  }
  UMockdevIoctlData* data = umockdev_ioctl_data_resolve(argument, 0, _IOC_SIZE(request), nullptr);
  if (data == nullptr)
  {
    return Answer(client, -EIO); // its program has ended meanwhile
  }
  const int result = Fill(plug->Model, client, request, data->data);
  g_object_unref(data);
  return Answer(client, result);
}

/** As sysfs writes bits: words of a long, the highest first, without leading zeros. */
std::string WordsOf(const std::set<unsigned>& bits)
{
  constexpr unsigned width = sizeof(long) * CHAR_BIT;
  std::string text;
  for (unsigned word = bits.empty() ? 1 : *bits.rbegin() / width + 1; word-- > 0;)
  {
    unsigned long value = 0;
    for (const unsigned bit : bits)
    {
      value |= bit / width == word ? 1UL << bit % width : 0UL;
    }
    char digits[20];
    std::snprintf(digits, sizeof(digits), text.empty() ? "%lx" : " %lx", value);
    text += digits;
  }
  return text;
}

/** The entries of udev: an input device, and its node. */
std::string Describe(const PadModel& model, int number, std::string& sysPath)
{
  char device[80];
  std::snprintf(device, sizeof(device), "/devices/virtual/input/input%d", number + 20);
  sysPath = std::string("/sys") + device + "/event" + std::to_string(number);
  char text[1500];
  const std::set<unsigned> rumble{ FF_RUMBLE, FF_PERIODIC, FF_SQUARE, FF_TRIANGLE, FF_SINE,
    FF_GAIN };
  std::snprintf(text, sizeof(text),
    "P: %s/event%d\nN: input/event%d\nE: DEVNAME=/dev/input/event%d\nE: SUBSYSTEM=input\n"
    "E: MAJOR=13\nE: MINOR=%d\nE: ID_INPUT=1\nE: ID_INPUT_JOYSTICK=1\nL: device=../../input%d\n"
    "A: dev=13:%d\\n\n\n"
    "P: %s\nE: SUBSYSTEM=input\nE: NAME=\"%s\"\nA: name=%s\\n\nA: id/vendor=%04x\\n\n"
    "A: id/product=%04x\\n\nA: capabilities/abs=%s\\n\nA: capabilities/key=%s\\n\n"
    "A: capabilities/ff=%s\\n\n\n",
    device, number, number, number, number + 64, number + 20, number + 64, device,
    model.GetName().c_str(), model.GetName().c_str(), model.GetVendor(), model.GetProduct(),
    WordsOf(AxesOf(model)).c_str(), WordsOf(PadModel::GetButtons()).c_str(),
    (model.Rumbles() ? WordsOf(rumble) : std::string("0")).c_str());
  return text;
}
} // namespace

EmulatedEvdev::EmulatedEvdev(PadModel& model)
  : Model(model)
  , Only(new Plug{ model })
{
  model.Input = [this](const std::vector<input_event>& events)
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (this->Current)
    {
      [[maybe_unused]] const auto written =
        write(this->Current->Fifo, events.data(), events.size() * sizeof(input_event));
    }
  };
  Plug* const plug = this->Only;
  // The second one has two digits, and its number is larger.
  static std::atomic<int> next{ 9 };
  const int number = next++;
  plug->Node = "/dev/input/event" + std::to_string(number);
  char* root = umockdev_testbed_get_root_dir(Testbed());
  plug->File = root + plug->Node;
  g_free(root);
  plug->Handler = umockdev_ioctl_base_new();
  g_signal_connect(plug->Handler, "handle-ioctl", G_CALLBACK(OnIoctl), plug);
  g_signal_connect(plug->Handler, "handle-write", G_CALLBACK(OnWrite), plug);
  g_signal_connect(plug->Handler, "handle-read", G_CALLBACK(OnRead), plug);
  Require(
    umockdev_testbed_attach_ioctl(Testbed(), plug->Node.c_str(), plug->Handler, nullptr), "attach");
  const std::string text = Describe(model, number, plug->SysPath);
  Require(umockdev_testbed_add_from_string(Testbed(), text.c_str(), nullptr), "add");
  unlink(plug->File.c_str());
  Require(mkfifo(plug->File.c_str(), 0666) == 0, "mkfifo");
  // A FIFO can't be opened in packet mode, only be put into it.
  plug->Fifo = open(plug->File.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  Require(plug->Fifo >= 0 && fcntl(plug->Fifo, F_SETFL, O_NONBLOCK | O_DIRECT) == 0, "fifo");
  const std::lock_guard<std::mutex> lock(this->Guard);
  this->Current = plug;
}

void EmulatedEvdev::Unplug()
{
  {
    const std::lock_guard<std::mutex> lock(this->Guard);
    if (!this->Current)
    {
      return;
    }
    this->Current = nullptr;
  }
  Plug* const plug = this->Only;
  plug->Gone = true;
  // A poll wakes up, and the read fails.
  const std::uint8_t byte = 0;
  [[maybe_unused]] const auto written = write(plug->Fifo, &byte, 1);
  umockdev_testbed_detach_ioctl(Testbed(), plug->Node.c_str(), nullptr);
  const std::string device = plug->SysPath.substr(0, plug->SysPath.rfind('/'));
  for (const std::string& path : { plug->SysPath, device })
  {
    umockdev_testbed_uevent(Testbed(), path.c_str(), "remove");
    umockdev_testbed_remove_device(Testbed(), path.c_str());
  }
  unlink(plug->File.c_str());
}

const std::string& EmulatedEvdev::GetNode() const
{
  return this->Only->Node;
}

void EmulatedEvdev::SetPermissions(unsigned mode)
{
  chmod(this->Only->File.c_str(), mode);
  // The rest is for everyone, the socket behind the node included.
  char* root = umockdev_testbed_get_root_dir(Testbed());
  const std::string ioctls = std::string(root) + "/ioctl";
  for (const std::string& path : { std::string(root), ioctls, ioctls + "/dev",
         ioctls + "/dev/input", ioctls + this->Only->Node })
  {
    chmod(path.c_str(), 0777);
  }
  g_free(root);
}

EmulatedEvdev::~EmulatedEvdev()
{
  this->Unplug();
  this->Model.Input = [](const auto&) {};
  close(this->Only->Fifo);
  g_object_unref(this->Only->Handler);
  delete this->Only;
}

} // namespace emulated

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualUsb.h"

#include "UsbIp.h"

#include <cerrno>
#include <chrono>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

namespace emulated
{
namespace
{
const std::string Hub = "/sys/devices/platform/vhci_hcd.0/";
constexpr int FullSpeed = 2;

/** Writes a text to a file of the hub. Returns false if the kernel refuses it. */
bool WriteText(const std::string& file, const std::string& text)
{
  std::ofstream stream(Hub + file);
  stream << text << std::flush;
  return static_cast<bool>(stream);
}

bool IsFree(int port)
{
  std::ifstream stream(Hub + "status");
  for (std::string line; std::getline(stream, line);)
  {
    std::istringstream words(line);
    std::string hub;
    int number = -1;
    int status = 0;
    if (words >> hub >> number >> status && number == port)
    {
      return status == 4;
    }
  }
  return false;
}
} // namespace

class VirtualUsb::Descriptor
{
public:
  explicit Descriptor(int number)
    : Number(number)
  {
    if (number < 0)
    {
      throw std::runtime_error("No file descriptor is left.");
    }
  }
  ~Descriptor() { close(this->Number); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  const int Number;
};

VirtualUsb::VirtualUsb(UsbModel& model, int port)
  : Model(model)
  , Port(port)
  , Wake(std::make_shared<Descriptor>(eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC)))
{
  model.Ready = [wake = this->Wake] { eventfd_write(wake->Number, 1); };
}

VirtualUsb::~VirtualUsb()
{
  this->Unplug();
}

void VirtualUsb::Plug()
{
  this->Unplug();
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
  {
    throw std::runtime_error("No socket is left.");
  }
  this->Socket = std::make_unique<Descriptor>(ends[0]);
  const Descriptor kernels(ends[1]);
  this->Thread = std::thread([this] { this->Serve(); });
  std::ostringstream order;
  // The number identifies the device; the kernel returns it in each message.
  order << this->Port << ' ' << kernels.Number << ' ' << 0x10001 + this->Port << ' ' << FullSpeed;
  if (!WriteText("attach", order.str()))
  {
    this->Unplug();
    throw std::runtime_error("The kernel plugs nothing into port " + std::to_string(this->Port) +
      ". Load its module vhci_hcd, be root, and use a port that is free.");
  }
}

void VirtualUsb::Unplug()
{
  if (!this->IsPlugged())
  {
    return;
  }
  WriteText("detach", std::to_string(this->Port));
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
  while (!IsFree(this->Port) && std::chrono::steady_clock::now() < end)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  shutdown(this->Socket->Number, SHUT_RDWR);
  this->Thread.join();
  this->Socket.reset();
}

void VirtualUsb::Serve()
{
  UsbIp dialogue(this->Model, this->Socket->Number);
  pollfd sources[2] = { { this->Socket->Number, POLLIN, 0 }, { this->Wake->Number, POLLIN, 0 } };
  bool goesOn = true;
  while (goesOn)
  {
    if (poll(sources, 2, -1) < 0)
    {
      // A signal has interrupted poll(), for example because the process has changed its user, so
      // try again.
      goesOn = errno == EINTR;
      continue;
    }
    if (sources[1].revents)
    {
      eventfd_t count = 0;
      eventfd_read(this->Wake->Number, &count);
      goesOn = dialogue.AnswerWaiting();
    }
    if (sources[0].revents)
    {
      goesOn = goesOn && dialogue.Receive();
    }
  }
}
} // namespace emulated

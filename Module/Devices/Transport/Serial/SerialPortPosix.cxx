// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#if !defined(_WIN32)
#include "Devices/Transport/Serial/SerialPort.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <poll.h>
#include <sys/file.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

/**
 * Opens a port exclusively. Returns the descriptor. On failure, returns a negative number and sets
 * errno, which is EBUSY if the port is in use.
 */
int OpenAlone(const std::string& path)
{
  const int descriptor = open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor >= 0 && isatty(descriptor) == 0)
  {
    close(descriptor);
    errno = ENOTTY;
    return -1;
  }
  if (descriptor >= 0 && flock(descriptor, LOCK_EX | LOCK_NB) != 0)
  {
    close(descriptor);
    errno = EBUSY;
    return -1;
  }
  return descriptor;
}

std::string Explain(int fault)
{
  switch (fault)
  {
    case EBUSY:
      return "in use by another program or device. Close it there.";
    case EACCES:
    case EPERM:
      return "no permission. Run \"sudo usermod -a -G dialout $USER\" and log in again.";
    case ENOENT:
      return "not plugged in. Plug it in, or give the port that it has.";
    case ENOTTY:
      return "not a serial port. Give the board's port, such as /dev/ttyACM0.";
    default:
      return std::string("can't be opened: ") + std::strerror(fault) + ".";
  }
}

} // namespace

bool SerialPort::IsPath(const std::string& path)
{
  return path[0] == '/';
}

bool SerialPort::IsThere(const std::string& path)
{
  return access(path.c_str(), F_OK) == 0;
}

std::vector<SerialPortInfo> SerialPort::List(const std::string& word, const std::string& folder)
{
  namespace fs = std::filesystem;
  std::vector<SerialPortInfo> ports;
  std::error_code error;
  for (fs::directory_iterator link(folder, error), end; !error && link != end;
       link.increment(error))
  {
    const std::string name = link->path().filename().string();
    std::error_code broken;
    const fs::path node = fs::canonical(link->path(), broken);
    if (!broken && name.find(word) != std::string::npos)
    {
      ports.push_back({ node.string(), name });
    }
  }
  std::sort(ports.begin(), ports.end(),
    [](const SerialPortInfo& a, const SerialPortInfo& b) { return a.Name < b.Name; });
  return ports;
}

std::string SerialPort::NameOf(const std::string& path, const std::string& folder)
{
  std::error_code error;
  const std::string node = std::filesystem::canonical(path, error).string();
  for (const SerialPortInfo& port : List("", folder))
  {
    if (!error && port.Path == node)
    {
      return port.Name;
    }
  }
  return {};
}

std::string SerialPort::StateOf(const std::string& path)
{
  const int descriptor = OpenAlone(path);
  if (descriptor < 0)
  {
    return errno == EBUSY ? "in use" : Explain(errno);
  }
  close(descriptor);
  return "available";
}

bool SerialPort::Open(const std::string& path, std::string& error)
{
  this->Close();
  this->Descriptor = OpenAlone(path);
  if (this->Descriptor < 0)
  {
    error = path + ": " + Explain(errno);
    return false;
  }
  termios settings{};
  bool isSet = tcgetattr(this->Descriptor, &settings) == 0;
  cfmakeraw(&settings);
  settings.c_cflag |= CLOCAL | CREAD;
  settings.c_cflag &= ~static_cast<tcflag_t>(CSTOPB | CRTSCTS);
  settings.c_iflag &= ~static_cast<tcflag_t>(IXON | IXOFF | IXANY);
  isSet = isSet && cfsetispeed(&settings, B115200) == 0 && cfsetospeed(&settings, B115200) == 0 &&
    tcsetattr(this->Descriptor, TCSANOW, &settings) == 0;
  if (!isSet)
  {
    error = path + ": can't be set up as a serial port: " + std::strerror(errno) + ".";
    this->Close();
    return false;
  }
  // Also exclude programs that ignore the lock.
  ioctl(this->Descriptor, TIOCEXCL);
  tcflush(this->Descriptor, TCIOFLUSH);
  return true;
}

void SerialPort::Close() noexcept
{
  if (this->Descriptor != Closed)
  {
    ioctl(this->Descriptor, TIOCNXCL);
    close(this->Descriptor);
    this->Descriptor = Closed;
  }
}

bool SerialPort::Write(const char* bytes, std::size_t size, int time) noexcept
{
  while (size > 0)
  {
    const ssize_t written = write(this->Descriptor, bytes, size);
    if (written > 0)
    {
      bytes += written;
      size -= static_cast<std::size_t>(written);
      continue;
    }
    if (written < 0 && errno != EAGAIN && errno != EINTR)
    {
      return false;
    }
    pollfd port{ this->Descriptor, POLLOUT, 0 };
    if (poll(&port, 1, time) <= 0 || (port.revents & POLLOUT) == 0)
    {
      return false;
    }
  }
  return true;
}

int SerialPort::Read(char* bytes, std::size_t size, int time) noexcept
{
  pollfd port{ this->Descriptor, POLLIN, 0 };
  if (poll(&port, 1, time) <= 0)
  {
    return 0;
  }
  const ssize_t got = read(this->Descriptor, bytes, size);
  if (got > 0)
  {
    return static_cast<int>(got);
  }
  // The port was readable but yields no data: the other end has hung up.
  return got < 0 && (errno == EAGAIN || errno == EINTR) ? 0 : -1;
}

void SerialPort::Drain() noexcept
{
  tcflush(this->Descriptor, TCIFLUSH);
}

} // namespace VolumeHaptics
#endif

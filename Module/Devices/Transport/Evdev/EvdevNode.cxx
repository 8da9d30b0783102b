// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Evdev/EvdevNode.h"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

constexpr const char* InputFolder = "/sys/class/input";
constexpr unsigned WordBits = sizeof(long) * CHAR_BIT;

/** Returns the value of a hexadecimal digit, or a negative number for any other character. */
int DigitOf(char c)
{
  return c >= '0' && c <= '9' ? c - '0' : c >= 'a' && c <= 'f' ? c - 'a' + 10 : -1;
}

/** Returns the beginning of a sysfs file; empty if the file is missing. */
std::string ReadFile(const std::string& path)
{
  char text[4096] = {};
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0)
  {
    return {};
  }
  const ssize_t size = read(file, text, sizeof(text));
  close(file);
  return std::string(text, static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
}

/** Returns the first line of a sysfs file; empty if the file is missing. */
std::string ReadAttribute(const std::string& path)
{
  const std::string text = ReadFile(path);
  return text.substr(0, text.find('\n'));
}

std::uint16_t ReadHexAttribute(const std::string& path)
{
  return static_cast<std::uint16_t>(std::strtoul(ReadAttribute(path).c_str(), nullptr, 16));
}

std::vector<int> ListNumbers()
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

bool HasEvdevBit(const std::string& words, unsigned bit)
{
  // Read from the end, because the lowest word comes last.
  unsigned word = 0;
  unsigned digit = 0;
  bool isSet = false;
  const std::size_t end = words.find_last_not_of('\n') + 1;
  for (std::size_t i = end; i-- > 0;)
  {
    if (words[i] == ' ')
    {
      ++word;
      digit = 0;
      continue;
    }
    const int value = DigitOf(words[i]);
    if (value < 0 || digit >= WordBits / 4)
    {
      return false;
    }
    const unsigned first = word * WordBits + 4 * digit++;
    isSet = isSet || (bit >= first && bit < first + 4 && (value >> (bit - first) & 1) != 0);
  }
  return isSet;
}

std::string EvdevNode::GetFolder() const
{
  return InputFolder + this->Path.substr(this->Path.rfind('/')) + "/device/";
}

bool EvdevNode::Has(const char* kind, unsigned code) const
{
  return HasEvdevBit(ReadAttribute(this->GetFolder() + "capabilities/" + kind), code);
}

bool EvdevNode::IsPid() const
{
  // Search for the item "usage page" with the PID page.
  return ReadFile(this->GetFolder() + "device/report_descriptor").find("\x05\x0f") !=
    std::string::npos;
}

int EvdevNode::Open() const noexcept
{
  const int node = open(this->Path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (node >= 0 && ioctl(node, EVIOCGRAB, 1) != 0)
  {
    const int fault = errno;
    close(node);
    errno = fault;
    return -1;
  }
  return node;
}

void EvdevNode::Close(int node) noexcept
{
  ioctl(node, EVIOCGRAB, 0);
  close(node);
}

std::string EvdevNode::Explain(int fault)
{
  switch (fault)
  {
    case EBUSY:
      return "in use: another program, such as Steam, has grabbed it. Close it there.";
    case EACCES:
    case EPERM:
      return "no permission. Log in at the computer itself, to whose user the system gives "
             "game controllers; "
             "or run \"sudo usermod -a -G input $USER\" and log in again.";
    case ENOENT:
    case ENODEV:
    case ENXIO:
      return "no longer connected. Plug it in, or switch it on.";
    default:
      return std::string("can't be opened: ") + std::strerror(fault) + ".";
  }
}

bool EvdevNode::SendForce(int node, int code, int value) noexcept
{
  input_event event{};
  event.type = EV_FF;
  event.code = static_cast<__u16>(code);
  event.value = value;
  return write(node, &event, sizeof(event)) == static_cast<ssize_t>(sizeof(event));
}

int EvdevNode::Receive(int node, int wake, int pause, EvdevEvents& events) noexcept
{
  pollfd watched[] = { { node, POLLIN, 0 }, { wake, POLLIN, 0 } };
  poll(watched, wake < 0 ? 1 : 2, pause);
  const ssize_t size = read(node, events.data(), sizeof(events));
  if (size < 0)
  {
    return errno == EAGAIN || errno == EINTR ? 0 : -1;
  }
  return static_cast<int>(static_cast<std::size_t>(size) / sizeof(input_event));
}

std::string EvdevNode::GetState() const
{
  // Grab the node for a moment: only this shows whether another program has grabbed it.
  const int node = this->Open();
  if (node < 0)
  {
    return Explain(errno);
  }
  Close(node);
  return "available";
}

std::vector<EvdevNode> ListEvdevNodes()
{
  std::vector<EvdevNode> nodes;
  for (const int number : ListNumbers())
  {
    const std::string event = "event" + std::to_string(number);
    const std::string device = std::string(InputFolder) + "/" + event + "/device";
    EvdevNode node;
    node.Path = "/dev/input/" + event;
    node.Name = ReadAttribute(device + "/name");
    node.Vendor = ReadHexAttribute(device + "/id/vendor");
    node.Product = ReadHexAttribute(device + "/id/product");
    node.Serial = ReadAttribute(device + "/uniq");
    nodes.push_back(node);
  }
  return nodes;
}

} // namespace VolumeHaptics

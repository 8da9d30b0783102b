// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "EmulatedEvdev.h"

#include "FifoNode.h"

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>

#include <sys/ioctl.h>

namespace emulated
{
namespace
{

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

int WriteEvents(PadModel& model, const std::uint8_t* bytes, std::size_t size)
{
  const std::size_t count = size / sizeof(input_event);
  for (std::size_t i = 0; i < count; ++i)
  {
    input_event event;
    std::memcpy(&event, bytes + i * sizeof(event), sizeof(event));
    model.Write(event);
  }
  return count == 0 ? -EINVAL : static_cast<int>(count * sizeof(input_event));
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
    for (const unsigned button : model.GetButtons())
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

int AnswerIoctl(PadModel& model, UMockdevIoctlClient* client, unsigned long request)
{
  if (_IOC_NR(request) == _IOC_NR(EVIOCGRAB) || _IOC_NR(request) == _IOC_NR(EVIOCRMFF))
  {
    // The argument of these ioctls is a value instead of an address.
    unsigned long value = 0;
    std::memcpy(&value, umockdev_ioctl_client_get_arg(client)->data, sizeof(value));
    return _IOC_NR(request) == _IOC_NR(EVIOCGRAB) ? model.Grab(client, value != 0)
                                                  : model.Erase(client, static_cast<int>(value));
  }
  return FifoNode::WithTarget(client, _IOC_SIZE(request),
    [&](std::uint8_t* bytes) { return Fill(model, client, request, bytes); });
}

/**
 * Formats bits as in sysfs: words of the size of a long, the highest word first, without leading
 * zeros.
 */
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

/** Returns udev's entries for an input device and its node. */
FifoNode::Device Describe(const PadModel& model, int number)
{
  char device[80];
  std::snprintf(device, sizeof(device), "/devices/virtual/input/input%d", number + 20);
  const std::string sysPath = std::string("/sys") + device;
  char text[1500];
  const std::set<unsigned> force = model.Rumbles()
    ? std::set<unsigned>{ FF_RUMBLE, FF_PERIODIC, FF_SQUARE, FF_TRIANGLE, FF_SINE, FF_GAIN }
    : std::set<unsigned>{ FF_CONSTANT, FF_AUTOCENTER, FF_GAIN };
  std::snprintf(text, sizeof(text),
    "P: %s/event%d\nN: input/event%d\nE: DEVNAME=/dev/input/event%d\nE: SUBSYSTEM=input\n"
    "E: MAJOR=13\nE: MINOR=%d\nE: ID_INPUT=1\nE: ID_INPUT_JOYSTICK=1\nL: device=../../input%d\n"
    "A: dev=13:%d\\n\n\n"
    "P: %s\nE: SUBSYSTEM=input\nE: NAME=\"%s\"\nA: name=%s\\n\nA: id/vendor=%04x\\n\n"
    "A: id/product=%04x\\n\nA: capabilities/abs=%s\\n\nA: capabilities/key=%s\\n\n"
    "A: uniq=%s\\n\nA: capabilities/ff=%s\\n\n\n",
    device, number, number, number, number + 64, number + 20, number + 64, device,
    model.GetName().c_str(), model.GetName().c_str(), model.GetVendor(), model.GetProduct(),
    WordsOf(AxesOf(model)).c_str(), WordsOf(model.GetButtons()).c_str(), model.Serial.c_str(),
    (model.HasForce() ? WordsOf(force) : std::string("0")).c_str());
  return { text, { sysPath + "/event" + std::to_string(number), sysPath } };
}

std::unique_ptr<FifoNode> MakeNode(PadModel& model)
{
  // Begin at 9, so that the second node's number has two digits.
  static std::atomic<int> next{ 9 };
  const int number = next++;
  FifoNode::Answers answers;
  answers.IoctlType = 'E';
  answers.GoneResult = -ENODEV;
  answers.Write = [&model](const std::uint8_t* bytes, std::size_t size)
  { return WriteEvents(model, bytes, size); };
  answers.Ioctl = [&model](UMockdevIoctlClient* client, unsigned long request)
  { return AnswerIoctl(model, client, request); };
  return std::make_unique<FifoNode>(
    "/dev/input/event" + std::to_string(number), Describe(model, number), answers);
}
} // namespace

EmulatedEvdev::EmulatedEvdev(PadModel& model)
  : Model(model)
  , Node(MakeNode(model))
{
  model.Input = [this](const std::vector<input_event>& events)
  { this->Node->Send(events.data(), events.size() * sizeof(input_event)); };
}

void EmulatedEvdev::Unplug()
{
  this->Node->Unplug();
}

const std::string& EmulatedEvdev::GetNode() const
{
  return this->Node->GetNode();
}

void EmulatedEvdev::SetPermissions(unsigned mode)
{
  this->Node->SetPermissions(mode);
}

EmulatedEvdev::~EmulatedEvdev()
{
  this->Unplug();
  this->Model.Input = [](const auto&) {};
}

} // namespace emulated

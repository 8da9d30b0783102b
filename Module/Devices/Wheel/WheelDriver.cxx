// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Wheel/WheelDriver.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Common/DeviceTexts.h"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <linux/input.h>
#include <sys/ioctl.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

constexpr int WheelRoundPause = 1; // ms, while servo and wheel send nothing
constexpr int WheelLostPause = 10; // ms
constexpr int FullLevel = 32767;
constexpr int ToTheLeft = 0x4000;
constexpr unsigned MostButtons = 32;

} // namespace

std::vector<EvdevNode> ListWheels()
{
  std::vector<EvdevNode> wheels = ListEvdevNodes();
  wheels.erase(std::remove_if(wheels.begin(), wheels.end(),
                 [](const EvdevNode& node) {
                   return !node.Has("ff", FF_CONSTANT) || !node.Has("abs", ABS_X) || node.IsPid();
                 }),
    wheels.end());
  return wheels;
}

WheelDriver::WheelDriver(int number, double newtons)
  : Number(number)
  , Newtons(newtons)
{
}

std::string WheelDriver::MakeLabel(const EvdevNode& node)
{
  return (node.Name.empty() ? "A wheel" : node.Name) + " (" + node.Path + ")";
}

std::string WheelDriver::MakeIdentity(const EvdevNode& node)
{
  char numbers[24];
  std::snprintf(numbers, sizeof(numbers), "wheel:%04x:%04x", node.Vendor, node.Product);
  std::string serial = node.Serial;
  // Replace spaces and '=', which separate words in the user's device file.
  std::replace_if(
    serial.begin(), serial.end(), [](char c) { return c <= ' ' || c == '=' || c > '~'; }, '_');
  return numbers + (serial.empty() ? std::string() : ":" + serial);
}

std::string WheelDriver::GetIdentity() const
{
  return MakeIdentity(this->Info) + (this->Newtons < 0.0 ? "-x" : "");
}

DeviceLimits WheelDriver::GetLimits() const
{
  DeviceLimits limits;
  limits.MaximumForce = std::abs(this->Newtons);
  limits.MaximumSpeed = FastestWheel;
  limits.WorkspaceRadius = Travel;
  limits.ForceAxes = 1;
  limits.LeastMotion = 2.0 * Travel / (this->Most - this->Least);
  return limits;
}

bool WheelDriver::Connect(std::string& error)
{
  const std::vector<EvdevNode> wheels = ListWheels();
  if (static_cast<std::size_t>(this->Number) >= wheels.size())
  {
    error = wheels.empty()
      ? "No wheel is plugged in whose driver plays constant forces (FF_CONSTANT). Plug it in, and "
        "load its driver; a wheel that speaks HID PID is opened as \"pid\"."
      : "There is no wheel with this number. Count from 0, as EnumerateDevices() does.";
    return false;
  }
  return this->Take(wheels[static_cast<std::size_t>(this->Number)], error);
}

bool WheelDriver::Reconnect(
  const std::string& identity, const std::function<bool()>& /*mustStop*/, std::string& error)
{
  const std::string reversed = this->Newtons < 0.0 ? "-x" : "";
  std::vector<EvdevNode> same;
  for (const EvdevNode& node : ListWheels())
  {
    if (MakeIdentity(node) + reversed == identity)
    {
      same.push_back(node);
    }
  }
  if (same.size() > 1)
  {
    error = this->Label + " was unplugged, and " + std::to_string(same.size()) +
      " devices have its serial number now. Open() and Start() the one that you mean.";
    return false;
  }
  const EvdevNode before = this->Info;
  const std::string label = this->Label;
  const bool isTaken = !same.empty() && this->Take(same.front(), error);
  if (!isTaken)
  {
    this->Info = before;
    this->Label = label;
  }
  return isTaken;
}

bool WheelDriver::Take(const EvdevNode& node, std::string& error)
{
  this->Label = MakeLabel(node);
  this->Node = node.Open();
  if (this->Node < 0)
  {
    error = this->Label + ": " + EvdevNode::Explain(errno);
    return false;
  }
  this->Info = node;
  this->HasTwin = false;
  this->FindUnpluggedText();
  this->Effect = -1;
  // The last program may have changed the gain, and the driver's centring spring would push without
  // a request. Drivers that lack these ignore the events.
  if (!this->ReadAll() || !EvdevNode::SendForce(this->Node, FF_GAIN, 0xFFFF) ||
    !EvdevNode::SendForce(this->Node, FF_AUTOCENTER, 0) || !this->Play(0))
  {
    error = this->Label +
      " does not accept a constant force. End other programs that use it, plug it in again, and "
      "open "
      "it again.";
    this->Disconnect();
    return false;
  }
  return true;
}

const char* WheelDriver::FindUnpluggedText()
{
  for (const EvdevNode& node : ListWheels())
  {
    this->HasTwin = this->HasTwin ||
      (node.Path != this->Info.Path && MakeIdentity(node) == MakeIdentity(this->Info));
  }
  return this->KeepsIdentity() ? UnpluggedText : OpenAgainText;
}

void WheelDriver::Disconnect() noexcept
{
  if (this->Node >= 0)
  {
    this->Rest();
    EvdevNode::Close(this->Node);
    this->Node = -1;
  }
}

bool WheelDriver::ReadAll() noexcept
{
  input_absinfo axis{};
  if (ioctl(this->Node, EVIOCGABS(ABS_X), &axis) < 0 || axis.maximum <= axis.minimum)
  {
    return false;
  }
  this->Value = axis.value;
  this->Least = axis.minimum;
  this->Most = axis.maximum;
  unsigned char keys[(KEY_CNT + 7) / 8] = {};
  this->Buttons = 0;
  if (ioctl(this->Node, EVIOCGKEY(sizeof(keys)), keys) >= 0)
  {
    for (unsigned i = 0; i < MostButtons; ++i)
    {
      const unsigned code = BTN_JOYSTICK + i;
      this->Buttons |= (keys[code / 8] >> (code % 8) & 1U) << i;
    }
  }
  this->IsDropping = false;
  this->HasNews = true;
  return true;
}

void WheelDriver::Serve(HardwareExchange& exchange)
{
  /** Ends the force when leaving the scope, even by an exception. */
  struct AtEnd
  {
    WheelDriver* Driver;
    ~AtEnd() { this->Driver->Rest(); }
  };
  const AtEnd atEnd{ this };
  this->Gone = false;
  this->Begin(exchange);
  while (!exchange.MustStop() && !(this->Gone && this->KeepsIdentity()))
  {
    if (exchange.HasSlept())
    {
      this->Lost = true;
      this->Rest();
    }
    if (exchange.DrainHomeRequest())
    {
      this->Begin(exchange);
    }
    if (!this->Lost)
    {
      this->Round(exchange);
      continue;
    }
    // Quench() and Close() wait until this thread has requested the force and received zero.
    exchange.GetForce();
    ServoClock::SleepUntil(ServoClock::Now() + WheelLostPause * ServoClock::Millisecond);
    if (!this->Gone && !this->Listen(exchange))
    {
      this->Gone = true;
      this->Report(exchange, DeviceStage::Lost, this->FindUnpluggedText());
    }
  }
}

void WheelDriver::Begin(HardwareExchange& exchange)
{
  this->Lost = this->IsReady = false;
  if (this->Gone || !this->Play(0) || !this->ReadAll())
  {
    this->Gone = true;
    this->Lose(exchange, this->FindUnpluggedText());
    return;
  }
  this->Report(exchange, DeviceStage::Homing, "");
}

void WheelDriver::Round(HardwareExchange& exchange)
{
  if (!this->Listen(exchange))
  {
    this->Gone = true;
    this->Lose(exchange, this->FindUnpluggedText());
    return;
  }
  exchange.ClearWake();
  const double share = exchange.GetForce().X / this->Newtons;
  const int level = std::isfinite(share)
    ? static_cast<int>(std::lround(-FullLevel * std::clamp(share, -1.0, 1.0)))
    : 0;
  if (!this->Show(level))
  {
    this->Gone = errno == ENODEV;
    this->Lose(exchange,
      this->Gone ? this->FindUnpluggedText()
                 : "does not accept what is sent to it. Check its cable and its power, then "
                   "Home() and Arm() again.");
    return;
  }
  if (this->Level == level)
  {
    exchange.RecordTaken();
  }
  if (!this->HasNews)
  {
    // The driver has just accepted a force, so the wheel is connected, and would have reported any
    // motion.
    exchange.Confirm();
    return;
  }
  this->HasNews = false;
  const double range = static_cast<double>(this->Most) - this->Least;
  DeviceSample sample;
  sample.Tip.X = Travel * (2.0 * (static_cast<double>(this->Value) - this->Least) / range - 1.0);
  sample.Buttons = this->Buttons;
  exchange.Report(sample);
  if (!this->IsReady)
  {
    this->IsReady = true;
    this->Report(exchange, DeviceStage::Ready, "");
  }
}

bool WheelDriver::Listen(const HardwareExchange& exchange) noexcept
{
  EvdevEvents events;
  const int count =
    EvdevNode::Receive(this->Node, exchange.GetWakeDescriptor(), WheelRoundPause, events);
  for (int i = 0; i < count; ++i)
  {
    const input_event& event = events[i];
    const unsigned button = event.code - static_cast<unsigned>(BTN_JOYSTICK);
    if (event.type == EV_SYN && event.code == SYN_DROPPED)
    {
      this->IsDropping = true;
    }
    else if (this->IsDropping)
    {
      if (event.type == EV_SYN && event.code == SYN_REPORT && !this->ReadAll())
      {
        return false;
      }
    }
    else if (event.type == EV_ABS && event.code == ABS_X)
    {
      this->Value = event.value;
      this->HasNews = true;
    }
    else if (event.type == EV_KEY && button < MostButtons)
    {
      this->Buttons = (this->Buttons & ~(1U << button)) | (event.value != 0 ? 1U << button : 0U);
      this->HasNews = true;
    }
  }
  return count >= 0;
}

bool WheelDriver::Show(int level) noexcept
{
  const double age = ServoClock::SecondsSince(this->SentAt);
  const bool isDue = level != this->Level ? level == 0 || age >= ShortestTime : age >= RenewTime;
  return !isDue || this->Play(level);
}

bool WheelDriver::Play(int level) noexcept
{
  ff_effect effect{};
  effect.type = FF_CONSTANT;
  effect.id = static_cast<__s16>(this->Effect);
  effect.direction = ToTheLeft;
  effect.replay.length = ReplayLength;
  effect.u.constant.level = static_cast<__s16>(level);
  int result = ioctl(this->Node, EVIOCSFF, &effect);
  if (result < 0 && this->Effect >= 0 && (errno == EINVAL || errno == EACCES))
  {
    // Create the effect again: before Linux 5.7, a child process that closes its copy of the node
    // erases the effects.
    effect.id = -1;
    result = ioctl(this->Node, EVIOCSFF, &effect);
  }
  this->Effect = result < 0 ? -1 : effect.id;
  this->SentAt = ServoClock::Now();
  this->Level = level;
  return result >= 0 && EvdevNode::SendForce(this->Node, this->Effect, 1);
}

void WheelDriver::Rest() noexcept
{
  if (this->Node >= 0 && this->Effect >= 0)
  {
    // Restart the effect, because only a start marks the new level as playing in the kernel.
    this->Play(0);
    EvdevNode::SendForce(this->Node, this->Effect, 0);
    ioctl(this->Node, EVIOCRMFF, this->Effect);
    this->Effect = -1;
  }
}

void WheelDriver::Lose(HardwareExchange& exchange, const char* text) noexcept
{
  // Notify the servo before sending anything, because sending may take long.
  this->Lost = true;
  this->Report(exchange, DeviceStage::Lost, text);
  this->Rest();
}

void WheelDriver::Report(
  HardwareExchange& exchange, DeviceStage stage, const char* text) const noexcept
{
  exchange.SetCondition(stage, this->Label.c_str(), text);
}

} // namespace VolumeHaptics

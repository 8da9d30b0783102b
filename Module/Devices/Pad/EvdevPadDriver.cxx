// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Pad/EvdevPadDriver.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Pad/EvdevReader.h"

#include <algorithm>
#include <cerrno>
#include <sys/ioctl.h>
#include <unistd.h>

namespace VolumeHaptics
{
namespace
{

constexpr int PadRoundPause = 2; // ms, while servo and pad send nothing
constexpr int PadLostPause = 10; // ms
constexpr const char* PadUnplugged =
  "is gone: unplugged, switched off or out of reach. Bring it back: it is opened by itself, and "
  "waits for Arm().";

bool IsBitSet(const unsigned char* bits, unsigned bit) noexcept
{
  return (bits[bit / 8] >> (bit % 8) & 1) != 0;
}

} // namespace

const char* const NoRumbleText =
  "can't vibrate: its driver offers no rumble (FF_RUMBLE). Use a pad with motors; if this one has "
  "some, look for a driver or a newer kernel that knows them.";

std::vector<EvdevPad> ListEvdevPads()
{
  std::vector<EvdevPad> pads;
  for (const EvdevNode& node : ListEvdevNodes())
  {
    if (node.Has("key", BTN_GAMEPAD) && node.Has("abs", ABS_X) && node.Has("abs", ABS_Y))
    {
      pads.push_back({ node, node.Has("ff", FF_RUMBLE) });
    }
  }
  return pads;
}

std::string EvdevPad::GetLabel() const
{
  return (this->Name.empty() ? "A gamepad" : this->Name) + " (" + this->Path + ")";
}

std::string EvdevPad::GetState() const
{
  return this->Vibrates ? this->EvdevNode::GetState() : NoRumbleText;
}

EvdevPadDriver::EvdevPadDriver(int number)
  : Number(number)
{
}

bool EvdevPadDriver::Connect(std::string& error)
{
  const std::vector<EvdevPad> pads = ListEvdevPads();
  if (pads.empty())
  {
    error = "No gamepad is plugged in. Plug one in, or pair it.";
    return false;
  }
  if (this->Number >= static_cast<int>(pads.size()))
  {
    error = "There is no gamepad with this number. Count from 0, as EnumerateDevices() does.";
    return false;
  }
  if (this->Number >= 0)
  {
    return this->Own(pads[static_cast<std::size_t>(this->Number)], error);
  }
  std::string first;
  for (const EvdevPad& pad : pads)
  {
    if (this->Own(pad, error))
    {
      return true;
    }
    first = first.empty() ? error : first;
  }
  error = first;
  return false;
}

bool EvdevPadDriver::Reconnect(const std::string& /*identity*/,
  const std::function<bool()>& /*mustStop*/, std::string& /*error*/)
{
  // Skip pads that are in use, because the previous pad is not in use.
  const EvdevPad before = this->Pad;
  const std::vector<EvdevPad> pads = ListEvdevPads();
  std::string ignored;
  return std::any_of(pads.begin(), pads.end(),
    [&](const EvdevPad& pad)
    {
      return pad.Vendor == before.Vendor && pad.Product == before.Product &&
        pad.Name == before.Name && this->Own(pad, ignored);
    });
}

bool EvdevPadDriver::Own(const EvdevPad& pad, std::string& error)
{
  if (!pad.Vibrates)
  {
    error = pad.GetLabel() + " " + NoRumbleText;
    return false;
  }
  this->Node = pad.Open();
  if (this->Node < 0)
  {
    error = pad.GetLabel() + ": " + EvdevPad::Explain(errno);
    return false;
  }
  if (!this->Rumble.Begin(this->Node))
  {
    error = pad.GetLabel() + " " + NoRumbleText;
    this->Disconnect();
    return false;
  }
  this->Pad = pad;
  this->Label = pad.GetLabel() + ", vibration, not force";
  this->Reader = {};
  this->ReadAll();
  return true;
}

void EvdevPadDriver::Disconnect() noexcept
{
  if (this->Node >= 0)
  {
    EvdevNode::Close(this->Node);
    this->Node = -1;
  }
}

void EvdevPadDriver::ReadAll() noexcept
{
  unsigned char axes[(ABS_CNT + 7) / 8] = {};
  if (ioctl(this->Node, EVIOCGBIT(EV_ABS, sizeof(axes)), axes) >= 0)
  {
    for (unsigned code = 0; code < ABS_CNT; ++code)
    {
      input_absinfo axis{};
      if (IsBitSet(axes, code) && ioctl(this->Node, EVIOCGABS(code), &axis) >= 0)
      {
        this->Reader.SetAxis(code, axis);
      }
    }
  }
  unsigned char buttons[(KEY_CNT + 7) / 8] = {};
  if (ioctl(this->Node, EVIOCGKEY(sizeof(buttons)), buttons) >= 0)
  {
    for (unsigned code = BTN_GAMEPAD; code <= BTN_THUMBR; ++code)
    {
      this->Reader.SetButton(code, IsBitSet(buttons, code));
    }
  }
}

void EvdevPadDriver::Serve(HardwareExchange& exchange)
{
  /** Stops the motors when leaving the scope, even by an exception. */
  struct AtEnd
  {
    EvdevPadDriver* Driver;
    ~AtEnd() { this->Driver->Rumble.End(); }
  };
  const AtEnd atEnd{ this };
  this->Gone = false;
  this->Begin(exchange);
  while (!exchange.MustStop() && !this->Gone)
  {
    if (exchange.HasSlept())
    {
      this->Lost = true;
      this->Rumble.Silence();
    }
    if (exchange.DrainHomeRequest())
    {
      this->Begin(exchange);
    }
    if (this->Lost)
    {
      // Quench() and Close() wait until this thread has requested the force and received zero.
      exchange.GetForce();
      exchange.WaitForWake(PadLostPause);
      if (!this->Gone && !this->Listen(exchange))
      {
        this->Gone = true;
        this->Report(exchange, DeviceStage::Lost, PadUnplugged);
      }
      continue;
    }
    this->Round(exchange);
  }
}

void EvdevPadDriver::Begin(HardwareExchange& exchange)
{
  this->Lost = false;
  this->Levels.Silence();
  this->Rumble.Silence();
  this->ReadAll();
  this->LastRound = ServoClock::Now();
  this->Tip.Begin(exchange);
  this->Report(exchange, DeviceStage::Ready, "");
}

void EvdevPadDriver::Round(HardwareExchange& exchange)
{
  if (!this->Listen(exchange))
  {
    this->Gone = true;
    this->Lose(exchange, PadUnplugged);
    return;
  }
  const PadState state = this->Reader.Get();
  const PadMotion motion = Steer(state);
  this->Tip.Move(exchange, motion.Push, motion.Turn, state.Buttons);
  exchange.ClearWake();
  const Vector3 force = exchange.GetForce();
  const double elapsed = ServoClock::SecondsSince(this->LastRound);
  this->LastRound = ServoClock::Now();
  if (!this->Rumble.Show(this->Levels.Advance(force, elapsed)))
  {
    this->Gone = errno == ENODEV;
    this->Lose(exchange,
      this->Gone ? PadUnplugged
                 : "does not accept what is sent to it. Check its cable or battery, then Home() "
                   "and Arm() again.");
    return;
  }
  exchange.RecordTaken();
}

bool EvdevPadDriver::Listen(const HardwareExchange& exchange) noexcept
{
  EvdevEvents events;
  const int count =
    EvdevNode::Receive(this->Node, exchange.GetWakeDescriptor(), PadRoundPause, events);
  for (int i = 0; i < count; ++i)
  {
    if (this->Reader.Receive(events[i]) == EvdevReader::News::MustRead)
    {
      this->ReadAll();
    }
  }
  return count >= 0;
}

void EvdevPadDriver::Lose(HardwareExchange& exchange, const char* text) noexcept
{
  // Notify the servo before sending anything, because sending may take long.
  this->Lost = true;
  this->Report(exchange, DeviceStage::Lost, text);
  this->Rumble.Silence();
}

void EvdevPadDriver::Report(
  HardwareExchange& exchange, DeviceStage stage, const char* text) const noexcept
{
  exchange.SetCondition(stage, this->Label.c_str(), text);
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vibration/HapbeatService.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Pad/Vibration.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace VolumeHaptics
{
namespace
{

constexpr double HapbeatPi = 3.14159265358979323846;
constexpr double HapbeatAskTime = 1.0; // s
constexpr auto HapbeatAskPause = std::chrono::milliseconds(2);
// number of times that each packet is sent, as in Hapbeat's SDK, because the device acknowledges
// none
constexpr int HapbeatRepeats = 3;
constexpr double FullSample = 0.8 * 32767; // as in Hapbeat's SDK

} // namespace

HapbeatService::HapbeatService(std::string address, std::uint16_t port)
  : Address(std::move(address))
  , Port(port)
{
}

std::string HapbeatService::GetName() const
{
  return "Hapbeat " + (this->Device.empty() ? "" : this->Device + " ") + "at " + this->Address;
}

std::string HapbeatService::GetText() const
{
  return "no longer answers. Check its battery and the network: it is then opened by "
         "itself, and waits for Arm().";
}

bool HapbeatService::Connect(std::string& error)
{
  std::string reason;
  if (!this->Socket.Open(this->Address, this->Port, reason))
  {
    error = reason + ".";
    return false;
  }
  const std::int64_t asked = ServoClock::Now();
  this->HeardAt = 0;
  this->PingedAt = 0;
  bool isThere = true;
  while (this->HeardAt == 0 && isThere && ServoClock::SecondsSince(asked) < HapbeatAskTime)
  {
    isThere = this->Ping() && this->Listen();
    if (this->HeardAt == 0)
    {
      std::this_thread::sleep_for(HapbeatAskPause);
    }
  }
  if (this->HeardAt == 0)
  {
    this->Socket.Close();
    error = "No Hapbeat answers at " + this->Address + ", port " + std::to_string(this->Port) +
      ". Switch it on, connect it to your network by Hapbeat Studio, and give the address that it "
      "shows there, as vibration:hapbeat:192.168.1.50.";
    return false;
  }
  this->IsStreaming = false;
  this->End(); // ends a stream of an earlier session
  return true;
}

bool HapbeatService::SendOften(const HapbeatPacket& packet)
{
  bool isThere = true;
  for (int i = 0; i < HapbeatRepeats; ++i)
  {
    isThere = this->Socket.Send(packet) && isThere;
  }
  return isThere;
}

bool HapbeatService::Ping()
{
  if (this->PingedAt != 0 && ServoClock::SecondsSince(this->PingedAt) < PingPeriod)
  {
    return true;
  }
  this->PingedAt = ServoClock::Now();
  return this->Socket.Send(WriteHapbeatPing(++this->Number, this->PingedAt / 1000));
}

bool HapbeatService::Listen()
{
  constexpr int most = 100; // limit of packets per call
  HapbeatPacket packet;
  bool isThere = this->Socket.Receive(packet);
  for (int i = 0; isThere && !packet.empty() && i < most; ++i)
  {
    if (ReadHapbeatPong(packet, this->Device))
    {
      this->HeardAt = ServoClock::Now();
    }
    isThere = this->Socket.Receive(packet);
  }
  return isThere;
}

bool HapbeatService::SendChunk(double amplitude)
{
  std::vector<std::int16_t> samples(Chunk);
  const std::int64_t first = this->Samples;
  for (int i = 0; i < Chunk; ++i)
  {
    const double share = static_cast<double>(i + 1) / Chunk;
    const double now = this->Amplitude + share * (amplitude - this->Amplitude);
    const double phase = 2.0 * HapbeatPi * Frequency * static_cast<double>(first + i) / HapbeatRate;
    samples[static_cast<std::size_t>(i)] =
      static_cast<std::int16_t>(std::lround(FullSample * now * std::sin(phase)));
  }
  this->Amplitude = amplitude;
  this->Samples += Chunk;
  return this->Socket.Send(WriteHapbeatSamples(++this->Number,
    static_cast<std::uint32_t>(first * static_cast<std::int64_t>(sizeof(std::int16_t))), samples));
}

bool HapbeatService::Stream(double amplitude)
{
  if (!this->IsStreaming)
  {
    this->IsStreaming = true;
    this->Begun = ServoClock::Now();
    this->Samples = 0;
    this->Amplitude = 0.0;
    if (!this->SendOften(WriteHapbeatBegin(++this->Number)))
    {
      return false;
    }
  }
  const auto played =
    static_cast<std::int64_t>(HapbeatRate * ServoClock::SecondsSince(this->Begun));
  // If this thread was delayed, the device has played all samples, so continue with the current
  // one.
  this->Samples = std::max(this->Samples, played - played % Chunk);
  bool isThere = true;
  while (isThere && this->Samples - played + Chunk <= Lead)
  {
    isThere = this->SendChunk(amplitude);
  }
  return isThere;
}

bool HapbeatService::End()
{
  this->IsStreaming = false;
  return this->SendOften(WriteHapbeatEnd(++this->Number));
}

VibrationService::State HapbeatService::Show(double amplitude)
{
  bool isThere = this->Socket.IsOpen() && this->Ping() && this->Listen() &&
    ServoClock::SecondsSince(this->HeardAt) < LongestSilence;
  const bool isQuiet = !(amplitude >= Vibration::Least);
  this->QuietSince = !isQuiet ? 0 : this->QuietSince == 0 ? ServoClock::Now() : this->QuietSince;
  if (isThere && !isQuiet)
  {
    isThere = this->Stream(std::min(1.0, amplitude));
  }
  else if (isThere && this->IsStreaming)
  {
    isThere =
      ServoClock::SecondsSince(this->QuietSince) < QuietTime ? this->Stream(0.0) : this->End();
  }
  return isThere ? State::Ready : State::Gone;
}

void HapbeatService::Disconnect() noexcept
{
  try
  {
    if (this->Socket.IsOpen())
    {
      this->End();
    }
  }
  catch (const std::exception&)
  {
    // There is no memory for a packet; the device becomes silent by itself.
  }
  this->Socket.Close();
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vibration/WeartService.h"

#include "Core/Platform/Files.h"
#include "Core/Realtime/ServoClock.h"
#include "Devices/Pad/Vibration.h"
#include "Devices/Transport/Local/LocalListener.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace VolumeHaptics
{
namespace
{

constexpr double WeartAskTime = 1.0; // s
constexpr auto WeartAskPause = std::chrono::milliseconds(2);
constexpr int FullVolume = 100;
constexpr const char* WeartCure =
  "Start WEART's middleware or the WeArt app, and connect a TouchDIVER to it. If it listens to "
  "another port than 13031, name it in VOLUMEHAPTICS_WEART.";

} // namespace

bool AskWeart(LineSocket& middleware, double seconds, WeartStatus& status, std::string& error)
{
  const std::string named = Files::GetVariable("VOLUMEHAPTICS_WEART");
  std::uint16_t port = 13031;
  if (!named.empty() && !ReadPort(named, port))
  {
    error = "The environment variable VOLUMEHAPTICS_WEART is \"" + named +
      "\". Give the port of WEART's middleware, such as 13031, or unset it.";
    return false;
  }
  std::string reason;
  if (!IsOwnListener(port, error))
  {
    error += WeartCure;
    return false;
  }
  if (!middleware.Open(port, seconds, reason))
  {
    error = "WEART's middleware does not answer at port " + std::to_string(port) + " (" + reason +
      "). " + WeartCure;
    return false;
  }
  const std::int64_t asked = ServoClock::Now();
  bool isTold = false;
  bool isOpen = middleware.Send(WriteWeartQuestion());
  while (isOpen && !isTold && ServoClock::SecondsSince(asked) < seconds)
  {
    std::vector<std::string> messages;
    isOpen = middleware.Receive(messages);
    for (const std::string& message : messages)
    {
      isTold = ReadWeartStatus(message, status) || isTold;
    }
    if (!isTold)
    {
      std::this_thread::sleep_for(WeartAskPause);
    }
  }
  if (!isTold)
  {
    middleware.Close();
    error = "The program at port " + std::to_string(port) +
      " does not report a status, as WEART's middleware 1.2 or later does. " + WeartCure;
  }
  return isTold;
}

WeartService::WeartService(std::string hand)
  : Wanted(std::move(hand))
{
}

std::string WeartService::GetName() const
{
  return "WEART TouchDIVER" + (this->Hand.empty() ? "" : " (" + this->Hand + ")");
}

bool WeartService::IsConnected() const
{
  const std::vector<std::string>& hands = this->Status.Hands;
  return std::find(hands.begin(), hands.end(), this->Hand) != hands.end();
}

bool WeartService::Connect(std::string& error)
{
  if (!AskWeart(this->Middleware, WeartAskTime, this->Status, error))
  {
    return false;
  }
  // After the first connection, reopen only the same hand.
  const std::string before = this->Hand.empty() ? this->Wanted : this->Hand;
  for (const char* const hand : { "RIGHT", "LEFT" })
  {
    this->Hand = before.empty() ? hand : before;
    if (this->IsConnected())
    {
      // An earlier connection may have ended before it could stop the middleware, so this session
      // still stops it at the end.
      this->IsStarter = this->IsStarter || this->Status.Status != "RUNNING";
      this->LastWord = WriteWeartStop(this->Hand) + WeartSeparator;
      this->Sent = 0;
      if ((!this->IsStarter || this->Middleware.Send(WriteWeartStart())) &&
        this->Middleware.Send(WriteWeartStop(this->Hand)))
      {
        return true;
      }
      error = "WEART's middleware closed the connection. Start it again.";
      return false;
    }
  }
  this->Hand = before;
  error = "No TouchDIVER" + (before.empty() ? "" : " for the hand " + before) +
    " is connected to WEART's middleware. Switch it on and connect it there.";
  this->Middleware.Close();
  return false;
}

VibrationService::State WeartService::Show(double amplitude)
{
  std::vector<std::string> messages;
  const bool isOpen = this->Middleware.Receive(messages);
  for (const std::string& message : messages)
  {
    ReadWeartStatus(message, this->Status);
  }
  const bool isReady = this->Status.Status == "RUNNING" && this->Status.IsActuating;
  const int volume = isReady ? Vibration::Quantize(amplitude, FullVolume) : 0;
  // A texture lasts until it is stopped, so don't send an unchanged one again.
  if (isOpen && volume != this->Sent &&
    Vibration::IsDue(false, volume == 0, ServoClock::SecondsSince(this->SentAt)))
  {
    this->Sent = volume;
    this->SentAt = ServoClock::Now();
    this->Middleware.Send(
      volume == 0 ? WriteWeartStop(this->Hand) : WriteWeartTexture(this->Hand, volume));
  }
  if (isOpen && !isReady && ServoClock::SecondsSince(this->AskedAt) >= WeartAskTime)
  {
    this->AskedAt = ServoClock::Now();
    this->Middleware.Send(WriteWeartQuestion());
  }
  if (!this->Middleware.IsOpen())
  {
    return this->Tell(State::Gone,
      "is gone: WEART's middleware has ended, or reads no more. Start it: the device is then "
      "opened "
      "by itself, and waits for Arm().");
  }
  if (!this->IsConnected())
  {
    return this->Tell(State::Gone,
      "is no longer connected to WEART's middleware. Switch it on: it is then opened by itself, "
      "and waits for Arm().");
  }
  return !this->Status.IsActuating
    ? this->Tell(State::Waiting, "waits: actuations are switched off in WEART's middleware.")
    : !isReady ? this->Tell(State::Waiting, "waits until WEART's middleware runs.")
               : State::Ready;
}

VibrationService::State WeartService::Tell(State state, const char* text)
{
  this->Text = text;
  return state;
}

void WeartService::StopAtCrash() noexcept
{
  this->Middleware.SendRaw(this->LastWord.data(), this->LastWord.size());
}

void WeartService::Disconnect() noexcept
{
  try
  {
    if (this->Middleware.IsOpen())
    {
      this->Middleware.Send(WriteWeartStop(this->Hand));
      if (this->IsStarter)
      {
        this->IsStarter = !this->Middleware.Send(WriteWeartEnd());
      }
    }
  }
  catch (const std::exception&)
  {
    // There is no memory for a message: send the message that was prepared.
    this->StopAtCrash();
  }
  this->Middleware.Close();
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vibration/BhapticsService.h"

#include "Core/Platform/Files.h"
#include "Core/Realtime/ServoClock.h"
#include "Devices/Pad/Vibration.h"
#include "Devices/Transport/Local/LocalListener.h"
#include "Devices/Vibration/ServiceMessages.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

constexpr double BhapticsAskTime = 1.0; // s
constexpr double BhapticsSendTime = 0.1;
constexpr double BhapticsLastTime = 0.2;
constexpr int MostStatuses = 100; // limit per call
constexpr int FullIntensity = 100;
constexpr int FrameTime = static_cast<int>(1000.0 * Vibration::ReplayTime); // ms
constexpr const char* BhapticsTarget = "/v2/feedbacks?app_id=org.vtk.volumehaptics&app_name="
                                       "VTK%20Volume%20Haptics";
constexpr const char* BhapticsCure =
  "Start bHaptics' Player and connect a device to it. If it listens to another port than 15881, "
  "name it in VOLUMEHAPTICS_BHAPTICS.";

} // namespace

std::uint16_t FindBhapticsPort(std::string& error)
{
  const std::string text = Files::GetVariable("VOLUMEHAPTICS_BHAPTICS");
  std::uint16_t port = 15881;
  if (!text.empty() && !ReadPort(text, port))
  {
    error = "The environment variable VOLUMEHAPTICS_BHAPTICS is \"" + text +
      "\". Give the port of bHaptics' Player, such as 15881, or unset it.";
    return 0;
  }
  return port;
}

bool AskBhaptics(
  WebSocketClient& player, double seconds, std::vector<std::string>& places, std::string& error)
{
  const std::uint16_t port = FindBhapticsPort(error);
  if (port == 0)
  {
    return false;
  }
  std::string reason;
  if (!IsOwnListener(port, error))
  {
    error += BhapticsCure;
    return false;
  }
  if (!player.Open(port, seconds, reason, BhapticsTarget))
  {
    error = "bHaptics' Player does not answer at port " + std::to_string(port) + " (" + reason +
      "). " + BhapticsCure;
    return false;
  }
  // Stop vibrations of an earlier session. The Player also answers with its status.
  const std::int64_t end =
    ServoClock::Now() + static_cast<std::int64_t>(seconds * ServoClock::NanosecondsPerSecond);
  bool isTold = false;
  std::string text;
  player.SetLastWord(WriteBhapticsStop());
  bool isOpen = player.Send(WriteBhapticsStop(), BhapticsSendTime);
  // Check the time, too: messages may arrive continuously, so that the loop would never end.
  while (isOpen && !isTold && ServoClock::Now() < end)
  {
    const WebSocketClient::Outcome outcome = player.Receive(text, end);
    isOpen = outcome == WebSocketClient::Outcome::Message;
    isTold = isOpen && ReadBhapticsStatus(text, places);
  }
  if (!isTold)
  {
    player.Close(BhapticsLastTime);
    error = "bHaptics' Player does not list the connected devices. Update it, or start it "
            "again.";
  }
  return isTold;
}

BhapticsService::BhapticsService(std::string place)
  : Wanted(std::move(place))
{
}

std::string BhapticsService::GetName() const
{
  return "bHaptics" + (this->Place.empty() ? "" : " " + this->Place);
}

bool BhapticsService::IsConnected(const std::vector<std::string>& places) const
{
  return std::find(places.begin(), places.end(), this->Place) != places.end();
}

bool BhapticsService::Connect(std::string& error)
{
  std::vector<std::string> places;
  if (!AskBhaptics(this->Player, BhapticsAskTime, places, error))
  {
    return false;
  }
  // After the first connection, reopen only the same place of the body.
  const std::string before = this->Place.empty() ? this->Wanted : this->Place;
  for (const std::string& place : BhapticsPlaces)
  {
    this->Place = before.empty() ? place : before;
    if (this->IsConnected(places))
    {
      this->Sent = 0;
      return true;
    }
  }
  this->Place = before;
  error = "No " + (before.empty() ? std::string("device") : before) +
    " is connected to bHaptics' Player. Switch it on and pair it in the Player.";
  this->Player.Close(BhapticsLastTime);
  return false;
}

VibrationService::State BhapticsService::Show(double amplitude)
{
  const int intensity = Vibration::Quantize(amplitude, FullIntensity);
  if (Vibration::IsDue(
        intensity == this->Sent, intensity == 0, ServoClock::SecondsSince(this->SentAt)))
  {
    this->Sent = intensity;
    this->SentAt = ServoClock::Now();
    this->Player.Send(
      intensity == 0 ? WriteBhapticsStop() : WriteBhapticsFrame(this->Place, intensity, FrameTime),
      BhapticsSendTime);
  }
  std::string text;
  std::vector<std::string> places;
  for (int i = 0; i < MostStatuses; ++i)
  {
    switch (this->Player.Receive(text, 0))
    {
      case WebSocketClient::Outcome::Nothing:
        return State::Ready;
      case WebSocketClient::Outcome::Closed:
        return this->Lose(
          "is gone: bHaptics' Player has ended. Start it: the device is then opened "
          "by itself, and waits for Arm().");
      case WebSocketClient::Outcome::Message:
        if (ReadBhapticsStatus(text, places) && !this->IsConnected(places))
        {
          return this->Lose("is no longer connected to bHaptics' Player. Switch it on: it is then "
                            "opened by itself, and waits for Arm().");
        }
        break;
    }
  }
  return State::Ready;
}

VibrationService::State BhapticsService::Lose(const char* text)
{
  this->Text = text;
  return State::Gone;
}

void BhapticsService::Disconnect() noexcept
{
  // The last word stops the vibration before the connection is closed.
  this->Player.Close(BhapticsLastTime);
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Haply/HaplyDriver.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Common/DeviceTexts.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace VolumeHaptics
{
namespace
{

///@{
/** Times in s. They are short, because the service runs on this computer. */
constexpr double OpenTime = 1.0;
constexpr double LookTime = 0.3; ///< time (s) for a step while searching for the arm
constexpr double EventsTime = 0.5;
constexpr double SendTime = 0.1;
/// time (s) for receiving the last state and for closing the session
constexpr double LastTime = 0.2;
///@}
constexpr int IdleWait = 2; // in ms, between messages if the servo has no force
constexpr std::int64_t StateWait = 5 * ServoClock::Millisecond;
// equals HardwareExchange::WatchdogTime
constexpr std::int64_t LateTime = 30 * ServoClock::Millisecond;
constexpr std::int64_t DropTime = 500 * ServoClock::Millisecond;
constexpr int LostWait = 10; // in ms
// limit of the queued states that are read at once: some seconds of states
constexpr int MostStates = 1000;

constexpr const char* AskForCalibration =
  "is not calibrated: put its handle into the inkwell, or lead it as Haply's Hub says.";
constexpr const char* AskForReady = "is not ready: look at its light and its power.";
constexpr const char* AskForOrigin =
  "does not report its origin: update Haply's Inverse service, and start it again.";
constexpr const char* AfterLoss = " Home() and Arm() again.";

/** Returns whether a preset has the arm in front of the user, which means Haply's own axes. */
bool IsForward(const std::string& preset)
{
  return preset == HaplyCentredPreset || preset == "defaults" || preset == "arm_front";
}

} // namespace

DeviceLimits HaplyDriver::GetLimits() const
{
  return { 2.0, 500.0, 0.0, 2.5, 0.0, this->Type == "minverse" ? 0.04 : 0.10 };
}

bool HaplyDriver::OpenConnection(
  double time, const std::function<bool()>& mustStop, std::string& error)
{
  std::string reason;
  if (!HaplyPorts::Read(this->Ports, error) ||
    !DetectHaplyService(this->Ports, this->Address.Version, error) || mustStop())
  {
    return false;
  }
  if (!this->States.Open(this->Ports.States, time, reason))
  {
    error = "No WebSocket to Haply's Inverse service: " + reason + ". " + HowToStartHaply;
    return false;
  }
  const std::int64_t end =
    ServoClock::Now() + static_cast<std::int64_t>(time * ServoClock::NanosecondsPerSecond);
  if (mustStop() || this->States.Receive(this->Text, end) != WebSocketClient::Outcome::Message)
  {
    error = "Haply's Inverse service does not list its devices. Start it again.";
    return false;
  }
  if (const char* const fault = ReadHaplyMessage(this->Text, this->Message))
  {
    error = std::string("Haply's Inverse service ") + fault + ". Start it again.";
    return false;
  }
  return true;
}

bool HaplyDriver::Choose(std::string& error)
{
  std::string known;
  for (const HaplyArm& arm : this->Message.Arms)
  {
    if (this->Wanted.empty() || arm.Id == this->Wanted)
    {
      this->Id = arm.Id;
      this->Type = arm.Type;
      this->Label = NameOfHaply(arm);
      return true;
    }
    known += (known.empty() ? "haply:" : ", haply:") + arm.Id;
  }
  error = known.empty()
    ? "Haply's Inverse service has no Inverse3, Inverse3x or Minverse. Plug one in and switch it "
      "on."
    : "Haply's Inverse service has no device \"" + this->Wanted + "\". It has " + known + ".";
  return false;
}

bool HaplyDriver::IsTaken() const
{
  return std::any_of(this->Message.Arms.begin(), this->Message.Arms.end(),
    [this](const HaplyArm& arm) { return arm.Id == this->Id && arm.IsInUse.value_or(false); });
}

bool HaplyDriver::SendFirstMessage(std::string& error)
{
  const auto arm = std::find_if(this->Message.Arms.begin(), this->Message.Arms.end(),
    [this](const HaplyArm& other) { return other.Id == this->Id; });
  if (arm == this->Message.Arms.end())
  {
    error = this->Label + " is no longer plugged in.";
    return false;
  }
  if (this->IsTaken())
  {
    error = this->Label + " is in use by another program. Close that program.";
    return false;
  }
  this->Address.Family = arm->Family;
  this->Address.Id = arm->Id;
  this->IsGone = this->IsLost = this->IsReady = this->HasSentRelief = this->HasTip = false;
  this->IsCalibrated = this->IsArmReady = false;
  this->CopyFlags(*arm);
  this->Settled = this->EmptyWaits = 0;
  this->Transform = {};
  this->Preset.clear();
  this->Untold = 0;
  this->Note.clear();
  this->Request = nullptr;
  this->ToldAt = this->HeardAt = this->SentAt = ServoClock::Now();
  this->Awaited = 1;
  if (!this->States.Send(WriteHaplyGreeting(this->Address), SendTime))
  {
    error = "Haply's Inverse service closed the connection. Start it again.";
    return false;
  }
  this->States.SetLastWord(WriteHaplyForce(this->Address, {}, false));
  // A service without this channel sends no events.
  std::string ignored;
  this->HasEvents = this->Events.Open(this->Ports.Events, EventsTime, ignored);
  return true;
}

bool HaplyDriver::Connect(std::string& error)
{
  if (this->OpenConnection(
        OpenTime, [] { return false; }, error) &&
    this->Choose(error) && this->SendFirstMessage(error))
  {
    return true;
  }
  this->Disconnect();
  return false;
}

bool HaplyDriver::Reconnect(
  const std::string& /*identity*/, const std::function<bool()>& mustStop, std::string& error)
{
  this->Message = {};
  const bool isThere = this->OpenConnection(LookTime, mustStop, error) && !mustStop() &&
    std::any_of(this->Message.Arms.begin(), this->Message.Arms.end(),
      [this](const HaplyArm& arm) { return arm.Id == this->Id && arm.Type == this->Type; });
  if (isThere && this->SendFirstMessage(error))
  {
    return true;
  }
  this->Disconnect();
  return false;
}

void HaplyDriver::Disconnect() noexcept
{
  this->Events.Close();
  this->States.Close(LastTime);
}

void HaplyDriver::Serve(HardwareExchange& exchange)
{
  /** Ends the force when leaving the scope, even by an exception. */
  struct AtEnd
  {
    HaplyDriver* Driver;
    ~AtEnd() { this->Driver->Rest(); }
  };
  const AtEnd atEnd{ this };
  while (!exchange.MustStop() && !this->IsGone)
  {
    if (exchange.HasSlept() && !this->IsLost)
    {
      this->IsLost = true;
      this->IsReady = false;
      this->Rest();
    }
    if (exchange.DrainHomeRequest())
    {
      this->Restart(exchange);
    }
    if (this->IsLost)
    {
      // Quench() and Close() wait until this thread has requested the force and received zero.
      exchange.GetForce();
      std::this_thread::sleep_for(std::chrono::milliseconds(LostWait));
    }
    else
    {
      this->Work(exchange);
    }
  }
}

void HaplyDriver::Restart(HardwareExchange& exchange)
{
  this->Rest();
  this->Disconnect();
  std::string error;
  const auto mustStop = [&exchange] { return exchange.MustStop(); };
  const std::int64_t end = ServoClock::Now() + DropTime;
  bool isOpen = false;
  for (bool tries = true; tries;)
  {
    this->Message = {};
    isOpen = this->OpenConnection(OpenTime, mustStop, error) && this->SendFirstMessage(error);
    if (!isOpen)
    {
      this->Disconnect();
    }
    // The service may still be ending the previous session.
    tries = !isOpen && this->IsTaken() && ServoClock::Now() < end && !exchange.MustStop();
    if (tries)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(LostWait));
    }
  }
  if (!isOpen)
  {
    this->IsLost = true;
    exchange.SetCondition(DeviceStage::Lost, error.c_str());
  }
}

void HaplyDriver::Work(HardwareExchange& exchange)
{
  if (this->Awaited == 0)
  {
    exchange.WaitForWake(IdleWait);
    this->HasSentRelief = false;
    this->Send(exchange.GetForce());
  }
  else if (!this->HasSentRelief && ServoClock::Now() - this->SentAt > LateTime)
  {
    this->HasSentRelief = true;
    this->Send({});
  }
  this->ReceiveStates(exchange);
  if (!this->IsLost)
  {
    this->ReceiveEvents(exchange);
  }
  if (!this->IsLost)
  {
    this->CheckSilence(exchange);
  }
}

void HaplyDriver::Send(const Vector3& force)
{
  const Vector3 limited = ClampNorm(force, this->GetLimits().MaximumForce);
  ++this->Awaited;
  this->SentAt = ServoClock::Now();
  const bool asksForAll = this->Address.Version.IsNew() && !this->IsReady;
  this->States.Send(WriteHaplyForce(this->Address, FromDevice(limited), asksForAll), SendTime);
}

void HaplyDriver::ReceiveStates(HardwareExchange& exchange)
{
  const std::int64_t end = ServoClock::Now() + StateWait;
  ++this->EmptyWaits;
  int taken = 0;
  for (bool hasMore = true; hasMore;)
  {
    switch (this->States.Receive(this->Text, taken == 0 ? end : 0))
    {
      case WebSocketClient::Outcome::Closed:
        this->IsGone = true;
        return this->Lose(exchange,
          "is gone: the Inverse service ended or closed the connection. Start it: the device is "
          "then opened by itself, and waits for Arm().");
      case WebSocketClient::Outcome::Nothing:
        hasMore = false;
        break;
      case WebSocketClient::Outcome::Message:
        this->Awaited = std::max(0, this->Awaited - 1);
        if (++taken > MostStates)
        {
          return this->Lose(exchange,
            std::string("is gone: the Inverse service sends states without a break.") + AfterLoss);
        }
        this->Newest.swap(this->Text);
        break;
    }
  }
  if (taken == 0)
  {
    return;
  }
  this->HeardAt = ServoClock::Now();
  if (const char* const fault = ReadHaplyMessage(this->Newest, this->Message))
  {
    return this->Lose(
      exchange, std::string("is gone: the Inverse service ") + fault + "." + AfterLoss);
  }
  if (this->Awaited == 0 && !this->HasSentRelief)
  {
    exchange.RecordTaken();
  }
  const auto arm = std::find_if(this->Message.Arms.begin(), this->Message.Arms.end(),
    [this](const HaplyArm& one) { return one.Id == this->Id; });
  if (arm != this->Message.Arms.end())
  {
    this->ReceiveState(exchange, *arm);
  }
}

void HaplyDriver::ReceiveState(HardwareExchange& exchange, const HaplyArm& arm)
{
  if (arm.IsSpoilt || (arm.Position && !IsFinite(*arm.Position)))
  {
    return this->Lose(exchange,
      std::string("is gone: the Inverse service reports a position that is not a "
                  "number.") +
        AfterLoss);
  }
  if (!arm.Position)
  {
    return;
  }
  const bool isNewPreset = !arm.Preset.empty() && arm.Preset != this->Preset;
  this->Preset = isNewPreset ? arm.Preset : this->Preset;
  if (!this->KnowsOrigin())
  {
    ++this->Untold;
    this->EmptyWaits = 0;
    this->ToldAt = this->HeardAt;
    return this->UpdateStatus(exchange, arm);
  }
  this->Untold = 0;
  const Vector3 origin = this->Preset == HaplyCentredPreset ? Vector3{} : Centre;
  const Vector3 tip = ToDevice(*arm.Position - origin);
  const double farthest =
    FarthestStep + this->GetLimits().MaximumSpeed * ServoClock::SecondsSince(this->ToldAt);
  const bool hasStepped = this->HasTip && Norm(tip - this->Tip) > farthest;
  const HaplyTransform transform = arm.Transform.value_or(this->Transform);
  const bool isMoved = isNewPreset || !transform.IsNear(this->Transform);
  this->Settled = hasStepped || isMoved ? 0 : std::min(this->Settled + 1, SettledStates);
  this->Tip = tip;
  this->HasTip = true;
  this->Transform = transform;
  this->ToldAt = this->HeardAt;
  this->EmptyWaits = 0;
  if (transform.IsScaled())
  {
    return this->Lose(exchange,
      std::string("has a scaled workspace, in which forces would do other work than "
                  "computed. Set its scale to 1 in Haply's Hub.") +
        AfterLoss);
  }
  if (this->IsReady && (hasStepped || isMoved))
  {
    return this->Lose(exchange,
      std::string("jumped while no hand moved it. Did Haply's Hub change its settings?") +
        AfterLoss);
  }
  DeviceSample sample;
  sample.Tip = tip;
  this->CopyGrips(sample);
  exchange.Report(sample);
  this->UpdateStatus(exchange, arm);
}

bool HaplyDriver::KnowsOrigin() const noexcept
{
  return !this->Address.Version.IsNew() || !this->Preset.empty();
}

void HaplyDriver::CopyGrips(DeviceSample& sample) const
{
  for (const HaplyGrip& grip : this->Message.Grips)
  {
    if (grip.IsAwake)
    {
      sample.Buttons |= grip.Buttons;
      if (grip.Orientation && !sample.HasOrientation)
      {
        sample.Orientation = ToDevice(*grip.Orientation);
        sample.HasOrientation = true;
      }
    }
  }
}

void HaplyDriver::CopyFlags(const HaplyArm& arm)
{
  this->IsCalibrated = arm.IsCalibrated.value_or(this->IsCalibrated);
  this->IsArmReady = arm.IsReady.value_or(this->IsArmReady);
}

void HaplyDriver::UpdateStatus(HardwareExchange& exchange, const HaplyArm& arm)
{
  this->CopyFlags(arm);
  const bool isCalibrated = this->IsCalibrated;
  const bool isReady = this->IsArmReady;
  if (this->IsReady && (!isCalibrated || !isReady))
  {
    return this->Lose(exchange,
      std::string(isCalibrated ? "is no longer ready." : "has lost its calibration.") + AfterLoss);
  }
  const char* const request = !isCalibrated ? AskForCalibration
    : !isReady                              ? AskForReady
    : this->Untold > SettledStates          ? AskForOrigin
                                            : nullptr;
  if (request != nullptr && request != this->Request)
  {
    this->Report(exchange, DeviceStage::Homing, request);
  }
  this->Request = request;
  if (request == nullptr && this->Settled == SettledStates && !this->IsReady)
  {
    if (this->Address.Version.IsNew() && !IsForward(this->Preset))
    {
      return this->Lose(exchange,
        "has the preset " + this->Preset + ", whose axes are not known here. Choose " +
          HaplyCentredPreset + " in Haply's Hub." + AfterLoss);
    }
    this->IsReady = true;
    this->Report(exchange, DeviceStage::Ready, "");
  }
}

void HaplyDriver::ReceiveEvents(HardwareExchange& exchange)
{
  HaplyEvent event;
  while (!this->IsLost && this->Events.IsOpen() &&
    this->Events.Receive(this->Text, 0) == WebSocketClient::Outcome::Message)
  {
    if (ReadHaplyEvent(this->Text, event) != nullptr || event.Level < HaplyLevel::Warning ||
      (!event.Device.empty() && event.Device != this->Id))
    {
      continue;
    }
    const std::string what = event.Text.empty() ? event.Name + " " + event.Safety : event.Text;
    const bool isOwn = event.Device == this->Id;
    if (isOwn && event.Name == "device-disconnected")
    {
      this->IsGone = true;
      return this->Lose(exchange, UnpluggedText);
    }
    if (event.Level >= (isOwn ? HaplyLevel::Error : HaplyLevel::Critical) ||
      (isOwn && event.Name == "device-busy"))
    {
      this->Lose(exchange, "was stopped by the Inverse service: " + what + "." + AfterLoss);
    }
    else if (this->IsReady && what != this->Note)
    {
      this->Note = what;
      this->Report(exchange, DeviceStage::Ready, "warns: " + what + ".");
    }
  }
  if (this->IsReady && this->HasEvents && !this->Events.IsOpen())
  {
    this->HasEvents = false;
    this->Report(exchange, DeviceStage::Ready,
      "goes on without the Inverse service's warnings: their connection has ended. Home() connects "
      "again.");
  }
}

void HaplyDriver::CheckSilence(HardwareExchange& exchange)
{
  if (this->EmptyWaits > SilentWaits && ServoClock::SecondsSince(this->ToldAt) > SilenceTime)
  {
    this->IsGone = std::none_of(this->Message.Arms.begin(), this->Message.Arms.end(),
      [this](const HaplyArm& arm) { return arm.Id == this->Id; });
    if (this->IsGone)
    {
      return this->Lose(exchange, UnpluggedText);
    }
    this->Lose(exchange,
      this->HeardAt == this->ToldAt
        ? "is gone: the Inverse service does not answer. Start it again, then Home() and Arm() "
          "again."
        : "is gone: the Inverse service does not report its position. Check its cable and its "
          "power, then Home() and Arm() again.");
  }
}

void HaplyDriver::Rest() noexcept
{
  try
  {
    if (this->States.IsOpen())
    {
      this->Send({});
      const std::int64_t end =
        ServoClock::Now() + static_cast<std::int64_t>(LastTime * ServoClock::NanosecondsPerSecond);
      // A state confirms that the service has received the message. If the service hangs, this does
      // not wait.
      while (this->Awaited > 0 &&
        this->States.Receive(this->Text, end) == WebSocketClient::Outcome::Message)
      {
        --this->Awaited;
      }
    }
  }
  catch (const std::exception&)
  {
    // There is no memory for a message. Closing the connection ends the session.
  }
}

void HaplyDriver::Lose(HardwareExchange& exchange, const std::string& text)
{
  // Notify the servo before sending anything, because sending may take long.
  this->Report(exchange, DeviceStage::Lost, text);
  this->IsLost = true;
  this->IsReady = false;
  this->Rest();
}

void HaplyDriver::Report(
  HardwareExchange& exchange, DeviceStage stage, const std::string& text) const
{
  exchange.SetCondition(stage, this->Label.c_str(), text.c_str());
}

} // namespace VolumeHaptics

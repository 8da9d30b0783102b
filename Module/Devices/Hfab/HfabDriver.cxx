// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Hfab/HfabDriver.h"

#include "Core/Realtime/ServoClock.h"
#include "Devices/Common/DeviceTexts.h"

#include <algorithm>
#include <cstdlib>

namespace VolumeHaptics
{
namespace
{

constexpr int HfabRoundPause = 2; // ms, between messages if the servo has no force
constexpr int HfabLostPause = 10; // ms
constexpr int WriteTime = 20;     // ms
/** Time (s) without an answer after which a message counts as lost and the next one is sent. */
constexpr double AnswerTime = 0.02;
constexpr int MostRefusals = 5;

constexpr const char* AskForPose =
  "needs to know where its arm is: put the arm into its pose for calibration, hold it still, and "
  "press Home().";
constexpr const char* AskForButton = "has to be calibrated by its firmware first: put the arm into "
                                     "its pose for calibration, press the "
                                     "button of its controller, and press Home().";

} // namespace

HfabDriver::HfabDriver(std::string port, std::string folder)
  : Wanted(std::move(port))
  , Folder(std::move(folder))
{
}

DeviceLimits HfabDriver::GetLimits() const
{
  return this->Geometry ? this->Geometry->Limits : DeviceLimits();
}

std::string HfabDriver::MakeIdentity(const SerialPortInfo& port)
{
  std::string word = port.Name.empty() ? "port:" + port.Path : port.Name;
  std::replace_if(
    word.begin(), word.end(), [](char c) { return c <= ' ' || c == '=' || c > '~'; }, '_');
  return "hfab:" + word;
}

std::vector<SerialPortInfo> HfabDriver::ListBoardPorts(const std::string& folder)
{
  std::vector<SerialPortInfo> boards = SerialPort::List(Board, folder);
  boards.erase(
    std::remove_if(boards.begin(), boards.end(),
      [](const SerialPortInfo& port) { return port.Name.find(OtherBoard) != std::string::npos; }),
    boards.end());
  return boards;
}

bool HfabDriver::Choose(SerialPortInfo& port, std::string& error) const
{
  if (!this->Wanted.empty())
  {
    port = { this->Wanted, SerialPort::NameOf(this->Wanted, this->Folder) };
    if (port.Name.find(OtherBoard) != std::string::npos)
    {
      error = "The board at " + port.Path + " is \"" + port.Name +
        "\", which is no hfab controller. Open it as \"haply\", by Haply's Inverse service.";
      return false;
    }
    return true;
  }
  const std::vector<SerialPortInfo> boards = ListBoardPorts(this->Folder);
  if (boards.size() == 1)
  {
    port = boards.front();
    return true;
  }
  std::string known;
  for (const SerialPortInfo& board : boards)
  {
    known += (known.empty() ? "hfab:" : ", hfab:") + board.Path + " (" + board.Name + ")";
  }
  error = boards.empty()
    ? std::string("No hfab controller is plugged in: no serial port of a board named \"") + Board +
      "\" is in " + this->Folder +
      ". Plug it in and switch it on, or give its port, such as \"hfab:" + SerialPort::Example +
      "\"."
    : "Several boards may be the hfab controller. Give the port: " + known + ".";
  return false;
}

bool HfabDriver::Connect(std::string& error)
{
  SerialPortInfo port;
  return this->Choose(port, error) &&
    this->Take(
      port, [] { return false; }, error);
}

bool HfabDriver::Reconnect(
  const std::string& identity, const std::function<bool()>& mustStop, std::string& error)
{
  // A board that is plugged in again may get a different port.
  std::vector<SerialPortInfo> ports = ListBoardPorts(this->Folder);
  if (!this->Wanted.empty() && SerialPort::IsThere(this->Wanted))
  {
    ports.push_back({ this->Wanted, SerialPort::NameOf(this->Wanted, this->Folder) });
  }
  const auto port = std::find_if(ports.begin(), ports.end(),
    [&identity](const SerialPortInfo& one) { return MakeIdentity(one) == identity; });
  if (port == ports.end())
  {
    return false;
  }
  const std::string label = this->Label;
  const int model = this->Model;
  const HfabGeometry* const geometry = this->Geometry;
  const bool isConnected = this->Take(*port, mustStop, error);
  if (isConnected && this->Model == model)
  {
    return true;
  }
  if (isConnected)
  {
    error = this->Label + " drives another arm than before. Open() and Start() it.";
    this->Port.Close();
  }
  this->Label = label;
  this->Model = model;
  this->Geometry = geometry;
  return false;
}

bool HfabDriver::Take(
  const SerialPortInfo& port, const std::function<bool()>& mustStop, std::string& error)
{
  this->Label = "hfab controller (" + port.Path + ")";
  if (!this->Port.Open(port.Path, error))
  {
    return false;
  }
  if (!this->Shake(mustStop, error))
  {
    this->Port.Close();
    return false;
  }
  this->Label = std::string(this->Geometry->Name) + " (" + port.Path + ")";
  this->Identity = MakeIdentity(port);
  return true;
}

bool HfabDriver::Shake(const std::function<bool()>& mustStop, std::string& error)
{
  this->Reader.Reset();
  const std::int64_t begin = ServoClock::Now();
  Reply reply = Reply::None;
  while (reply == Reply::None && ServoClock::SecondsSince(begin) < HandshakeTime && !mustStop())
  {
    reply = this->Ask({});
  }
  if (reply != Reply::Answer)
  {
    error = this->Label +
      (reply == Reply::Gone ? " was unplugged. Plug it in again."
          : this->Reader.GetBadLines() > 0
          ? " sends lines that an hfab controller does not send. Give "
            "the port of the controller."
          : " does not answer. Give the port of the controller, and "
            "check its firmware.");
    return false;
  }
  this->Model = this->Reader.Get().Model;
  this->Geometry = HfabModel::Find(this->Model);
  if (!this->Geometry)
  {
    error = this->Label + " drives an arm of the model " + std::to_string(this->Model) +
      ", whose geometry is not known. Known are 1 (Polhem), 2 (PHANToM) and 3 (WoodenHaptics).";
    return false;
  }
  return true;
}

void HfabDriver::Disconnect() noexcept
{
  this->Port.Close();
}

HfabDriver::Reply HfabDriver::Ask(const std::array<int, 3>& milliamperes) noexcept
{
  // Discard late answers, so that none counts as the answer to the next message.
  char bytes[128];
  int late = 0;
  while ((late = this->Port.Read(bytes, sizeof(bytes), 0)) > 0)
  {
    this->Reader.Discard();
  }
  if (late < 0)
  {
    return Reply::Gone;
  }
  const HfabMessage message = EncodeHfab(milliamperes);
  if (!this->Port.Write(message.Bytes.data(), message.Size, WriteTime))
  {
    char byte = 0;
    return this->Port.Read(&byte, 1, 0) < 0 ? Reply::Gone : Reply::None;
  }
  const std::int64_t begin = ServoClock::Now();
  // Read at least once, even if this computer itself was delayed beyond the time limit.
  do
  {
    const int size = this->Port.Read(bytes, sizeof(bytes), 5);
    if (size < 0)
    {
      return Reply::Gone;
    }
    bool hasAnswer = false;
    for (int i = 0; i < size; ++i)
    {
      hasAnswer = this->Reader.Receive(bytes[i]) || hasAnswer;
    }
    if (hasAnswer)
    {
      return Reply::Answer;
    }
  } while (ServoClock::SecondsSince(begin) < AnswerTime);
  return Reply::None;
}

bool HfabDriver::EchoesCurrents() noexcept
{
  // Send currents too small to be felt. Encoder counts would not equal all of them by chance.
  bool echoes = false;
  for (const int milliamperes : { 1, 2, 1, 0 })
  {
    const HfabAnswer& answer = this->Reader.Get();
    if (this->Ask({ milliamperes, 0, 0 }) == Reply::Answer &&
      (answer.Error & HfabMessageErrors) == 0)
    {
      echoes = true;
      if (answer.Counts[1] != milliamperes)
      {
        return false;
      }
    }
  }
  return echoes;
}

void HfabDriver::Rest() noexcept
{
  const HfabMessage zero = EncodeHfab({});
  this->Port.Write(zero.Bytes.data(), zero.Size, WriteTime);
}

void HfabDriver::Serve(HardwareExchange& exchange)
{
  /** Ends the force when leaving the scope, even by an exception. */
  struct AtEnd
  {
    HfabDriver* Driver;
    ~AtEnd()
    {
      if (!this->Driver->Gone)
      {
        this->Driver->Rest();
      }
    }
  };
  const AtEnd atEnd{ this };
  this->Gone = false;
  this->Restart(exchange);
  while (!exchange.MustStop() && !this->Gone)
  {
    if (exchange.HasSlept())
    {
      this->Lost = true;
      this->Rest();
    }
    if (exchange.DrainHomeRequest())
    {
      if (this->Lost || this->Now == Phase::Ready)
      {
        this->Restart(exchange);
      }
      else if (this->EchoesCurrents())
      {
        this->Now = Phase::Waiting;
        this->Report(exchange, DeviceStage::Homing, AskForButton);
      }
      else
      {
        this->Now = Phase::Calibrating;
        this->StillSince = 0;
        this->Report(exchange, DeviceStage::Homing, "is being calibrated: hold its arm still.");
      }
    }
    if (this->Lost)
    {
      // Quench() and Close() wait until this thread has requested the force and received zero.
      exchange.GetForce();
      exchange.WaitForWake(HfabLostPause);
      continue;
    }
    this->Round(exchange);
    if (!this->Lost)
    {
      exchange.WaitForWake(HfabRoundPause);
    }
  }
}

void HfabDriver::Restart(HardwareExchange& exchange)
{
  this->Lost = false;
  this->HasTip = false;
  this->Refusals = 0;
  this->Now = Phase::Waiting;
  this->LastAnswer = ServoClock::Now();
  this->Port.Drain();
  this->Reader.Reset();
  this->Report(exchange, DeviceStage::Homing, AskForPose);
}

void HfabDriver::Round(HardwareExchange& exchange)
{
  const Vector3 force = exchange.GetForce();
  const std::array<int, 3> currents = this->Now == Phase::Ready
    ? HfabModel::ComputeCurrents(*this->Geometry, this->JointAngles, HfabModel::ToArm(force))
    : std::array<int, 3>{};
  const Reply reply = this->Ask(currents);
  if (reply == Reply::Gone)
  {
    this->Gone = true;
    this->Lose(exchange, UnpluggedText);
    return;
  }
  if (reply == Reply::None)
  {
    if (ServoClock::SecondsSince(this->LastAnswer) > SilenceTime)
    {
      this->Lose(exchange,
        "does not answer. Check its cable and its power, then press Home() and put the arm "
        "into its pose for calibration.");
    }
    return;
  }
  this->Pause = ServoClock::SecondsSince(this->LastAnswer);
  this->LastAnswer = ServoClock::Now();
  if (this->ReceiveAnswer(exchange))
  {
    exchange.RecordTaken();
  }
}

bool HfabDriver::ReceiveAnswer(HardwareExchange& exchange)
{
  const HfabAnswer& answer = this->Reader.Get();
  if (answer.Model != this->Model && (answer.Error & HfabMessageErrors) == 0)
  {
    this->Lose(exchange, "says that it drives another arm now. Open() it again.");
    return false;
  }
  if ((answer.Error & HfabMessageErrors) != 0)
  {
    // The counts belong to an earlier message. A single corrupted message is not an error, because
    // the next one follows at once.
    if (++this->Refusals > MostRefusals)
    {
      this->Lose(exchange,
        "does not understand what is sent to it. Check its cable and firmware, then press "
        "Home() and put the arm into its pose for calibration.");
    }
    return false;
  }
  this->Refusals = 0;
  this->Raw = answer.Counts;
  if (this->Now == Phase::Calibrating)
  {
    this->Calibrate(exchange);
  }
  else if (this->Now == Phase::Ready)
  {
    this->UpdateHand(exchange);
  }
  return !this->Lost;
}

void HfabDriver::Calibrate(HardwareExchange& exchange)
{
  bool isStill = this->StillSince != 0;
  for (std::size_t e = 0; e < 3; ++e)
  {
    isStill = isStill && std::abs(this->Raw[e] - this->StillAt[e]) <= StillCounts;
  }
  if (!isStill)
  {
    this->StillAt = this->Raw;
    this->StillSince = ServoClock::Now();
    return;
  }
  if (ServoClock::SecondsSince(this->StillSince) < StillTime)
  {
    return;
  }
  this->HandleMoves = false;
  for (std::size_t e = 0; e < this->Zero.size(); ++e)
  {
    this->Zero[e] = this->Raw[e] - this->Geometry->Home[e];
  }
  this->UpdateHand(exchange);
  if (!this->Lost)
  {
    this->Now = Phase::Ready;
    this->Report(exchange, DeviceStage::Ready, "");
  }
}

void HfabDriver::UpdateHand(HardwareExchange& exchange)
{
  HfabModel::Counts counts{};
  for (std::size_t e = 0; e < counts.size(); ++e)
  {
    counts[e] = this->Raw[e] - this->Zero[e];
  }
  this->JointAngles = HfabModel::ComputeAngles(*this->Geometry, counts);
  Vector3 tip;
  const bool exists = HfabModel::ComputeTip(*this->Geometry, this->JointAngles, tip);
  const double farthest = std::max(FarthestStep, FastestHand * this->Pause);
  if (!exists || (this->HasTip && Norm(tip - this->Tip) > farthest))
  {
    this->Lose(exchange,
      "reports a jump of its arm that no hand can make: its button was pressed, or its encoders "
      "have "
      "lost their zero. Press Home() and put the arm into its pose for calibration.");
    return;
  }
  this->Tip = tip;
  this->HasTip = true;
  DeviceSample sample;
  sample.Tip = HfabModel::ToDevice(tip);
  // A PHANToM with a thimble has no encoders in its handle, so these counts never change.
  this->HandleMoves = this->HandleMoves || this->Geometry->IsLinkage ||
    !std::equal(counts.begin() + 3, counts.end(), this->Geometry->Home.begin() + 3);
  sample.HasOrientation = this->Geometry->GimbalCounts > 0.0 && this->HandleMoves &&
    (this->Reader.Get().Error & HfabGimbalErrors) == 0;
  if (sample.HasOrientation)
  {
    sample.Orientation = HfabModel::ComputeOrientation(*this->Geometry, counts);
  }
  exchange.Report(sample);
}

void HfabDriver::Lose(HardwareExchange& exchange, const char* text) noexcept
{
  // Notify the servo before sending anything, because sending may take long.
  this->Lost = true;
  this->Report(exchange, DeviceStage::Lost, text);
  if (!this->Gone)
  {
    this->Rest();
  }
}

void HfabDriver::Report(
  HardwareExchange& exchange, DeviceStage stage, const char* text) const noexcept
{
  exchange.SetCondition(stage, this->Label.c_str(), text);
}

} // namespace VolumeHaptics

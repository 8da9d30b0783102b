// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TouchFalcon.h"

#include "Dealer.h"
#include "Devices/Falcon/FalconHoming.h"
#include "Devices/Falcon/FalconLoader.h"
#include "Devices/Falcon/FalconStream.h"

#include <algorithm>
#include <cmath>
#include <vector>

using namespace VolumeHaptics;

namespace
{
constexpr int MostTransfers = 400;
constexpr int MostLoaderSteps = 2000;

FalconReport DealReport(Dealer& dealer)
{
  FalconReport report;
  for (std::int16_t& count : report.Encoders)
  {
    // Draw most counts within the workspace, where the forward kinematics has a solution.
    count = static_cast<std::int16_t>(
      dealer.Choose(8) == 0 ? dealer.Between(-32768.0, 32767.0) : dealer.Between(-1500.0, 1500.0));
  }
  report.Buttons = dealer.Byte() & 0x0F;
  report.Homed = dealer.Choose(4) == 0 ? dealer.Byte() & FalconAllHomed : FalconAllHomed;
  return report;
}

/**
 * Returns one or more pieces in a row. A piece is raw bytes, a part of a packet, or a whole packet,
 * which may be damaged.
 */
std::vector<std::uint8_t> DealBytes(Dealer& dealer)
{
  std::vector<std::uint8_t> bytes;
  for (int pieces = dealer.Choose(4); pieces >= 0; --pieces)
  {
    if (dealer.Choose(4) == 0)
    {
      std::vector<std::uint8_t> raw(dealer.Byte());
      dealer.Fill(raw.data(), raw.size());
      bytes.insert(bytes.end(), raw.begin(), raw.end());
      continue;
    }
    FalconPacket packet = FalconEncode(DealReport(dealer));
    if (dealer.Choose(4) == 0)
    {
      packet[dealer.Choose(FalconPacketSize)] = dealer.Byte();
    }
    const int cut = dealer.Choose(4) == 0 ? dealer.Choose(FalconPacketSize) : 0;
    bytes.insert(bytes.end(), packet.begin() + cut, packet.end());
  }
  return bytes;
}

std::vector<std::uint8_t> Wrap(const std::vector<std::uint8_t>& bytes, int status)
{
  std::vector<std::uint8_t> transfer;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    if (i % (FtdiPacketSize - FtdiStatusSize) == 0)
    {
      transfer.insert(transfer.end(), FtdiStatusSize, static_cast<std::uint8_t>(status));
    }
    transfer.push_back(bytes[i]);
  }
  return transfer;
}

Vector3 DealForce(Dealer& dealer)
{
  constexpr double sizes[] = { 1.0, 10.0, 1e6, 1e308, HUGE_VAL };
  const double size = sizes[dealer.Choose(5)];
  return { size * dealer.Between(-1.0, 1.0), size * dealer.Between(-1.0, 1.0),
    dealer.Choose(16) == 0 ? std::nan("") : size * dealer.Between(-1.0, 1.0) };
}

void CheckForce(const FalconPose& pose, const Vector3& force)
{
  const FalconCounts commands = FalconCommandsOf(pose.Jacobian, force);
  const Vector3 wanted = FalconTorqueCommands(pose.Jacobian, force);
  const double each[3] = { wanted.X, wanted.Y, wanted.Z };
  for (int leg = 0; leg < 3; ++leg)
  {
    Check(std::abs(commands[leg]) <= FalconLargestCommand, "the cap holds");
    Check(commands[leg] == 0 || commands[leg] * each[leg] > 0.0, "no command turns its sign");
    Check(IsFinite(wanted) || commands[leg] == 0, "what is no number is no force");
  }
}

void CheckPose(const FalconReport& report, const Vector3& force)
{
  const Vector3 angles = FalconAnglesOf(report.Encoders);
  const FalconPose pose = FalconForward(angles);
  Check(IsFinite(pose.Position), "positions are finite");
  if (pose.Reach == FalconReach::Reached)
  {
    Vector3 again;
    Check(FalconInverse(pose.Position, again), "what is reached has angles");
    Check(Norm(again - angles) < 1e-6, "and they are those that were measured");
    CheckForce(pose, force);
  }
}

void Listen(Dealer& dealer)
{
  FalconStream stream;
  FalconHoming homing(dealer.Between(0.0, 10.0));
  std::size_t sent = 0;
  std::size_t taken = 0;
  for (int i = 0; i < MostTransfers && dealer.HasMore(); ++i)
  {
    const bool raw = dealer.Choose(8) == 0;
    const std::vector<std::uint8_t> bytes = DealBytes(dealer);
    const std::vector<std::uint8_t> transfer = raw ? bytes : Wrap(bytes, dealer.Byte());
    FalconReport report;
    const int reports = stream.Receive(transfer.data(), transfer.size(), report);
    sent += transfer.size();
    taken += reports * FalconPacketSize;
    Check(taken + stream.GetDropped() <= sent, "no byte counts twice");
    const FalconHomingState before = homing.GetState();
    const double elapsed = dealer.Choose(16) == 0 ? std::nan("") : dealer.Between(-0.01, 0.5);
    homing.Update(elapsed, reports > 0 ? &report : nullptr);
    Check(homing.GetOrder().Motors == FalconCounts{}, "no force while it is homing");
    if (reports > 0)
    {
      CheckPose(report, DealForce(dealer));
    }
    if (homing.GetState() == FalconHomingState::Ready && before != FalconHomingState::Ready)
    {
      const FalconPose pose = FalconForward(FalconAnglesOf(report.Encoders));
      Check(reports > 0 && report.Homed == FalconAllHomed && pose.Reach == FalconReach::Reached &&
          pose.Position.Z > FalconReadyHeight,
        "ready is homed and out");
    }
    dealer.Choose(32) == 0 ? homing.Restart() : void();
  }
}

/** Mostly answers as the device does. With wrong answers only, the dialogue would end at once. */
void Answer(Dealer& dealer, FalconLoader& loader, const std::vector<std::uint8_t>& written)
{
  const std::size_t due = loader.GetStep().Size;
  const std::vector<std::uint8_t> greeting = { 0x0A, 0x44, 0x2C, 0x0D };
  std::vector<std::uint8_t> answer = written.size() == 3 ? greeting : written;
  answer.erase(answer.begin(), answer.end() - std::min(due, answer.size()));
  switch (dealer.Choose(32))
  {
    case 1:
      return loader.TimeOut();
    case 2:
      answer[dealer.Choose(static_cast<int>(answer.size()))] = dealer.Byte();
      break;
    case 3:
      answer.resize(dealer.Byte());
      break;
    case 4:
      answer = DealBytes(dealer);
      break;
  }
  // An empty answer stands for a timeout. Otherwise, a device that never answers would prevent the
  // dialogue from ending.
  answer.empty() ? loader.TimeOut() : loader.Receive(answer.data(), answer.size());
}

void Load(Dealer& dealer)
{
  std::vector<std::uint8_t> image(std::size_t{ 4 } * dealer.Byte());
  dealer.Fill(image.data(), image.size() / 4);
  FalconLoader loader(image.data(), image.size());
  std::vector<std::uint8_t> written;
  std::size_t confirmed = 0;
  for (int i = 0; i < MostLoaderSteps; ++i)
  {
    const FalconLoaderStep step = loader.GetStep();
    Check(loader.GetConfirmed() >= confirmed, "what is confirmed stays so");
    confirmed = loader.GetConfirmed();
    switch (step.What)
    {
      case FalconLoaderStep::Kind::Write:
        Check(step.Size > 0 && step.Size <= FalconBlockSize, "a block fits into a packet");
        written.assign(step.Bytes, step.Bytes + step.Size);
        [[fallthrough]];
      case FalconLoaderStep::Kind::Request:
        dealer.Choose(64) == 63 ? loader.Refuse() : loader.Done();
        break;
      case FalconLoaderStep::Kind::Read:
        Check(step.Size > 0, "something is due");
        Answer(dealer, loader, written);
        break;
      case FalconLoaderStep::Kind::Finished:
        return Check(confirmed == image.size(), "finished is loaded whole");
      case FalconLoaderStep::Kind::Failed:
        return Check(loader.GetFault() != FalconLoaderFault::None, "a failure has a reason");
    }
  }
  Check(false, "the dialogue comes to an end");
}
} // namespace

void TouchFalcon(const std::uint8_t* bytes, std::size_t size)
{
  Dealer dealer(bytes, size);
  dealer.Choose(4) == 0 ? Load(dealer) : Listen(dealer);
}

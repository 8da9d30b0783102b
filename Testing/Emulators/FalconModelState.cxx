// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "FalconModel.h"

#include <utility>

namespace emulated
{

using Lock = std::lock_guard<std::mutex>;

void FalconModel::Break(FalconFault fault, int packets)
{
  const Lock lock(this->Mutex);
  this->Fault = fault;
  this->FaultyPackets = packets;
}

void FalconModel::SetTimed(bool timed)
{
  // Run the model at half of the device's speed: a round trip through umockdev takes about as long
  // as a real one, so at full speed no answer would be late.
  constexpr int slowness = 2;
  const auto step = [this, tick = 0]() mutable
  {
    if (++tick % slowness == 0)
    {
      this->Deliver();
    }
  };
  auto clock = timed ? std::make_unique<ModelClock>(step) : nullptr;
  {
    const Lock lock(this->Mutex);
    std::swap(this->Clock, clock);
  }
  // The old clock must stop here, outside the lock, because its thread may be waiting for the lock.
}

long FalconModel::GetInStep() const
{
  const Lock lock(this->Mutex);
  return this->InStep;
}

void FalconModel::BreakAttempts(const std::vector<FalconFault>& faults)
{
  const Lock lock(this->Mutex);
  this->Attempts.assign(faults.begin(), faults.end());
}

void FalconModel::SetButtons(int bits)
{
  const Lock lock(this->Mutex);
  this->Buttons = bits;
}

void FalconModel::SetAim(const Numbers& aim)
{
  const Lock lock(this->Mutex);
  this->Grip.Aim = aim;
}

void FalconModel::SetMotorSign(double sign)
{
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->MotorSign = sign;
}

void FalconModel::SetHeld(bool held)
{
  const Lock lock(this->Mutex);
  this->Grip.IsHeld = held;
}

Numbers FalconModel::GetGrip() const
{
  const Lock lock(this->Mutex);
  return this->Grip.Place;
}

Numbers FalconModel::GetHand() const
{
  const Lock lock(this->Mutex);
  return this->Grip.Hand;
}

Numbers FalconModel::GetCommands() const
{
  const Lock lock(this->Mutex);
  return this->Commands;
}

Numbers FalconModel::GetForce() const
{
  const Lock lock(this->Mutex);
  return this->Force;
}

int FalconModel::GetLights() const
{
  const Lock lock(this->Mutex);
  return this->Lights;
}

long FalconModel::GetPackets() const
{
  const Lock lock(this->Mutex);
  return this->Packets;
}

double FalconModel::DrainLargestCommand()
{
  const Lock lock(this->Mutex);
  return std::exchange(this->LargestCommand, 0.0);
}

std::pair<long, std::chrono::steady_clock::time_point> FalconModel::GetLastPush() const
{
  const Lock lock(this->Mutex);
  return this->LastPush;
}

std::vector<std::uint8_t> FalconModel::GetImage() const
{
  const Lock lock(this->Mutex);
  return this->Image;
}

void FalconModel::SetImageSize(std::size_t bytes)
{
  const Lock lock(this->Mutex);
  this->ImageSize = bytes;
}

bool FalconModel::IsRunning() const
{
  const Lock lock(this->Mutex);
  return this->Runs;
}

void FalconModel::SwitchOff()
{
  const Lock lock(this->Mutex);
  this->Runs = false;
  this->Homed = 0;
  this->SeenOut = {};
  this->SeenIn = {};
  this->Commands = {};
  this->Image.clear();
  this->Replies.clear();
  this->Pending.clear();
  this->Late.clear();
}

std::vector<std::string> FalconModel::DrainTranscript()
{
  const Lock lock(this->Mutex);
  return std::exchange(this->Transcript, {});
}

} // namespace emulated

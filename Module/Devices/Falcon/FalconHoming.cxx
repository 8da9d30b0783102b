// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconHoming.h"

namespace VolumeHaptics
{

namespace
{
bool IsOut(const FalconReport& report) noexcept
{
  const FalconPose pose = FalconForward(FalconAnglesOf(report.Encoders));
  return pose.Reach == FalconReach::Reached && pose.Position.Z > FalconReadyHeight;
}
} // namespace

const char* FalconHomingText(FalconHomingState state) noexcept
{
  switch (state)
  {
    case FalconHomingState::OutAndIn:
      return "Pull the grip fully out, then push it fully in";
    case FalconHomingState::Out:
      return "Pull the grip out";
    case FalconHomingState::Ready:
      return "Ready";
    case FalconHomingState::TimedOut:
      return "The grip was not moved through its range in time";
    case FalconHomingState::Lost:
      return "The device has lost its zero";
  }
  return "unknown";
}

void FalconHoming::Enter(FalconHomingState state) noexcept
{
  this->State = state;
  this->Waited = 0.0;
}

void FalconHoming::Restart() noexcept
{
  this->Enter(FalconHomingState::OutAndIn);
  this->Missing = FalconAllHomed;
}

void FalconHoming::Update(double elapsed, const FalconReport* report) noexcept
{
  if (this->State == FalconHomingState::TimedOut || this->State == FalconHomingState::Lost)
  {
    return;
  }
  if (report != nullptr)
  {
    this->Missing = FalconAllHomed & ~report->Homed;
    if (this->State == FalconHomingState::OutAndIn && this->Missing == 0)
    {
      this->Enter(FalconHomingState::Out);
      elapsed = 0.0;
    }
    else if (this->State != FalconHomingState::OutAndIn && this->Missing != 0)
    {
      this->Enter(FalconHomingState::Lost);
      return;
    }
    if (this->State == FalconHomingState::Out && IsOut(*report))
    {
      this->Enter(FalconHomingState::Ready);
    }
  }
  if (this->State != FalconHomingState::Ready)
  {
    this->Waited += elapsed >= 0.0 ? elapsed : this->TimeLimit;
    if (!(this->Waited < this->TimeLimit))
    {
      this->Enter(FalconHomingState::TimedOut);
    }
  }
}

FalconOrder FalconHoming::GetOrder() const noexcept
{
  FalconOrder order;
  switch (this->State)
  {
    case FalconHomingState::OutAndIn:
      order.Lights = FalconHome | FalconRed;
      break;
    case FalconHomingState::Out:
      order.Lights = FalconBlue;
      break;
    case FalconHomingState::Ready:
      order.Lights = FalconGreen;
      break;
    default:
      order.Lights = FalconRed;
      break;
  }
  return order;
}

} // namespace VolumeHaptics

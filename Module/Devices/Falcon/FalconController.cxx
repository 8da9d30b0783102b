// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconController.h"

#include <algorithm>
#include <cstdio>

namespace VolumeHaptics
{
namespace
{

constexpr double MaximumSpeed = 2.5; // m/s
// Least assumed time between two measurements, even if the bus delivers two reports close together.
constexpr double ShortestTime = 1e-3; // s
constexpr double Tolerance = 2e-3;    // m

const char* const Again = "Home() and Arm() again.";

} // namespace

DeviceLimits FalconLimits() noexcept
{
  DeviceLimits limits;
  limits.MaximumForce = 8.0;
  limits.MaximumStiffness = 3000.0;
  limits.MaximumDamping = 20.0;
  limits.MaximumSpeed = MaximumSpeed;
  limits.WorkspaceRadius = 0.04;
  return limits;
}

std::uint32_t FalconButtonsOf(std::uint8_t buttons) noexcept
{
  return ((buttons & FalconCenter) != 0 ? 1u : 0u) | ((buttons & FalconPlus) != 0 ? 2u : 0u) |
    ((buttons & FalconMinus) != 0 ? 4u : 0u) | ((buttons & FalconForwardButton) != 0 ? 8u : 0u);
}

FalconController::FalconController(HardwareExchange& exchange, double homingTime) noexcept
  : Exchange(exchange)
  , Homing(homingTime)
{
  this->ReportState();
}

void FalconController::Restart() noexcept
{
  this->IsStopped = false;
  this->Missed = 0;
  this->Pose = {};
  this->Homing.Restart();
  this->Told = FalconHomingState::Ready;
  this->ReportState();
}

void FalconController::Lose(const char* text) noexcept
{
  if (!this->IsStopped)
  {
    this->IsStopped = true;
    this->Exchange.SetCondition(DeviceStage::Lost, text);
  }
}

void FalconController::ReportState() noexcept
{
  const FalconHomingState state = this->Homing.GetState();
  if (state == this->Told)
  {
    return;
  }
  this->Told = state;
  const char* const text = FalconHomingText(state);
  char whole[160];
  switch (state)
  {
    case FalconHomingState::OutAndIn:
    case FalconHomingState::Out:
      return this->Exchange.SetCondition(DeviceStage::Homing, text);
    case FalconHomingState::Ready:
      return this->Exchange.SetCondition(DeviceStage::Ready, "");
    case FalconHomingState::TimedOut:
      std::snprintf(whole, sizeof(whole), "%s. Home() to try again.", text);
      return this->Lose(whole);
    case FalconHomingState::Lost:
      std::snprintf(whole, sizeof(whole), "%s. %s", text, Again);
      return this->Lose(whole);
  }
}

bool FalconController::IsPossible(const Vector3& position, double elapsed) const noexcept
{
  // Allow twice the speed at which the servo cuts the force off. At a higher speed, the reports
  // themselves are unreliable.
  const double far = Tolerance + 2.0 * MaximumSpeed * std::max(elapsed, ShortestTime);
  return Norm(position - this->Pose.Position) <= std::min(far, LongestStep);
}

void FalconController::UpdateHoming(const FalconReport& report) noexcept
{
  if (this->Homing.GetState() != FalconHomingState::Ready)
  {
    return;
  }
  const FalconPose pose = FalconForward(FalconAnglesOf(report.Encoders));
  if (pose.Reach != FalconReach::Reached)
  {
    return this->Lose(
      "The device's encoders lead to a place out of its reach: they have lost "
      "counts. Home() and Arm() again; if it comes back, switch the device off and on.");
  }
  const bool isFirst = this->Told != FalconHomingState::Ready;
  if (!isFirst && !this->IsPossible(pose.Position, this->SincePose))
  {
    return this->Lose(
      "The device's position jumped as no hand can move: its encoders have lost "
      "counts. Home() and Arm() again; if it comes back, switch the device off and on.");
  }
  this->Pose = pose;
  this->SincePose = 0.0;
  DeviceSample sample;
  sample.Tip = pose.Position - FalconMiddle;
  sample.Buttons = FalconButtonsOf(report.Buttons);
  // Report the sample before the stage becomes Ready, so that no older sample is used.
  this->Exchange.Report(sample);
}

void FalconController::Receive(const FalconReport& report, double elapsed) noexcept
{
  this->Missed = 0;
  if (this->IsStopped)
  {
    return;
  }
  this->SincePose += elapsed;
  this->Homing.Update(elapsed, &report);
  this->UpdateHoming(report);
  if (!this->IsStopped)
  {
    this->ReportState();
  }
}

void FalconController::Miss(double elapsed, const char* why) noexcept
{
  ++this->Missed;
  if (this->IsStopped)
  {
    return;
  }
  this->SincePose += elapsed;
  this->Homing.Update(elapsed, nullptr);
  this->ReportState();
  if (this->Missed >= MostMissed)
  {
    char text[240];
    std::snprintf(text, sizeof(text),
      "The device %s%s. Check its cable and its power supply, then %s",
      why != nullptr ? "sends nothing that makes sense: " : "does not answer",
      why != nullptr ? why : "", Again);
    this->Lose(text);
  }
}

FalconOrder FalconController::GetOrder() noexcept
{
  const int lights = this->Exchange.GetLights();
  FalconOrder order;
  if (this->IsStopped)
  {
    order.Lights = FalconRed;
  }
  else if (this->Homing.GetState() != FalconHomingState::Ready)
  {
    return this->Homing.GetOrder();
  }
  else
  {
    const Vector3 force = this->Exchange.GetForce();
    order.Motors = FalconCommandsOf(this->Pose.Jacobian, force);
    order.Lights = Norm(force) > 0.0 ? FalconBlue : FalconGreen;
  }
  if (lights >= 0)
  {
    order.Lights = FalconColours(lights);
  }
  return order;
}

} // namespace VolumeHaptics

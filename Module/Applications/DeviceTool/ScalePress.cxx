// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/ScalePress.h"

#include <algorithm>
#include <cstdio>

namespace
{

constexpr double PressSpeed = 8e-3; ///< speed of the spring's fixed end while the force grows (m/s)
constexpr double ReleaseSpeed =
  30e-3; ///< speed of the spring's fixed end while the force ends (m/s)
constexpr double ScaleLongestStep = 0.05; ///< longest time step that is integrated (s)
constexpr double MostWay = 40e-3;         ///< largest shift of the spring's fixed end (m)
constexpr double ScaleRestPlace = 0.3e-3; ///< range of the positions of a handle at rest (m)
constexpr double ScaleRestShare =
  0.02; ///< range of the force at rest, as a fraction of the largest force
constexpr double ScaleRestTime = 0.5;    ///< time within these ranges that counts as rest (s)
constexpr double ScaleSettleTime = 10.0; ///< longest wait for rest (s)
constexpr double HeldPlace = 1e-3;       ///< range of the positions of a pressed handle (m)
constexpr double HeldFraction = 0.05;    ///< range of its force, as a fraction of the largest force

} // namespace

ScalePress::ScalePress(const Settings& settings)
  : Given(settings)
  , Rest(ScaleRestPlace, ScaleRestShare * settings.MostForce, ScaleRestTime)
  , Held(HeldPlace, HeldFraction * settings.MostForce, 0.5 * ReadTime)
{
}

std::string ScalePress::GetRequest() const
{
  char text[100];
  switch (this->Now)
  {
    case Phase::Settle:
      return "Let the handle go slowly. Don't touch it from now on.";
    case Phase::Press:
      std::snprintf(text, sizeof(text), "The force rises to %.2f N. Don't touch the handle.",
        this->Given.Level);
      return text;
    case Phase::Hold:
      std::snprintf(text, sizeof(text), "Read the scale now: %.0f s",
        std::max(0.0, HoldTime - this->PhaseTime));
      return this->PhaseTime < HoldTime - ReadTime ? "The scale settles." : text;
    case Phase::Release:
    case Phase::Done:
    case Phase::Refused:
      break;
  }
  return "The force ends.";
}

void ScalePress::Begin(Phase phase)
{
  this->Now = phase;
  this->PhaseTime = 0.0;
}

void ScalePress::Refuse(const std::string& fault)
{
  this->Fault = fault;
  this->Begin(Phase::Refused);
}

void ScalePress::Hold(const HeldSample& sample, double force)
{
  if (this->PhaseTime >= HoldTime)
  {
    this->Begin(Phase::Release);
    return;
  }
  if (this->PhaseTime < HoldTime - ReadTime)
  {
    return;
  }
  this->Sum += sample.Elapsed * force;
  this->SumTime += sample.Elapsed;
  const bool rests = this->Held.Step(sample.Tip[this->Given.Axis], force, sample.Elapsed);
  if (!rests && this->PhaseTime > HoldTime - 0.25 * ReadTime)
  {
    this->Refuse(
      "The handle moves on the scale. Take your hand away, and see that it stands on the "
      "scale safely and can't slip off.");
  }
}

void ScalePress::Step(const HeldSample& sample)
{
  if (this->IsOver())
  {
    return;
  }
  const double force = this->Given.Direction * sample.Force[this->Given.Axis];
  const double elapsed = std::min(sample.Elapsed, ScaleLongestStep);
  this->PhaseTime += sample.Elapsed;
  switch (this->Now)
  {
    case Phase::Settle:
      if (this->Rest.Step(sample.Tip[this->Given.Axis], force, sample.Elapsed))
      {
        this->Begin(Phase::Press);
      }
      else if (this->PhaseTime > ScaleSettleTime)
      {
        this->Refuse("The handle does not come to rest. Let it go, and stand the device firmly.");
      }
      break;
    case Phase::Press:
      this->Way += PressSpeed * elapsed;
      if (force >= this->Given.Level)
      {
        this->Begin(Phase::Hold);
      }
      else if (this->Way > MostWay)
      {
        this->Refuse("The handle meets nothing. Put the scale under it, closer than 2 cm, or name "
                     "the direction to the scale with --axis, such as -y.");
      }
      break;
    case Phase::Hold:
      this->Hold(sample, force);
      break;
    case Phase::Release:
      this->Way = std::max(0.0, this->Way - ReleaseSpeed * elapsed);
      if (this->Way == 0.0)
      {
        this->Begin(Phase::Done);
      }
      break;
    case Phase::Done:
    case Phase::Refused:
      break;
  }
}

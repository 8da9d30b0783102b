// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/LocalSurfaceFitter.h"

#include "Core/Model/HapticModel.h"
#include "Core/Servo/ModelExchange.h"
#include "Core/Servo/ServoClock.h"
#include "Core/Solvers/ServoState.h"

namespace VolumeHaptics
{
namespace
{

/** How often to look whether there is something to do (ns). */
constexpr std::int64_t IdlePeriod = 10000000;
constexpr double NanosecondsPerSecond = 1e9;

} // namespace

std::int64_t LocalSurfaceFitter::Look() noexcept
{
  const std::int64_t now = ServoClock::Now();
  const HapticModel* const model = this->Models.Hold();
  const bool isAsked = model && model->Settings.Method == HapticMethod::LocalSurface;
  const std::int64_t period = isAsked
    ? static_cast<std::int64_t>(NanosecondsPerSecond / model->Settings.LocalSurfaceRate)
    : IdlePeriod;
  if (now - this->Looked >= period)
  {
    this->Looked = std::max(this->Looked + period, now - period);
    if (isAsked && this->Questions.Update())
    {
      const Question& question = this->Questions.Read();
      this->Answers.Write(
        { FitLocalSurface(*model, question.Asked), question.Number, model->BakedNumber });
    }
  }
  this->Models.LetGo();
  // Models and stops are seen soon, however slow the loop is.
  return std::clamp<std::int64_t>(this->Looked + period - now, 0, IdlePeriod);
}

void LocalSurfaceFitter::Run() noexcept
{
  ServoClock::BlockSignals();
  this->Looked = ServoClock::Now();
  while (!this->StopRequested.load(std::memory_order_acquire))
  {
    const std::int64_t wait = this->Look();
    ServoClock::SleepUntil(ServoClock::Now() + wait);
  }
}

LocalAnswer LocalSurfaceFitter::FindAnswer(
  const HapticModel& model, const LocalState& local) noexcept
{
  this->Answers.Update();
  const Answer& answer = this->Answers.Read();
  const bool isMeant = answer.Number == local.Number && answer.Baked == model.BakedNumber;
  return { false, isMeant ? &answer.Surface : nullptr };
}

void LocalSurfaceFitter::Ask(const HapticModel& model, const LocalState& local) noexcept
{
  if (model.Settings.Method == HapticMethod::LocalSurface)
  {
    // With every tick, until there is an answer: the fitter may have taken one for another model.
    this->Questions.Write({ local.Asked, local.Number });
  }
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "LocalSurfaceFitter.h"

#include "HapticModel.h"
#include "ModelExchange.h"
#include "ServoClock.h"

namespace VolumeHaptics
{
namespace
{

/** How often to look whether there is something to do (ns). */
constexpr std::int64_t IdlePeriod = 10000000;
constexpr double NanosecondsPerSecond = 1e9;

} // namespace

void LocalSurfaceFitter::Run() noexcept
{
  ServoClock::BlockSignals();
  std::int64_t planned = ServoClock::Now();
  while (!this->StopRequested.load(std::memory_order_acquire))
  {
    std::int64_t period = IdlePeriod;
    const HapticModel* const model = this->Models.Hold();
    if (model && model->Settings.Method == HapticMethod::LocalSurface)
    {
      period = static_cast<std::int64_t>(NanosecondsPerSecond / model->Settings.LocalSurfaceRate);
      if (this->Questions.Update())
      {
        const Question& question = this->Questions.Read();
        this->Answers.Write(
          { FitLocalSurface(*model, question.Asked), question.Number, &model->Field });
      }
    }
    this->Models.LetGo();
    planned = std::max(planned + period, ServoClock::Now());
    // Stop soon, however slow the loop is.
    while (!this->StopRequested.load(std::memory_order_acquire) && ServoClock::Now() < planned)
    {
      ServoClock::SleepUntil(std::min(planned, ServoClock::Now() + IdlePeriod));
    }
  }
}

LocalAnswer LocalSurfaceFitter::FindAnswer(
  const HapticModel& model, const LocalState& local) noexcept
{
  this->Answers.Update();
  const Answer& answer = this->Answers.Read();
  const bool isMeant = answer.Number == local.Number && answer.Field == &model.Field;
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

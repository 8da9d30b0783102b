// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/LocalSurfaceFitter.h"

#include "Core/Model/HapticModel.h"
#include "Core/Realtime/ServoClock.h"
#include "Core/Servo/ModelExchange.h"
#include "Core/State/ServoState.h"

namespace VolumeHaptics
{
namespace
{

/** Longest time (ns) until the loop polls for a new model or a request to stop. */
constexpr std::int64_t IdlePeriod = 10000000;

} // namespace

std::int64_t LocalSurfaceFitter::Look() noexcept
{
  const std::int64_t now = ServoClock::Now();
  const HapticModel* const model = this->Models.Hold(ModelExchange::Fitter);
  const bool isAsked = model && model->Baked->Settings.Method == HapticMethod::LocalSurface;
  const std::int64_t period = isAsked ? static_cast<std::int64_t>(ServoClock::NanosecondsPerSecond /
                                          model->Baked->Settings.LocalSurfaceRate)
                                      : IdlePeriod;
  if (now - this->Looked >= period)
  {
    this->Looked = std::max(this->Looked + period, now - period);
    if (isAsked && this->Requests.Update())
    {
      const Request& request = this->Requests.Read();
      this->Results.Write(
        { FitLocalSurface(*model, request.Wanted), request.Number, model->Baked->Number });
    }
  }
  this->Models.LetGo(ModelExchange::Fitter);
  // The wait is limited, so that the loop soon notices new models and a request to stop even if its
  // rate is low.
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

LocalSurfaceResult LocalSurfaceFitter::PollResult(
  const HapticModel& model, const LocalState& local) noexcept
{
  this->Results.Update();
  const Result& result = this->Results.Read();
  const bool isMeant = result.Number == local.Number && result.Baked == model.Baked->Number;
  return { false, isMeant ? &result.Surface : nullptr };
}

void LocalSurfaceFitter::Send(const HapticModel& model, const LocalState& local) noexcept
{
  if (model.Baked->Settings.Method == HapticMethod::LocalSurface)
  {
    // Repeat the request in every tick until there is a result, because the fitter may have
    // answered an earlier request with another model.
    this->Requests.Write({ local.Request, local.Number });
  }
}

} // namespace VolumeHaptics

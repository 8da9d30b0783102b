// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TipPathWalk.h"

namespace VolumeHaptics
{

TipPathWalk::TipPathWalk(const TipPath& path, double period)
  : Path(path)
  , Period(period)
  , State(path.InitialState)
{
}

std::shared_ptr<const HapticModel> TipPathWalk::Tick(
  std::shared_ptr<const HapticModel> model, TickRecord& record)
{
  const std::size_t i = this->Next++;
  if (!this->Path.IsRecording)
  {
    this->Step(
      *model, model->WorldToDevice(this->Path.Tips[i]), record, LocalSurfaceResult::Simulated());
    return model;
  }
  // In the order of the servo: the model, then enabling, then the tick.
  const int placement = this->Path.PlacementOf[i];
  if (i == 0 || placement != this->Path.PlacementOf[i - 1])
  {
    auto moved = std::make_shared<const HapticModel>(
      *model, this->Path.Placements[placement], this->Path.Caps[placement]);
    if (i > 0)
    {
      CarryState(*model, *moved, this->State);
    }
    model = std::move(moved);
  }
  if (this->Path.Enabled[i])
  {
    this->State.Enabled = false;
  }
  // A surface counts from the tick in which the result of the slow loop came.
  LocalSurface surface;
  LocalSurfaceResult result;
  if (this->Path.Renewed[i])
  {
    surface = FitLocalSurface(*model, this->State.Local.Request);
    result.Surface = &surface;
  }
  this->Step(*model, this->Path.Tips[i], record, result);
  return model;
}

void TipPathWalk::Step(const HapticModel& model, const Vector3& tip, TickRecord& record,
  const LocalSurfaceResult& result)
{
  this->Servo.Tick(
    model, this->State, tip, model.Baked->Settings.TickPeriod, this->Whole, result, this->Gate);
  record = this->Whole;
  if (this->Gate.GetOpening() < 1.0)
  {
    record.Force = this->Gate.GetOpening() * record.Force;
  }
}

double TipPathWalk::GetTime() const
{
  const std::size_t i = this->Next - 1;
  return this->Path.Times.empty() ? this->Path.StartTime + static_cast<double>(i) * this->Period
                                  : this->Path.Times[i];
}

} // namespace VolumeHaptics

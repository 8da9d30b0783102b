// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/Paths/TipPathWalk.h"

#include "Core/Servo/ServoTick.h"
#include "Core/Tools/PointShell/BakedShell.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{
namespace
{

/**
 * Computes the data time: the first step's at the hand's time 0, and never before the first step's
 * or after the last step's.
 */
double FindDataTime(const HapticModel& model, double time)
{
  const std::vector<FieldFrame>& frames = model.Baked->Frames;
  return frames.empty()
    ? 0.0
    : std::clamp(frames.front().Time + model.Baked->Settings.TimeUnitsPerSecond * time,
        frames.front().Time, frames.back().Time);
}

} // namespace

TipPathWalk::TipPathWalk(const TipReader& tips, const ModelFinder* finder)
  : Tips(tips)
  , Finder(finder)
{
}

TipPathWalk::TipPathWalk(const RecordedPath& recording)
  : Recording(&recording)
  , State(recording.InitialState)
{
}

void TipPathWalk::Tick(const HapticModel& model, TickRecord& record)
{
  // Computes what ResidentServo does where all samples are there.
  const Vector3 tip = model.WorldToDevice(this->Tips->Next());
  this->State.DataTime = FindDataTime(model, this->Tips->GetTime());
  this->TakeHand(model);
  this->ProvideTool(model);
  TickAndServe(model, this->State, tip, record, LocalSurfaceResult::Simulated(), &this->Taps,
    this->Tool.get());
}

void TipPathWalk::ProvideTool(const HapticModel& model)
{
  if (this->ToolOf != model.Baked.get())
  {
    this->ToolOf = model.Baked.get();
    this->Tool = ToolMemory::Provide(*model.Baked, this->Tool);
  }
}

std::shared_ptr<const HapticModel> TipPathWalk::Tick(std::shared_ptr<const HapticModel> model)
{
  if (this->Tips)
  {
    const Vector3 tip = model->WorldToDevice(this->Tips->Next());
    this->State.DataTime = FindDataTime(*model, this->Tips->GetTime());
    this->TakeHand(*model);
    if (this->Finder)
    {
      model = (*this->Finder)(std::move(model), this->State, tip);
    }
    this->Step(*model, tip, LocalSurfaceResult::Simulated());
    return model;
  }
  const RecordedPath& recording = *this->Recording;
  const std::size_t i = this->Next++;
  // Keeps the order of the servo: the model, then enabling, then the tick.
  const int placement = recording.PlacementOf[i];
  if (i == 0 || placement != recording.PlacementOf[i - 1])
  {
    auto moved = std::make_shared<const HapticModel>(
      *model, recording.Placements[placement], recording.Caps[placement]);
    this->ProvideTool(*moved);
    if (i > 0)
    {
      CarryState(*model, *moved, this->State, this->Tool.get());
    }
    else if (this->Tool &&
      !RestoreContacts(
        *this->Tool, *moved->Baked, recording.InitialContacts, recording.ContactShare))
    {
      // The state belongs to another tool; the new tool begins in the hand.
      this->State.Shell = ShellState{};
    }
    model = std::move(moved);
  }
  if (recording.Enabled[i])
  {
    this->State.Enabled = false;
  }
  if (!recording.DataTimes.empty())
  {
    this->State.DataTime = recording.DataTimes[i];
  }
  if (!recording.Orientations.empty())
  {
    this->SetOrientation(recording.Orientations[i]);
  }
  this->TakeRemoval(*model, i);
  // A surface counts from the tick in which the result of the slow loop arrived.
  LocalSurface surface;
  LocalSurfaceResult result;
  if (recording.Renewed[i])
  {
    surface = FitLocalSurface(*model, this->State.Local.Request);
    result.Surface = &surface;
  }
  this->Step(*model, recording.Tips[i], result);
  return model;
}

void TipPathWalk::TakeRemoval(const HapticModel& model, std::size_t i)
{
  const RecordedPath& recording = *this->Recording;
  this->State.IsSpinning = !recording.Spinning.empty() && recording.Spinning[i];
  const RemovalRequest request =
    recording.Requests.empty() ? RemovalRequest::None : recording.Requests[i];
  if (request != RemovalRequest::None && model.Baked->Removal)
  {
    model.Baked->Removal->Request(request);
  }
}

void TipPathWalk::TakeHand(const HapticModel& model)
{
  if (model.Baked->Tool)
  {
    this->State.IsSpinning = this->Tips->IsSpinning();
    const Quaternion world = this->Tips->GetOrientation();
    this->SetOrientation(IsIdentical(world, NoOrientation)
        ? world
        : Conjugate(ToQuaternion(model.DeviceToWorldRotation)) * world);
  }
}

void TipPathWalk::SetOrientation(const Quaternion& orientation)
{
  this->State.HasOrientation = !IsIdentical(orientation, NoOrientation);
  this->State.Orientation = this->State.HasOrientation ? orientation : Quaternion{};
}

Quaternion TipPathWalk::GetOrientation(const HapticModel& model) const
{
  return TurnedBy(model.DeviceToWorldRotation, this->State.Orientation, this->State.HasOrientation);
}

void TipPathWalk::Step(
  const HapticModel& model, const Vector3& tip, const LocalSurfaceResult& result)
{
  this->ProvideTool(model);
  this->Servo.Tick(model, this->State, tip, model.Baked->Settings.TickPeriod, this->Whole, result,
    this->Gate, this->Tool.get());
  if (this->Gate.GetOpening() < 1.0)
  {
    this->Scaled = this->Whole;
    this->Scaled.Force = this->Gate.GetOpening() * this->Whole.Force;
    this->Scaled.Torque = this->Gate.GetOpening() * this->Whole.Torque;
  }
}

const TickRecord& TipPathWalk::GetRecord() const
{
  return this->Gate.GetOpening() < 1.0 ? this->Scaled : this->Whole;
}

ModeForces TipPathWalk::FindModeForces(const HapticModel& model) const
{
  ModeForces forces = VolumeHaptics::FindModeForces(model, this->State);
  for (Vector3& force : forces)
  {
    force = this->Gate.GetOpening() * force;
  }
  return forces;
}

double TipPathWalk::GetTime() const
{
  return this->Tips ? this->Tips->GetTime() : this->Recording->Times[this->Next - 1];
}

} // namespace VolumeHaptics

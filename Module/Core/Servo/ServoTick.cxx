// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/ServoTick.h"

#include "Core/Solvers/Methods/Methods.h"
#include "Core/Solvers/SurfaceProxy/SurfaceProxy.h"

#include <utility>

namespace VolumeHaptics
{
namespace
{

/** Computes a tick of the method, in which the hand feels with a point. */
inline void StepMethod(const HapticModel& model, ServoState& state, TickRecord& record,
  const LocalSurfaceResult& result, TickMemory* memory) noexcept
{
  GetMethod(model.Baked->Settings).Step(model, state, record, { result, memory });
}

/** The tick of a tool. The tool may also use the method's point. */
class MethodTick final : public ToolTick
{
public:
  MethodTick(const HapticModel& model, ServoState& state, TickRecord& record, ToolMemory* tool,
    const LocalSurfaceResult& result, TickMemory* taps) noexcept
    : ToolTick(model, state, record, tool)
    , Result(result)
    , Taps(taps)
  {
  }

  void FeelPoint() const noexcept override
  {
    StepMethod(this->Model, this->State, this->Record, this->Result, this->Taps);
  }

private:
  const LocalSurfaceResult& Result;
  TickMemory* const Taps;
};

/** Ends the force, because removed tissue may be restored at the hand's position. */
void Rest(
  const HapticModel& model, ServoState& state, const Vector3& tip, TickRecord& record) noexcept
{
  record = TickRecord{};
  record.Tip = record.Proxy = tip;
  record.DataTime = state.DataTime;
  record.Normal = model.FallbackNormal;
  record.IsServed = true;
  record.Value = record.SurfaceValue = record.MediumValue = model.ValueAtDevice(record.Tip);
  state.Proxy = state.PreviousTip = record.Tip;
  state.Enabled = false;
  static_cast<ToolStates&>(state) = ToolStates{};
}

} // namespace

void Tick(const HapticModel& model, ServoState& state, const Vector3& tip, TickRecord& record,
  const LocalSurfaceResult& result, TickMemory* memory, ToolMemory* tool) noexcept
{
  if (!IsNear(tip, FarthestTip))
  {
    record = TickRecord{};
    record.Tip = tip;
    record.Proxy = state.Proxy;
    state.Enabled = false;
    return;
  }
  // The methods below may leave these members unset, so set them first.
  record.Tip = tip;
  record.DataTime = state.DataTime;
  record.Force = Vector3{};
  record.NormalForce = record.FrictionForce = record.DragForce = record.WallWork = 0.0;
  record.MayLeap = false;
  record.Leap = Vector3{};
  record.LeapStiffness = 0.0;
  record.Depth = record.ShaftForce = record.RemovedVolume = 0.0;
  record.ToolNumbers = {};
  record.Request = RemovalRequest::None;
  record.IsServed = false;
  record.Torque = Vector3{};
  record.ToolOrientation = record.HandOrientation = NoOrientation;
  record.Contact = ContactState::Free;
  record.IsUnfinished = record.IsRenewed = false;

  bool hasOwnLaw = false;
  if (const BakedTool* const held = model.Baked->Tool.get())
  {
    if (!state.Enabled)
    {
      state.LetGo();
    }
    hasOwnLaw = held->Step(MethodTick(model, state, record, tool, result, memory));
  }
  else
  {
    StepMethod(model, state, record, result, memory);
  }
  if (model.Baked->Removal || model.Baked->Others)
  {
    // Read the value now, because a later tick may remove the tissue here.
    record.Value = model.ValueAtDevice(record.Proxy);
  }
  state.Proxy = record.Proxy;
  state.CarriedTo = state.DataTime;
  state.Stiffness = record.Stiffness;
  state.SurfaceStrength = record.SurfaceStrength;
  if (!state.Enabled || hasOwnLaw)
  {
    state.Release = ReleaseState{};
  }
  else
  {
    ReleaseProxy(model.Baked->Settings, tip - state.PreviousTip, state.Release, record);
  }
  state.PreviousTip = tip;
  state.Enabled = true;

  const double limit = model.Baked->Settings.MaximumForce;
  if (limit > 0.0)
  {
    record.Force = ClampNorm(record.Force, limit);
  }
}

void TickAndServe(const HapticModel& model, ServoState& state, const Vector3& tip,
  TickRecord& record, const LocalSurfaceResult& result, TickMemory* memory,
  ToolMemory* tool) noexcept
{
  TissueRemoval* const removal = model.Baked->Removal.get();
  RemovalRequest begun = RemovalRequest::None;
  if (removal && IsNear(tip, FarthestTip) && removal->Serve(&begun))
  {
    Rest(model, state, tip, record);
    record.Request = begun;
    return;
  }
  if (const TissueRemoval* const others = model.Baked->Others.get())
  {
    // The other hand, which has the tool, serves its requests. Read the number of pending requests
    // first. Otherwise a request that is finished meanwhile would be missed.
    const bool isServed = others->HasWork();
    const std::size_t done = others->GetDone();
    if ((std::exchange(state.OthersRequests, done) != done || isServed) && IsNear(tip, FarthestTip))
    {
      Rest(model, state, tip, record);
      return;
    }
  }
  Tick(model, state, tip, record, result, memory, tool);
}

Vector3 ComputeDrag(
  const HapticModel& model, const ServoState& before, const TickRecord& record) noexcept
{
  const Method& method = GetMethod(model.Baked->Settings);
  return method.Drag ? method.Drag(model, before, record) : Vector3{};
}

void CarryState(
  const HapticModel& from, const HapticModel& to, ServoState& state, ToolMemory* tool) noexcept
{
  const bool isRegion = !from.Resident.IsWhole() || !to.Resident.IsWhole();
  const bool isSeries = from.Baked->IsMoving() && to.Baked->IsMoving();
  if ((isRegion || isSeries) && from.Baked->Number == to.Baked->Number &&
    IsIdentical(from.DeviceToWorld, to.DeviceToWorld))
  {
    // Another region of the same volume, or other time steps, do not change the felt force.
    return;
  }
  const auto carry = [&](const Vector3& x) { return to.WorldToDevice(from.DeviceToWorld(x)); };
  const HapticSettings& was = from.Baked->Settings;
  const HapticSettings& is = to.Baked->Settings;
  bool beginsAnew = false;
  if (from.Baked->Tool)
  {
    beginsAnew = from.Baked->Tool->Carry(from, to, state, tool);
  }
  else
  {
    static_cast<ToolStates&>(state) = ToolStates{};
  }
  if (to.Baked->Tool)
  {
    to.Baked->Tool->Begin(state);
  }
  // A coarse image and the data that replace it have surfaces at different positions. The proxy
  // must not end up on the other side of the surface.
  const bool isOtherSurface = from.Baked->ResidentShare != to.Baked->ResidentShare &&
    was.Method == HapticMethod::SurfaceProxy && is.Method == HapticMethod::SurfaceProxy &&
    IsOutsideSurface(from, state.Proxy, state.DataTime);
  state.Proxy = carry(state.Proxy);
  if (isOtherSurface)
  {
    state.Proxy = EnterSurface(to, state.Proxy, state.DataTime);
  }
  state.Precise.ReachedTip = carry(state.Precise.ReachedTip);
  state.Precise.Spring.DropReserve();
  state.Precise.CachedSampleDistance = PreciseState::Unknown;
  state.Precise.StepPrediction = 1.0;
  const bool isOther = was.Method != is.Method;
  if (isOther || was.Solver != is.Solver || beginsAnew)
  {
    // A method or solver updates only its own state, so reset the others.
    state.Precise = PreciseState{};
    state.Precise.ReachedTip = carry(state.PreviousTip);
  }
  if (isOther)
  {
    const Vector3 outside = EnterSurface(to, state.Proxy, state.DataTime);
    state.Proxy = is.Method == HapticMethod::SurfaceProxy ? outside : state.Proxy;
    StartLocalSurface(to.DeviceToWorld(outside), to.DeviceToWorld(state.PreviousTip), state.Local);
  }
  if (isOther || from.Baked->Number != to.Baked->Number)
  {
    // The forces belong to the old volume's primitives.
    state.Primitives = PrimitiveMemory{};
  }
  // The proxy is held by a level, which is a value of the old volume.
  state.Precise.IsHeld = state.Precise.IsHeld && from.Baked->Number == to.Baked->Number;
}

} // namespace VolumeHaptics

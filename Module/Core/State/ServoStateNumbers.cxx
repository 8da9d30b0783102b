// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/State/ServoStateNumbers.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <type_traits>

namespace VolumeHaptics
{
namespace
{

template <typename Vector, typename Function>
void VisitVector(Vector& v, Function&& visit)
{
  visit(v.X);
  visit(v.Y);
  visit(v.Z);
}

template <typename Shape, typename Function>
void VisitQuadric(Shape& shape, Function&& visit)
{
  VisitVector(shape.Centre, visit);
  VisitVector(shape.Gradient, visit);
  VisitVector(shape.Curvature.Diagonal, visit);
  VisitVector(shape.Curvature.Mixed, visit);
}

template <typename State, typename Function>
void VisitPrecise(State& precise, Function&& visit)
{
  VisitVector(precise.ReachedTip, visit);
  visit(precise.Level);
  visit(precise.IsHeld);
  visit(precise.Spring.Tissue);
  visit(precise.Spring.Tension);
  visit(precise.Spring.Reserve);
  visit(precise.StepPrediction);
  auto& here = precise.Here;
  VisitVector(here.Normal, visit);
  visit(here.GradientMagnitude);
  visit(here.SurfaceValue);
  visit(here.MediumValue);
  visit(here.Stiffness);
  visit(here.Friction);
  visit(here.Viscosity);
  visit(here.SurfaceStrength);
  visit(here.Value);
  visit(here.Slope);
  visit(precise.CachedSampleDistance);
}

template <typename State, typename Function>
void VisitLocal(State& local, Function&& visit)
{
  visit(local.Surface.IsThere);
  VisitQuadric(local.Surface.Shape, visit);
  VisitVector(local.Position, visit);
  visit(local.IsHeld);
  VisitVector(local.Tip, visit);
  VisitVector(local.Fading, visit);
  visit(local.Fall);
  visit(local.Age);
  visit(local.Number);
  VisitVector(local.Request.Position, visit);
  VisitVector(local.Request.Ahead, visit);
  VisitVector(local.Request.Normal, visit);
}

/**
 * Reads a number. Returns false if the type can't represent it; the value is then harmless.
 */
bool Read(double number, double& value)
{
  value = number;
  return std::isfinite(number);
}

bool Read(double number, bool& value)
{
  value = number != 0.0;
  return number == 0.0 || number == 1.0;
}

bool Read(double number, std::uint32_t& value)
{
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  const bool isGood = number >= 0.0 && number <= most && number == std::floor(number);
  value = isGood ? static_cast<std::uint32_t>(number) : 0;
  return isGood;
}

bool Read(double number, float& value)
{
  value = static_cast<float>(number);
  return std::isfinite(value);
}

/**
 * Reads a label. It is a whole number that a double represents exactly, or NoLabel, which it
 * represents, too.
 */
bool Read(double number, std::int64_t& value)
{
  constexpr double most = 9007199254740992.0; // 2^53
  const bool isNone = number == static_cast<double>(NoLabel);
  const bool isGood = isNone || (std::abs(number) <= most && number == std::floor(number));
  value = isGood && !isNone ? static_cast<std::int64_t>(number) : NoLabel;
  return isGood;
}

bool Read(double number, int& value)
{
  const bool isGood = number >= 0.0 && number <= NeedleTrack::Most && number == std::floor(number);
  value = isGood ? static_cast<int>(number) : 0;
  return isGood;
}

template <typename Needle, typename Function>
void VisitNeedle(Needle& needle, Function&& visit)
{
  visit(needle.IsInserted);
  visit(needle.IsOutside);
  VisitVector(needle.Axis, visit);
  VisitVector(needle.Normal, visit);
  VisitVector(needle.Entry, visit);
  visit(needle.Depth);
  visit(needle.Deepest);
  visit(needle.Stiffness);
  visit(needle.Puncture);
  visit(needle.PuncturedAt);
  visit(needle.PuncturedLabel);
  VisitVector(needle.Motion, visit);
  visit(needle.Pushed);
  visit(needle.Touches);
  visit(needle.IsTouching);
  // If numbers are being read, the visit changes the copy `size`, so store it afterwards.
  int size = needle.Track.GetSize();
  visit(size);
  if constexpr (!std::is_const_v<Needle>)
  {
    needle.Track.SetSize(size);
  }
  for (int i = 0; i < NeedleTrack::Most; ++i)
  {
    visit(needle.Track[i].Begin);
    visit(needle.Track[i].Shaft);
    visit(needle.Track[i].Label);
  }
}

template <typename Orientation, typename Function>
void VisitQuaternion(Orientation& q, Function&& visit)
{
  visit(q.W);
  visit(q.X);
  visit(q.Y);
  visit(q.Z);
}

template <typename Shell, typename Function>
void VisitShell(Shell& shell, Function&& visit)
{
  visit(shell.Enabled);
  visit(shell.IsCarried);
  for (auto* const pose : { &shell.Tool, &shell.Hand })
  {
    VisitVector(pose->Position, visit);
    VisitQuaternion(pose->Orientation, visit);
  }
  visit(shell.Budget);
  visit(shell.Sum.Energy);
  for (auto& number : shell.Sum.Gradient)
  {
    visit(number);
  }
  for (auto& number : shell.Sum.Curvature)
  {
    visit(number);
  }
  visit(shell.Sum.Contacts);
  visit(shell.Sum.Yielding);
}

template <typename Burr, typename Function>
void VisitBurr(Burr& burr, Function&& visit)
{
  visit(burr.IsCarving);
  visit(burr.IsRemoved);
  VisitVector(burr.Carved, visit);
  visit(burr.Unspent);
  visit(burr.LastCost);
  visit(burr.LastWay);
  visit(burr.Idle);
  visit(burr.Phase);
  visit(burr.Lost);
  VisitVector(burr.Vibration, visit);
  VisitVector(burr.Next, visit);
  visit(burr.Part);
  visit(burr.Shorter);
}

/**
 * Visits all numbers of a state. Newer numbers come after older ones, because older files lack
 * them.
 */
template <typename State, typename Function>
void VisitState(State& state, Function&& visit)
{
  VisitVector(state.Proxy, visit);
  VisitVector(state.PreviousTip, visit);
  visit(state.Enabled);
  VisitPrecise(state.Precise, visit);
  VisitLocal(state.Local, visit);
  // The newer numbers, after the older ones.
  auto& here = state.Precise.Here;
  visit(here.Far.Ahead);
  visit(here.Far.Behind);
  visit(here.Far.Evenness);
  visit(here.FarLasts);
  visit(state.DataTime);
  visit(state.CarriedTo);
  visit(state.Stiffness);
  visit(state.SurfaceStrength);
  visit(state.Local.Request.DataTime);
  for (auto& force : state.Primitives.Forces)
  {
    VisitVector(force, visit);
  }
  visit(state.Primitives.Rate);
  VisitVector(state.Primitives.Towards, visit);
  VisitQuaternion(state.Orientation, visit);
  visit(state.HasOrientation);
  VisitNeedle(state.Needle, visit);
  VisitShell(state.Shell, visit);
  visit(state.IsSpinning);
  VisitBurr(state.Burr, visit);
  VisitVector(state.Release.Force, visit);
  visit(state.Release.Stiffness);
  visit(state.Release.Saved);
  visit(state.Burr.Room);
  ToolStates::VisitLast(state, visit);
}

/** Limit of a position (world units). It is beyond FarthestTip, even in micrometres. */
constexpr double FarthestPlace = 1e15;
/** Tolerance for the rounding of a unit vector's length. */
constexpr double DirectionTolerance = 1e-6;
/**
 * Limit of a number in newtons, newtons per metre or joules. Products of two such numbers do not
 * overflow.
 */
constexpr double MostOfMaterial = 1e100;
/** Limit (N) of a primitive's force. It is at least twice the largest force of a primitive. */
constexpr double MostOfForce = 2e6;
/** Limit of the length of PrimitiveMemory::Towards. */
constexpr double MostOfDirection = 10.0;
/** Limit of a learned prediction. The solver Precise learns only smaller ones. */
constexpr double MostStatePrediction = 2.0;

/** Returns whether a vector has unit length, or is 0 for an unknown direction. */
bool IsDirection(const Vector3& v)
{
  const double square = Dot(v, v);
  return square == 0.0 || std::abs(square - 1.0) <= DirectionTolerance;
}

bool IsAmount(double x)
{
  return x >= 0.0 && x <= MostOfMaterial;
}

bool IsPossible(const PreciseState& precise)
{
  const PassiveSpring& spring = precise.Spring;
  const PrecisePoint& here = precise.Here;
  return IsNear(precise.ReachedTip, FarthestTip) && IsAmount(spring.Tissue) &&
    spring.Tension >= 0.0 && spring.Tension <= 1.0 && IsAmount(spring.Reserve) &&
    precise.StepPrediction > 0.0 && precise.StepPrediction <= MostStatePrediction &&
    IsDirection(here.Normal) && here.GradientMagnitude >= 0.0 && IsAmount(here.Stiffness) &&
    IsAmount(here.Friction) && IsAmount(here.Viscosity) && IsAmount(here.SurfaceStrength) &&
    here.Far.Evenness >= 0.0 && here.Far.Evenness <= 1.0 && here.FarLasts >= 0.0 &&
    precise.CachedSampleDistance >= 0.0;
}

bool IsPossible(const LocalState& local)
{
  const Quadric& shape = local.Surface.Shape;
  return IsNear(shape.Centre, FarthestPlace) && IsDirection(shape.Gradient) &&
    IsNear(shape.Curvature.Diagonal, FarthestPlace) &&
    IsNear(shape.Curvature.Mixed, FarthestPlace) && IsNear(local.Position, FarthestPlace) &&
    IsNear(local.Tip, FarthestPlace) && IsNear(local.Fading, FarthestPlace) && local.Fall >= 0.0 &&
    local.Fall < FarthestPlace && IsNear(local.Request.Position, FarthestPlace) &&
    IsNear(local.Request.Ahead, FarthestPlace) && IsDirection(local.Request.Normal);
}

bool IsPossible(const PrimitiveMemory& primitives)
{
  return IsAmount(primitives.Rate) && IsNear(primitives.Towards, MostOfDirection) &&
    std::all_of(primitives.Forces.begin(), primitives.Forces.end(),
      [](const Vector3& force) { return IsNear(force, MostOfForce); });
}

bool IsPossible(const NeedleState& needle)
{
  const auto isLength = [](double length) { return length >= 0.0 && length < FarthestTip; };
  const bool hasTrack = !needle.IsInserted || needle.Track.GetSize() > 0;
  const bool hasAxis = !needle.IsInserted || Dot(needle.Axis, needle.Axis) > 0.0;
  const bool hasSpring = !needle.IsInserted || needle.Stiffness > 0.0;
  return hasTrack && hasAxis && hasSpring && IsDirection(needle.Axis) &&
    IsDirection(needle.Normal) && IsNear(needle.Entry, FarthestTip) &&
    IsNear(needle.Motion, FarthestTip) && isLength(needle.Depth) && isLength(needle.Deepest) &&
    IsAmount(needle.Stiffness) && IsAmount(needle.Puncture) && isLength(needle.PuncturedAt) &&
    isLength(needle.Pushed) && needle.Track.IsPossible();
}

/** Returns whether an orientation that is marked as valid is a unit quaternion. */
bool IsPossible(Quaternion orientation, bool isValid)
{
  return !isValid || MakeUnit(orientation);
}

bool IsPossible(const ShellState& shell)
{
  const auto isPose = [](const ShellPose& pose)
  { return IsNear(pose.Position, FarthestTip) && IsPossible(pose.Orientation, true); };
  const auto isNumber = [](double number) { return std::abs(number) <= MostOfMaterial; };
  const ShellSum& sum = shell.Sum;
  // Files from before shells have zeros here, which is possible because the state is not enabled.
  return !shell.Enabled ||
    (isPose(shell.Tool) && isPose(shell.Hand) && IsAmount(shell.Budget) && IsAmount(sum.Energy) &&
      std::all_of(std::begin(sum.Gradient), std::end(sum.Gradient), isNumber) &&
      std::all_of(std::begin(sum.Curvature), std::end(sum.Curvature), isNumber) &&
      sum.Yielding <= sum.Contacts);
}

bool IsPossible(const BurrState& burr)
{
  return IsNear(burr.Carved, FarthestTip) && IsAmount(burr.Unspent) && IsAmount(burr.LastCost) &&
    burr.LastWay >= 0.0 && burr.LastWay < FarthestTip && IsAmount(burr.Idle) && burr.Phase >= 0.0 &&
    burr.Phase <= 1.0 && std::abs(burr.Lost) <= MostOfMaterial &&
    IsNear(burr.Vibration, MostOfMaterial) && IsNear(burr.Next, FarthestTip) &&
    burr.Shorter >= 0.0 && burr.Shorter < FarthestTip && burr.Room >= 0.0 &&
    burr.Room < FarthestTip;
}

bool IsPossible(const ReleaseState& release)
{
  return IsNear(release.Force, MostOfForce) && IsAmount(release.Stiffness) &&
    IsAmount(release.Saved);
}

} // namespace

std::array<double, ServoStateSize> ToNumbers(const ServoState& state) noexcept
{
  std::array<double, ServoStateSize> numbers;
  std::size_t i = 0;
  VisitState(state, [&](auto value) { numbers[i++] = static_cast<double>(value); });
  return numbers;
}

ServoState FromNumbers(const std::array<double, ServoStateSize>& numbers) noexcept
{
  ServoState state;
  std::size_t i = 0;
  VisitState(state, [&](auto& value) { Read(numbers[i++], value); });
  return state;
}

bool AreOfAState(const std::array<double, ServoStateSize>& numbers) noexcept
{
  ServoState state;
  std::size_t i = 0;
  bool isGood = true;
  VisitState(state, [&](auto& value) { isGood = Read(numbers[i++], value) && isGood; });
  return isGood && IsNear(state.Proxy, FarthestTip) && IsNear(state.PreviousTip, FarthestTip) &&
    IsAmount(state.Stiffness) && IsAmount(state.SurfaceStrength) && IsPossible(state.Precise) &&
    IsPossible(state.Local) && IsPossible(state.Primitives) && IsPossible(state.Needle) &&
    IsPossible(state.Orientation, state.HasOrientation) && IsPossible(state.Shell) &&
    IsPossible(state.Burr) && IsPossible(state.Release);
}

} // namespace VolumeHaptics

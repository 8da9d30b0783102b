// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Primitives/PrimitiveFollower.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/**
 * Largest correction of a step's end, as a fraction of the step, towards the end of the path that
 * the stages predict. Farther from the step's end, the weights of the stages lose an order.
 */
constexpr double Farthest = 0.1;

/**
 * Returns where the path ends, as a fraction of a step. It is the zero of the quadratic through the
 * remaining lengths at 0, 1/2 and 3/4 of the step.
 */
double ComputeEnd(double atBegin, double atMiddle, double late) noexcept
{
  const double early = 2.0 * (atMiddle - atBegin);
  const double bend = (4.0 / 3.0) * (4.0 * (late - atMiddle) - early);
  const double atEnd = atBegin + early + 0.5 * bend;
  const double slope = early + 1.5 * bend;
  // The comparison is false for NaN, too.
  return slope < 0.0 ? 1.0 + std::clamp(-atEnd / slope, -Farthest, Farthest) : 1.0;
}

constexpr double LeastRate = 0.25;
constexpr double MostRate = 1e12; // reached a picometre away from the axis of a vortex
/** A step is restarted if the rate at its middle exceeds the expected rate by this factor. */
constexpr double RateExcess = 1.01;

/** The path of a proxy to the balance with one tip. */
class Way
{
public:
  Way(const PrimitiveField& field, double k, const Vector3& from, const Vector3& tip,
    PrimitiveMemory& memory) noexcept
    : Field(field)
    , Stiffness(k)
    , Tip(tip)
    , Memory(memory)
    , Place(from)
  {
    this->Arrive(from, memory.Towards);
  }

  /** Makes one step. Returns the rate that the step has measured. */
  double Step(double rate, double longest) noexcept
  {
    const double across = this->ComputeRateAcross();
    this->Shown = {};
    return across > 0.0 ? this->StepAcross(across)
      : this->Length < PrimitiveFollower::ShortFraction * rate * longest
      ? this->StepShortly(rate)
      : this->StepFar(rate, longest);
  }

  /** Return the rest of the motion, and its length (m). */
  const Vector3& GetRest() const noexcept { return this->Rest; }
  double GetLength() const noexcept { return this->Length; }
  bool IsSpent() const noexcept { return this->SweepsLeft <= 0; }
  const Vector3& GetPlace() const noexcept { return this->Place; }
  const PrimitiveBalance& GetBalance() const noexcept { return this->Balance; }

private:
  double StepFar(double rate, double longest) noexcept
  {
    const Vector3 from = this->Place;
    const double before = this->Length;
    const Vector3 first = (1.0 / before) * this->Rest;
    double length = std::min(before / rate, longest);
    const Vector3 middle = this->ComputeMiddle(first, rate, length);
    const Vector3 second = Along(middle, first);
    const Vector3 late =
      this->SolveRest(from + (0.75 * length) * second, 1.5 * second - 0.5 * first);
    const Vector3 third = Along(late, second);
    const double most = longest / length;
    const double fraction =
      std::min(ComputeEnd(before, Dot(middle, second), Dot(late, third)), most);
    // Compute the direction at the end of the step from the quadratic through the stages, and its
    // integrals.
    const Vector3 last = 1.0 / 3.0 * first - 2.0 * second + 8.0 / 3.0 * third;
    const double square = fraction * fraction;
    const double ofFirst = fraction + square * (8.0 / 9.0 * fraction - 5.0 / 3.0);
    const double ofSecond = square * (3.0 - 8.0 / 3.0 * fraction);
    const double ofThird = square * (16.0 / 9.0 * fraction - 4.0 / 3.0);
    this->Arrive(from + length * (ofFirst * first + ofSecond * second + ofThird * third), last);
    this->Memory.Towards = last;
    if (fraction < most)
    {
      this->Shown = before * (1.0 + fraction * (8.0 / 3.0 * fraction - 10.0 / 3.0)) * first +
        fraction * (6.0 - 8.0 * fraction) * middle +
        fraction * (16.0 / 3.0 * fraction - 8.0 / 3.0) * late;
      this->EndRate = before / (fraction * length);
    }
    return Rate((before - Dot(this->Rest, third)) / (fraction * length));
  }

  /**
   * Returns the rate of the rest across the path after a long step, as the stages predict it, or 0
   * if they do not predict it. Let m be the ratio of this rate to the rate along the path. The
   * weights of the stages leave the fraction (1 - m) (1 - 5/3 m + 4/3 m^2) of the part across, and
   * the quadratic through the stages predicts (1 - m) (1 - 2 m) of it at the end of the step. The
   * ratio of both determines m.
   */
  double ComputeRateAcross() const noexcept
  {
    const double shown = Dot(this->Shown, this->Shown);
    const double ratio = Dot(this->Rest, this->Shown) / shown;
    const Vector3 other = this->Rest - ratio * this->Shown;
    // The comparisons are false for NaN, too.
    if (!(ratio < -0.5 && ratio > -1.0) || Dot(other, other) > 0.01 * this->Length * this->Length)
    {
      return 0.0;
    }
    const double half = 5.0 / 6.0 - ratio;
    const double root = half * half - 4.0 / 3.0 * (1.0 - ratio);
    return root > 0.0 ? this->EndRate * 0.75 * (half - std::sqrt(root)) : 0.0;
  }

  /**
   * Makes a step that ends slightly before the end of the rest, because a primitive would hold the
   * proxy if it went too far.
   */
  double StepAcross(double rate) noexcept
  {
    const double before = this->Length;
    const Vector3 first = (1.0 / before) * this->Rest;
    const double length = 0.98 * before / rate;
    this->Arrive(this->Place + length * first, first);
    return Rate((before - Dot(this->Rest, first)) / length);
  }

  /** Makes a step by the midpoint method, to where D ends if it falls at the rate of the middle. */
  double StepShortly(double rate) noexcept
  {
    const Vector3 from = this->Place;
    const double before = this->Length;
    const Vector3 first = (1.0 / before) * this->Rest;
    double length = before / rate;
    const Vector3 middle = this->ComputeMiddle(first, rate, length);
    const Vector3 second = Along(middle, first);
    // End the step where the middle is valid, because a primitive would hold the proxy if it went
    // farther.
    const double end = before / Rate((before - Dot(middle, second)) / (0.5 * length));
    length = std::min(end, (1.0 + Farthest) * length);
    this->Arrive(from + length * second, second);
    this->Memory.Towards = second;
    return Rate((before - Dot(this->Rest, second)) / length);
  }

  /**
   * Computes the rest at the middle of a step. If the step is too long, shortens it and computes
   * the rest again.
   */
  Vector3 ComputeMiddle(const Vector3& first, double rate, double& length) noexcept
  {
    const double before = this->Length;
    const Vector3 middle = this->SolveRest(this->Place + (0.5 * length) * first, first);
    const double met = (before - Dot(middle, first)) / (0.5 * length);
    const double shorter = before / std::min(met, MostRate);
    // The comparison is false for NaN, too.
    if (met > RateExcess * rate && shorter < length)
    {
      length = shorter;
      return this->SolveRest(this->Place + (0.5 * length) * first, first);
    }
    return middle;
  }

  /** Limits a measured rate to the range from LeastRate to MostRate. */
  static double Rate(double met) noexcept
  {
    return met > LeastRate ? std::min(met, MostRate) : LeastRate;
  }

  /**
   * Returns the direction of the rest, reversed if it points backwards, or `before` if there is no
   * rest.
   */
  static Vector3 Along(const Vector3& rest, const Vector3& before) noexcept
  {
    const double length = Norm(rest);
    return length > 0.0 ? std::copysign(1.0 / length, Dot(rest, before)) * rest : before;
  }

  /**
   * Computes the balance at a place. Returns the rest of the motion.
   * @param towards expected direction of the rest
   */
  Vector3 SolveRest(const Vector3& place, const Vector3& towards) noexcept
  {
    PrimitiveSet set;
    this->Field.Collect(this->Field.Context, place, set);
    this->Balance = Minimise(
      set, this->Stiffness, this->Tip, this->Memory.Forces, std::max(this->SweepsLeft, 1), towards);
    this->SweepsLeft -= this->Balance.Sweeps;
    return this->Balance.Proxy - place;
  }

  void Arrive(const Vector3& place, const Vector3& towards) noexcept
  {
    this->Place = place;
    this->Rest = this->SolveRest(place, towards);
    this->Length = Norm(this->Rest);
  }

  const PrimitiveField& Field;
  const double Stiffness;
  const Vector3& Tip;
  PrimitiveMemory& Memory;
  Vector3 Place;
  Vector3 Rest;
  /** Rest that the stages predict after a long step at the end of the path, and otherwise 0. */
  Vector3 Shown;
  double EndRate = 0.0;
  double Length = 0.0;
  int SweepsLeft = PrimitiveSolver::MostSweeps; ///< number of sweeps that the tick may still use
  PrimitiveBalance Balance;
};

} // namespace

PrimitiveMotion SolvePrimitives(const PrimitiveField& field, double k, double longestStep,
  const Vector3& from, const Vector3& tip, PrimitiveMemory& memory) noexcept
{
  // The comparison is false for NaN, too.
  if (!(longestStep > 0.0) || !IsFinite(from))
  {
    memory = {};
    return { tip, {}, 0, false };
  }
  // The memory may come from a file, so limit its values.
  memory.Rate = memory.Rate > LeastRate ? std::min(memory.Rate, MostRate) : LeastRate;
  PrimitiveMotion motion;
  Way way(field, k, from, tip, memory);
  const double finished = PrimitiveFollower::FinishedFraction * longestStep;
  // The next tick's path will be similar to this one, but not to the short corrections at its end,
  // which therefore do not change the stored rate.
  const double told = PrimitiveFollower::ShortFraction * way.GetLength();
  double rate = memory.Rate;
  while (
    way.GetLength() > finished && motion.Steps < PrimitiveFollower::MostSteps && !way.IsSpent())
  {
    const bool tells = way.GetLength() > told;
    rate = way.Step(rate, longestStep);
    memory.Rate = tells ? rate : memory.Rate;
    ++motion.Steps;
  }
  const bool isThere = way.GetLength() <= finished;
  motion.Proxy = way.GetPlace();
  motion.Force = way.GetBalance().Force;
  motion.IsUnfinished = !isThere || way.GetBalance().IsUnfinished;
  if (isThere)
  {
    motion.Proxy += (1.0 / std::max(rate, 1.0)) * way.GetRest();
  }
  return motion;
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Precise/FarSide.h"

#include <cmath>
#include <limits>

namespace VolumeHaptics
{
namespace
{

/** Smallest rise that counts. The reciprocal of a smaller rise might not be finite. */
constexpr double LeastRise = std::numeric_limits<double>::min();

/** Returns a smooth step that rises from 0 at `low` to 1 at `high`. */
double SmoothStep(double low, double high, double x) noexcept
{
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/** The walk from the proxy to one side. */
struct Walk
{
  double Far;    ///< value of the side so far
  double Last;   ///< V at the last sample
  double Valley; ///< Far at the smallest rise since the largest one
  /**
   * Rise of V along the gradient in this step. Before the first step, it is the gradient's rise.
   */
  double Rise;
  double Weight = 1.0;
  /** Rise where the walk ends, as a fraction of the largest rise. */
  double EndRise = 0.0;
  double EndRiseInValley = 0.0; ///< EndRise at the smallest rise since the largest one
  double Change = 0.0;          ///< change of V in this step
  double Largest = 0.0;
  double LargestBefore = 0.0; ///< largest rise before this step
  double First = 0.0;         ///< rise of the first step
  int Steps = 0;
  /** Smallest rise since the largest one. */
  double Smallest = std::numeric_limits<double>::infinity();
  double Pair = 0.0; ///< rise of the present pair of steps
  double LeastPair = std::numeric_limits<double>::infinity();
  double LargestPair = 0.0;

  /**
   * Moves on to the next sample.
   * @param sign 1 if V rises in the direction of this walk, else -1
   */
  void Step(double value, double sign) noexcept
  {
    this->Change = value - this->Last;
    this->Rise = sign * this->Change;
    this->Last = value;
    this->LargestBefore = this->Largest;
    this->Largest = std::max(this->Largest, this->Rise);
    this->First = this->Steps++ == 0 ? this->Rise : this->First;
    this->Pair += this->Rise;
    if (this->Steps % 2 == 0)
    {
      this->AddPair(this->Pair);
    }
  }

  /**
   * Completes the last pair if the walk stopped at the border after its first step. That step then
   * counts twice.
   */
  void AddRest() noexcept
  {
    if (this->Steps % 2 != 0)
    {
      this->AddPair(2.0 * this->Pair);
    }
  }

  void AddPair(double rise) noexcept
  {
    this->LeastPair = std::min(this->LeastPair, rise);
    this->LargestPair = std::max(this->LargestPair, rise);
    this->Pair = 0.0;
  }

  /**
   * Adds the last step to the side's value.
   * @param opposite the walk to the other side, after the same step
   */
  void Add(const Walk& opposite, double inverseOfMost) noexcept
  {
    const bool isLargest = this->Rise >= this->Largest;
    const bool isValley = isLargest || this->Rise <= this->Smallest;
    this->Smallest = std::min(this->Smallest, this->Rise);
    // Between two edges, the position belongs to the edge on whose flank it is, unless it is on a
    // plateau.
    const double flank = SmoothStep(FarSide::Flat, FarSide::Steep, this->First * inverseOfMost);
    const double hill =
      std::min(this->Rise, std::max(this->LargestBefore, flank * opposite.Largest));
    const double before =
      1.0 - SmoothStep(FarSide::Rise, FarSide::NextEdge, (hill - this->Smallest) * inverseOfMost);
    const double relative = std::max(this->Rise * inverseOfMost, 0.0);
    const double goesOn = SmoothStep(FarSide::Flat, FarSide::Steep, relative);
    this->Far = this->Valley + before * (this->Far - this->Valley);
    this->EndRise = this->EndRiseInValley + before * (this->EndRise - this->EndRiseInValley);
    this->Weight *= before;
    const double ends = this->Weight * (1.0 - goesOn);
    this->Weight *= goesOn;
    this->Far += (this->Weight + (relative > 0.0 ? 0.5 * ends : 0.0)) * this->Change;
    this->EndRise += ends * relative;
    this->Smallest = isLargest ? this->Rise : this->Smallest;
    this->Valley = isValley ? this->Far : this->Valley;
    this->EndRiseInValley = isValley ? this->EndRise : this->EndRiseInValley;
  }
};

/**
 * Returns the evenness E of a ramp (FarSide.h).
 * @param rise rise of a pair of steps according to the gradient
 */
double ComputeEvenness(const Walk& ahead, const Walk& behind, double rise) noexcept
{
  const double found = std::min(ahead.LeastPair, behind.LeastPair);
  // If no pair of steps was inside the volume, use the gradient's rise.
  const double least = std::isfinite(found) ? found : rise;
  const double largest = std::max(rise, std::max(ahead.LargestPair, behind.LargestPair));
  // The comparisons are false if a rise or a ratio is NaN.
  return least > 0.0 && largest > LeastRise && least <= largest ? least / largest : 0.0;
}

} // namespace

FarValues MeasureFarSide(const FieldAtTime& field, const Vector3& index, const Vector3& reach,
  double radius, double rise, bool isDescending) noexcept
{
  const double part = radius / (FarSide::StepsPerRadius * Norm(reach));
  const Vector3 step = part * reach;
  const double sign = isDescending ? -1.0 : 1.0;
  const double start = field.Value(index);
  Walk ahead{ start, start, start, part * rise };
  Walk behind{ start, start, start, part * rise };
  bool goesAhead = true;
  bool goesBehind = true;
  for (int j = 1; j <= FarSide::MostSteps; ++j)
  {
    const Vector3 offset = static_cast<double>(j) * step;
    goesAhead = goesAhead && field.IsInside(index + offset);
    goesBehind = goesBehind && field.IsInside(index - offset);
    const ValuePair values = field.Values(index, offset);
    if (goesAhead)
    {
      ahead.Step(values.Ahead, sign);
    }
    if (goesBehind)
    {
      behind.Step(values.Behind, -sign);
    }
    const double most = std::max(part * rise, std::max(ahead.Largest, behind.Largest));
    const double inverse = most > LeastRise ? 1.0 / most : 0.0;
    if (goesAhead)
    {
      ahead.Add(behind, inverse);
    }
    if (goesBehind)
    {
      behind.Add(ahead, inverse);
    }
    const bool isDone =
      (!goesAhead || ahead.Weight == 0.0) && (!goesBehind || behind.Weight == 0.0);
    // Ripple can reduce both weights to 0, too, so a ramp is checked over the whole walk.
    if (isDone && ComputeEvenness(ahead, behind, 2.0 * part * rise) <= FarSide::EdgeEvenness)
    {
      break;
    }
  }
  ahead.AddRest();
  behind.AddRest();
  const double evenness = ComputeEvenness(ahead, behind, 2.0 * part * rise);
  const auto finite = [start](double far) { return std::isfinite(far) ? far : start; };
  const double tail = FarSide::Tail * (ahead.Far - behind.Far);
  return { finite(ahead.Far + ahead.EndRise * tail), finite(behind.Far - behind.EndRise * tail),
    evenness };
}

} // namespace VolumeHaptics

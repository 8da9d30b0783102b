// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How a hand drifts by itself: a line through the last tips, and whether it foretells the next.
 *
 * The line is fitted to the tips of a quarter of a second by least squares: long enough for two
 * cycles of a hand's tremor (8 to 12 Hz), which then hardly tilts it. A slow swing looks like a
 * line for as long, but does not go on along it: so the tips of 0.4 s are kept, and a line through
 * the older ones has to foretell the newer ones.
 */
#ifndef DriftLine_h
#define DriftLine_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

class DriftLine
{
public:
  /** Time (s) between two stored tips. */
  static constexpr double Spacing = 0.008;
  /** The number of stored tips, and the number of tips that a line is fitted to. */
  static constexpr int Capacity = 50;
  static constexpr int Fitted = 31;

  /** Removes all tips. */
  void Reset() noexcept;
  /** Adds a measured tip (m) at a time (s). Tips closer in time than Spacing are left out. */
  void Add(const Vector3& tip, double time) noexcept;
  bool IsFull() const noexcept { return this->Count == Capacity; }

  /**
   * Returns the largest distance (m) of the newer tips, along each axis, from a line through the
   * older tips. Call it only when all places are full.
   */
  Vector3 ComputeSurprise() noexcept;

  /** Fits the line to the newest tips. Call it only when all places are full. */
  void Fit() noexcept { this->FitFrom(Capacity - Fitted); }
  ///@{
  /**
   * Results of the last fit: the place at a time (m); the slope (m/s); and, along each axis, the
   * root mean square distance of the tips from the line (m).
   */
  Vector3 GetPlace(double time) const noexcept
  {
    return this->Middle + (time - this->MiddleTime) * this->Velocity;
  }
  const Vector3& GetVelocity() const noexcept { return this->Velocity; }
  const Vector3& GetSpread() const noexcept { return this->Spread; }
  ///@}

private:
  struct Entry
  {
    Vector3 Tip;
    double Time = 0.0;
  };
  /** Returns an entry by age: 0 is the oldest. */
  const Entry& Get(int i) const noexcept { return this->Entries[(this->Next + i) % Capacity]; }
  Vector3 GetDistance(int i) const noexcept
  {
    return this->Get(i).Tip - this->GetPlace(this->Get(i).Time);
  }
  void FitFrom(int first) noexcept;

  Entry Entries[Capacity];
  int Count = 0;
  int Next = 0; ///< the oldest entry, when full
  double LastTime = 0.0;
  Vector3 Middle;
  double MiddleTime = 0.0;
  Vector3 Velocity;
  Vector3 Spread;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Predicts where a hand drifts by itself, by a line through the last tips, and checks whether such
 * a line predicts the next tips.
 *
 * The line is fitted by least squares to the tips of a quarter of a second. This is long enough for
 * two cycles of a hand's tremor (8 to 12 Hz), so that tremor hardly tilts the line. A slow swing
 * also looks like a line over this time, but soon leaves it. To detect this, the tips of 0.4 s are
 * stored, and a line through the older ones must predict the newer ones.
 */
#ifndef DriftLine_h
#define DriftLine_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

class DriftLine
{
public:
  /** Shortest time (s) between two stored tips. */
  static constexpr double Spacing = 0.008;
  /** Number of stored tips, and the number of tips to which a line is fitted. */
  static constexpr int Capacity = 50;
  static constexpr int Fitted = 31;

  void Reset() noexcept;
  /**
   * Adds a measured tip (m) at a time (s). Ignores a tip that comes less than Spacing after the
   * last one.
   */
  void Add(const Vector3& tip, double time) noexcept;
  bool IsFull() const noexcept { return this->Count == Capacity; }

  /**
   * Returns, for each axis, the largest distance (m) of the newer tips from a line through the
   * older tips. Must be called only if IsFull() is true.
   */
  Vector3 ComputeSurprise() noexcept;

  /** Fits the line to the newest tips. Must be called only if IsFull() is true. */
  void Fit() noexcept { this->FitFrom(Capacity - Fitted); }
  ///@{
  /**
   * Return results of the last fit: the line's position at a time (m), its slope (m/s), and for
   * each axis the root mean square distance of the tips from the line (m).
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
  /** Returns an entry, in the order of age. 0 is the oldest. */
  const Entry& Get(int i) const noexcept { return this->Entries[(this->Next + i) % Capacity]; }
  Vector3 GetDistance(int i) const noexcept
  {
    return this->Get(i).Tip - this->GetPlace(this->Get(i).Time);
  }
  void FitFrom(int first) noexcept;

  Entry Entries[Capacity];
  int Count = 0;
  int Next = 0; ///< index of the oldest entry if all are used
  double LastTime = 0.0;
  Vector3 Middle;
  double MiddleTime = 0.0;
  Vector3 Velocity;
  Vector3 Spread;
};

} // namespace VolumeHaptics

#endif

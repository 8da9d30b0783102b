// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The samples of a volume from which a tool has removed tissue:
 *
 *   V' = V - (1 - rho) (V - V_air),
 *
 * where rho is the fraction that remains. Where tissue was removed, a kernel reads a copy of the
 * few samples that it needs, as doubles. Elsewhere it reads the samples themselves, so the result
 * equals that without removal, to the bit.
 */
#ifndef CarvedSamples_h
#define CarvedSamples_h

#include "Core/Carving/CarvedBricks.h"
#include "Core/Field/VolumeView.h"

namespace VolumeHaptics
{

/**
 * The remaining fractions, and the value of a sample without tissue. The pointer to the bricks is
 * null if nothing can be removed.
 */
struct CarvedView
{
  const CarvedBricks* Bricks = nullptr;
  double Air = 0.0;

  /** Returns whether any tissue was removed. */
  bool HasAny() const noexcept { return this->Bricks && !this->Bricks->IsEmpty(); }
  /**
   * Returns a sample's value after the removal. If all of the sample's tissue remains, returns
   * `value` itself, to the bit.
   * @param fraction 0 to CarvedBricks::Whole, or a mean of such fractions
   */
  double Left(double value, double fraction) const noexcept
  {
    constexpr double scale = 1.0 / CarvedBricks::Whole;
    return value - scale * (CarvedBricks::Whole - fraction) * (value - this->Air);
  }
};

/** A box of samples, both ends included. It is at most MostSide samples long along each axis. */
struct CarvedBox
{
  static constexpr std::int64_t MostSide = 64;

  std::int64_t Low[3];
  std::int64_t High[3];

  std::int64_t Size(int axis) const noexcept { return this->High[axis] - this->Low[axis] + 1; }
  std::int64_t Samples() const noexcept { return this->Size(0) * this->Size(1) * this->Size(2); }
};

/**
 * Returns the box of the samples that a kernel reads at a position: from `before` samples before
 * the position's cell to `behind` samples after it, limited to the resident samples. Clamps the
 * position to the resident samples first.
 */
CarvedBox ComputeBox(
  const VolumeView& view, const double* position, int before, int behind) noexcept;

/**
 * Copies the samples of a box to `to`, x fastest, with the removal applied. `copy` receives a view
 * of them with the indices of the whole volume; only samples in the box may be read. Returns false
 * and copies nothing if no tissue was removed in the box.
 * @param whole a view whose Data points to the volume's first sample (WholeData)
 */
bool CopyCarved(const VolumeView& whole, const CarvedView& carved, const CarvedBox& box, double* to,
  VolumeView& copy) noexcept;

} // namespace VolumeHaptics

#endif

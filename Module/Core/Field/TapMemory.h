// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TapMemory_h
#define TapMemory_h

#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{

/**
 * The samples of the last gradient, as numbers to compute with, stored from one tick to the next: a
 * hand stays within a voxel for many ticks. They change no result.
 */
struct TapMemory
{
  static constexpr int MostTaps = 6; ///< along an axis

  std::uint64_t Field = 0;             ///< the number of the FieldSampler; 0: no samples
  std::int64_t First[3] = { 0, 0, 0 }; ///< the index of the first tap along each axis
  /** Pairs of rows along x, in the layout of RowPair. */
  alignas(32) double Taps[MostTaps * MostTaps * MostTaps];
};

/**
 * The samples around the last gradient in two blended time steps, to blend them with any fraction.
 * Rows lie along x as in a volume, so that values can be read from them, too.
 */
struct TimeStepTaps
{
  static constexpr int MostTaps = TapMemory::MostTaps;
  /** The numbers in a row of N taps: whole vectors. */
  template <int N>
  static constexpr int Line = (N + 3) / 4 * 4;
  static constexpr int Most = MostTaps * MostTaps * Line<MostTaps>;

  std::uint64_t Field = 0;       ///< number of the first time step, as TapMemory::Field
  std::uint64_t SecondField = 0; ///< number of the second time step
  std::int64_t First[3] = { 0, 0, 0 };
  alignas(64) double Taps[Most];    ///< the first time step's
  alignas(64) double Changes[Most]; ///< the second time step's minus the first time step's
};

/** The samples of two time steps, blended: TapMemory::Field is the first time step. */
struct BlendMemory : TapMemory
{
  std::uint64_t SecondField = 0;
  double Fraction = 0.0; ///< the second time step's
};

/**
 * The memories of a tick: one for each of the two time steps between which a volume moves, if each
 * is read at its own place; one for both, if they are blended; and one for each of two blends, as a
 * tick goes from one instant to another. A time step has the same memory before and after it; a
 * volume that stands still has the first one.
 */
struct TickMemory
{
  TapMemory TimeSteps[2];
  TimeStepTaps Pair;
  BlendMemory Blends[2];
  int OldBlend = 0; ///< the blend to replace next

  TapMemory& Of(std::size_t timeStep) noexcept { return this->TimeSteps[timeStep % 2]; }
};

} // namespace VolumeHaptics

#endif

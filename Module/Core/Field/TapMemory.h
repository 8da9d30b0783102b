// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TapMemory_h
#define TapMemory_h

#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{

/**
 * The samples of the last gradient, stored as numbers from one tick to the next, because a hand
 * stays within a voxel for many ticks. The memory changes no result.
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
  /** The length of a row of N taps, rounded up to whole vectors. */
  template <int N>
  static constexpr int Line = (N + 3) / 4 * 4;
  static constexpr int Most = MostTaps * MostTaps * Line<MostTaps>;

  std::uint64_t Field = 0;       ///< number of the first time step, as TapMemory::Field
  std::uint64_t SecondField = 0; ///< number of the second time step
  std::int64_t First[3] = { 0, 0, 0 };
  alignas(64) double Taps[Most];    ///< taps of the first time step
  alignas(64) double Changes[Most]; ///< taps of the second time step, minus Taps
};

/** The samples of two time steps, blended: TapMemory::Field is the first time step. */
struct BlendMemory : TapMemory
{
  std::uint64_t SecondField = 0;
  double Fraction = 0.0; ///< fraction of the second time step
};

/**
 * The memories of a tick. If each time step is read at its own place, each of the two time steps
 * has a memory; if they are blended, both share a memory, and each of the two instants of a tick
 * has a memory for its blend. A time step keeps its memory when the volume moves past it; a volume
 * that stands still uses the first memory.
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

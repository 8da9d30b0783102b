// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TapMemory_h
#define TapMemory_h

#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{

/**
 * The samples that the last gradient used. They are kept for the next ticks, because a hand stays
 * within a voxel for many ticks. The memory saves time and changes no result.
 */
struct TapMemory
{
  static constexpr int MostTaps = 6; ///< largest number of taps along an axis

  std::uint64_t Field = 0; ///< number of the FieldSampler; 0 if the memory has no samples
  std::int64_t First[3] = { 0, 0, 0 }; ///< index of the first tap along each axis
  /** Pairs of rows along x, in the layout of RowPair. */
  alignas(32) double Taps[MostTaps * MostTaps * MostTaps];
};

/**
 * The samples around the last gradient in two time steps, which can be blended with any fraction.
 * As in a volume, rows are along x, so that values can be computed from them, too.
 */
struct TimeStepTaps
{
  static constexpr int MostTaps = TapMemory::MostTaps;
  /** Length of a row of N taps, rounded up to whole vectors. */
  template <int N>
  static constexpr int Line = (N + 3) / 4 * 4;
  static constexpr int Most = MostTaps * MostTaps * Line<MostTaps>;

  std::uint64_t Field = 0;       ///< number of the first time step, like TapMemory::Field
  std::uint64_t SecondField = 0; ///< number of the second time step
  std::int64_t First[3] = { 0, 0, 0 };
  alignas(64) double Taps[Most];    ///< taps of the first time step
  alignas(64) double Changes[Most]; ///< taps of the second time step minus Taps
};

/** The blended samples of two time steps. TapMemory::Field is the first time step's number. */
struct BlendMemory : TapMemory
{
  std::uint64_t SecondField = 0;
  double Fraction = 0.0; ///< weight of the second time step
};

/**
 * The memories of a tick. If both time steps are read at different places, each has its own memory
 * (TimeSteps). If they are blended, they share a memory (Pair), and the blend at each of the tick's
 * two instants has its own (Blends). A time step keeps its memory when the data time passes it. A
 * volume that does not move uses only the first memory.
 */
struct TickMemory
{
  TapMemory TimeSteps[2];
  TimeStepTaps Pair;
  BlendMemory Blends[2];
  int OldBlend = 0; ///< index of the blend to replace next

  TapMemory& Of(std::size_t timeStep) noexcept { return this->TimeSteps[timeStep % 2]; }
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Data times of the time steps of a moving volume, and the choice of the steps that the servo
 * needs.
 */
#ifndef TimeSteps_h
#define TimeSteps_h

#include "Core/Servo/DataClock.h"

#include <cstddef>
#include <vector>

namespace VolumeHaptics
{

struct TimeSteps
{
  std::vector<double> Times; ///< ascending
  bool AreComponents = false;
  bool AreInMemory = false; ///< whether all time steps are in the source's memory

  /**
   * The pair of neighbouring steps First and First + 1 that time is between, and the step that it
   * needs next.
   */
  struct Need
  {
    std::size_t First;
    std::size_t Next;
  };
  /** Returns the steps that are needed when time advances from a data time. */
  Need ComputeNeed(double time, bool isBackward, Playback mode) const;

  std::size_t After(std::size_t step) const { return (step + 1) % this->Times.size(); }
  std::size_t Before(std::size_t step) const
  {
    return (step + this->Times.size() - 1) % this->Times.size();
  }
  /** Whether the servo gets all steps in one time span. */
  bool AreAllAtOnce() const
  {
    constexpr std::size_t most = 3;
    return this->AreComponents || this->AreInMemory || this->Times.size() <= most;
  }
};

} // namespace VolumeHaptics

#endif

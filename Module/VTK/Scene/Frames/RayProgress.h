// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Estimates how long all rays of a frame will take, from those already cast.
 */
#ifndef RayProgress_h
#define RayProgress_h

#include <optional>

namespace VolumeHaptics
{

/**
 * Estimates the time of a whole frame while a mapper casts its rays row by row. Work before the
 * rays, such as the gradients of a new volume, counts as measured. After a tenth of the rows, the
 * other rows are assumed to be alike.
 */
class RayProgress
{
public:
  static constexpr double LeastShare = 0.1;

  /** The rays begin. `time`: since the beginning of the frame, s. */
  void Begin(double time)
  {
    this->Before = time;
    this->Whole.reset();
  }
  /** Records the finished fraction of the rows. `time`: as above. */
  void Note(double time, double share)
  {
    if (share >= LeastShare)
    {
      this->Whole = this->Before + (time - this->Before) / share;
    }
  }
  /** Forgets the frame. */
  void Clear() { this->Whole.reset(); }
  /** The time of the frame with all its rays, s; empty while too few are cast. */
  const std::optional<double>& GetWhole() const { return this->Whole; }

private:
  double Before = 0.0;
  std::optional<double> Whole;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures the delay of positions and forces in the servo loop.
 *
 * Let a device measure its tip at the times m, and let a(m) be the time at which it receives the
 * force for such a measurement. Until it receives the force for the next measurement m', at a(m'),
 * its force belongs to a position that the tip has left: the force of a spring of stiffness k is
 * wrong by k times the length of the motion since m. On average over that time, the age of the
 * position is
 *
 *   ((a(m) - m) + (a(m') - m)) / 2 = T / 2
 *
 * where T is called the *round trip*. The force of a spring that is late by T / 2 has a component
 * along the motion of k T / 2 times the speed. The device's own friction b must absorb it: k <= 2 b
 * / T. If the device receives its force at once, T = m' - m, its period. If the force takes d to
 * arrive, T = m' - m + 2 d: a delay counts twice.
 *
 * A device that is silent at rest stays at its last position, so this position does not age
 * (DeviceSample::Alive). Its period is measured only between two reports with a motion of several
 * times its smallest step.
 */
#ifndef LoopTiming_h
#define LoopTiming_h

#include "Core/Safety/DeviceBackend.h"
#include "Core/Servo/RecentDurations.h"

namespace VolumeHaptics
{

class LoopTiming
{
public:
  /**
   * Longest interval (ns) that counts as a period. During a longer one, the device rested, or
   * something blocked it.
   */
  static constexpr std::int64_t LongestPeriod = 30000000;

  /**
   * @param leastMotion smallest step (m) of a device that is silent at rest
   * (DeviceLimits::LeastMotion)
   */
  explicit LoopTiming(double leastMotion) noexcept
    : LeastMotion(leastMotion)
  {
  }

  ///@{
  /**
   * Records a sample that has a Time. `now` is in ns. Returns the time (s) of the tip's motion from
   * its last position, by the device's own clock. If the thread that receives the reports was
   * delayed, the result is at least a typical report period. It is 0 for the first sample, and if
   * the sample is not new. The servo calls this once in each tick.
   */
  double RecordSample(const DeviceSample& sample, std::int64_t now) noexcept;
  /** Records a force that the device has received. Ignores a repeated or older force. */
  void RecordTaken(const TakenForce& taken) noexcept;
  ///@}

  ///@{
  /**
   * Return upper estimates (s) over about the last second, or 0 until they are known. Any thread
   * may call these.
   */
  double GetReportPeriod() const noexcept;
  double GetRoundTrip() const noexcept;
  ///@}

private:
  struct Measurement
  {
    std::int64_t Time = 0;  ///< time in ns
    std::int64_t Until = 0; ///< end of the time (ns) during which the tip stayed there
    bool TellsPeriod = false;
  };
  static constexpr std::size_t Kept = 32;
  const Measurement* Find(std::int64_t time) const noexcept;

  const double LeastMotion;
  std::array<Measurement, Kept> Last{}; ///< a ring buffer
  std::uint64_t Count = 0;
  Vector3 Tip;              ///< position of the tip at the last measurement
  std::int64_t AliveAt = 0; ///< last time (ns) at which the device reported no motion
  bool Continues = false;   ///< whether the next motion of the tip begins at the last measurement
  TakenForce Acting;
  RecentDurations Reports;
  RecentDurations RoundTrips;
};

} // namespace VolumeHaptics

#endif

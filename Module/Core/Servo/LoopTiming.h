// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The time that positions and forces take through the servo loop, as it is measured.
 *
 * Let a device measure its tip at the times m, and let it take the force that answers such a
 * measurement at a(m). From then until it takes the force of the next measurement m', at a(m'), it
 * pushes according to a place that the tip has left: the force of a spring of stiffness k is wrong
 * by k times the way since m, along the motion. On the average over that time the place is
 *
 *   ((a(m) - m) + (a(m') - m)) / 2 = T / 2
 *
 * old, where T is called the *round trip*. The pull of a spring that is late by T / 2 has a part k
 * T / 2 times the speed, along the motion, which the device's own friction b has to take: k <= 2 b
 * / T. If the device takes its force at once, T = m' - m, its period. If the force takes d on its
 * way, T = m' - m + 2 d: a delay counts twice.
 *
 * A device that is silent at rest stays at its last place, so that its place does not get old
 * (DeviceSample::Alive). Its period is only measured between two reports with a motion of several
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
  /** A longer interval (ns) is no period: the device rested, or something stood still. */
  static constexpr std::int64_t LongestPeriod = 30000000;

  /**
   * `leastMotion` is the smallest step (m) of a device that is silent at rest:
   * DeviceLimits::LeastMotion.
   */
  explicit LoopTiming(double leastMotion) noexcept
    : LeastMotion(leastMotion)
  {
  }

  ///@{
  /**
   * Records a sample, with a Time, at a time `now` (ns). Returns the time (s) that the tip took
   * from its last place, by the device's own clock: at least a typical report period, if the thread
   * that takes the reports was held up; 0 if the sample is not new, or the first. Called by the
   * servo once in a tick.
   */
  double RecordSample(const DeviceSample& sample, std::int64_t now) noexcept;
  /** Records a force that the device has taken; a repeated or older force changes nothing. */
  void RecordTaken(const TakenForce& taken) noexcept;
  ///@}

  ///@{
  /** Return upper figures (s) of about the last second; 0 until they are known. From any thread. */
  double GetReportPeriod() const noexcept;
  double GetRoundTrip() const noexcept;
  ///@}

private:
  struct Measurement
  {
    std::int64_t Time = 0;  ///< ns
    std::int64_t Until = 0; ///< ns: the end of the time in which the tip stayed there
    bool TellsPeriod = false;
  };
  static constexpr std::size_t Kept = 32;
  const Measurement* Find(std::int64_t time) const noexcept;

  const double LeastMotion;
  std::array<Measurement, Kept> Last{}; ///< a ring
  std::uint64_t Count = 0;
  Vector3 Tip;              ///< the tip at the last measurement
  std::int64_t AliveAt = 0; ///< ns, the last time at which the device reported no motion
  bool Continues = false;   ///< whether the next tip continues the motion from the last one
  TakenForce Acting;
  RecentDurations Reports;
  RecentDurations RoundTrips;
};

} // namespace VolumeHaptics

#endif

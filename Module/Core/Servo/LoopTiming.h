// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The time that positions and forces take through the servo loop, as it is measured.
 *
 * Let a device measure its tip at the times m, and let it take the force that answers such a
 * measurement at a(m). From then until it takes the force of the next one, at a(m'), it pushes by a
 * place that the tip has left: a spring of stiffness k pulls by k times the way since m, along the
 * motion. On the average over that time the place is
 *
 *   ((a(m) - m) + (a(m') - m)) / 2 = T / 2
 *
 * old, where T is called the *round trip*. The pull of a spring that is late by T / 2 has a part
 * k T / 2 times the speed, along the motion, which the device's own friction b has to take:
 * k <= 2 b / T. A device that takes its force in no time has T = m' - m, its period. A force that
 * takes d on its way makes it m' - m + 2 d: a delay counts twice.
 *
 * A device that is silent at rest is at its last place all the time, so that its place does not get
 * old (DeviceSample::Alive). Nor do its rests tell anything about its period: only two reports
 * between which it moved by several times its smallest step do.
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

  /** The smallest step (m) of a device that is silent at rest: DeviceLimits::LeastMotion. */
  explicit LoopTiming(double leastMotion) noexcept
    : LeastMotion(leastMotion)
  {
  }

  ///@{
  /**
   * The servo's side, once a tick: the sample, with a Time, at a time `now` (ns). The result is the
   * time (s) in which the tip has come here from the last place, by the device's own clock: no less
   * than a typical report period, if the thread was held up that takes the reports. 0 if the sample
   * brings no news, or the first.
   */
  double NoteSample(const DeviceSample& sample, std::int64_t now) noexcept;
  /** A force that the device has taken; the same one again, or an older one, changes nothing. */
  void NoteTaken(const TakenForce& taken) noexcept;
  ///@}

  ///@{
  /** Any thread: upper figures (s) of the last second or so; 0 as long as they are not known. */
  double GetReportPeriod() const noexcept;
  double GetRoundTrip() const noexcept;
  ///@}

private:
  struct Measurement
  {
    std::int64_t Time = 0;  ///< ns
    std::int64_t Until = 0; ///< ns: the tip was there until then
    bool TellsPeriod = false;
  };
  static constexpr std::size_t Kept = 32;
  const Measurement* Find(std::int64_t time) const noexcept;

  const double LeastMotion;
  std::array<Measurement, Kept> Last{}; ///< a ring
  std::uint64_t Count = 0;
  Vector3 Tip;              ///< of the last one
  std::int64_t AliveAt = 0; ///< ns: the device said there was nothing new
  bool Continues = false;   ///< the next one comes from the place of the last one
  TakenForce Acting;
  RecentDurations Reports;
  RecentDurations RoundTrips;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * Moves a handle slowly up and down past a position, and measures the force there, free of
 * friction.
 */
#ifndef HandleSweep_h
#define HandleSweep_h

#include "Applications/DeviceTool/HeldSample.h"

#include <vector>

/**
 * A spring holds the handle, and the sweep shifts the spring's fixed end along an axis: up until
 * the handle is Reach above the position, down until it is equally far below, and so on. The mean
 * force of an upward sweep, within Window of the position, includes the friction; the mean of a
 * downward sweep includes it with the opposite sign. The average of both means has no friction,
 * neither Coulomb nor viscous, because both sweeps are equally fast. Half of the difference is the
 * friction.
 */
class HandleSweep
{
public:
  static constexpr double Speed = 4e-3;   ///< speed of the spring's fixed end (m/s)
  static constexpr double Reach = 1.5e-3; ///< distance of both turning points from the position (m)
  static constexpr double Window = 1e-3;  ///< half of the range that the force is averaged over (m)

  /// Mean of the forces on an upward sweep and on the downward sweep before it.
  struct Reading
  {
    std::array<double, 3> Force{}; ///< N, without friction
    double Friction = 0.0;         ///< friction along the axis (N)
  };

  /// Begins `pairs` sweeps up and down past a position (m). The spring's fixed end is at `shift`
  /// (m).
  void Begin(int axis, double place, double shift, int pairs);
  void Step(const HeldSample& sample);

  /// Returns the shift of the spring's fixed end (m).
  double GetShift() const { return this->Shift; }
  bool IsDone() const { return this->Readings.size() == this->Pairs; }
  /// Returns whether the handle is stuck: the current sweep takes longer than MostTime.
  bool IsStuck() const { return this->WayTime > MostTime; }
  const std::vector<Reading>& GetReadings() const { return this->Readings; }

private:
  static constexpr double MostTime = 10.0; ///< longest time of one sweep (s)

  void EndWay();

  int Axis = 0;
  double Place = 0.0;
  double Shift = 0.0;
  std::size_t Pairs = 0;
  double Direction = 1.0;
  double WayTime = 0.0;
  int Ways = 0;
  /// integral of the force over time in the window, on this sweep (N s)
  std::array<double, 3> Sum{};
  double SumTime = 0.0;
  std::array<double, 3> Down{}; ///< mean force on the last downward sweep (N)
  std::vector<Reading> Readings;
};

#endif

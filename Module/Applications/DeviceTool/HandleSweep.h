// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Moves a handle slowly up and down past a place, and measures the force there, without friction.
 */
#ifndef HandleSweep_h
#define HandleSweep_h

#include "Applications/DeviceTool/HeldSample.h"

#include <vector>

/**
 * A spring holds the handle, and the sweep shifts the spring's fixed end along an axis: up until
 * the handle is Reach above the place, down until it is as far below, and so on. The mean force of
 * a way up, within Window of the place, includes the whole friction; the mean of a way down
 * includes it with the opposite sign. Their mean has no friction, neither Coulomb's nor viscous,
 * since both ways are equally fast. Half of the difference is the friction.
 */
class HandleSweep
{
public:
  static constexpr double Speed = 4e-3;   ///< speed of the spring's fixed end (m/s)
  static constexpr double Reach = 1.5e-3; ///< m
  static constexpr double Window = 1e-3;  ///< m

  /// The mean of a way up and of the way down before it.
  struct Reading
  {
    std::array<double, 3> Force{}; ///< N, without friction
    double Friction = 0.0;         ///< friction along the axis (N)
  };

  /// Begins `pairs` sweeps up and down past a place (m), with the spring's fixed end at `shift`
  /// (m).
  void Begin(int axis, double place, double shift, int pairs);
  void Step(const HeldSample& sample);

  /// Returns the shift of the spring's fixed end (m).
  double GetShift() const { return this->Shift; }
  bool IsDone() const { return this->Readings.size() == this->Pairs; }
  /// Whether the handle does not follow: the present way takes longer than MostTime.
  bool IsStuck() const { return this->WayTime > MostTime; }
  const std::vector<Reading>& GetReadings() const { return this->Readings; }

private:
  static constexpr double MostTime = 10.0; ///< s, for one way

  void EndWay();

  int Axis = 0;
  double Place = 0.0;
  double Shift = 0.0;
  std::size_t Pairs = 0;
  double Direction = 1.0;
  double WayTime = 0.0;
  int Ways = 0;
  std::array<double, 3> Sum{}; ///< force times time in the window, on this way (N s)
  double SumTime = 0.0;
  std::array<double, 3> Down{}; ///< mean force on the last way (N)
  std::vector<Reading> Readings;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Presses a handle on a kitchen scale with a given force, long enough for the user to read the
 * scale.
 */
#ifndef ScalePress_h
#define ScalePress_h

#include "Applications/DeviceTool/HeldSample.h"
#include "Applications/DeviceTool/RestWatch.h"

#include <string>

/**
 * A spring holds the handle. The spring's fixed end moves slowly towards the scale until the spring
 * pulls with the wanted level, stays there for HoldTime, and goes back. The handle thus never goes
 * beyond the spring's fixed end, even if there is no scale.
 *
 * The level is always approached from below, so that the friction has the same direction and size
 * whenever the handle settles on the scale.
 */
class ScalePress
{
public:
  static constexpr double HoldTime = 7.0; ///< time (s) for which the level is held
  static constexpr double ReadTime = 5.0; ///< last part of HoldTime (s), for reading the scale

  struct Settings
  {
    int Axis = 1;
    double Direction = -1.0; ///< towards the scale
    double Level = 0.0;      ///< N
    double MostForce = 0.0;  ///< N, the largest force that may be requested from the device
  };

  explicit ScalePress(const Settings& settings);

  void Step(const HeldSample& sample);
  /// Returns the shift of the spring's fixed end along the axis (m).
  double GetShift() const { return this->Given.Direction * this->Way; }
  bool IsOver() const { return this->Now == Phase::Done || this->Now == Phase::Refused; }
  /// Returns the user's instruction for this phase.
  std::string GetRequest() const;

  /// @{
  /// Return the result after the end: GetFault the fault and the cure, empty on success; GetForce
  /// the mean force (N) towards the scale during ReadTime.
  const std::string& GetFault() const { return this->Fault; }
  double GetForce() const { return this->Sum / this->SumTime; }
  ///@}

private:
  enum class Phase
  {
    Settle,
    Press,
    Hold,
    Release,
    Done,
    Refused
  };

  void Begin(Phase phase);
  void Refuse(const std::string& fault);
  void Hold(const HeldSample& sample, double force);

  const Settings Given;
  Phase Now = Phase::Settle;
  double PhaseTime = 0.0;
  double Way = 0.0; ///< distance of the spring's fixed end from its initial position (m)
  double Sum = 0.0; ///< integral of the force over time (N s)
  double SumTime = 0.0;
  RestWatch Rest;
  RestWatch Held;
  std::string Fault;
};

#endif

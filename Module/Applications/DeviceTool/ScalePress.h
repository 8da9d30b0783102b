// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Presses a handle on a kitchen scale with a given force, for long enough to read the scale. */
#ifndef ScalePress_h
#define ScalePress_h

#include "Applications/DeviceTool/HeldSample.h"
#include "Applications/DeviceTool/RestWatch.h"

#include <string>

/**
 * A spring holds the handle, and its fixed end moves slowly towards the scale until the spring
 * pulls with the wanted level. It stays there for HoldTime, and goes back. So the handle never goes
 * farther than the spring's end, even if there is no scale.
 *
 * The force always rises to the level, so that friction always holds back the same part of it, as
 * the handle settles into the scale.
 */
class ScalePress
{
public:
  static constexpr double HoldTime = 7.0; ///< s
  static constexpr double ReadTime = 5.0; ///< s, the last part of HoldTime: the scale is read

  struct Settings
  {
    int Axis = 1;
    double Direction = -1.0; ///< towards the scale
    double Level = 0.0;      ///< N
    double MostForce = 0.0;  ///< N, the largest force that the device may be asked for
  };

  explicit ScalePress(const Settings& settings);

  void Step(const HeldSample& sample);
  /// Returns the shift of the spring's fixed end along the axis (m).
  double GetShift() const { return this->Given.Direction * this->Way; }
  bool IsOver() const { return this->Now == Phase::Done || this->Now == Phase::Refused; }
  /// Returns the instruction for the user in this phase.
  std::string GetRequest() const;

  /// @{
  /// After the end: the fault and the cure, or else the mean force (N) of ReadTime, towards the
  /// scale.
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
  double Way = 0.0; ///< m, of the spring's fixed end
  double Sum = 0.0; ///< N s
  double SumTime = 0.0;
  RestWatch Rest;
  RestWatch Held;
  std::string Fault;
};

#endif

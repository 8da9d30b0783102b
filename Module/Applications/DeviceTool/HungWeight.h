// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Measures how many newtons a device gives for each one that it is asked for, with a known weight
 * that the user hangs on its handle.
 */
#ifndef HungWeight_h
#define HungWeight_h

#include "Applications/DeviceTool/HandleSweep.h"
#include "Applications/DeviceTool/RestWatch.h"

#include <string>

/**
 * A spring holds the handle at its place. At rest the motors carry all that hangs on the handle:
 *
 *   factor * force asked for = weight of the handle + pull of the arm + friction (+ m g).
 *
 * The difference between the forces with and without the weight, at the same place, has neither the
 * handle nor the arm in it, and forces that are read on ways up and down (HandleSweep.h) have no
 * friction. So
 *
 *   factor = m g / (force asked for with the weight - force asked for without it).
 *
 * The forces without the weight are read before and after: a zero that drifts shows.
 *
 *   every 10 ms:  Step(sample), and the spring to GetShift();  until IsOver().
 */
class HungWeight
{
public:
  static constexpr double Gravity = 9.80665; ///< m/s^2: weights are adjusted to the local one

  struct Settings
  {
    double Weight = 0.0;    ///< N
    int Axis = 1;           ///< the vertical one
    double MostForce = 0.0; ///< N, that the device may be asked for
    double Patience = 60.0; ///< s, for the user
  };

  explicit HungWeight(const Settings& settings);

  void Step(const HeldSample& sample);
  /// Of the spring's fixed end along the axis (m).
  double GetShift() const { return this->Shift; }
  /// The user's part, now.
  const char* GetRequest() const;
  bool IsOver() const { return this->Now == Phase::Done || this->Now == Phase::Refused; }

  ///@{
  /// Once it is over: the fault and the cure, or else the factor and half of the range in which the
  /// single readings lie.
  const std::string& GetFault() const { return this->Fault; }
  double GetFactor() const { return this->Factor; }
  double GetDoubt() const { return this->Doubt; }
  ///@}
  /// N that the device was asked for.
  double GetFriction() const { return this->Friction; }

private:
  enum class Phase
  {
    Settle,
    Before,
    Hang,
    With,
    TakeOff,
    After,
    Done,
    Refused
  };

  void Begin(Phase phase, const HeldSample& sample);
  void FollowSweep(const HeldSample& sample, Phase next);
  void WaitForWeight(const HeldSample& sample);
  void WaitForRemoval(const HeldSample& sample);
  void Refuse(const std::string& fault);
  void Judge();

  const Settings Given;
  Phase Now = Phase::Settle;
  double PhaseTime = 0.0;
  double SaturatedTime = 0.0;
  double Shift = 0.0;
  double Place = 0.0; ///< m, at which all forces are read
  bool IsChanged = false;
  RestWatch Rest;
  HandleSweep Sweep;
  std::vector<HandleSweep::Reading> Without;
  std::vector<HandleSweep::Reading> With;
  std::size_t CountBefore = 0; ///< of Without
  double Friction = 0.0;
  double Factor = 0.0;
  double Doubt = 0.0;
  std::string Fault;
};

#endif

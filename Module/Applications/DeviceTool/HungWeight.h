// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Measures how many newtons a device gives for each newton asked for, with a known weight that the
 * user hangs on its handle.
 */
#ifndef HungWeight_h
#define HungWeight_h

#include "Applications/DeviceTool/HandleSweep.h"
#include "Applications/DeviceTool/RestWatch.h"

#include <string>

/**
 * A spring holds the handle in its position. At rest the motors carry everything that hangs on the
 * handle:
 *
 *   factor * force asked for = weight of the handle + pull of the arm + friction (+ m g).
 *
 * The difference between the forces with and without the weight, at the same position, does not
 * contain handle and arm, and forces that are measured on ways up and down (HandleSweep.h) do not
 * contain friction. So
 *
 *   factor = m g / (force asked for with the weight - force asked for without it).
 *
 * The forces without the weight are measured before and after it hangs, which reveals a drifting
 * zero.
 *
 *   every 10 ms:  Step(sample), and the spring to GetShift();  until IsOver().
 */
class HungWeight
{
public:
  static constexpr double Gravity = 9.80665; ///< m/s^2: weights are adjusted to the local gravity

  struct Settings
  {
    double Weight = 0.0;    ///< N
    int Axis = 1;           ///< the vertical axis
    double MostForce = 0.0; ///< N, the largest force that the device may be asked for
    double Patience = 60.0; ///< time that the user may take to hang or to remove the weight (s)
  };

  explicit HungWeight(const Settings& settings);

  void Step(const HeldSample& sample);
  /// Returns the shift of the spring's fixed end along the axis (m).
  double GetShift() const { return this->Shift; }
  /// Returns the user's instruction for this phase.
  const char* GetRequest() const;
  bool IsOver() const { return this->Now == Phase::Done || this->Now == Phase::Refused; }

  /// Return the result once IsOver() is true: GetFault the fault and the cure, empty if there is
  /// none; GetFactor the factor; GetDoubt half of the range of the single readings.
  const std::string& GetFault() const { return this->Fault; }
  double GetFactor() const { return this->Factor; }
  double GetDoubt() const { return this->Doubt; }
  ///@}
  /// Returns the friction, in newtons as the device is asked for them, before calibration.
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
  void UpdateSweep(const HeldSample& sample, Phase next);
  void WaitForWeight(const HeldSample& sample);
  void WaitForRemoval(const HeldSample& sample);
  void Refuse(const std::string& fault);
  void Judge();

  const Settings Given;
  Phase Now = Phase::Settle;
  double PhaseTime = 0.0;
  double SaturatedTime = 0.0;
  double Shift = 0.0;
  double Place = 0.0; ///< position at which all forces are measured (m)
  bool IsChanged = false;
  RestWatch Rest;
  HandleSweep Sweep;
  std::vector<HandleSweep::Reading> Without;
  std::vector<HandleSweep::Reading> With;
  std::size_t CountBefore = 0; ///< number of readings in Without that were taken before the weight
                               ///< was hung
  double Friction = 0.0;
  double Factor = 0.0;
  double Doubt = 0.0;
  std::string Fault;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Measures how many newtons a device exerts for each newton requested, with a known weight that the
 * user hangs on its handle.
 */
#ifndef HungWeight_h
#define HungWeight_h

#include "Applications/DeviceTool/HandleSweep.h"
#include "Applications/DeviceTool/RestWatch.h"

#include <string>

/**
 * A spring holds the handle in its position. At rest the motors carry the whole load on the handle:
 *
 *   factor * requested force = weight of the handle + pull of the arm + friction (+ m g).
 *
 * At the same position, the difference between the forces with and without the weight cancels
 * handle and arm. Sweeps up and down (HandleSweep.h) cancel the friction. So
 *
 *   factor = m g / (requested force with the weight - requested force without it).
 *
 * The forces without the weight are measured before it is hung and after it is removed, which
 * reveals a drifting zero.
 *
 *   every 10 ms:  Step(sample), and the spring to GetShift();  until IsOver().
 */
class HungWeight
{
public:
  /// m/s^2, standard gravity; weights are adjusted to the local gravity
  static constexpr double Gravity = 9.80665;

  struct Settings
  {
    double Weight = 0.0;    ///< N
    int Axis = 1;           ///< the vertical axis
    double MostForce = 0.0; ///< N, the largest force that may be requested from the device
    double Patience = 60.0; ///< time that the user may take to hang or to remove the weight (s)
  };

  explicit HungWeight(const Settings& settings);

  void Step(const HeldSample& sample);
  /// Returns the shift of the spring's fixed end along the axis (m).
  double GetShift() const { return this->Shift; }
  /// Returns the user's instruction for this phase.
  const char* GetRequest() const;
  bool IsOver() const { return this->Now == Phase::Done || this->Now == Phase::Refused; }

  /// Return the result once IsOver() is true: GetFault the fault and the cure, empty on success;
  /// GetFactor the factor; GetDoubt half of the range of the single readings.
  const std::string& GetFault() const { return this->Fault; }
  double GetFactor() const { return this->Factor; }
  double GetDoubt() const { return this->Doubt; }
  ///@}
  /// Returns the friction, in uncalibrated newtons as requested from the device.
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

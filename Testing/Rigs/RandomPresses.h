// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Moves a hand at random into a conservative force field and out again, through the safety stage.
 * Measures how much more energy the hand receives than it has put in.
 *
 * The field is a spring wall: a plane, or the inside of a sphere. Half of the walls have a proxy.
 * Where the gate makes the proxy start at the tip, the wall also starts there until the tip has
 * gone back. Walls without a proxy are armed only while the hand is outside, because an inside hand
 * would receive the energy of its position.
 *
 * The device exerts the force of a tick until the next tick, so a tick gives the hand the energy F
 * . dx. Around a closed path, a spring k gives k |dx|^2 / 2 per tick even without the stage,
 * because a constant W over dx gives W . dx, and the integral of W along dx is W . dx - k |dx|^2 /
 * 2. This leak of sampling is allowed for all motions with force. While a device does not report
 * its motion, or the loop stalls, the energy of the last force is allowed.
 */
#ifndef RandomPresses_h
#define RandomPresses_h

#include "GatedStage.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace rigs
{

/// Which rules act in the stage. Without any rule, the stage only limits the force, at a value that
/// is never reached.
struct StageRules
{
  const char* Name;
  bool Clamp = false;
  bool Slew = false;
  bool Ramp = false;  ///< arms the gate again at random moments during a press
  bool Fade = false;  ///< varies the opening for missing data, as if data came and went
  bool Hold = false;  ///< holds and releases the force at random, as an application may
  bool Gap = false;   ///< leaves out samples, and stalls the loop
  bool Trip = false;  ///< causes faults, disarming, fades and clutching, and arms again later
  bool Speed = false; ///< limits the speed of the tip, and arms again after each fault
};

inline constexpr StageRules AllStageRules[] = {
  { "None" },
  { "Clamp", true },
  { "Slew", false, true },
  { "Both", true, true },
  { "Ramp", false, false, true },
  { "Fade", false, false, false, true },
  { "Hold", false, false, false, false, true },
  { "Gap", false, false, false, false, false, true },
  { "Trip", false, false, false, false, false, false, true },
  { "Speed", false, false, false, false, false, false, false, true },
  { "All", true, true, true, true, true, true, true, true },
};

class RandomPresses
{
public:
  /// J: rounding error of the sums over a press, which have thousands of products of some newtons
  /// and millimetres.
  static constexpr double Tolerance = 1e-9;

  RandomPresses(const StageRules& rules, unsigned seed)
    : Active(rules)
    , Engine(seed)
  {
    this->Limits.MaximumForce = rules.Clamp ? this->Draw(1.0, 6.0) : 1e6;
    this->Limits.MaximumForceRate = rules.Slew ? std::pow(10.0, this->Draw(1.0, 3.0)) : 1e9;
    this->Limits.MaximumSpeed = rules.Speed ? std::pow(10.0, this->Draw(-1.5, 0.0)) : 0.0;
    this->Limits.RampTime = rules.Ramp ? this->Draw(0.02, 0.5) : 0.0;
    this->Stiffness = std::pow(10.0, this->Draw(2.0, 3.5));
    this->IsSphere = this->Draw(0.0, 1.0) < 0.5;
    this->Input.Period = Period;
    this->Hand = this->Input.Tip = this->Home();
    this->Input.Stiffness = this->Draw(0.0, 1.0) < 0.5 ? 0.0 : this->Stiffness;
    this->HasProxy = this->Draw(0.0, 1.0) < 0.5;
    this->Start = this->Surface();
    this->Stage.Arm();
  }

  /// Returns how often the stage has reported that the tip is too fast.
  int GetSpeedTrips() const { return this->SpeedTrips; }

  /// Presses once. Returns the energy (J) that the hand has received beyond the leak of sampling.
  double Press()
  {
    this->Given = this->Leak = 0.0;
    const double inward = this->Draw(0.005, 0.05);
    const double speed = std::pow(10.0, this->Draw(-1.5, 0.0));
    this->MoveBy({ this->Draw(-0.005, 0.005), this->Draw(-0.005, 0.005), -inward }, speed);
    const int pokes = static_cast<int>(this->Draw(0.0, 4.0));
    for (int i = 0; i < pokes; ++i)
    {
      const double way = this->Draw(-0.4, 0.4) * inward;
      this->MoveBy({ this->Draw(-0.01, 0.01), this->Draw(-0.01, 0.01), way }, speed);
      this->Rest(static_cast<int>(this->Draw(0.0, 200.0)));
    }
    this->MoveBy(this->Home() - this->Hand, std::pow(10.0, this->Draw(-1.5, 0.0)));
    this->Rest(5);
    return this->Given - this->Leak;
  }

private:
  static constexpr double Period = 1e-3; ///< s, duration of a tick

  double Draw(double low, double high)
  {
    return std::uniform_real_distribution<double>(low, high)(this->Engine);
  }
  bool Happens(double perSecond) { return this->Draw(0.0, 1.0) < perSecond * Period; }

  VolumeHaptics::Vector3 Home() const { return { 0.0, 0.0, this->IsSphere ? 0.0 : 0.005 }; }
  /// Depth() returns the depth (m) in the direction of the wall. Surface() returns the depth (m) at
  /// which a wall without a proxy begins.
  double Depth(const VolumeHaptics::Vector3& x) const { return this->IsSphere ? Norm(x) : -x.Z; }
  double Surface() const { return this->IsSphere ? 0.008 : 0.0; }
  VolumeHaptics::Vector3 Field(const VolumeHaptics::Vector3& x) const
  {
    const double depth = this->Depth(x);
    const double force = this->Stiffness * std::max(0.0, depth - this->Start);
    return this->IsSphere ? (depth > 0.0 ? -force / depth : 0.0) * x
                          : VolumeHaptics::Vector3{ 0.0, 0.0, force };
  }
  void UpdateProxy()
  {
    const bool restarts = this->Stage.Gate.DrainRestart() && this->HasProxy;
    const double depth = this->Depth(this->Input.Tip);
    this->Start = std::max(this->Surface(), restarts ? depth : std::min(this->Start, depth));
  }

  void MoveBy(const VolumeHaptics::Vector3& way, double speed)
  {
    const int ticks = std::max(1, static_cast<int>(Norm(way) / (speed * Period)));
    for (int i = 0; i < ticks; ++i)
    {
      this->Step((1.0 / ticks) * way);
    }
  }
  void Rest(int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      this->Step({});
    }
  }

  /// Runs a tick, and then moves the hand by a distance (m). The force for the last known tip is
  /// constant while the hand moves.
  void Step(const VolumeHaptics::Vector3& way)
  {
    this->Input.Elapsed += Period;
    const bool isStanding = this->Standing > 0;
    this->Standing -= isStanding ? 1 : 0;
    bool isSilent = false;
    if (!isStanding)
    {
      isSilent = this->Tick();
    }
    this->Hand += way;
    this->Given += Dot(this->Force, way);
    this->Leak += isSilent || isStanding ? Norm(this->Force) * Norm(way) : 0.0;
  }
  /// Runs the stage's part of a tick. Returns true if the tip's position is unknown.
  bool Tick()
  {
    this->Trouble();
    const bool isSilent = this->Silence > 0;
    this->Silence -= isSilent ? 1 : 0;
    this->Input.Fresh = !isSilent;
    const VolumeHaptics::Vector3 before = this->Input.Tip;
    const bool wasFelt = Norm(this->Field(before)) > 0.0;
    this->Input.Tip = isSilent ? before : this->Hand;
    this->UpdateProxy();
    this->Input.Force = this->Field(this->Input.Tip);
    const bool isFelt = wasFelt || Norm(this->Input.Force) > 0.0;
    const VolumeHaptics::Vector3 leap = this->Input.Tip - before;
    // The leak is exact for a plane. In a sphere, it is exact for steps much shorter than the
    // radius.
    this->Leak += isFelt ? 0.505 * this->Stiffness * Dot(leap, leap) : 0.0;
    this->Input.Stretch = Norm(this->Input.Force) / this->Stiffness;
    const bool wasFault = this->Stage.Gate.GetFault() != VolumeHaptics::GateReason::None;
    this->Force = this->Stage.Apply(this->Input, this->Limits);
    this->SpeedTrips +=
      !wasFault && this->Stage.Gate.GetFault() == VolumeHaptics::GateReason::OverSpeed ? 1 : 0;
    this->Input.Elapsed = 0.0;
    return isSilent;
  }

  void Trouble()
  {
    VolumeHaptics::ForceGate& gate = this->Stage.Gate;
    if ((this->Active.Ramp || this->Active.Speed) && this->MayArm() && this->Happens(20.0))
    {
      this->Stage.Arm();
    }
    if (this->Active.Trip)
    {
      this->Trip();
    }
    if (this->Active.Fade && this->Happens(10.0))
    {
      this->Residency = this->Draw(0.0, 1.0) < 0.5 ? 0.0 : 1.0;
    }
    if (this->Active.Hold && this->Happens(10.0))
    {
      this->IsHeld = !this->IsHeld;
    }
    gate.SetHeld(this->IsHeld);
    gate.ReportData(this->Residency, Period);
    if (this->Active.Gap && this->Happens(5.0))
    {
      this->Silence = static_cast<int>(this->Draw(1.0, 60.0));
    }
    if (this->Active.Gap && this->Happens(1.0))
    {
      this->Standing = static_cast<int>(this->Draw(1.0, 60.0));
    }
  }
  bool MayArm() const { return this->HasProxy || this->Depth(this->Hand) <= this->Surface(); }
  void Trip()
  {
    VolumeHaptics::ForceGate& gate = this->Stage.Gate;
    if (this->Happens(10.0))
    {
      switch (this->Engine() % 5)
      {
        case 0:
          gate.Disarm();
          break;
        case 1:
          gate.ReportFault(VolumeHaptics::GateReason::OverSpeed);
          break;
        case 2:
          gate.FadeOut();
          break;
        case 3:
          gate.ReportSilence();
          break;
        default:
          gate.SetClutched(true);
          break;
      }
    }
    if (this->MayArm() && this->Happens(20.0))
    {
      const bool isArmed = gate.Arm(this->Draw(0.0, 1.0) < 0.5);
      if (gate.SetClutched(false) || isArmed)
      {
        this->Stage.Reset();
      }
    }
  }

  const StageRules Active;
  std::mt19937 Engine;
  GatedStage Stage;
  VolumeHaptics::SafetyLimits Limits;
  VolumeHaptics::SafetyInput Input;
  VolumeHaptics::Vector3 Hand;  ///< m
  VolumeHaptics::Vector3 Force; ///< N
  double Stiffness = 0.0;
  bool IsSphere = false;
  bool HasProxy = false;
  double Start = 0.0; ///< m, where the wall begins
  double Residency = 1.0;
  bool IsHeld = false;
  int Silence = 0;  ///< number of coming ticks without samples
  int Standing = 0; ///< number of coming ticks in which the loop stalls
  double Given = 0.0;
  double Leak = 0.0;
  int SpeedTrips = 0;
};

} // namespace rigs

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Presses an arm against a stiff wall, in closed loop through the safety stage.
 *
 * The arm is a mass m with viscous friction b and dry friction f. Its encoder has steps, and forces
 * may act a tick late. Either a weight presses the arm, whose mass is added to it, or a finger
 * holds the arm: 0.3 kg on a soft grip (500 N/m, 5 N s/m), led by muscles (100 N/m, 10 N s/m) with
 * a tremor of 0.1 mm at 9.3 Hz. These figures are in the range of ArmSessions.h. The integration
 * has semi-implicit steps of 50 us. Forces are constant between ticks, so the work of the port is
 * exact.
 *
 * Figures of the arms: the Touch has 45 g at its tip, 0.26 N of dry friction, 3.3 N and steps of
 * 0.055 mm, as its data sheet is usually quoted (not read here); here its dry friction is 0.2 N.
 * The Falcon has 8 N and steps of 0.06 mm, and takes forces a millisecond late by USB. The Falcon's
 * mass (0.1 kg) and friction, and the viscous friction of both (0.5 N s/m), are those of T16 in
 * Documentation/evaluation.md.
 */
#ifndef StiffWalls_h
#define StiffWalls_h

#include "Rigs/GatedStage.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace rigs
{

struct StiffArm
{
  const char* Name = "";
  double Mass = 0.0;         ///< kg, of the arm
  double Damping = 0.5;      ///< N s/m
  double Friction = 0.2;     ///< N, dry friction
  double Step = 0.0;         ///< m, resolution of the encoder
  int Delay = 0;             ///< ticks until a force acts
  double MaximumForce = 0.0; ///< N

  static constexpr double Period = 1e-3; ///< s, duration of a tick
  double RoundTrip() const { return Period * (1 + 2 * this->Delay); }
  /** Returns 2 b / T (N/m): the largest stiffness of a passive sampled wall. */
  double Sampled() const { return 2.0 * this->Damping / this->RoundTrip(); }

  static StiffArm FalconLike() { return { "Falcon-like", 0.1, 0.5, 0.2, 6e-5, 1, 8.0 }; }
  static StiffArm TouchLike() { return { "Touch-like", 0.045, 0.5, 0.2, 5.5e-5, 0, 3.3 }; }
};

/** How the arm is pressed. */
struct StiffPress
{
  bool IsHeld = false;
  double Force = 1.0; ///< N, force of the weight or of the muscles
  double Speed = 0.1; ///< m/s, speed of the approach
  double Gain = 1.0;  ///< stiffness of the wall in units of 2 b / T
  bool Augments = false;
  double MaximumForceRate = 500.0; ///< N/s, slew limit
  /** Slack (m) of the wall's spring, as in PassiveSpring.h: |f| = K (|d| - slack). */
  double Slack = 0.0;
};

struct StiffResult
{
  double Shown = 0.0; ///< N/m, mean force divided by mean depth during the hold
  double Swing = 0.0; ///< m, swing of the tip during the hold
  /**
   * Energy that the port delivered to the hand, divided by the energy that the port absorbed plus
   * the losses by damping and friction in contact.
   */
  double Ratio = 0.0;
  double MostGiven = 0.0; ///< J: largest energy that the hand has received beyond its input
  /**
   * J: MostGiven without the energy lost to dry friction, which the energy account does not
   * include.
   */
  double MostWithoutFriction = 0.0;
  double Deepest = 0.0;  ///< m, largest depth in the wall
  bool IsDamped = false; ///< whether PortDamper acted
  bool IsCut = false;    ///< whether a fault cut the force
};

/** Presses for two seconds and releases for one second. Measures the hold from 1.0 s to 1.9 s. */
inline StiffResult PressStiffly(const StiffArm& arm, const StiffPress& press)
{
  using namespace VolumeHaptics;
  constexpr int Steps = 20;
  constexpr double h = StiffArm::Period / Steps;
  constexpr double Pi = 3.14159265358979323846;
  SafetyLimits limits;
  limits.MaximumForce = arm.MaximumForce;
  limits.MaximumForceRate = press.MaximumForceRate;
  limits.RampTime = 0.0;
  limits.MovesTip = true;
  SafetyInput input;
  input.Elapsed = input.Period = input.MotionTime = StiffArm::Period;
  input.RoundTrip = arm.RoundTrip();
  input.Fresh = true;
  input.Slope = press.Gain * arm.Sampled();
  input.Feedback = press.Augments ? arm.Sampled() : 0.0;
  GatedStage stage;
  stage.Arm();
  ForceGate& gate = stage.Gate;

  std::deque<double> onTheWay(static_cast<std::size_t>(arm.Delay), 0.0);
  double x = 2e-3;
  double v = -press.Speed;
  double finger = x;
  double fingerSpeed = v;
  double path = x;
  const double mass = arm.Mass + (press.IsHeld ? 0.0 : press.Force / 9.81);
  constexpr double FingerMass = 0.3;
  constexpr double Grip = 500.0;
  constexpr double GripLoss = 5.0;
  constexpr double Muscle = 100.0;
  constexpr double MuscleLoss = 10.0;

  StiffResult result;
  double taken = 0.0;
  double given = 0.0;
  double net = 0.0;
  double withoutFriction = 0.0;
  double forces = 0.0;
  double depths = 0.0;
  double low = 1.0;
  double high = -1.0;
  for (int i = 0; i < 3000; ++i)
  {
    const double time = i * StiffArm::Period;
    input.Tip.Z = arm.Step > 0.0 ? arm.Step * std::floor(x / arm.Step + 0.5) : x;
    input.Stretch = std::max(0.0, -input.Tip.Z);
    input.Force.Z = input.Slope * input.Stretch;
    input.Stretch += input.Force.Z > 0.0 ? press.Slack : 0.0;
    input.Stiffness = input.Force.Z > 0.0 ? input.Force.Z / input.Stretch : input.Slope;
    onTheWay.push_back(stage.Apply(input, limits).Z);
    const double force = onTheWay.front();
    onTheWay.pop_front();
    result.IsCut = result.IsCut || gate.GetFault() != GateReason::None;
    const double from = x;
    const bool presses = time < 2.0;
    for (int s = 0; s < Steps; ++s)
    {
      const double t = time + s * h;
      const double lost = arm.Damping * v + arm.Friction * std::tanh(v / 1e-3);
      double push = presses ? -press.Force : press.Force;
      if (press.IsHeld)
      {
        const double target = presses ? -press.Force / Muscle : 0.01;
        path += std::clamp(target - path, -press.Speed * h, press.Speed * h);
        const double tremor = 1e-4 * std::sin(2.0 * Pi * 9.3 * t);
        push = Grip * (finger - x) + GripLoss * (fingerSpeed - v);
        fingerSpeed +=
          h / FingerMass * (Muscle * (path + tremor - finger) - MuscleLoss * fingerSpeed - push);
        finger += h * fingerSpeed;
      }
      const bool isFelt = x < 0.0 || force > 0.0;
      v += h / mass * (force - lost + push);
      x += h * v;
      // The friction is on the hand's side, between the port and the hand.
      const double friction = isFelt ? h * v * lost : 0.0;
      taken += friction;
      net -= friction;
      withoutFriction -= isFelt ? h * v * arm.Damping * v : 0.0;
    }
    const double work = force * (x - from);
    (work > 0.0 ? given : taken) += std::abs(work);
    net += work;
    withoutFriction += work;
    result.MostGiven = std::max(result.MostGiven, net);
    result.MostWithoutFriction = std::max(result.MostWithoutFriction, withoutFriction);
    result.Deepest = std::max(result.Deepest, -x);
    if (time >= 1.0 && time < 1.9)
    {
      forces += force;
      depths -= x;
      low = std::min(low, x);
      high = std::max(high, x);
    }
    if (x > 0.02)
    {
      break;
    }
  }
  result.Shown = depths > 0.0 ? forces / depths : 0.0;
  result.Swing = high - low;
  result.Ratio = taken > 0.0 ? given / taken : 0.0;
  return result;
}

} // namespace rigs

#endif

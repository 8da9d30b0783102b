// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A tap on a wall in closed loop through the safety stage, with the arms of StiffWalls.h.
 *
 * A hand throws the arm together with 50 g of a finger, and does not press, so that only the wall
 * stops the arm. An ideal spring K would stop it after x = v sqrt(m / K). So K = m (v / x)^2 is the
 * effective stiffness of a wall that stops it after x.
 */
#ifndef Taps_h
#define Taps_h

#include "Rigs/StiffWalls.h"

#include <vector>

namespace rigs
{

struct Tap
{
  double Speed = 0.1;     ///< m/s, before the touch
  double Stiffness = 0.0; ///< N/m, of the wall
  double Frequency = 0.0; ///< Hz, frequency of the material
  double Gain = 0.0;      ///< gain of the transient
  double Phase = 0.0;     ///< fraction of a tick by which the touch comes later
  bool MovesTip = true;
};

struct TapResult
{
  double Effective = 0.0; ///< N/m, effective stiffness
  double Returned = 0.0;  ///< energy with which the arm leaves, divided by the energy with which it
                          ///< came
  /** J: largest energy that port and friction have given beyond what they took */
  double MostGiven = 0.0;
  std::vector<double> Forces; ///< N, forces sent in each tick from the touch on
};

inline TapResult TapOnce(const StiffArm& arm, const Tap& tap)
{
  using namespace VolumeHaptics;
  constexpr int Steps = 20;
  constexpr double h = StiffArm::Period / Steps;
  const double mass = arm.Mass + 0.05;
  SafetyLimits limits;
  limits.MaximumForce = arm.MaximumForce;
  limits.MaximumForceRate = 5000.0;
  limits.RampTime = 0.0;
  limits.MovesTip = tap.MovesTip;
  limits.TransientGain = tap.Gain;
  SafetyInput input;
  input.Elapsed = input.Period = input.MotionTime = StiffArm::Period;
  input.RoundTrip = arm.RoundTrip();
  input.Fresh = true;
  input.Stiffness = tap.Stiffness;
  GatedStage stage;
  stage.Arm();
  std::deque<double> onTheWay(static_cast<std::size_t>(arm.Delay), 0.0);
  double x = (30.0 + tap.Phase) * StiffArm::Period * tap.Speed;
  double v = -tap.Speed;
  double deepest = 0.0;
  double net = 0.0;
  TapResult result;
  bool isTouched = false;
  double came = 0.0;
  for (int i = 0; i < 400; ++i)
  {
    input.Tip.Z = arm.Step > 0.0 ? arm.Step * std::floor(x / arm.Step + 0.5) : x;
    input.Stretch = std::max(0.0, -input.Tip.Z);
    input.Force.Z = input.Stiffness * input.Stretch;
    input.Frequency = input.Force.Z > 0.0 ? tap.Frequency : 0.0;
    const double sent = stage.Apply(input, limits).Z;
    if (!isTouched && input.Force.Z > 0.0)
    {
      isTouched = true;
      came = 0.5 * mass * v * v;
    }
    if (isTouched)
    {
      result.Forces.push_back(sent);
    }
    onTheWay.push_back(sent);
    const double force = onTheWay.front();
    onTheWay.pop_front();
    for (int s = 0; s < Steps; ++s)
    {
      const double lost = isTouched ? arm.Damping * v + arm.Friction * std::tanh(v / 1e-3) : 0.0;
      v += h / mass * (force - lost);
      x += h * v;
      net += h * v * (force - lost);
    }
    result.MostGiven = std::max(result.MostGiven, net);
    deepest = std::max(deepest, -x);
    if (isTouched && x > 2e-4 && v > 0.0)
    {
      break;
    }
  }
  result.Effective = mass * tap.Speed * tap.Speed / (deepest * deepest);
  result.Returned = v > 0.0 && came > 0.0 ? 0.5 * mass * v * v / came : 0.0;
  return result;
}

} // namespace rigs

#endif

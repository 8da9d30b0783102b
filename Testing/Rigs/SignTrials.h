// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs sign checks in closed loop with a simulated hand: through the force gate and the safety
 * stage, with encoders of a finite resolution, slow reports and late forces.
 */
#ifndef SignTrials_h
#define SignTrials_h

#include "Core/Safety/SafetyStage.h"
#include "Core/Safety/SignCheck.h"
#include "HeldDevice.h"

namespace signtest
{
/** Properties of a device that affect the servo. */
struct Port
{
  double Rate = 1000.0;     ///< Hz, rate of the servo
  double ReportTime = 0.0;  ///< s between two reports; 0: a report in each tick
  double Quantum = 0.06e-3; ///< m, resolution of the encoders
  bool IsLate = false;      ///< whether forces act one tick later
  double Force = 8.0;       ///< N, largest force of the device
};

struct Outcome
{
  VolumeHaptics::SignVerdict Verdict;
  double Work = 0.0;    ///< J, largest work of the motors on the hand
  double Motion = 0.0;  ///< m, largest distance between the tip with the check and the tip without
                        ///< it
  double Seconds = 0.0; ///< s until the verdict
};

/// Checks the signs of a device in a hand, until there is a verdict or two minutes have passed.
inline Outcome CheckSigns(const Hand& hand, const Port& port, const Triple& signs, unsigned seed)
{
  using namespace VolumeHaptics;
  HeldDevice held(hand, signs, seed);
  HeldDevice free(hand, signs, seed);
  // With friction, the tip may rest against the hand's own spring, and a push releases the spring's
  // force. Then only the motion since the beginning of a push is due to the push.
  const bool isComparable = hand.StaticFriction == 0.0;
  SignCheck check;
  check.Begin(7, port.Force);
  ForceGate gate;
  SafetyStage stage;
  SafetyLimits limits;
  limits.MaximumForce = 0.5 * port.Force;
  limits.RampTime = 0.0;
  SafetyInput input;
  input.Period = input.Elapsed = 1.0 / port.Rate;
  gate.Arm();
  stage.Reset();

  const int every = port.ReportTime > 0.0 ? static_cast<int>(port.ReportTime * port.Rate + 0.5) : 1;
  const int most = static_cast<int>(120.0 * port.Rate);
  Outcome outcome;
  Triple sent{};
  Triple from{};
  int n = 0;
  for (; n < most && check.GetVerdict().Result == SignResult::Pending; ++n)
  {
    input.Fresh = n % every == 0;
    if (input.Fresh)
    {
      const Triple& x = held.GetPlace();
      const auto count = [&port](double place)
      { return port.Quantum * std::round(place / port.Quantum); };
      input.Tip = { count(x[0]), count(x[1]), count(x[2]) };
    }
    input.Force = check.Step(input.Tip, input.Fresh, input.Elapsed);
    const Vector3 command = stage.Apply(input, limits, gate);
    const Triple next{ command.X, command.Y, command.Z };
    from = Norm(command) > 0.0 ? from : held.GetPlace();
    held.Move(port.IsLate ? sent : next, input.Period);
    free.Move({}, input.Period);
    sent = next;
    for (int i = 0; i < 3; ++i)
    {
      const double reference = isComparable ? free.GetPlace()[i] : from[i];
      outcome.Motion = std::max(outcome.Motion, std::abs(held.GetPlace()[i] - reference));
    }
  }
  outcome.Verdict = check.GetVerdict();
  outcome.Work = held.GetMostWork();
  outcome.Seconds = n * input.Period;
  return outcome;
}

/// Draws random hands and devices.
class RandomHands
{
public:
  explicit RandomHands(unsigned seed)
    : Random(seed)
  {
  }
  void Draw(Hand& hand, Port& port)
  {
    hand = Hand();
    port = Port();
    hand.Mass = 0.05 * std::pow(10.0, this->Between(0.0, 1.0));
    hand.Stiffness = this->Pick({ 0.0, 0.0, 50.0, 150.0, 300.0, 500.0 });
    hand.Damping = this->Pick({ 0.0, 0.5, 2.0, 5.0, 20.0 });
    // Give the hand at least a tenth of critical damping.
    hand.Damping = std::max(hand.Damping, 0.2 * std::sqrt(hand.Stiffness * hand.Mass));
    // Exclude hands that friction holds more than a millimetre from their equilibrium, because they
    // jump without a push once they slip.
    const double friction = this->Pick({ 0.0, 0.0, 0.05, 0.15 });
    hand.StaticFriction =
      hand.Stiffness > 0.0 ? std::min(friction, 1e-3 * hand.Stiffness) : friction;
    hand.KineticFriction = this->Between(0.6, 1.0) * hand.StaticFriction;
    hand.Weight = hand.Stiffness > 0.0 ? this->Pick({ 0.0, 0.5, 1.0 }) : 0.3 * hand.StaticFriction;
    hand.TremorSize = this->Between(0.0, 0.1e-3);
    hand.TremorFrequency = this->Between(8.0, 12.0);
    hand.Drift = this->Between(0.0, 5e-3);
    hand.Wander = this->Pick({ 0.0, 1e-3, 3e-3 });
    hand.Coupling = this->Pick({ 0.0, 0.3 });
    port.Rate = this->Pick({ 1000.0, 4000.0 });
    port.ReportTime = this->Pick({ 0.0, 0.0, 0.008 });
    port.IsLate = this->Pick({ 0.0, 1.0 }) > 0.0;
    port.Force = this->Pick({ 5.0, 8.0, 14.0, 40.0, 100.0 });
  }
  /// Returns signs with at least one wrong sign.
  Triple DrawWrongSigns()
  {
    const unsigned wrong = 1 + this->Random() % 7;
    return { wrong & 1u ? -1.0 : 1.0, wrong & 2u ? -1.0 : 1.0, wrong & 4u ? -1.0 : 1.0 };
  }

private:
  double Between(double a, double b) { return a + (b - a) * (this->Random() * 0x1p-32); }
  double Pick(std::initializer_list<double> of) { return of.begin()[this->Random() % of.size()]; }

  std::mt19937 Random;
};
} // namespace signtest

#endif

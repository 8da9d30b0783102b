// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A hand that holds a device's tip, as plain mechanics without the library:
 *
 *   m x'' = f - w - friction - b (x' - p') - k (x - p)
 *
 * with m the mass of hand and device, f the force of the motors, w a weight, Coulomb friction with
 * a static and a smaller kinetic force, and p(t) the position that the hand wants: a steady drift,
 * a wander (an Ornstein-Uhlenbeck velocity) and a tremor of 8 to 12 Hz. Axes may be coupled by a
 * stiffness matrix that is not diagonal. It is integrated with semi-implicit Euler steps of an
 * eighth of a millisecond.
 *
 * The figures of a hand come from the literature on tremor and hand impedance: physiological tremor
 * of 8 to 12 Hz and about 0.1 mm (Elble and Koller, Tremor, 1990), fingers of 0.05 to 0.5 kg, up to
 * some 500 N/m and 20 N s/m (Hajian and Howe, Identification of the mechanical impedance at the
 * human finger tip, 1997).
 */
#ifndef HeldDevice_h
#define HeldDevice_h

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace signtest
{
using Triple = std::array<double, 3>;

struct Hand
{
  double Mass = 0.15;            ///< kg, hand and device
  double Damping = 2.0;          ///< N s/m
  double Stiffness = 200.0;      ///< N/m
  double Coupling = 0.0;         ///< coupling between two axes, relative to the stiffness
  double StaticFriction = 0.0;   ///< N
  double KineticFriction = 0.0;  ///< N
  double Weight = 0.0;           ///< N, acts along the second axis
  double TremorSize = 0.1e-3;    ///< m, amplitude
  double TremorFrequency = 10.0; ///< Hz
  double Drift = 0.0;            ///< m/s, of the intended position
  double Wander = 0.0;           ///< m/s, root mean square of the wander
  double WanderTime = 0.5;       ///< s, correlation time of the wander
};

/// A hand that holds a device with 3 axes. The motion starts at rest, in balance.
class HeldDevice
{
public:
  static constexpr double Step = 1e-3 / 8.0;

  HeldDevice(const Hand& hand, const Triple& signs, unsigned seed)
    : TheHand(hand)
    , Signs(signs)
    , Random(seed)
  {
    std::uniform_real_distribution<double> phase(0.0, 2.0 * std::acos(-1.0));
    for (int i = 0; i < 3; ++i)
    {
      this->Phase[i] = phase(this->Random);
      this->DriftOf[i] = hand.Drift * std::cos(phase(this->Random));
    }
    this->Aim();
    this->Place = this->Wish;
    this->Place[1] -= hand.Stiffness > 0.0 ? hand.Weight / hand.Stiffness : 0.0;
  }

  /// Moves hand and device for a time (s) under a command (N). The device's signs are applied to
  /// the motors' force.
  void Move(const Triple& command, double seconds)
  {
    const int steps = static_cast<int>(std::lround(seconds / Step));
    for (int i = 0; i < steps; ++i)
    {
      this->Aim();
      this->Advance(command);
    }
  }

  const Triple& GetPlace() const { return this->Place; }
  /// Returns the work (J) that the motors have done on the hand. GetMostWork() returns its maximum
  /// so far.
  double GetWork() const { return this->Work; }
  double GetMostWork() const { return this->MostWork; }

private:
  void Aim()
  {
    const Hand& hand = this->TheHand;
    std::normal_distribution<double> normal;
    const double omega = 2.0 * std::acos(-1.0) * hand.TremorFrequency;
    for (int i = 0; i < 3; ++i)
    {
      const double kick = std::sqrt(2.0 * Step / hand.WanderTime) * hand.Wander;
      this->Wandering[i] += (kick > 0.0 ? kick * normal(this->Random) : 0.0) -
        this->Wandering[i] * Step / hand.WanderTime;
      this->Path[i] += (this->DriftOf[i] + this->Wandering[i]) * Step;
      const double angle = omega * this->Time + this->Phase[i];
      this->Wish[i] = this->Path[i] + hand.TremorSize * std::sin(angle);
      this->WishSpeed[i] =
        this->DriftOf[i] + this->Wandering[i] + hand.TremorSize * omega * std::cos(angle);
    }
    this->Time += Step;
  }

  void Advance(const Triple& command)
  {
    const Hand& hand = this->TheHand;
    Triple stretch;
    for (int i = 0; i < 3; ++i)
    {
      stretch[i] = this->Place[i] - this->Wish[i];
    }
    for (int i = 0; i < 3; ++i)
    {
      const double spring = hand.Stiffness *
        (stretch[i] + hand.Coupling * (stretch[(i + 1) % 3] + stretch[(i + 2) % 3]));
      const double motor = this->Signs[i] * command[i];
      const double weight = i == 1 ? hand.Weight : 0.0;
      const double force =
        motor - weight - hand.Damping * (this->Velocity[i] - this->WishSpeed[i]) - spring;
      const bool sticks = hand.StaticFriction > 0.0 && this->Velocity[i] == 0.0;
      double speed = this->Velocity[i];
      if (sticks && std::abs(force) <= hand.StaticFriction)
      {
        speed = 0.0;
      }
      else
      {
        const double way = speed != 0.0 ? speed : force;
        const double friction = std::copysign(hand.KineticFriction, way);
        const double next = speed + (force - friction) * Step / hand.Mass;
        speed = hand.KineticFriction > 0.0 && next * way < 0.0 ? 0.0 : next;
      }
      this->Velocity[i] = speed;
      this->Place[i] += speed * Step;
      this->Work += motor * speed * Step;
    }
    this->MostWork = std::max(this->MostWork, this->Work);
  }

  const Hand TheHand;
  const Triple Signs;
  std::mt19937 Random;
  Triple Phase{};
  Triple DriftOf{};
  Triple Wandering{};
  Triple Path{};
  Triple Wish{};
  Triple WishSpeed{};
  Triple Place{};
  Triple Velocity{};
  double Time = 0.0;
  double Work = 0.0;
  double MostWork = 0.0;
};
} // namespace signtest

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The handle of a haptic device in simulated time, which can carry a weight or press on a kitchen
 * scale. The handle follows Newton's second law, m a = sum of forces, with Coulomb's dry friction,
 * viscous friction, and Hooke's law for the arm's own springs and for the scale. The motors exert
 * `Strength` newtons for each newton of a command. The simulation is independent of the device's
 * driver and of the tool: a measurement must yield the values that are set here.
 */
#ifndef HungHandle_h
#define HungHandle_h

#include "EmulatedHand.h"

namespace emulated
{

class HungHandle
{
public:
  static constexpr double Gravity = 9.80665; ///< m/s^2

  double Strength = 1.0;         ///< N exerted for each newton of a command
  double Mass = 0.15;            ///< kg, mass of handle and arm
  double Balance = 0.9;          ///< fraction of the handle's weight that the arm carries
  double ArmStiffness = 15.0;    ///< N/m, stiffness of the arm's own springs
  double Viscosity = 1.0;        ///< N s/m
  double Friction = 0.1;         ///< N, Coulomb friction
  Triple Down{ 0.0, -1.0, 0.0 }; ///< direction of gravity, a unit vector
  double Quantum = 0.02e-3;      ///< m, resolution of the encoders
  double Weight = 0.0;           ///< kg, mass that hangs on the handle
  bool IsHeld = true;            ///< whether a hand holds the handle in place
  double Tremor = 0.0;           ///< m, size of the holding hand's tremor
  /// whether there is a scale below the handle, with its plate perpendicular to y
  bool HasScale = false;
  double PlateBelow = 0.005;      ///< m, distance of the plate below the initial position
  double ScaleStiffness = 5000.0; ///< N/m
  double ScaleDamping = 20.0;     ///< N s/m

  /// Applies a commanded force (N) for a time (s).
  void Step(const Triple& asked, double time)
  {
    constexpr double shortest = 1e-4;
    for (double done = 0.0; done < time - 1e-9; done += shortest)
    {
      this->StepOnce(asked, std::min(shortest, time - done));
    }
  }
  /// Returns the position (m) as the encoders measure it.
  Triple GetTip() const
  {
    Triple tip = this->Place;
    for (double& x : tip)
    {
      x = this->Quantum * std::round(x / this->Quantum);
    }
    return tip;
  }
  /// Returns the mass (g) that the scale shows, rounded like on a kitchen scale.
  double GetShown() const { return std::round(1e3 * this->OnScale / Gravity); }

private:
  double ComputeForce(int axis, const Triple& asked) const
  {
    const double own = this->Mass * (1.0 - this->Balance);
    double force = this->Strength * asked[axis] +
      (own + this->Weight) * Gravity * this->Down[axis] - this->ArmStiffness * this->Place[axis];
    if (this->IsHeld || this->Tremor > 0.0)
    {
      const double hand = axis == 1 ? this->Tremor * std::sin(9.0 * this->Time) : 0.0;
      force += 600.0 * (hand - this->Place[axis]) - 20.0 * this->Velocity[axis];
    }
    return force;
  }

  void StepOnce(const Triple& asked, double time)
  {
    const double mass = this->Mass + this->Weight;
    this->Time += time;
    this->OnScale = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      double force = this->ComputeForce(a, asked);
      const double depth = -this->PlateBelow - this->Place[a];
      if (a == 1 && this->HasScale && depth > 0.0)
      {
        this->OnScale =
          std::max(0.0, this->ScaleStiffness * depth - this->ScaleDamping * this->Velocity[a]);
        force += this->OnScale;
      }
      // Friction reduces the speed but never reverses it. Viscous friction acts at the end of the
      // step.
      const double pushed = this->Velocity[a] + time / mass * force;
      const double taken = time / mass * this->Friction;
      const double left = std::max(0.0, std::abs(pushed) - taken);
      this->Velocity[a] = std::copysign(left, pushed) / (1.0 + time / mass * this->Viscosity);
      this->Place[a] += time * this->Velocity[a];
    }
  }

  Triple Place{};
  Triple Velocity{};
  double Time = 0.0;
  double OnScale = 0.0; ///< N
};

} // namespace emulated

#endif

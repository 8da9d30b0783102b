// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A hand that holds an arm: a mass that a spring and a damper pull towards a goal, in simulated
 * time.
 */
#ifndef EmulatedHand_h
#define EmulatedHand_h

#include <algorithm>
#include <array>
#include <cmath>

namespace emulated
{
using Triple = std::array<double, 3>;

struct EmulatedHand
{
  static constexpr double Mass = 0.1;        ///< kg
  static constexpr double Stiffness = 300.0; ///< N/m
  /// N s/m: so large that late forces do not make the hand oscillate
  static constexpr double Damping = 25.0;
  /// m/s, speed at which the spring's fixed end moves to the goal
  static constexpr double Speed = 0.1;

  Triple Tip{}; ///< m
  Triple Velocity{};
  Triple Led{};  ///< m, fixed end of the spring
  Triple Goal{}; ///< m, target position of the hand

  /** Applies a force (N) for a time (s). */
  void Step(double time, const Triple& force)
  {
    double distance = 0.0;
    for (int a = 0; a < 3; ++a)
    {
      distance += (this->Goal[a] - this->Led[a]) * (this->Goal[a] - this->Led[a]);
    }
    const double part = std::min(1.0, Speed * time / std::max(std::sqrt(distance), 1e-12));
    for (int a = 0; a < 3; ++a)
    {
      this->Led[a] += part * (this->Goal[a] - this->Led[a]);
      const double pull = Stiffness * (this->Led[a] - this->Tip[a]) + force[a];
      // Apply the damping implicitly (at the end of the step), which is stable for steps of any
      // length.
      this->Velocity[a] = (this->Velocity[a] + time / Mass * pull) / (1.0 + time * Damping / Mass);
      this->Tip[a] += time * this->Velocity[a];
    }
  }
  void Place(const Triple& tip)
  {
    this->Tip = this->Led = this->Goal = tip;
    this->Velocity = {};
  }
};

} // namespace emulated

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The mechanics of the emulated Novint Falcon, written from the published dimensions alone, without
 * code from the tested driver. Positions are in metres in the device's frame, with z from the base
 * to the hand.
 */
#ifndef FalconMechanics_h
#define FalconMechanics_h

#include <array>

namespace emulated
{

using Numbers = std::array<double, 3>;

/** Returns the angles (degrees) of the three arms; NaN if the grip can't be at this position. */
Numbers FalconArmAngles(const Numbers& grip);

/** Returns the unrounded counts of homed encoders. */
Numbers FalconEncoderCounts(const Numbers& grip);

/**
 * Returns the force (N) on the grip for motor commands (-1e-4 N m per unit), from differences of
 * the arms' angles along each axis.
 */
Numbers FalconMotorForce(const Numbers& grip, const Numbers& commands);

/**
 * A grip of 0.1 kg between the motors and a hand. The hand is a spring and a damper whose end moves
 * to a target.
 */
class FalconGrip
{
public:
  static constexpr double Mass = 0.1;            ///< kg
  static constexpr double HandStiffness = 300.0; ///< N/m
  static constexpr double HandDamping = 8.0;     ///< N s/m
  static constexpr double HandSpeed = 0.8;       ///< m/s
  static constexpr double Innermost = 0.078;     ///< m, along z
  static constexpr double Outermost = 0.174;     ///< m, along z

  /** Advances by a millisecond under a force (N) of the motors. */
  void Step(const Numbers& force);

  Numbers Place{ 0.0, 0.0, 0.11 };
  Numbers Velocity{};
  Numbers Hand = Place; ///< m, position of the hand
  Numbers Aim = Place;  ///< m, target of the hand
  bool IsHeld = false;  ///< whether the hand is clamped, so that no force moves it
};

} // namespace emulated

#endif

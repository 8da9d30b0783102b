// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A burr, baked for the servo tick: see Core/Tools/Burr/BurrTool.h.
 */
#ifndef BakedBurr_h
#define BakedBurr_h

#include "Core/Math/PiecewiseTable.h"
#include "Core/Model/PointShell.h"

#include <cstddef>
#include <vector>

namespace VolumeHaptics
{

/** All numbers but SpinButton are at least 0. */
struct BurrSettings
{
  double Radius = 2.0;    ///< a, world units
  double Speed = 1000.0;  ///< n, revolutions a second
  double Friction = 0.3;  ///< mu, between burr and tissue
  double Vibration = 0.0; ///< fraction of the force, 0 to 1
  /// Bit of the device's button, 0 to 31: the burr spins while it is pressed; -1: none.
  int SpinButton = 0;
};

/** The energy (J/mm^3) for removing tissue, by value: channel 0. */
using SpecificEnergyTable = PiecewiseTable<2>;

/** A burr without the points of its head. */
struct BurrDescription
{
  BurrSettings Settings;
  Polyline SpecificEnergy = ConstantPolyline(10.0); ///< U, J/mm^3 of the hand's space, at least 0
};

/** A burr as a tick reads it, with what follows from its settings. Immutable. */
struct BakedBurr
{
  explicit BakedBurr(const BurrDescription& description);

  /** Points of equal areas on a sphere around the origin. */
  static std::vector<ShellPoint> MakeHead(double radius, std::size_t points = 1000);

  std::size_t GetMemorySize() const noexcept
  {
    return sizeof(*this) + this->SpecificEnergy.GetMemorySize() - sizeof(this->SpecificEnergy);
  }

  const BurrSettings Settings;
  const SpecificEnergyTable SpecificEnergy;
  const double RimSpeed;  ///< v, world units a second
  const double Frequency; ///< Hz, of the vibration: at most MostFrequency

  static constexpr double MostFrequency = 250.0;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A burr, baked for the servo tick: see Core/Tools/Burr/BurrTool.h.
 */
#ifndef BakedBurr_h
#define BakedBurr_h

#include "Core/Math/PiecewiseTable.h"
#include "Core/Tools/Burr/SphereCarver.h"
#include "Core/Tools/PointShell/BakedShell.h"

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
  /// The number of the device's button, 0 to 31, that makes the burr spin while it is pressed; -1:
  /// none.
  int SpinButton = 0;
};

struct BurrDescription
{
  BurrSettings Settings;
  Polyline SpecificEnergy = ConstantPolyline(10.0); ///< U, J/mm^3 of the hand's space, at least 0
  ShellDescription Head;                            ///< head with the points of MakeHead()
};

/**
 * A burr as a tick reads it, with what follows from its settings. Its centre is at the device's
 * tip. Its head has its size in the world, like a BakedShell; forces, energies and volumes are in
 * the hand's space.
 */
class BakedBurr final : public ShapedTool
{
public:
  explicit BakedBurr(BurrDescription description);

  /** Returns the array RemovedVolume. */
  static const ToolColumns& Columns();

  /** Makes points of equal areas on a sphere around the origin. */
  static std::vector<ShellPoint> MakeHead(double radius, std::size_t points = 1000);

  bool IsSame(const BakedTool& other) const override;
  /** Computes one tick, HapticSettings::TickPeriod long. The proxy is the centre of the head. */
  bool Step(const ToolTick& tick) const noexcept override;
  /**
   * Carries the head to another model; removal begins anew. Returns whether the method begins anew.
   */
  bool Carry(const HapticModel& from, const HapticModel& to, ServoState& state,
    ToolMemory* memory) const noexcept override;
  std::shared_ptr<ToolMemory> MakeMemory(const std::shared_ptr<ToolMemory>& last) const override;
  void AppendTables(std::vector<MemoryRange>& tables) const override;
  const ToolColumns& GetColumns() const override { return Columns(); }
  bool RemovesTissue() const noexcept override { return true; }
  bool Spins(std::uint32_t buttons, bool isOrdered) const noexcept override;

  const BurrSettings Settings;
  const Polyline SpecificEnergyLine; ///< U, as described
  const SpecificEnergyTable SpecificEnergy;
  const double RimSpeed;  ///< v, world units a second
  const double Frequency; ///< the frequency (Hz) of the vibration, at most MostFrequency

  static constexpr double MostFrequency = 250.0;
};

} // namespace VolumeHaptics

#endif

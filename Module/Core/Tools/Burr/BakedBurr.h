// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A burr, baked for the servo tick. See Core/Tools/Burr/BurrTool.h.
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

/** The settings of a burr. All numbers except SpinButton are at least 0. */
struct BurrSettings
{
  double Radius = 2.0;    ///< radius a of the head in world units
  double Speed = 1000.0;  ///< revolutions n per second
  double Friction = 0.3;  ///< friction mu between burr and tissue
  double Vibration = 0.0; ///< fraction of the force that vibrates, 0 to 1
  /// Number of the device's button (0 to 31) that makes the burr spin while it is pressed; -1 for
  /// none.
  int SpinButton = 0;
};

struct BurrDescription
{
  BurrSettings Settings;
  /** Specific energy U (J/mm^3 in the hand's space), at least 0. */
  Polyline SpecificEnergy = ConstantPolyline(10.0);
  ShellDescription Head; ///< the head, with the points of MakeHead()
};

/**
 * A burr as a tick reads it, with values that follow from its settings. Its centre is at the
 * device's tip. Like a BakedShell, its head has a fixed size in the world. Forces, energies and
 * volumes are in the hand's space.
 */
class BakedBurr final : public ShapedTool
{
public:
  explicit BakedBurr(BurrDescription description);

  /** Returns the trace's column RemovedVolume. */
  static const ToolColumns& Columns();

  /** Makes points on a sphere around the origin. Each point stands for the same area. */
  static std::vector<ShellPoint> MakeHead(double radius, std::size_t points = 1000);

  bool IsSame(const BakedTool& other) const override;
  /**
   * Computes a tick, which lasts HapticSettings::TickPeriod. The proxy is the centre of the head.
   */
  bool Step(const ToolTick& tick) const noexcept override;
  /**
   * Moves the head to another model, and starts a new removal. Returns whether the method must
   * start anew.
   */
  bool Carry(const HapticModel& from, const HapticModel& to, ServoState& state,
    ToolMemory* memory) const noexcept override;
  std::shared_ptr<ToolMemory> MakeMemory(const std::shared_ptr<ToolMemory>& last) const override;
  void AppendTables(std::vector<MemoryRange>& tables) const override;
  const ToolColumns& GetColumns() const override { return Columns(); }
  bool RemovesTissue() const noexcept override { return true; }
  bool Spins(std::uint32_t buttons, bool isOrdered) const noexcept override;

  const BurrSettings Settings;
  const Polyline SpecificEnergyLine; ///< U as in the description
  const SpecificEnergyTable SpecificEnergy;
  const double RimSpeed;  ///< speed v of the rim in world units per second
  const double Frequency; ///< frequency of the vibration (Hz), at most MostFrequency

  static constexpr double MostFrequency = 250.0;
};

} // namespace VolumeHaptics

#endif

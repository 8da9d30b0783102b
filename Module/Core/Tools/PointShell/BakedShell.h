// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A tool with a shape, baked for the servo tick: see ShellCoupling.h.
 *
 * Its frame is the stylus's: the origin at the device's tip, the axes those of the stylus. It has
 * its size in the world, so that it is as large as it is drawn, for any placement of the device. If
 * the device measures no orientation, the tool keeps its last one.
 */
#ifndef BakedShell_h
#define BakedShell_h

#include "Core/Model/BakedTool.h"
#include "Core/State/ToolMemory.h"
#include "Core/Tools/PointShell/ShellCoupling.h"

#include <memory>

namespace VolumeHaptics
{

/** A tool with a shape, and how it is felt. */
struct ShellDescription
{
  std::shared_ptr<const PointShell> Points; ///< points in world units; not null
  /**
   * The settings of the shell. The contact area is in square world units here, and the scale is not
   * used.
   */
  ShellSettings Touch;
};

/** The base of tools that touch with the points of a shell. */
class ShapedTool : public BakedTool
{
public:
  /** Returns the tool of a model; null if the tool has no shape. Not for ticks. */
  static const ShapedTool* Find(const BakedVolume& baked) noexcept;

  bool IsSame(const BakedTool& other) const override;
  /** Carries the state to another model. If the tool can't be carried, the hand begins anew. */
  bool Carry(const HapticModel& from, const HapticModel& to, ServoState& state,
    ToolMemory* memory) const noexcept override;
  void Begin(ServoState& state) const noexcept override;
  std::shared_ptr<ToolMemory> MakeMemory(const std::shared_ptr<ToolMemory>& last) const override;
  void AppendTables(std::vector<MemoryRange>& tables) const override;
  double GetReach() const noexcept override { return this->Description.Points->GetReach(); }

  const ShellDescription Description;

protected:
  explicit ShapedTool(ShellDescription description);

  /** Writes what is felt to the record of a tick, and to the state of the method. */
  static void WriteRecord(const ToolTick& tick, const ShellRecord& felt) noexcept;
};

/** The memory of a tool with a shape. */
class ShapedMemory : public ToolMemory
{
public:
  explicit ShapedMemory(std::shared_ptr<const PointShell> points);

  void Keep() noexcept override { this->Shell.Keep(); }
  std::vector<MemoryRange> GetTables() const override;

  const std::shared_ptr<const PointShell> Points;
  ShellMemory Shell;
};

/** A point shell: its points are pressed out of what is solid. */
class BakedShell final : public ShapedTool
{
public:
  explicit BakedShell(ShellDescription description);

  /** Returns the array ToolOrientation. */
  static const ToolColumns& Columns();

  bool Step(const ToolTick& tick) const noexcept override;
  const ToolColumns& GetColumns() const override { return Columns(); }
  double GetTurningStiffness() const noexcept override
  {
    return this->Description.Touch.TurningStiffness;
  }
};

///@{
/**
 * For recordings: FindKeptContacts returns the contacts that a tool with a shape has kept
 * (ToolMemory::Keep), null without such a tool; RestoreContacts continues with a copy of such
 * contacts. If they belong to another tool, RestoreContacts returns false and changes nothing.
 */
const ShellContacts* FindKeptContacts(const ToolMemory* memory) noexcept;
bool RestoreContacts(ToolMemory& memory, const BakedVolume& baked,
  const std::vector<ShellContact>& contacts, double fraction);
///@}

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A tool with a shape, baked for the servo tick (ShellCoupling.h).
 *
 * The tool's frame is the stylus's: the origin is at the device's tip, and the axes are the
 * stylus's. The tool has a fixed size in the world, so it is felt with the size in which it is
 * drawn, whatever the placement of the device. If the device does not measure an orientation, the
 * tool keeps its last one.
 */
#ifndef BakedShell_h
#define BakedShell_h

#include "Core/Model/BakedTool.h"
#include "Core/State/ToolMemory.h"
#include "Core/Tools/PointShell/ShellCoupling.h"

#include <memory>

namespace VolumeHaptics
{

/** A tool with a shape, and its haptic settings. */
struct ShellDescription
{
  std::shared_ptr<const PointShell> Points; ///< points in world units; not null
  /** Settings of the shell. ContactArea is in square world units here, and Scale is not used. */
  ShellSettings Touch;
};

/** Base class of tools that touch with the points of a shell. */
class ShapedTool : public BakedTool
{
public:
  /** Returns the tool of a model, or null if it has no shape. Not for ticks. */
  static const ShapedTool* Find(const BakedVolume& baked) noexcept;

  bool IsSame(const BakedTool& other) const override;
  /** Moves the state to another model. If this is impossible, the tool restarts in the hand. */
  bool Carry(const HapticModel& from, const HapticModel& to, ServoState& state,
    ToolMemory* memory) const noexcept override;
  void Begin(ServoState& state) const noexcept override;
  std::shared_ptr<ToolMemory> MakeMemory(const std::shared_ptr<ToolMemory>& last) const override;
  void AppendTables(std::vector<MemoryRange>& tables) const override;
  double GetReach() const noexcept override { return this->Description.Points->GetReach(); }

  const ShellDescription Description;

protected:
  explicit ShapedTool(ShellDescription description);

  /** Writes the result of a tick to the record, and to the state of the method. */
  static void WriteRecord(const ToolTick& tick, const ShellRecord& felt) noexcept;
};

/** Data that a tool with a shape keeps between ticks: its points, and where they touch. */
class ShapedMemory : public ToolMemory
{
public:
  explicit ShapedMemory(std::shared_ptr<const PointShell> points);

  void Keep() noexcept override { this->Shell.Keep(); }
  std::vector<MemoryRange> GetTables() const override;

  const std::shared_ptr<const PointShell> Points;
  ShellMemory Shell;
};

/** A point shell as a tool. Solid tissue pushes its points out. */
class BakedShell final : public ShapedTool
{
public:
  explicit BakedShell(ShellDescription description);

  /** Returns the trace's column ToolOrientation. */
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
 * For recordings. FindKeptContacts() returns the contacts that a tool with a shape has copied
 * (ToolMemory::Keep), or null if the memory does not belong to such a tool. RestoreContacts()
 * continues with a copy of contacts; it returns false and changes nothing if they belong to another
 * tool.
 */
const ShellContacts* FindKeptContacts(const ToolMemory* memory) noexcept;
bool RestoreContacts(ToolMemory& memory, const BakedVolume& baked,
  const std::vector<ShellContact>& contacts, double fraction);
///@}

} // namespace VolumeHaptics

#endif

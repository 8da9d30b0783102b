// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The interface of the tools in the hand, baked for the servo tick.
 *
 * Without a tool, the hand feels with a point. A kind of tool is a class in a folder of Core/Tools;
 * nothing outside its folder names it, but for the list of states in Core/State/ToolStates.h. What
 * passes from tick to tick is in ServoState, and in ToolMemory if its size depends on the tool.
 */
#ifndef BakedTool_h
#define BakedTool_h

#include "Core/Model/MemoryRange.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

class HapticModel;
class ToolMemory;
struct ServoState;
struct TickRecord;

/** An array that only traces of some tools have. */
struct ToolColumn
{
  const char* Name;
  const char* Unit; ///< unit as in a column's title, such as " (mm^3)"; empty if there is none
  int Components;
  bool IsRecorded; ///< whether recordings have the array, too
  /** Writes the array's numbers for a tick to `numbers`; 0 for a record of another tool. */
  void (*Read)(const HapticModel& model, const TickRecord& record, double* numbers);
};
using ToolColumns = std::vector<ToolColumn>;

/** One tick of a tool. */
class ToolTick
{
public:
  ToolTick(const HapticModel& model, ServoState& state, TickRecord& record, ToolMemory* memory)
    : Model(model)
    , State(state)
    , Record(record)
    , Memory(memory)
  {
  }
  virtual ~ToolTick() = default;

  /** Makes one tick of the method, which feels with a point. */
  virtual void FeelPoint() const noexcept = 0;

  const HapticModel& Model;
  ServoState& State;
  TickRecord& Record;       ///< the tick's record, which has the tip
  ToolMemory* const Memory; ///< made by MakeMemory() of the model's tool; null if there is none
};

/** A tool as a tick reads it. Immutable. The functions without noexcept are not for ticks. */
class BakedTool
{
public:
  virtual ~BakedTool() = default;

  /** Returns whether another tool feels the same as this one. */
  virtual bool IsSame(const BakedTool& other) const = 0;

  /**
   * Advances the state by a tick, and writes the record. Returns whether the tool's own law holds
   * the hand, so that releases of the method's proxy are not felt.
   */
  virtual bool Step(const ToolTick& tick) const noexcept = 0;

  ///@{
  /**
   * Carries the tool's state from its model to the next model, which may have another tool or none;
   * if that is not possible, lets go of the hand. `memory` belongs to the next tool. Returns
   * whether the method begins anew. Afterwards, Begin() of the next tool is called.
   */
  virtual bool Carry(const HapticModel& /*from*/, const HapticModel& /*to*/, ServoState& /*state*/,
    ToolMemory* /*memory*/) const noexcept
  {
    return false;
  }
  virtual void Begin(ServoState& /*state*/) const noexcept {}
  ///@}

  /**
   * Returns `last` if it can go on with this tool, otherwise a new memory; null if the tool needs
   * none.
   */
  virtual std::shared_ptr<ToolMemory> MakeMemory(const std::shared_ptr<ToolMemory>& /*last*/) const
  {
    return nullptr;
  }

  /** Appends the memory that a tick reads. */
  virtual void AppendTables(std::vector<MemoryRange>& tables) const = 0;

  /** Returns the arrays that only traces of this tool have. */
  virtual const ToolColumns& GetColumns() const
  {
    static const ToolColumns none;
    return none;
  }

  /**
   * Returns the largest distance (world units) between the tip and a point that touches; less than
   * 0 if only the method's point touches.
   */
  virtual double GetReach() const noexcept { return -1.0; }
  /** Returns the stiffness (N m/rad) of the spring that turns the hand; 0 if nothing turns it. */
  virtual double GetTurningStiffness() const noexcept { return 0.0; }
  /** Returns whether the tool writes to BakedVolume::Removal. */
  virtual bool RemovesTissue() const noexcept { return false; }
  /**
   * Returns whether the tool spins while these buttons are pressed, or because the program orders
   * it.
   */
  virtual bool Spins(std::uint32_t /*buttons*/, bool /*isOrdered*/) const noexcept { return false; }
};

} // namespace VolumeHaptics

#endif

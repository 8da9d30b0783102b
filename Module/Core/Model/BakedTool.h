// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The interface of a tool in the hand, baked for the servo tick.
 *
 * Without a tool, the hand feels with a point. Each kind of tool is a class in its own folder in
 * Core/Tools. Outside this folder, Core names the class only in the list of states,
 * Core/State/ToolStates.h. ServoState contains the state that a tool passes from tick to tick, and
 * ToolMemory the data whose size depends on the tool.
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

/** A column (array) of a trace that only some tools fill. */
struct ToolColumn
{
  const char* Name;
  const char* Unit; ///< unit as in a column's title, such as " (mm^3)"; empty without a unit
  int Components;
  bool IsRecorded; ///< whether recordings contain the array, too
  /**
   * Writes the array's numbers of a tick to `numbers`, or zeros if the record comes from another
   * tool.
   */
  void (*Read)(const HapticModel& model, const TickRecord& record, double* numbers);
};
using ToolColumns = std::vector<ToolColumn>;

/** The input and the output of a tool in a tick. */
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

  /** Computes the tick of the method, in which the hand feels with a point. */
  virtual void FeelPoint() const noexcept = 0;

  const HapticModel& Model;
  ServoState& State;
  TickRecord& Record;       ///< record of the tick; its tip is already set
  ToolMemory* const Memory; ///< memory from MakeMemory() of the model's tool; null if it needs none
};

/** A tool as a tick reads it. Immutable. A tick calls only the noexcept functions. */
class BakedTool
{
public:
  virtual ~BakedTool() = default;

  /** Returns whether another tool has the same properties, so that it feels the same. */
  virtual bool IsSame(const BakedTool& other) const = 0;

  /**
   * Computes a tick: advances the state and writes the record. Returns true if the tool's own law
   * holds the hand. Then the release of the method's proxy (ProxyRelease.h) must not be felt.
   */
  virtual bool Step(const ToolTick& tick) const noexcept = 0;

  ///@{
  /**
   * Moves the tool's state from its model to the next model, which may have another tool or none.
   * If that is impossible, drops the states that hold the hand. `memory` belongs to the next tool.
   * Returns whether the method must restart. If so, Begin() of the next tool is called.
   */
  virtual bool Carry(const HapticModel& /*from*/, const HapticModel& /*to*/, ServoState& /*state*/,
    ToolMemory* /*memory*/) const noexcept
  {
    return false;
  }
  virtual void Begin(ServoState& /*state*/) const noexcept {}
  ///@}

  /**
   * Returns `last` if this tool can use it. If not, returns new memory, or null if the tool needs
   * none.
   */
  virtual std::shared_ptr<ToolMemory> MakeMemory(const std::shared_ptr<ToolMemory>& /*last*/) const
  {
    return nullptr;
  }

  /** Appends the ranges of memory that a tick of this tool reads. */
  virtual void AppendTables(std::vector<MemoryRange>& tables) const = 0;

  /** Returns the columns of a trace that only this tool fills. */
  virtual const ToolColumns& GetColumns() const
  {
    static const ToolColumns none;
    return none;
  }

  /**
   * Returns the largest distance (world units) from the tip at which the tool can touch anything. A
   * negative number means that it touches only at the tip, like the method without a tool.
   */
  virtual double GetReach() const noexcept { return -1.0; }
  /**
   * Returns the stiffness (N m/rad) of the spring between the hand's and the tool's orientation, or
   * 0 if the tool exerts no torque.
   */
  virtual double GetTurningStiffness() const noexcept { return 0.0; }
  /** Returns whether the tool changes BakedVolume::Removal. */
  virtual bool RemovesTissue() const noexcept { return false; }
  /**
   * Returns whether the tool spins while these buttons are pressed. `isOrdered` is whether the
   * program orders it to spin.
   */
  virtual bool Spins(std::uint32_t /*buttons*/, bool /*isOrdered*/) const noexcept { return false; }
};

} // namespace VolumeHaptics

#endif

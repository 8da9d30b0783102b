// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Data that a tool passes from tick to tick in addition to ServoState.
 *
 * The state of a servo has a fixed size, and is copied with each snapshot. Data that grow with the
 * tool are here: allocated outside the servo, together with the model that has the tool, and used
 * by one thread that ticks. A model with the same tool continues with the same memory.
 */
#ifndef ToolMemory_h
#define ToolMemory_h

#include "Core/Tools/Burr/SphereCarver.h"
#include "Core/Tools/PointShell/ShellCoupling.h"

#include <memory>
#include <optional>
#include <vector>

namespace VolumeHaptics
{

class ToolMemory
{
public:
  explicit ToolMemory(std::shared_ptr<const BakedTool> tool);

  /**
   * The memory for a model: `last` if it belongs to the same tool; null if the tool needs none.
   * Allocates.
   */
  static std::shared_ptr<ToolMemory> Provide(
    const BakedVolume& baked, const std::shared_ptr<ToolMemory>& last);

  /** Null if the tool has no shape. */
  ShellMemory* GetShell() noexcept { return this->Shell ? &*this->Shell : nullptr; }

  /** Null if the tool removes nothing. */
  SphereCarver* GetCarver() noexcept { return this->Carver ? &*this->Carver : nullptr; }

  ///@{
  /**
   * Copies, on the thread that ticks, the part that belongs to the state before its next tick, once
   * for each recording; another thread reads the copy then.
   */
  void Keep() noexcept;
  const ShellContacts* GetKept() const noexcept
  {
    return this->Shell ? &this->Shell->GetKept() : nullptr;
  }
  ///@}
  /** Continues with a copy. If it belongs to another tool, returns false and changes nothing. */
  bool Restore(const BakedVolume& baked, const std::vector<ShellContact>& contacts, double share);

  /** The memory that a tick writes. */
  std::vector<HapticModel::MemoryRange> GetTables() const;

private:
  const std::shared_ptr<const BakedTool> Tool;
  std::optional<ShellMemory> Shell;
  std::optional<SphereCarver> Carver;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a tool passes from tick to tick beside ServoState.
 *
 * The state of a servo has a fixed size, and is copied with each snapshot. What grows with the tool
 * lives here: allocated away from the servo, together with the model that has the tool, and used by
 * one thread that ticks. A model with the same tool goes on with the same memory.
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

  /** For a model: the last one if that has the same tool; null if it needs none. Allocates. */
  static std::shared_ptr<ToolMemory> Provide(
    const BakedVolume& baked, const std::shared_ptr<ToolMemory>& last);

  /** Null if the tool has no shape. */
  ShellMemory* GetShell() noexcept { return this->Shell ? &*this->Shell : nullptr; }

  /** Null if the tool removes nothing. */
  SphereCarver* GetCarver() noexcept { return this->Carver ? &*this->Carver : nullptr; }

  ///@{
  /**
   * The thread that ticks keeps a copy of what belongs to the state before its next tick, once for
   * each recording; another one reads it then.
   */
  void Keep() noexcept;
  const ShellContacts* GetKept() const noexcept
  {
    return this->Shell ? &this->Shell->GetKept() : nullptr;
  }
  ///@}
  /** Goes on with what was kept. False, and it is left as it is, if it is of another tool. */
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

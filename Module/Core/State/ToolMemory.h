// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Data that a tool passes from tick to tick, in addition to ServoState.
 *
 * ServoState has a fixed size and is copied with each snapshot. Data whose size depends on the tool
 * are here instead. They are allocated outside the servo, together with the tool's model, and used
 * by one ticking thread. A new model with the same tool uses the same memory again.
 */
#ifndef ToolMemory_h
#define ToolMemory_h

#include "Core/Model/HapticModel.h"

#include <memory>
#include <vector>

namespace VolumeHaptics
{

class ToolMemory
{
public:
  virtual ~ToolMemory() = default;

  /**
   * Returns the memory for a model: `last` if it belongs to the same tool, new memory if it does
   * not, or null if the tool needs none. Allocates.
   */
  static std::shared_ptr<ToolMemory> Provide(
    const BakedVolume& baked, const std::shared_ptr<ToolMemory>& last)
  {
    return baked.Tool ? baked.Tool->MakeMemory(last) : nullptr;
  }

  /**
   * Copies the part of the memory that belongs to the state before the next tick. The ticking
   * thread calls this once for each recording; another thread then reads the copy.
   */
  virtual void Keep() noexcept = 0;

  virtual std::vector<MemoryRange> GetTables() const = 0;
};

} // namespace VolumeHaptics

#endif

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
   * Returns the memory for a model: `last` if it belongs to the same tool; null if the tool needs
   * none. Allocates.
   */
  static std::shared_ptr<ToolMemory> Provide(
    const BakedVolume& baked, const std::shared_ptr<ToolMemory>& last)
  {
    return baked.Tool ? baked.Tool->MakeMemory(last) : nullptr;
  }

  /**
   * Copies the part of the memory that belongs to the state before the next tick, on the thread
   * that ticks. Called once for each recording; another thread then reads the copy.
   */
  virtual void Keep() noexcept = 0;

  /** Returns the memory that a tick writes. */
  virtual std::vector<MemoryRange> GetTables() const = 0;
};

} // namespace VolumeHaptics

#endif

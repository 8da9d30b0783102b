// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Passes models from the publishing thread to the servo and its helper threads.
 *
 * To publish a model, a pointer is swapped. The servo acknowledges the generation that it uses from
 * then on. The fitter of local surfaces and the keeper of the samples around the tip register the
 * model that they use. Only the publishing thread frees models, as soon as no other thread uses
 * them.
 *
 * A model comes with the memory of its tool (ToolMemory.h). Models with the same tool share one
 * memory, to which only the servo writes.
 */
#ifndef ModelExchange_h
#define ModelExchange_h

#include "Core/Realtime/MemoryLock.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace VolumeHaptics
{
class HapticModel;
class ToolMemory;

/** A model and its data. The swapped pointer points to this. */
struct PublishedModel
{
  std::shared_ptr<const HapticModel> Model;
  /** Memory of the tool, for the servo; null if the tool needs none. */
  std::shared_ptr<ToolMemory> Tool;
  std::uint64_t Generation = 0;
  MemoryLock Lock; ///< locks the tables of Model and Tool
};

class ModelExchange
{
public:
  ModelExchange();
  ~ModelExchange();
  ModelExchange(const ModelExchange&) = delete;
  ModelExchange& operator=(const ModelExchange&) = delete;

  ///@{
  /** Publishes a model and returns its generation. Only the publishing thread may call this. */
  std::uint64_t Publish(std::shared_ptr<const HapticModel> model);
  /**
   * Returns the tool memory of the model that was published last, or null if its tool needs none.
   */
  const std::shared_ptr<ToolMemory>& GetTool() const noexcept { return this->Kept.back()->Tool; }
  /**
   * Frees the models that no other thread uses any more. Only the publishing thread may call this.
   */
  void Collect();
  /** Returns whether the system refused to lock the tables of a model. Any thread may call this. */
  bool IsLockRefused() const noexcept { return this->LockRefused.load(std::memory_order_relaxed); }
  /** Returns the last generation that the servo has acknowledged. */
  std::uint64_t GetAcknowledged() const noexcept
  {
    return this->Acknowledged.load(std::memory_order_acquire);
  }
  ///@}

  ///@{
  /**
   * Returns the latest model. It is not freed until the servo acknowledges a later one. Only the
   * servo may call this.
   */
  const PublishedModel* GetLatest() const noexcept
  {
    return this->Next.load(std::memory_order_acquire);
  }
  void Acknowledge(std::uint64_t generation) noexcept
  {
    this->Acknowledged.store(generation, std::memory_order_release);
  }
  ///@}

  ///@{
  /**
   * Returns the latest model. It is not freed until the thread releases it by LetGo(). Only the
   * thread of a holder may call this.
   */
  enum Holder : std::uint8_t
  {
    Fitter,
    SampleKeeper,
    Holders ///< the number of holders
  };
  const HapticModel* Hold(Holder holder) noexcept;
  void LetGo(Holder holder) noexcept { this->Held[holder].store(nullptr); }
  ///@}

private:
  std::atomic<const PublishedModel*> Next;
  std::atomic<std::uint64_t> Acknowledged{ 0 };
  std::atomic<const PublishedModel*> Held[Holders] = {};
  std::atomic<bool> LockRefused{ false };
  // only for the publisher; oldest first
  std::vector<std::unique_ptr<const PublishedModel>> Kept;
  std::uint64_t Generation = 0; // only for the publisher
  // The last tool memory that a model needed. Only for the publisher.
  std::shared_ptr<ToolMemory> LastTool;
};

} // namespace VolumeHaptics

#endif

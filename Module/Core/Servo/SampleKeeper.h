// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Keeps the samples around the tip in memory, on its own thread.
 *
 * An array may be mapped from a file that is larger than memory: a tick that reads a missing page
 * waits for the disk. This thread polls the tip, brings the pages of a box around tip and proxy
 * into memory before the tip gets there, and locks them as far as the limit of the user allows
 * (RLIMIT_MEMLOCK). It reads no other part of the volume.
 *
 * The box holds what a tick reads (ComputeReadReach) here and at the extrapolated tip of the next
 * poll, with a margin of up to 32 voxels, limited to SampleKeeper::MostBytes in whole pages. It is
 * renewed when the tip has used up half the margin. The labels have a separate box.
 */
#ifndef SampleKeeper_h
#define SampleKeeper_h

#include "Core/Math/Vector3.h"
#include "Core/Realtime/MemoryLock.h"
#include "Core/Realtime/TripleBuffer.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace VolumeHaptics
{
class ModelExchange;
struct VolumeView;

/** A box of samples: its first and last indices, as the view counts them. */
struct SampleBox
{
  std::int64_t First[3] = { 0, 0, 0 };
  std::int64_t Last[3] = { -1, -1, -1 };
};

/** A range of bytes, from the first to the last page. */
struct SamplePages
{
  std::uintptr_t Begin = 0; ///< an address
  std::uintptr_t End = 0;
};

/**
 * Collects the whole pages that hold a box of samples, ascending and disjoint. If the pages have
 * more than `most` bytes, stops and returns false.
 */
bool CollectSamplePages(const VolumeView& view, const SampleBox& box, std::size_t pageSize,
  std::size_t most, std::vector<SamplePages>& pages);

class SampleKeeper
{
public:
  explicit SampleKeeper(ModelExchange& models) noexcept
    : Models(models)
  {
  }

  /** The limit for the pages of each of the two boxes. */
  static constexpr std::size_t MostBytes = std::size_t{ 1 } << 22;

  ///@{
  /**
   * Keeps samples in memory until the loop is stopped; then unlocks all pages. Runs on the keeper's
   * thread.
   */
  void Run() noexcept;
  void RequestStop() noexcept { this->StopRequested.store(true, std::memory_order_release); }
  ///@}

  /** Passes on tip and proxy (device). Called by the servo in every tick. */
  void Update(const Vector3& tip, const Vector3& proxy) noexcept
  {
    this->Places.Write({ tip, proxy });
  }

  ///@{
  /**
   * Return the number of polls that had samples to keep, and whether some samples were not locked
   * after the last poll. From any thread.
   */
  std::uint64_t GetLooks() const noexcept { return this->Looks.load(std::memory_order_acquire); }
  bool IsLockRefused() const noexcept { return this->Refused.load(std::memory_order_relaxed); }
  ///@}

private:
  struct Place
  {
    Vector3 Tip;
    Vector3 Proxy;
  };
  /** The samples of one array that stay in memory. */
  struct Kept
  {
    const void* Of = nullptr; ///< the array's first sample
    SampleBox Enough;         ///< the box stays as long as ticks read within this box
    bool IsLocked = false;
    std::unique_ptr<MemoryLock> Lock;
  };

  void Look();
  /** Keeps the samples around tip and proxy. `reach` is in index steps. */
  void Keep(const VolumeView& view, const Affine3& deviceToIndex, const Vector3& reach, Kept& kept);
  void Lock(const std::vector<SamplePages>& pages, Kept& kept);
  bool IsStopping() const noexcept { return this->StopRequested.load(std::memory_order_acquire); }

  ModelExchange& Models;
  TripleBuffer<Place> Places;
  std::atomic<bool> StopRequested{ false };
  std::atomic<bool> Refused{ false };
  std::atomic<std::uint64_t> Looks{ 0 };

  // Members that only the thread uses.
  bool HasPlace = false;
  Vector3 LastTip;
  Vector3 NextTip; ///< the expected place of the tip at the next poll
  Kept Scalars;
  Kept Labels;
  Kept LabelFractions; ///< the fractions of FineLabels
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Keeps the samples around the tip in memory, on a separate thread.
 *
 * An array may be mapped from a file that is larger than the memory. A tick that reads a missing
 * page would then wait for the disk. This thread polls the tip, reads the pages of a box around tip
 * and proxy into memory before the tip gets there, and locks as many of them as the user's limit
 * allows (RLIMIT_MEMLOCK). It reads no other part of the volume.
 *
 * The box contains the samples that a tick reads (ComputeReadReach) at the tip and at its
 * extrapolated position at the next poll, with a margin of up to 32 voxels. It is limited to
 * SampleKeeper::MostBytes in whole pages. A new box is made when the tip has used up half of the
 * margin. Labels have a separate box.
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

/** A box of samples: its first and last indices, as in the view. */
struct SampleBox
{
  std::int64_t First[3] = { 0, 0, 0 };
  std::int64_t Last[3] = { -1, -1, -1 };
};

/** A range of whole pages. */
struct SamplePages
{
  std::uintptr_t Begin = 0; ///< address of the first byte
  std::uintptr_t End = 0;
};

/**
 * Collects the whole pages that contain a box of samples, in ascending order and without overlap.
 * Returns false, with an incomplete list, if the pages are larger than `most` bytes.
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

  /** Largest size (bytes) of the pages of each of the two boxes. */
  static constexpr std::size_t MostBytes = std::size_t{ 1 } << 22;

  ///@{
  /**
   * Keeps samples in memory until RequestStop(), then unlocks all pages. Must be called on the
   * keeper's thread.
   */
  void Run() noexcept;
  void RequestStop() noexcept { this->StopRequested.store(true, std::memory_order_release); }
  ///@}

  /** Sends tip and proxy (device) to the keeper's thread. The servo calls this in every tick. */
  void Update(const Vector3& tip, const Vector3& proxy) noexcept
  {
    this->Places.Write({ tip, proxy });
  }

  ///@{
  /**
   * GetLooks() returns the number of polls with samples to keep. IsLockRefused() returns whether
   * some samples were not locked at the last poll. Any thread may call these.
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
  /** The samples of one array that are being kept in memory. */
  struct Kept
  {
    const void* First = nullptr; ///< first sample of the array
    SampleBox Enough;            ///< a new box is made when ticks read outside this smaller box
    bool IsLocked = false;
    std::unique_ptr<MemoryLock> Lock;
  };

  void Look();
  /** Keeps the samples around tip and proxy in memory. `reach` is in index steps. */
  void Keep(const VolumeView& view, const Affine3& deviceToIndex, const Vector3& reach, Kept& kept);
  void Lock(const std::vector<SamplePages>& pages, Kept& kept);
  bool IsStopping() const noexcept { return this->StopRequested.load(std::memory_order_acquire); }

  ModelExchange& Models;
  TripleBuffer<Place> Places;
  std::atomic<bool> StopRequested{ false };
  std::atomic<bool> Refused{ false };
  std::atomic<std::uint64_t> Looks{ 0 };

  // Members that only the keeper's thread uses.
  bool HasPlace = false;
  Vector3 LastTip;
  Vector3 NextTip; ///< expected position of the tip at the next poll
  Kept Scalars;
  Kept Labels;
  Kept LabelFractions; ///< for the fractions of FineLabels
};

} // namespace VolumeHaptics

#endif

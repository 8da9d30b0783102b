// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads regions of a large volume on a thread of its own.
 */
#ifndef RegionReader_h
#define RegionReader_h

#include "VTK/Regions/Formats/LargeVolume.h"
#include "VTK/Regions/VolumeSurvey.h"

#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <thread>

namespace VolumeHaptics
{

struct FreeMemory
{
  void operator()(void* memory) const { std::free(memory); }
};

/** Samples of a region. All their pages have been written, so that they are in memory. */
struct RegionSamples
{
  BoxExtent Extent;
  std::unique_ptr<void, FreeMemory> Samples;
};

/**
 * Reads regions on a thread of its own. First the thread surveys the volume (VolumeSurvey.h). Then
 * it always reads the region that was ordered last, and drops earlier orders. A failed read is
 * repeated, after a time that doubles from 50 ms to 2 s, until it succeeds or another region is
 * ordered. If the reader ends the thread itself (pthread_exit), a new thread continues after the
 * same delay.
 *
 * All functions are for the owner (the GUI thread), and none of them waits for a read except the
 * destructor, which waits only for the read that is under way. If the volume is not awaited
 * (LargeVolume::IsAwaited), the destructor does not wait either.
 */
class RegionReader
{
public:
  /**
   * Begins to read a volume. If facts are given, does not survey it. Throws std::system_error if
   * the system provides no thread.
   */
  RegionReader(std::shared_ptr<const LargeVolume> volume, const std::optional<VolumeFacts>& facts);
  ~RegionReader();
  RegionReader(const RegionReader&) = delete;
  RegionReader& operator=(const RegionReader&) = delete;

  void Order(const BoxExtent& region);
  /** Returns the facts, once they are known. */
  std::optional<VolumeFacts> GetFacts() const;
  /** Returns the latest region that has arrived since the last call, if there is one. */
  std::optional<RegionSamples> Drain();
  /** Returns why the last read failed; empty if it did not. */
  std::string GetTrouble() const;

private:
  struct Work;

  void Begin();
  /** Starts a new thread if a reader function has ended the last thread. */
  void Revive();

  std::shared_ptr<Work> Shared; ///< shared with the thread
  std::unique_ptr<std::thread> Thread;
  const std::int64_t Process;
};

} // namespace VolumeHaptics

#endif

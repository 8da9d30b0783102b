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

/** Samples that have been written, so that their pages are in memory. */
struct RegionSamples
{
  BoxExtent Extent;
  std::unique_ptr<void, FreeMemory> Samples;
};

/**
 * First the thread surveys the volume (VolumeSurvey.h). Then it reads the region that was ordered
 * last; regions that were ordered before and have not been begun are left out. A read that failed
 * is tried again, after a time that doubles from 50 ms to 2 s, until it succeeds or another region
 * is ordered. If the reader ends the thread itself (pthread_exit), another one goes on after such a
 * time.
 *
 * All functions are for the owner (the GUI thread), and none of them waits for a read but the
 * destructor: it waits for the one that is under way, and for no other. If the volume is not
 * awaited (LargeVolume::IsAwaited), it waits for none.
 */
class RegionReader
{
public:
  /** With facts, nothing is surveyed. Throws std::system_error if the system gives no thread. */
  RegionReader(std::shared_ptr<const LargeVolume> volume, const std::optional<VolumeFacts>& facts);
  ~RegionReader();
  RegionReader(const RegionReader&) = delete;
  RegionReader& operator=(const RegionReader&) = delete;

  void Order(const BoxExtent& region);
  /** The facts, once they are known. */
  std::optional<VolumeFacts> GetFacts() const;
  /** The last region that has come since the last call, if there is one. */
  std::optional<RegionSamples> Take();
  /** Why the last read failed; empty if it did not. */
  std::string GetTrouble() const;

private:
  struct Work;

  void Begin();
  /** Lets another thread go on in the place of one that a reader has ended. */
  void Revive();

  std::shared_ptr<Work> Shared; ///< with the thread
  std::unique_ptr<std::thread> Thread;
  const std::int64_t Process;
};

} // namespace VolumeHaptics

#endif

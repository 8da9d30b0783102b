// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads regions of a large volume on a separate thread.
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

/** Samples of a region. Every page was written, so all are in physical memory. */
struct RegionSamples
{
  BoxExtent Extent;
  std::unique_ptr<void, FreeMemory> Samples;
};

/**
 * Reads regions on a separate thread. The thread first surveys the volume (VolumeSurvey.h). Then it
 * always reads the last ordered region, and drops earlier orders. A failed read is repeated, after
 * a time that doubles from 50 ms to 2 s, until it succeeds or another region is ordered. If the
 * reader ends the thread itself (pthread_exit), a new thread continues after the same delay.
 *
 * Call all functions on the owner's thread (the GUI thread). None of them waits for a read, except
 * the destructor, which waits for the read in progress if LargeVolume::IsAwaited.
 */
class RegionReader
{
public:
  /**
   * Starts to read a volume. Skips the survey if facts are given. Throws std::system_error if the
   * system provides no thread.
   */
  RegionReader(std::shared_ptr<const LargeVolume> volume, const std::optional<VolumeFacts>& facts);
  ~RegionReader();
  RegionReader(const RegionReader&) = delete;
  RegionReader& operator=(const RegionReader&) = delete;

  void Order(const BoxExtent& region);
  /** Returns the facts from the survey, once they are known. */
  std::optional<VolumeFacts> GetFacts() const;
  /** Returns the latest region that has arrived since the last call; nothing if there is none. */
  std::optional<RegionSamples> Drain();
  /** Returns why the last read failed; empty if it succeeded. */
  std::string GetTrouble() const;

private:
  struct Work;

  void Begin();
  /** Starts a new thread if a reader function has ended the previous one. */
  void Revive();

  std::shared_ptr<Work> Shared; ///< state shared with the thread
  std::unique_ptr<std::thread> Thread;
  const std::int64_t Process;
};

} // namespace VolumeHaptics

#endif

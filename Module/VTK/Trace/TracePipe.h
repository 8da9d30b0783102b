// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The ticks of a path, on their way into the trace by another thread.
 */
#ifndef TracePipe_h
#define TracePipe_h

#include "VTK/Trace/TraceRecords.h"

#include <array>
#include <condition_variable>
#include <cstddef>
#include <memory>
#include <mutex>
#include <thread>

namespace VolumeHaptics
{

/**
 * Each tick waits for the one before it, but nothing waits for the trace: another thread writes a
 * block of records, which needs the value at each proxy, and new memory, while the next ones are
 * computed. It is for a walk on one model (TipPathWalk::IsPlain).
 */
class TracePipe
{
public:
  /** Handing over a block costs nothing beside that many ticks. */
  static constexpr std::size_t BlockSize = 2048;

  /** Throws std::bad_alloc, and std::system_error if there is no thread to be had. */
  TracePipe(const HapticTrace& trace, std::shared_ptr<const HapticModel> model, vtkIdType firstRow);
  /** Writes the rest. */
  ~TracePipe();
  TracePipe(const TracePipe&) = delete;
  TracePipe& operator=(const TracePipe&) = delete;

  /** The record that Append() takes; to be written whole before that. */
  TickRecord& GetNext() { return this->Filling->Records[this->Filling->Count]; }
  void Append(double time)
  {
    this->Filling->Times[this->Filling->Count] = time;
    if (++this->Filling->Count == BlockSize)
    {
      this->PassOn();
    }
    else if (this->Filling->Count + 1 < BlockSize)
    {
      FetchToWrite(this->Filling->Records[this->Filling->Count + 1]);
    }
  }
  /** Waits until all is in the trace. More may follow. */
  void Finish();

private:
  struct Block
  {
    std::size_t Count = 0;
    std::array<TickRecord, BlockSize> Records;
    std::array<double, BlockSize> Times; ///< s
  };
  /** One is filled, one is written, and one lies between, so that neither waits for a jitter. */
  static constexpr std::size_t Blocks = 3;

  /**
   * The other thread has read the record, so that its lines are in the cache of another processor:
   * they come while the tick before it is computed, and no write waits for them.
   */
  static void FetchToWrite(const TickRecord& record)
  {
#if defined(__GNUC__) && defined(__x86_64__)
    constexpr std::size_t line = 64; // bytes
    const auto* const begin = reinterpret_cast<const char*>(&record);
    for (std::size_t at = 0; at < sizeof(record); at += line)
    {
      // Not __builtin_prefetch, which by default asks for a line to read.
      __asm__ volatile("prefetchw %0" : : "m"(begin[at]));
    }
#else
    static_cast<void>(record);
#endif
  }
  /** Hands the block over, and waits for an empty one. */
  void PassOn();
  /** The other thread. */
  void WriteBlocks();
  void Write(const Block& block);

  const HapticTrace& Trace;
  const std::shared_ptr<const HapticModel> Model;
  std::array<std::unique_ptr<Block>, Blocks> Ring;
  Block* Filling;
  // Of the other thread.
  vtkIdType Next;
  WorkMeter Work;

  // Changed with the mutex only, which also hands the blocks over.
  std::mutex Mutex;
  std::condition_variable HasPassed;
  std::condition_variable HasWritten;
  std::size_t Passed = 0; ///< blocks
  std::size_t Written = 0;
  bool IsEnding = false;

  std::thread Thread; ///< the last member: it uses the others
};

} // namespace VolumeHaptics

#endif

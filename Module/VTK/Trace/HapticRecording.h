// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A recording of the servo loop: a trace with everything that replays it to the bit.
 *
 * Every tick goes to a journal beside the file, on a thread of the recording's own: a disk that
 * makes its writer wait holds up neither the servo nor the session's keeper. What waits for the
 * disk is bounded; ticks beyond that are lost, and counted. The file is made from the journal at
 * the end (HapticRecordingFile.h).
 */
#ifndef HapticRecording_h
#define HapticRecording_h

#include "Core/Servo/ServoClock.h"
#include "VTK/Trace/JournalWriter.h"

#include <atomic>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace VolumeHaptics
{

class HapticRecording
{
public:
  /** Ticks that may wait for the disk: 16 s at 1 kHz, 5 MB. */
  static constexpr std::size_t MostWaiting = 1 << 14;

  HapticRecording();
  /** Ends the writing; the journal stays, unless Finish made the file. */
  ~HapticRecording();
  HapticRecording(const HapticRecording&) = delete;
  HapticRecording& operator=(const HapticRecording&) = delete;

  /**
   * Begins the journal of a file. False, with the reason and the cure, where the file could not be
   * written. A journal of the same name that an earlier program left is renamed, and the warning
   * says to what.
   */
  bool Start(
    const std::string& file, const RecordingAbout& about, std::string& error, std::string& warning);

  /**
   * The model of a generation that the loop may use from now on. Frees older ones: for their
   * owner's thread.
   */
  void AddModel(std::uint64_t generation, std::shared_ptr<const HapticModel> model);
  /**
   * Takes a tick; false where it is lost. Ticks without a model are left out: there was no world to
   * be in.
   */
  bool Append(const ServoSnapshot& snapshot);
  /** How many ticks have not come this far. */
  void SetMissed(std::uint64_t ticks) { this->Missed.store(ticks); }
  std::uint64_t GetLostTicks() const { return this->Missed.load() + this->Dropped.load(); }

  /** Those that are in the journal. */
  std::uint64_t GetNumberOfTicks() const { return this->Written.load(); }

  /**
   * Why it ended before it was stopped, and what is left of it; empty while all is well. From any
   * thread.
   */
  std::string GetTrouble() const;

  /**
   * Ends the journal and makes the file. False where not all of it is in the file; the error says
   * where it is.
   */
  bool Finish(std::string& error);

private:
  void WriteUntilStopped();
  /** Writes a group that is full, or any if it is the end; false where there is none. */
  bool WriteGroup(bool isEnd);
  void StopWriter();
  bool IsOurs() const { return this->Process == ServoClock::GetProcess(); }

  std::string File;
  const std::int64_t Process = ServoClock::GetProcess(); // whose thread and journal they are

  // The keeper's, and its owner's between two of its calls.
  std::map<std::uint64_t, std::shared_ptr<const HapticModel>> Models;
  WorkMeter Work;
  std::uint64_t LastGeneration = 0; // of the ticks that came, whether they are recorded or not
  std::uint64_t PlacedGeneration = 0;
  int LastPlacement = -1;

  // Between the keeper and the writer.
  std::mutex QueueMutex;
  std::deque<RecordingRow> Waiting;
  std::vector<PlacementRow> NewPlacements;
  std::unique_ptr<RecordingBegin> Begin; // until it is written
  std::atomic<std::uint64_t> Missed{ 0 };
  std::atomic<std::uint64_t> Dropped{ 0 };
  std::atomic<bool> StopRequested{ false };
  std::atomic<int> Failure{ 0 }; // the errno that ended the journal
  std::atomic<std::uint64_t> Written{ 0 };

  // The writer's. A child process that was forked lets it be: see the destructor.
  std::unique_ptr<JournalWriter> Writer;
  std::unique_ptr<std::thread> WriterThread;
};

} // namespace VolumeHaptics

#endif

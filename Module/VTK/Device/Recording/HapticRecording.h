// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Records the ticks of the servo loop: a trace with all data for an exact replay.
 *
 * The recording writes every tick to a journal beside the file on a separate thread, so that a slow
 * disk delays neither the servo nor the session's keeper thread. A limited number of ticks may wait
 * for the disk; further ticks are lost and counted. At the end, the file is made from the journal
 * (HapticRecordingFile.h).
 */
#ifndef HapticRecording_h
#define HapticRecording_h

#include "Core/Realtime/ServoClock.h"
#include "VTK/Device/Recording/JournalWriter.h"

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
class HapticModel;
class ToolMemory;

/** A model that the loop may use, with the memory of its tool; null if the tool needs none. */
struct PublishedTouch
{
  std::shared_ptr<const HapticModel> Model;
  std::shared_ptr<const ToolMemory> Tool;
};

class HapticRecording
{
public:
  /** Largest number of ticks that may wait for the disk: 15 s at 1 kHz, or 6.8 MB. */
  static constexpr std::size_t MostWaiting = 15000;

  HapticRecording();
  /** Stops writing. The journal stays on the disk unless Finish has made the file. */
  ~HapticRecording();
  HapticRecording(const HapticRecording&) = delete;
  HapticRecording& operator=(const HapticRecording&) = delete;

  /**
   * Starts the journal of a file. Returns false, with the reason and the cure in `error`, if the
   * file can't be written. Renames a journal of the same name that an earlier program left, and
   * reports its new name in `warning`.
   */
  bool Start(
    const std::string& file, const RecordingAbout& about, std::string& error, std::string& warning);

  /**
   * Adds the model of a generation, which the loop may use from now on, with the memory of its
   * tool. Also frees older models, so call this on their owner's thread.
   */
  void AddModel(std::uint64_t generation, std::shared_ptr<const HapticModel> model,
    std::shared_ptr<const ToolMemory> tool = nullptr);
  /**
   * Records a tick. Returns false if the tick is lost. Skips ticks without a model, because they
   * have no world coordinates. Until the first tick is recorded, also skips ticks that are older
   * than the stored memory of the tool and the removed tissue (ServoLoop::KeepTool).
   */
  bool Append(const ServoSnapshot& snapshot);
  /** Returns whether the first tick is still to be recorded. */
  bool IsAwaited() const { return this->LastPlacement < 0; }
  /** Sets the hashes once they are computed. Call this once, on the owner's thread. */
  void SetHashes(const RecordingHashes& hashes);

  /** Sets the number of ticks that were lost before they reached the recording. */
  void SetMissed(std::uint64_t ticks) { this->Missed.store(ticks); }
  std::uint64_t GetLostTicks() const { return this->Missed.load() + this->Dropped.load(); }

  const std::string& GetFile() const { return this->File; }

  /** Returns the number of ticks in the journal. */
  std::uint64_t GetNumberOfTicks() const { return this->Written.load(); }

  /**
   * Returns why the recording ended by itself and which part of it remains; empty if it did not.
   * Any thread may call this.
   */
  std::string GetTrouble() const;

  /**
   * Completes the journal and makes the file. Returns false if ticks are missing in the file;
   * `error` then says where they are.
   */
  bool Finish(std::string& error);

private:
  void WriteUntilStopped();
  void WriteHashes();
  /**
   * Writes a full group, or the remaining ticks at the end. Returns false if there are too few
   * ticks.
   */
  bool WriteGroup(bool isEnd);
  void StopWriter();
  bool IsOurs() const { return this->Process == ServoClock::GetProcess(); }

  std::string File;
  // Process that owns the thread and the journal.
  const std::int64_t Process = ServoClock::GetProcess();

  // Used by the keeper thread. The owner may access them only while the keeper is not in a call.
  std::map<std::uint64_t, PublishedTouch> Models;
  WorkMeter Work;
  std::uint64_t LastGeneration = 0; // generation of the last tick that arrived, even if it was not
                                    // recorded
  std::uint64_t PlacedGeneration = 0;
  int LastPlacement = -1;

  // Shared by the keeper thread and the writer thread, under QueueMutex.
  std::mutex QueueMutex;
  std::deque<RecordingRow> Waiting;
  std::vector<PlacementRow> NewPlacements;
  std::unique_ptr<RecordingHashes> Hashes; // hashes to write; null before they are set and after
                                           // they are written
  std::unique_ptr<RecordingBegin> Begin;   // beginning to write; null after it is written
  std::vector<ContactRow> BeginContacts;   // tool contacts in the state Begin
  std::vector<BrickTissue> BeginTissue;    // removed tissue in the state Begin
  std::atomic<std::uint64_t> Missed{ 0 };
  std::atomic<std::uint64_t> Dropped{ 0 };
  std::atomic<bool> StopRequested{ false };
  std::atomic<int> Failure{ 0 }; // errno of the failure that ended the journal; 0 without one
  std::atomic<std::uint64_t> Written{ 0 };

  // Used by the writer thread. A forked child must leave them alone: see the destructor.
  std::unique_ptr<JournalWriter> Writer;
  std::unique_ptr<std::thread> WriterThread;
};

} // namespace VolumeHaptics

#endif

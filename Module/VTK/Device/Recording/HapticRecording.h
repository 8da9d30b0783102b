// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Records the ticks of the servo loop: a trace with all data for an exact replay.
 *
 * The recording has a thread of its own that writes every tick to a journal beside the file, so
 * that a slow disk delays neither the servo nor the session's keeper. A limited number of ticks may
 * wait for the disk; further ticks are lost and counted. At the end the file is made from the
 * journal (HapticRecordingFile.h).
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

/** A model that the loop may use, and its tool's memory, which is null if the tool needs none. */
struct PublishedTouch
{
  std::shared_ptr<const HapticModel> Model;
  std::shared_ptr<const ToolMemory> Tool;
};

class HapticRecording
{
public:
  /** Largest number of ticks that may wait for the disk: 15 s at 1 kHz, 6.8 MB. */
  static constexpr std::size_t MostWaiting = 15000;

  HapticRecording();
  /** Stops writing. The journal stays, unless Finish has made the file. */
  ~HapticRecording();
  HapticRecording(const HapticRecording&) = delete;
  HapticRecording& operator=(const HapticRecording&) = delete;

  /**
   * Begins the journal of a file. Returns false, and the reason and the cure in `error`, if the
   * file can't be written. A journal of the same name that an earlier program left is renamed;
   * `warning` then contains its new name.
   */
  bool Start(
    const std::string& file, const RecordingAbout& about, std::string& error, std::string& warning);

  /**
   * Adds the model of a generation that the loop may use from now on, with the memory of its tool.
   * Frees older models, so call it on their owner's thread.
   */
  void AddModel(std::uint64_t generation, std::shared_ptr<const HapticModel> model,
    std::shared_ptr<const ToolMemory> tool = nullptr);
  /**
   * Records a tick. Returns false if the tick is lost. Leaves out ticks without a model, because
   * they have no world coordinates. Until the first tick is recorded, also leaves out ticks that
   * are older than the kept memory of the tool and the removed tissue (ServoLoop::KeepTool).
   */
  bool Append(const ServoSnapshot& snapshot);
  /** Returns whether no tick has been recorded yet. */
  bool IsAwaited() const { return this->LastPlacement < 0; }
  /** Sets the hashes when they are known. Call it once, on the owner's thread. */
  void SetHashes(const RecordingHashes& hashes);

  /** Sets the number of ticks that were lost before they reached the recording. */
  void SetMissed(std::uint64_t ticks) { this->Missed.store(ticks); }
  std::uint64_t GetLostTicks() const { return this->Missed.load() + this->Dropped.load(); }

  const std::string& GetFile() const { return this->File; }

  /** Returns the number of ticks in the journal. */
  std::uint64_t GetNumberOfTicks() const { return this->Written.load(); }

  /**
   * Returns why the recording ended before it was stopped, and which part of it remains; empty if
   * the recording did not end early. Any thread may call this.
   */
  std::string GetTrouble() const;

  /**
   * Ends the journal and makes the file. Returns false if ticks are missing in the file; `error`
   * says where they are.
   */
  bool Finish(std::string& error);

private:
  void WriteUntilStopped();
  void WriteHashes();
  /** Writes a full group, or at the end the remaining ticks. Returns false if there are too few. */
  bool WriteGroup(bool isEnd);
  void StopWriter();
  bool IsOurs() const { return this->Process == ServoClock::GetProcess(); }

  std::string File;
  // the process that the thread and the journal belong to
  const std::int64_t Process = ServoClock::GetProcess();

  // Used by the keeper. The owner may use them only between two calls of the keeper.
  std::map<std::uint64_t, PublishedTouch> Models;
  WorkMeter Work;
  std::uint64_t LastGeneration = 0; // generation of the last tick that arrived, recorded or not
  std::uint64_t PlacedGeneration = 0;
  int LastPlacement = -1;

  // Shared by the keeper and the writer, under QueueMutex.
  std::mutex QueueMutex;
  std::deque<RecordingRow> Waiting;
  std::vector<PlacementRow> NewPlacements;
  std::unique_ptr<RecordingHashes> Hashes; // hashes to write; null once they are written
  std::unique_ptr<RecordingBegin> Begin;   // beginning to write; null once it is written
  std::vector<ContactRow> BeginContacts;   // contacts of Begin
  std::vector<BrickTissue> BeginTissue;    // removed tissue of Begin
  std::atomic<std::uint64_t> Missed{ 0 };
  std::atomic<std::uint64_t> Dropped{ 0 };
  std::atomic<bool> StopRequested{ false };
  std::atomic<int> Failure{ 0 }; // errno that ended the journal
  std::atomic<std::uint64_t> Written{ 0 };

  // Used by the writer. A forked child leaves them alone: see the destructor.
  std::unique_ptr<JournalWriter> Writer;
  std::unique_ptr<std::thread> WriterThread;
};

} // namespace VolumeHaptics

#endif

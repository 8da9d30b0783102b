// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A recording of the servo loop: a trace with all data for an exact replay.
 *
 * The recording has a thread of its own that writes every tick to a journal beside the file: a slow
 * disk delays neither the servo nor the session's keeper. A limited number of ticks may wait for
 * the disk; further ones are lost, and counted. At the end the file is made from the journal
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

/** A model that the loop may use, and the memory of its tool; null if that needs none. */
struct PublishedTouch
{
  std::shared_ptr<const HapticModel> Model;
  std::shared_ptr<const ToolMemory> Tool;
};

class HapticRecording
{
public:
  /** Ticks that may wait for the disk: 15 s at 1 kHz, 6.8 MB. */
  static constexpr std::size_t MostWaiting = 15000;

  HapticRecording();
  /** Stops writing; the journal stays, unless Finish made the file. */
  ~HapticRecording();
  HapticRecording(const HapticRecording&) = delete;
  HapticRecording& operator=(const HapticRecording&) = delete;

  /**
   * Begins the journal of a file. False, with the reason and the cure, if the file could not be
   * written. A journal of the same name that an earlier program left is renamed, and the warning
   * tells its new name.
   */
  bool Start(
    const std::string& file, const RecordingAbout& about, std::string& error, std::string& warning);

  /**
   * The model of a generation that the loop may use from now on, with the memory of its tool. Frees
   * older ones, so call it on their owner's thread.
   */
  void AddModel(std::uint64_t generation, std::shared_ptr<const HapticModel> model,
    std::shared_ptr<const ToolMemory> tool = nullptr);
  /**
   * Takes a tick; false if it is lost. Ticks without a model are left out, because they have no
   * world. So are ticks before that at which the memory of the tool and the removed tissue were
   * kept (ServoLoop::KeepTool), as long as none has come.
   */
  bool Append(const ServoSnapshot& snapshot);
  /** Whether no tick has been taken yet. */
  bool IsAwaited() const { return this->LastPlacement < 0; }
  /** Tells the hashes, once, when they are known; from the owner's thread. */
  void SetHashes(const RecordingHashes& hashes);

  /** The number of ticks that were lost before they came here. */
  void SetMissed(std::uint64_t ticks) { this->Missed.store(ticks); }
  std::uint64_t GetLostTicks() const { return this->Missed.load() + this->Dropped.load(); }

  const std::string& GetFile() const { return this->File; }

  /** The number of ticks in the journal. */
  std::uint64_t GetNumberOfTicks() const { return this->Written.load(); }

  /**
   * Why it ended before it was stopped, and what is left of it; empty if it did not. From any
   * thread.
   */
  std::string GetTrouble() const;

  /**
   * Ends the journal and makes the file. False if some of it is missing in the file; the error
   * tells where it is.
   */
  bool Finish(std::string& error);

private:
  void WriteUntilStopped();
  void WriteHashes();
  /** Writes a full group, or at the end any group; false if there is none. */
  bool WriteGroup(bool isEnd);
  void StopWriter();
  bool IsOurs() const { return this->Process == ServoClock::GetProcess(); }

  std::string File;
  // the process that the thread and the journal belong to
  const std::int64_t Process = ServoClock::GetProcess();

  // Used by the keeper, and by its owner between two of the keeper's calls.
  std::map<std::uint64_t, PublishedTouch> Models;
  WorkMeter Work;
  std::uint64_t LastGeneration = 0; // of the ticks that came, recorded or not
  std::uint64_t PlacedGeneration = 0;
  int LastPlacement = -1;

  // Shared by the keeper and the writer.
  std::mutex QueueMutex;
  std::deque<RecordingRow> Waiting;
  std::vector<PlacementRow> NewPlacements;
  std::unique_ptr<RecordingHashes> Hashes; // until they are written
  std::unique_ptr<RecordingBegin> Begin;   // until it is written
  std::vector<ContactRow> BeginContacts;   // of Begin
  std::vector<BrickShares> BeginShares;    // of Begin
  std::atomic<std::uint64_t> Missed{ 0 };
  std::atomic<std::uint64_t> Dropped{ 0 };
  std::atomic<bool> StopRequested{ false };
  std::atomic<int> Failure{ 0 }; // the errno that ended the journal
  std::atomic<std::uint64_t> Written{ 0 };

  // Used by the writer. A forked child leaves it alone: see the destructor.
  std::unique_ptr<JournalWriter> Writer;
  std::unique_ptr<std::thread> WriterThread;
};

} // namespace VolumeHaptics

#endif

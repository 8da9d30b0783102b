// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Collects the ticks of a servo loop for a recording and for displays, with their models.
 */
#ifndef TickCollector_h
#define TickCollector_h

#include "Core/Servo/ServoLoop.h"
#include "VTK/Session/HapticStateTable.h"
#include "VTK/Trace/HapticRecording.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** All functions are for the owner, except for Drain, which the keeper thread may call, too. */
class TickCollector
{
public:
  /** The loop must outlive this. */
  explicit TickCollector(ServoLoop& loop)
    : Loop(loop)
  {
  }

  /** Hands the loop a model, and keeps it for as long as a state of its ticks may be read. */
  void Publish(std::shared_ptr<const HapticModel> model);
  /** The model that was published last; null before the first. */
  const HapticModel* GetLatestModel() const
  {
    return this->Models.empty() ? nullptr : this->Models.rbegin()->second.get();
  }
  /** The model of a generation that the owner may still see in a state; null before the first. */
  const HapticModel* FindModel(std::uint64_t generation);

  ///@{
  /** The recording, which was started, is filled by Drain until it is handed back. */
  void StartRecording(std::unique_ptr<HapticRecording> recording);
  std::unique_ptr<HapticRecording> StopRecording();
  bool IsRecording() const { return this->Recording != nullptr; }
  /** Why the recording that is under way got no further; empty while all is well. */
  std::string GetRecordingTrouble() const
  {
    return this->Recording ? this->Recording->GetTrouble() : std::string();
  }
  ///@}

  ///@{
  /**
   * Every state since a reader's last call, oldest first, for a display that must not miss one; the
   * first call begins to keep them, and StopTaking ends it. Readers do not take each other's. If
   * one of them does not take for MostStates ticks, it loses the oldest.
   */
  std::vector<StateRow> TakeStates(int reader);
  void StopTaking(int reader);
  ///@}
  static constexpr std::size_t MostStates = 100000;

  /** Takes all ticks that the loop has written. */
  void Drain();

private:
  /** Lets go of the states that all readers have. Under the mutex. */
  void ForgetStates();
  /** Lets go of the models older than a generation that no reader can ask for any more. */
  void Forget(std::uint64_t generation);

  ServoLoop& Loop;
  std::mutex Mutex; // between the owner and the keeper; the loop never takes it
  std::unique_ptr<HapticRecording> Recording;
  std::uint64_t LostBefore = 0; // ticks, when the recording began
  struct Reader
  {
    std::uint64_t Next = 0;            // how many states there were before the first to be taken
    std::uint64_t TakenGeneration = 0; // of the last state that was taken
    std::uint64_t FirstUntaken = 0;    // no state to be taken is of an older one
  };
  std::map<int, Reader> Readers; // written by the owner, under the mutex
  std::deque<StateRow> States;
  std::uint64_t Forgotten = 0; // how many states there were before those
  /** The owner's: models by generation, from the one of the last state that was asked for. */
  std::map<std::uint64_t, std::shared_ptr<const HapticModel>> Models;
};

} // namespace VolumeHaptics

#endif

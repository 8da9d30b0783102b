// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A running servo: the loop on a thread of its own, and a keeper beside it.
 *
 * The keeper thread does what must neither be done in the loop nor wait for the GUI: it collects
 * the ticks of a recording or for a display, and quenches the device when the loop does not answer.
 */
#ifndef HapticSession_h
#define HapticSession_h

#include "Core/Servo/ServoClock.h"
#include "VTK/Session/HapticStateTable.h"
#include "VTK/Trace/HapticRecording.h"

#include "vtkMultiThreader.h"
#include "vtkNew.h"

#include <atomic>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace VolumeHaptics
{

class HapticSession
{
public:
  /** Starts the threads. The back end must be open and outlive the session. */
  HapticSession(DeviceBackend& backend, double rate, const SafetyLimits& limits,
    std::shared_ptr<const HapticModel> model);
  /** Stops the loop, with zero force sent, and joins the threads. */
  ~HapticSession();
  HapticSession(const HapticSession&) = delete;
  HapticSession& operator=(const HapticSession&) = delete;

  ServoLoop& GetLoop() { return this->Loop; }
  /** False in a process that was forked from the one whose threads these are. */
  bool IsOurs() const { return this->Process == ServoClock::GetProcess(); }

  void Publish(std::shared_ptr<const HapticModel> model);
  /** The model that was published last; null before the first. */
  const HapticModel* GetLatestModel() const
  {
    return this->Models.empty() ? nullptr : this->Models.rbegin()->second.get();
  }
  /** The model of a generation that the owner may still see in a state; null before the first. */
  const HapticModel* FindModel(std::uint64_t generation);

  ///@{
  /** The recording, which was started, is filled by the keeper until it is handed back. */
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
   * first call begins to keep them, and StopTaking ends it. Readers do not take each other's. What
   * one of them does not take for MostStates ticks is lost to it, oldest first. The owner's.
   */
  std::vector<StateRow> TakeStates(int reader);
  void StopTaking(int reader);
  ///@}
  static constexpr std::size_t MostStates = 100000;

  /**
   * Lets the force fade (ServoLoop::Hold) and waits until it is gone, a quarter of a second at
   * most.
   */
  void Hold() noexcept;
  /**
   * From any thread: no force on the devices of all these once this returns, until they are armed
   * again. Each is told before any is waited for, so that a loop that hangs delays none of the
   * others; 40 ms at most, all together.
   */
  static void Quench(const std::vector<HapticSession*>& sessions) noexcept;
  /** Stops the loop, with zero force sent, and joins the threads, as the destructor does. */
  void End();

private:
  static VTK_THREAD_RETURN_TYPE RunLoop(void* info);
  static VTK_THREAD_RETURN_TYPE RunFitter(void* info);
  static VTK_THREAD_RETURN_TYPE RunKeeper(void* info);
  void Keep();
  void Drain();
  /**
   * After Quench was begun: whether the device has got it, and no tick is under way that may still
   * write a force.
   */
  bool IsQuenched() noexcept;
  /** Lets go of the states that all readers have. Under the mutex. */
  void ForgetStates();
  /** Lets go of the models older than a generation that nobody can ask for any more. */
  void Forget(std::uint64_t generation);

  DeviceBackend& Backend;
  ServoLoop Loop;
  vtkNew<vtkMultiThreader> Threader;
  const std::int64_t Process = ServoClock::GetProcess(); // whose threads they are
  int LoopThread = -1;
  int FitterThread = -1;
  int KeeperThread = -1;
  std::atomic<bool> KeeperStop{ false };
  std::atomic<bool> HasEnded{ false };
  ///@{
  /**
   * Of Quench, which one thread at a time may call: the tick that sees it, and whether that has
   * come.
   */
  std::uint64_t QuenchedTick = 0;
  bool HasSeenQuench = false;
  ///@}
  std::mutex RecordingMutex; // between the owner and the keeper; the loop never takes it
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

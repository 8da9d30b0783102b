// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The threads of a running servo: the loop's own thread and five helper threads.
 *
 * The fitter thread computes local surfaces. The sample thread keeps the samples around the tip in
 * memory. The keeper thread does the work that must not run in the loop and must not wait for the
 * GUI: it collects ticks for a recording or a display, and quenches the device (sends zero force)
 * if the loop does not answer. The watch thread wakes the loop up on another processor if the
 * loop's own processor does not do so in time. The fifth thread asks RealtimeKit for real-time
 * scheduling of the loop if the kernel refuses it, and then ends.
 */
#ifndef ServoThreads_h
#define ServoThreads_h

#include "Core/Realtime/ServoClock.h"
#include "Core/Servo/ServoLoop.h"
#include "VTK/Device/Recording/TickCollector.h"

#include "vtkMultiThreader.h"
#include "vtkNew.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <vector>

namespace VolumeHaptics
{

class ServoThreads
{
public:
  /** Starts the threads. The back end must be open and must outlive them. */
  ServoThreads(DeviceBackend& backend, double rate, const SafetyLimits& limits,
    std::shared_ptr<const HapticModel> model);
  /** Sends zero force, stops the loop and joins the threads. */
  ~ServoThreads();
  ServoThreads(const ServoThreads&) = delete;
  ServoThreads& operator=(const ServoThreads&) = delete;

  ServoLoop& GetLoop() { return this->Loop; }
  TickCollector& GetTicks() { return this->Ticks; }
  /** Returns whether this process started the threads; false in a fork of that process. */
  bool IsOurs() const { return this->Process == ServoClock::GetProcess(); }

  /**
   * Fades the force out (ServoLoop::Hold) and waits until it is gone, at most a quarter of a
   * second.
   */
  void Hold() noexcept;
  /**
   * Quenches all these servos: when this returns, their devices have no force until they are armed
   * again. Orders all of them to quench before it waits for the first, so that a hanging loop does
   * not delay the others. Takes at most 40 ms in total. Any thread may call this.
   */
  static void Quench(const std::vector<ServoThreads*>& servos) noexcept;
  /** Sends zero force, stops the loop and joins the threads, as the destructor does. */
  void End();

private:
  static VTK_THREAD_RETURN_TYPE RunLoop(void* info);
  static VTK_THREAD_RETURN_TYPE RunFitter(void* info);
  static VTK_THREAD_RETURN_TYPE RunSampleKeeper(void* info);
  static VTK_THREAD_RETURN_TYPE RunKeeper(void* info);
  static VTK_THREAD_RETURN_TYPE RunWatch(void* info);
  static VTK_THREAD_RETURN_TYPE RunRequest(void* info);
  void Keep();
  /**
   * Returns whether the device has received the order of Quench and no running tick can write a
   * force any more. Call this only after Quench has begun.
   */
  bool IsQuenched() noexcept;

  DeviceBackend& Backend;
  ServoLoop Loop;
  TickCollector Ticks{ Loop };
  vtkNew<vtkMultiThreader> Threader;
  const std::int64_t Process = ServoClock::GetProcess(); // process that started the threads
  int LoopThread = -1;
  int FitterThread = -1;
  int SampleThread = -1;
  int KeeperThread = -1;
  int WatchThread = -1;
  int RequestThread = -1;
  std::atomic<bool> KeeperStop{ false };
  std::atomic<bool> HasEnded{ false };
  ///@{
  /**
   * State of Quench, which only one thread may call at a time. QuenchedTick: number of the first
   * tick that surely sees the order. HasSeenQuench: whether that tick has run.
   */
  std::uint64_t QuenchedTick = 0;
  bool HasSeenQuench = false;
  ///@}
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/ServoThreads.h"

#include <utility>

namespace VolumeHaptics
{
namespace
{

/**
 * KeeperPeriod: interval (ns) at which the keeper polls. MostSilence: time (ns) without a tick
 * after which the keeper quenches the device.
 */
constexpr std::int64_t KeeperPeriod = 5000000;
constexpr std::int64_t MostSilence = 40000000;
/** Interval (ns) at which Quench polls the loop. */
constexpr std::int64_t QuenchPoll = 200000;
/**
 * Longest time (ns) that Hold waits for a fade. A fade takes 50 ms and may begin late on a busy
 * machine.
 */
constexpr std::int64_t LongestFade = 250000000;

template <typename T>
T* UserData(void* info)
{
  return static_cast<T*>(static_cast<vtkMultiThreader::ThreadInfo*>(info)->UserData);
}

} // namespace

ServoThreads::ServoThreads(DeviceBackend& backend, double rate, const SafetyLimits& limits,
  std::shared_ptr<const HapticModel> model)
  : Backend(backend)
  , Loop(backend, rate)
{
  this->Loop.SetLimits(limits);
  if (model)
  {
    this->Ticks.Publish(std::move(model));
  }
  this->LoopThread = this->Threader->SpawnThread(&ServoThreads::RunLoop, this);
  this->FitterThread = this->Threader->SpawnThread(&ServoThreads::RunFitter, this);
  this->SampleThread = this->Threader->SpawnThread(&ServoThreads::RunSampleKeeper, this);
  this->KeeperThread = this->Threader->SpawnThread(&ServoThreads::RunKeeper, this);
  this->WatchThread = this->Threader->SpawnThread(&ServoThreads::RunWatch, this);
  this->RequestThread = this->Threader->SpawnThread(&ServoThreads::RunRequest, this);
}

ServoThreads::~ServoThreads()
{
  this->End();
}

void ServoThreads::End()
{
  if (this->HasEnded.load() || !this->IsOurs())
  {
    return; // the threads have already ended, or belong to the parent of this forked process
  }
  // RequestStop() makes the thread functions return; TerminateThread then only joins the threads.
  this->Loop.RequestStop();
  this->Threader->TerminateThread(this->LoopThread);
  this->Threader->TerminateThread(this->FitterThread);
  this->Threader->TerminateThread(this->SampleThread);
  this->Threader->TerminateThread(this->WatchThread);
  this->Threader->TerminateThread(this->RequestThread);
  this->KeeperStop.store(true);
  this->Threader->TerminateThread(this->KeeperThread);
  this->HasEnded.store(true);
}

VTK_THREAD_RETURN_TYPE ServoThreads::RunLoop(void* info)
{
  UserData<ServoThreads>(info)->Loop.Run();
  return VTK_THREAD_RETURN_VALUE;
}

VTK_THREAD_RETURN_TYPE ServoThreads::RunFitter(void* info)
{
  UserData<ServoThreads>(info)->Loop.RunFitter();
  return VTK_THREAD_RETURN_VALUE;
}

VTK_THREAD_RETURN_TYPE ServoThreads::RunSampleKeeper(void* info)
{
  UserData<ServoThreads>(info)->Loop.RunSampleKeeper();
  return VTK_THREAD_RETURN_VALUE;
}

VTK_THREAD_RETURN_TYPE ServoThreads::RunKeeper(void* info)
{
  UserData<ServoThreads>(info)->Keep();
  return VTK_THREAD_RETURN_VALUE;
}

VTK_THREAD_RETURN_TYPE ServoThreads::RunWatch(void* info)
{
  ServoClock::BlockSignals();
  UserData<ServoThreads>(info)->Loop.WatchSleep();
  return VTK_THREAD_RETURN_VALUE;
}

VTK_THREAD_RETURN_TYPE ServoThreads::RunRequest(void* info)
{
  ServoClock::BlockSignals();
  UserData<ServoThreads>(info)->Loop.AskRealtimeKit();
  return VTK_THREAD_RETURN_VALUE;
}

void ServoThreads::Keep()
{
  ServoClock::BlockSignals();
  std::uint64_t seen = this->Loop.GetTickCount();
  std::int64_t seenAt = ServoClock::Now();
  while (!this->KeeperStop.load())
  {
    const std::int64_t now = ServoClock::Now();
    const std::uint64_t count = this->Loop.GetTickCount();
    if (count != seen)
    {
      seen = count;
      seenAt = now;
    }
    else if (now - seenAt > MostSilence)
    {
      this->Backend.Quench();
    }
    this->Ticks.Drain();
    ServoClock::SleepUntil(now + KeeperPeriod);
  }
}

void ServoThreads::Hold() noexcept
{
  this->Loop.Hold();
  const std::int64_t latest = ServoClock::Now() + LongestFade;
  while (!this->Loop.IsAtRest() && ServoClock::Now() < latest)
  {
    ServoClock::SleepUntil(ServoClock::Now() + QuenchPoll);
  }
}

bool ServoThreads::IsQuenched() noexcept
{
  if (!this->HasSeenQuench)
  {
    if (!this->HasEnded.load() && this->Loop.GetTickCount() < this->QuenchedTick)
    {
      return false;
    }
    this->Backend.Quench();
    this->HasSeenQuench = true;
  }
  return this->Backend.IsAtRest();
}

void ServoThreads::Quench(const std::vector<ServoThreads*>& servos) noexcept
{
  for (ServoThreads* servo : servos)
  {
    servo->Loop.Disarm();
  }
  for (ServoThreads* servo : servos)
  {
    servo->Backend.Quench();
    // The running tick may still write a force. The second tick from now is the first that surely
    // sees Disarm; if the loop hangs before it, it does not write a force either.
    servo->QuenchedTick = servo->Loop.GetTickCount() + 2;
    servo->HasSeenQuench = false;
  }
  const auto areQuenched = [&servos]
  {
    bool all = true;
    for (ServoThreads* servo : servos)
    {
      all = servo->IsQuenched() && all;
    }
    return all;
  };
  const std::int64_t latest = ServoClock::Now() + MostSilence;
  while (!areQuenched() && ServoClock::Now() < latest)
  {
    ServoClock::SleepUntil(ServoClock::Now() + QuenchPoll);
  }
  for (ServoThreads* servo : servos)
  {
    servo->HasSeenQuench ? void() : servo->Backend.Quench();
  }
}

} // namespace VolumeHaptics

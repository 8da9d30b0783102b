// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Session/HapticSession.h"

#include "Core/Servo/ServoClock.h"

#include <algorithm>
#include <chrono>
#include <thread>

namespace VolumeHaptics
{
namespace
{

/** How often the keeper looks (ns), and how long the loop may be silent before it is quenched (ns).
 */
constexpr std::int64_t KeeperPeriod = 5000000;
constexpr std::int64_t MostSilence = 40000000;
/** How often Quench looks whether the loop has got it (ns). */
constexpr std::int64_t QuenchPoll = 200000;
/**
 * For how long Hold waits for a fade (ns), which takes 50 ms and may begin late on a busy machine.
 */
constexpr std::int64_t LongestFade = 250000000;

template <typename T>
T* UserData(void* info)
{
  return static_cast<T*>(static_cast<vtkMultiThreader::ThreadInfo*>(info)->UserData);
}

} // namespace

HapticSession::HapticSession(DeviceBackend& backend, double rate, const SafetyLimits& limits,
  std::shared_ptr<const HapticModel> model)
  : Backend(backend)
  , Loop(backend, rate)
{
  this->Loop.SetLimits(limits);
  if (model)
  {
    this->Publish(std::move(model));
  }
  this->LoopThread = this->Threader->SpawnThread(&HapticSession::RunLoop, this);
  this->FitterThread = this->Threader->SpawnThread(&HapticSession::RunFitter, this);
  this->KeeperThread = this->Threader->SpawnThread(&HapticSession::RunKeeper, this);
}

HapticSession::~HapticSession()
{
  this->End();
}

void HapticSession::End()
{
  if (this->HasEnded.load() || !this->IsOurs())
  {
    return; // the threads are gone, or those of the process that this one was forked from
  }
  // Our own flags stop the threads; TerminateThread only joins them.
  this->Loop.RequestStop();
  this->Threader->TerminateThread(this->LoopThread);
  this->Threader->TerminateThread(this->FitterThread);
  this->KeeperStop.store(true);
  this->Threader->TerminateThread(this->KeeperThread);
  this->HasEnded.store(true);
}

VTK_THREAD_RETURN_TYPE HapticSession::RunLoop(void* info)
{
  UserData<HapticSession>(info)->Loop.Run();
  return VTK_THREAD_RETURN_VALUE;
}

VTK_THREAD_RETURN_TYPE HapticSession::RunFitter(void* info)
{
  UserData<HapticSession>(info)->Loop.RunFitter();
  return VTK_THREAD_RETURN_VALUE;
}

VTK_THREAD_RETURN_TYPE HapticSession::RunKeeper(void* info)
{
  UserData<HapticSession>(info)->Keep();
  return VTK_THREAD_RETURN_VALUE;
}

void HapticSession::Keep()
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
    this->Drain();
    ServoClock::SleepUntil(now + KeeperPeriod);
  }
}

void HapticSession::Drain()
{
  const std::lock_guard<std::mutex> lock(this->RecordingMutex);
  ServoSnapshot snapshot;
  while (this->Loop.Drain(snapshot))
  {
    if (this->Recording)
    {
      this->Recording->Append(snapshot);
    }
    if (!this->Readers.empty())
    {
      if (this->States.size() == MostStates)
      {
        this->States.pop_front();
        ++this->Forgotten;
      }
      this->States.emplace_back(snapshot);
    }
  }
  if (this->Recording)
  {
    this->Recording->SetMissed(this->Loop.GetLostRecords() - this->LostBefore);
  }
}

void HapticSession::Publish(std::shared_ptr<const HapticModel> model)
{
  const std::lock_guard<std::mutex> lock(this->RecordingMutex);
  const std::uint64_t generation = this->Loop.Publish(model);
  if (this->Recording)
  {
    this->Recording->AddModel(generation, model);
  }
  this->Models[generation] = std::move(model);
  // Where nobody asks for states, models must not pile up either.
  for (auto& [id, reader] : this->Readers)
  {
    if (reader.Next < this->Forgotten && !this->States.empty())
    {
      const std::uint64_t first = this->States.front().Generation;
      reader.TakenGeneration = std::max(reader.TakenGeneration, first);
      reader.FirstUntaken = std::max(reader.FirstUntaken, first);
    }
  }
  this->Forget(this->Loop.GetWrittenGeneration());
}

void HapticSession::Forget(std::uint64_t generation)
{
  std::uint64_t first = generation;
  for (const auto& [id, reader] : this->Readers)
  {
    first = std::min(first, reader.FirstUntaken);
  }
  this->Models.erase(this->Models.begin(), this->Models.lower_bound(first));
}

void HapticSession::ForgetStates()
{
  std::uint64_t least = this->Forgotten + this->States.size();
  for (const auto& [id, reader] : this->Readers)
  {
    least = std::min(least, reader.Next);
  }
  for (; this->Forgotten < least; ++this->Forgotten)
  {
    this->States.pop_front();
  }
}

std::vector<StateRow> HapticSession::TakeStates(int id)
{
  if (this->Readers.count(id) == 0)
  {
    const std::uint64_t generation = this->Loop.GetWrittenGeneration();
    this->Drain(); // what is of other readers alone
    const std::lock_guard<std::mutex> lock(this->RecordingMutex);
    this->Readers[id] = { this->Forgotten + this->States.size(), generation, generation };
    this->Loop.SetRecording(true);
  }
  this->Drain();
  const std::lock_guard<std::mutex> lock(this->RecordingMutex);
  Reader& reader = this->Readers[id];
  const std::uint64_t first = std::max(reader.Next, this->Forgotten) - this->Forgotten;
  std::vector<StateRow> states(
    this->States.begin() + static_cast<std::ptrdiff_t>(first), this->States.end());
  reader.Next = this->Forgotten + this->States.size();
  reader.FirstUntaken = reader.TakenGeneration;
  if (!states.empty())
  {
    reader.TakenGeneration = states.back().Generation;
  }
  this->ForgetStates();
  return states;
}

void HapticSession::StopTaking(int id)
{
  const std::lock_guard<std::mutex> lock(this->RecordingMutex);
  this->Readers.erase(id);
  this->ForgetStates();
  this->Loop.SetRecording(this->Recording || !this->Readers.empty());
}

const HapticModel* HapticSession::FindModel(std::uint64_t generation)
{
  // States come in order: what is older than this one is not asked for again.
  this->Forget(generation);
  const auto found = this->Models.find(generation);
  return found == this->Models.end() ? nullptr : found->second.get();
}

void HapticSession::StartRecording(std::unique_ptr<HapticRecording> recording)
{
  const std::lock_guard<std::mutex> lock(this->RecordingMutex);
  this->LostBefore = this->Loop.GetLostRecords();
  for (const auto& [generation, model] : this->Models)
  {
    recording->AddModel(generation, model);
  }
  this->Recording = std::move(recording);
  this->Loop.SetRecording(true);
}

std::unique_ptr<HapticRecording> HapticSession::StopRecording()
{
  this->Loop.SetRecording(!this->Readers.empty());
  // The tick that the loop is in belongs to it, too.
  const std::uint64_t last = this->Loop.GetTickCount();
  for (int i = 0; i < 100 && this->Loop.GetTickCount() == last; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  this->Drain();
  const std::lock_guard<std::mutex> lock(this->RecordingMutex);
  return std::move(this->Recording);
}

void HapticSession::Hold() noexcept
{
  this->Loop.Hold();
  const std::int64_t latest = ServoClock::Now() + LongestFade;
  while (!this->Loop.IsAtRest() && ServoClock::Now() < latest)
  {
    ServoClock::SleepUntil(ServoClock::Now() + QuenchPoll);
  }
}

bool HapticSession::IsQuenched() noexcept
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

void HapticSession::Quench(const std::vector<HapticSession*>& sessions) noexcept
{
  for (HapticSession* session : sessions)
  {
    session->Loop.Disarm();
  }
  for (HapticSession* session : sessions)
  {
    session->Backend.Quench();
    // A tick that is under way may still write a force after that. The second one from here has
    // seen Disarm; a loop that does not get there does not write either.
    session->QuenchedTick = session->Loop.GetTickCount() + 2;
    session->HasSeenQuench = false;
  }
  const auto areQuenched = [&sessions]
  {
    bool all = true;
    for (HapticSession* session : sessions)
    {
      all = session->IsQuenched() && all;
    }
    return all;
  };
  const std::int64_t latest = ServoClock::Now() + MostSilence;
  while (!areQuenched() && ServoClock::Now() < latest)
  {
    ServoClock::SleepUntil(ServoClock::Now() + QuenchPoll);
  }
  for (HapticSession* session : sessions)
  {
    session->HasSeenQuench ? void() : session->Backend.Quench();
  }
}

} // namespace VolumeHaptics

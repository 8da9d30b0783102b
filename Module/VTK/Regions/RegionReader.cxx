// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/RegionReader.h"

#include "Core/Realtime/ServoClock.h"
#include "VTK/Base/OutsideFiller.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <system_error>
#include <utility>

namespace VolumeHaptics
{
namespace
{

using Milliseconds = std::chrono::milliseconds;
constexpr Milliseconds ShortestDelay{ 50 };
constexpr Milliseconds LongestDelay{ 2000 };

} // namespace

struct RegionReader::Work
{
  explicit Work(std::shared_ptr<const LargeVolume> volume)
    : Volume(std::move(volume))
  {
  }

  const std::shared_ptr<const LargeVolume> Volume;
  ///@{
  /** Guarded by the mutex, down to Revival. The mutex is never held during a read. */
  mutable std::mutex Mutex;
  std::condition_variable Wake;
  bool IsEnding = false;
  std::optional<BoxExtent> Ordered;
  std::optional<VolumeFacts> Facts;
  std::optional<RegionSamples> Arrived;
  std::string Trouble;
  bool IsLost = false;      ///< whether the thread has ended without being told to
  std::int64_t Revival = 0; ///< earliest time (ServoClock) for the start of another thread
  ///@}
  ///@{
  /** Used only by the thread. */
  Milliseconds Delay{ 0 };
  OutsideSamples Outside;
  ///@}

  void RunToEnd();
  void Run();
  bool Survey();
  /** Waits for the next order. Returns nothing if the thread must end. */
  std::optional<BoxExtent> AwaitOrder();
  std::optional<RegionSamples> Read(const BoxExtent& region, std::string& error) const;
  /**
   * Stores the reason for a failed read, and waits before the next attempt. Returns false if the
   * thread must end.
   */
  bool RecordFailure(const std::string& error);
  /**
   * Records that a reader function ends this thread. Called while the thread's stack is unwound.
   */
  void RecordLoss() noexcept;
};

bool RegionReader::Work::RecordFailure(const std::string& error)
{
  this->Delay = std::clamp(2 * this->Delay, ShortestDelay, LongestDelay);
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Trouble = error;
  return !this->Wake.wait_for(lock, this->Delay, [this] { return this->IsEnding; });
}

void RegionReader::Work::RecordLoss() noexcept
{
  this->Delay = std::clamp(2 * this->Delay, ShortestDelay, LongestDelay);
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->IsLost = true;
  this->Revival = ServoClock::Now() + this->Delay.count() * ServoClock::Millisecond;
  try
  {
    this->Trouble = "The samples can't be read from " + this->Volume->Name +
      ": its reader ends the thread that calls it. Let it return instead.";
  }
  catch (const std::bad_alloc&)
  {
    this->Trouble.clear();
  }
}

bool RegionReader::Work::Survey()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (this->Facts)
    {
      return true;
    }
  }
  VolumeSurvey survey(*this->Volume);
  while (!survey.IsDone())
  {
    std::string error;
    if (!survey.Advance(error))
    {
      if (!this->RecordFailure(error))
      {
        return false;
      }
      continue;
    }
    this->Delay = Milliseconds(0);
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Trouble.clear();
    if (this->IsEnding)
    {
      return false;
    }
  }
  const VolumeFacts facts = survey.GetFacts();
  const std::lock_guard<std::mutex> lock(this->Mutex);
  this->Facts = facts;
  return true;
}

std::optional<BoxExtent> RegionReader::Work::AwaitOrder()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->Wake.wait(lock, [this] { return this->IsEnding || this->Ordered; });
  return this->IsEnding ? std::nullopt : this->Ordered;
}

std::optional<RegionSamples> RegionReader::Work::Read(
  const BoxExtent& region, std::string& error) const
{
  const auto size = static_cast<std::size_t>(CountSamples(region)) * this->Volume->SampleSize;
  RegionSamples samples{ region, std::unique_ptr<void, FreeMemory>(std::malloc(size)) };
  if (!samples.Samples)
  {
    error = "There is not enough memory for a region of " + this->Volume->Name + ": it takes " +
      std::to_string(size) + " bytes. Lower MemoryLimit.";
    return std::nullopt;
  }
  if (!ReadSamples(*this->Volume, region, samples.Samples.get(), error))
  {
    return std::nullopt;
  }
  FillOutside(this->Outside, this->Volume->ScalarType, samples.Samples.get(),
    static_cast<std::int64_t>(CountSamples(region)));
  return samples;
}

void RegionReader::Work::Run()
{
  if (!this->Survey())
  {
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Outside = this->Facts->Outside;
  }
  while (const std::optional<BoxExtent> region = this->AwaitOrder())
  {
    std::string error;
    std::optional<RegionSamples> samples = this->Read(*region, error);
    if (!samples)
    {
      if (!this->RecordFailure(error))
      {
        return;
      }
      continue;
    }
    this->Delay = Milliseconds(0);
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Trouble.clear();
    this->Arrived = std::move(samples);
    if (this->Ordered == region)
    {
      this->Ordered.reset();
    }
  }
}

void RegionReader::Work::RunToEnd()
{
  // Detects that a reader function ends its thread: pthread_exit() unwinds the stack, and Python
  // calls it when the interpreter ends.
  struct End
  {
    Work& Of;
    bool IsOrderly = false;
    ~End()
    {
      if (!this->IsOrderly)
      {
        this->Of.RecordLoss();
      }
    }
  } end{ *this };
  for (bool goesOn = true; goesOn;)
  {
    try
    {
      this->Run();
      goesOn = false;
    }
    catch (const std::bad_alloc&) // memory may be available again later
    {
      goesOn = this->RecordFailure(std::string());
    }
  }
  end.IsOrderly = true;
}

RegionReader::RegionReader(
  std::shared_ptr<const LargeVolume> volume, const std::optional<VolumeFacts>& facts)
  : Shared(std::make_shared<Work>(std::move(volume)))
  , Process(ServoClock::GetProcess())
{
  this->Shared->Facts = facts;
  this->Begin();
}

void RegionReader::Begin()
{
  this->Thread = std::make_unique<std::thread>(
    [work = this->Shared]
    {
      ServoClock::BlockSignals();
      work->RunToEnd();
    });
}

RegionReader::~RegionReader()
{
  if (this->Process != ServoClock::GetProcess())
  {
    // In a forked child, the thread, and perhaps a lock of the mutex, belong to the parent.
    (void)this->Thread.release();
    (void)new std::shared_ptr<Work>(std::move(this->Shared));
    return;
  }
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    this->Shared->IsEnding = true;
  }
  this->Shared->Wake.notify_all();
  if (!this->Thread->joinable())
  {
    return; // the lost thread was joined, but no new thread could be started
  }
  if (this->Shared->Volume->IsAwaited)
  {
    this->Thread->join();
  }
  else
  {
    this->Thread->detach();
  }
}

void RegionReader::Order(const BoxExtent& region)
{
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    this->Shared->Ordered = region;
  }
  this->Shared->Wake.notify_all();
}

std::optional<VolumeFacts> RegionReader::GetFacts() const
{
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  return this->Shared->Facts;
}

void RegionReader::Revive()
{
  if (this->Process != ServoClock::GetProcess())
  {
    return; // in a forked child: see the destructor
  }
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    if (!this->Shared->IsLost || ServoClock::Now() < this->Shared->Revival)
    {
      return;
    }
    this->Shared->IsLost = false;
  }
  if (this->Thread->joinable())
  {
    this->Thread->join();
  }
  try
  {
    this->Begin();
  }
  catch (const std::system_error&)
  {
    const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
    this->Shared->IsLost = true; // no thread was available; try again later
  }
}

std::optional<RegionSamples> RegionReader::Drain()
{
  this->Revive();
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  return std::exchange(this->Shared->Arrived, std::nullopt);
}

std::string RegionReader::GetTrouble() const
{
  const std::lock_guard<std::mutex> lock(this->Shared->Mutex);
  return this->Shared->Trouble;
}

} // namespace VolumeHaptics

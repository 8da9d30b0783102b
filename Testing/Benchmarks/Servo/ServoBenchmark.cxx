// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The servo's cost beyond the solver, and its punctuality on this machine: with all that the user
 * may have, and in turn without any of it; alone, and beside as many busy threads as the machine
 * has processors. To see it without a privilege, run it as an ordinary user.
 *
 * usage: volumehaptics-servo-benchmark [--seconds S]   (S a line of the table, 2 by default)
 */

#include "Core/Servo/ServoClock.h"
#include "Core/Servo/ServoLoop.h"
#include "Rigs/CoreScene.h"

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <pthread.h>
#include <sys/prctl.h>
#include <thread>
#include <vector>

using namespace coretest;

namespace
{

/** Slides over the ramp, 0.1 m/s at 1 kHz. A plain one returns all that the loop was granted. */
class Slide : public DeviceBackend
{
public:
  explicit Slide(bool plain)
    : Plain(plain)
  {
  }
  bool Open(std::string&) override { return true; }
  void Close() override {}
  std::string GetName() const override { return "slide"; }
  DeviceLimits GetLimits() const override { return {}; }
  DeviceState Read(double, DeviceSample& sample) noexcept override
  {
    if (this->Tick == 0 && this->Plain)
    {
      const sched_param none{};
      pthread_setschedparam(pthread_self(), SCHED_OTHER, &none); // and the slice that is usual
      prctl(PR_SET_TIMERSLACK, 0UL);                             // as it was
    }
    const double phase = 0.02 * static_cast<double>(this->Tick++);
    sample.Tip = { 0.012 + 0.005 * std::sin(phase), 0.012, 0.012 + 0.002 * std::sin(0.1 * phase) };
    sample.Fresh = true;
    return DeviceState::Running;
  }
  DeviceState Write(const Vector3&) noexcept override { return DeviceState::Running; }
  void Quench() noexcept override {}

private:
  const bool Plain;
  std::uint64_t Tick = 0;
};

class RunningLoop
{
public:
  RunningLoop(double rate, bool plain, std::shared_ptr<const HapticModel> model)
    : Device(plain)
    , Loop(this->Device, rate)
  {
    SafetyLimits limits;
    limits.MaximumForce = 4.0;
    this->Loop.SetLimits(limits);
    this->Loop.Publish(std::move(model));
    this->Loop.Arm();
    this->Thread = std::thread([this] { this->Loop.Run(); });
    this->Wait(0.1);
    this->Loop.ResetStatistics();
  }
  ~RunningLoop()
  {
    this->Loop.RequestStop();
    this->Thread.join();
  }
  void Wait(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }
  ServoLoop* operator->() { return &this->Loop; }

private:
  Slide Device;
  ServoLoop Loop;
  std::thread Thread;
};

double Median(std::vector<double> values)
{
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return values.empty() ? 0.0 : *middle;
}

void PrintCost(const std::shared_ptr<const HapticModel>& model, double seconds)
{
  const auto cost = [&](std::shared_ptr<const HapticModel> used)
  {
    RunningLoop loop(10000.0, false, std::move(used));
    loop->SetRecording(true);
    ServoSnapshot s;
    for (int i = 0; i < 100; ++i)
    {
      loop.Wait(0.01 * seconds);
      while (loop->Drain(s))
      {
      }
    }
    return loop->GetTickCost().GetPercentile(0.5);
  };
  const double all = cost(model);
  const double servo = cost(nullptr);
  std::printf(
    "Cost of a tick at 10 kHz, recording, p50 to 1/8: %.0f ns; without a model, that is, the "
    "servo beyond the solver: %.0f ns (wanted: 1000 or less)\n",
    all, servo);
}

void PrintHandOff(const std::shared_ptr<const HapticModel>& model)
{
  RunningLoop loop(1000.0, false, model);
  loop->SetRecording(true);
  ServoSnapshot s;
  std::vector<double> ticks;
  double most = 0.0;
  for (int i = 0; i < 300; ++i)
  {
    const std::uint64_t done = loop->GetTickCount();
    const std::uint64_t generation = loop->Publish(model);
    do
    {
      std::this_thread::yield();
    } while (!loop->Drain(s) || s.Generation < generation);
    ticks.push_back(static_cast<double>(s.Tick + 1 - done));
    most = std::max(most, ticks.back());
  }
  std::printf("Publish to effect: %.0f tick(s), at most %.0f\n", Median(ticks), most);

  std::vector<double> reads;
  std::uint64_t sum = 0;
  while (reads.size() < 1000)
  {
    const std::int64_t before = ServoClock::Now();
    const bool fresh = loop->ReadState();
    const ServoSnapshot copy = loop->GetState();
    const std::int64_t after = ServoClock::Now();
    sum += copy.Tick;
    if (fresh)
    {
      reads.push_back(static_cast<double>(after - before));
    }
    std::this_thread::yield();
  }
  std::printf("Reading a state (%zu bytes) that is new: %.0f ns, the clock included%s\n",
    sizeof(ServoSnapshot), Median(reads), sum == 0 ? " (?)" : "");
}

/** Threads that compute without pause, as those of a software renderer do. */
class BusyThreads
{
public:
  explicit BusyThreads(unsigned count)
  {
    for (unsigned i = 0; i < count; ++i)
    {
      this->Threads.emplace_back(
        [this]
        {
          volatile double value = 1.0;
          while (!this->Stop.load())
          {
            for (int k = 0; k < 10000; ++k)
            {
              value = std::sin(value) + 1.0;
            }
          }
        });
    }
  }
  ~BusyThreads()
  {
    this->Stop.store(true);
    for (std::thread& thread : this->Threads)
    {
      thread.join();
    }
  }

private:
  std::atomic<bool> Stop{ false };
  std::vector<std::thread> Threads;
};

const char* NameScheduling(bool plain, RealTimeGrant grant)
{
  return plain                            ? "SCHED_OTHER"
    : grant == RealTimeGrant::Kernel      ? "SCHED_FIFO"
    : grant == RealTimeGrant::RealtimeKit ? "RealtimeKit"
                                          : "short slices";
}

/** What short runs of one kind told. */
struct Punctuality
{
  double Ticks = 0.0;
  double Missed = 0.0;
  std::vector<double> Wake[4];
  RealTimeGrant Grant = RealTimeGrant::Unknown;
};
constexpr double WakeShares[4] = { 0.5, 0.9, 0.99, 0.999 };

/** In turn, so that what else the machine does falls on each way of scheduling alike. */
void PrintTimeKeeping(
  const std::shared_ptr<const HapticModel>& model, double seconds, unsigned busy)
{
  constexpr int turns = 5;
  std::printf(
    "Time keeping beside %u busy threads, over %.1f s each in %d turns; wake-up after the "
    "planned time, microseconds\n"
    "%8s  %-22s %9s %8s %8s %8s %8s\n",
    busy, seconds, turns, "rate/Hz", "scheduling", "missed", "p50", "p90", "p99", "p99.9");
  for (const double rate : { 1000.0, 5000.0, 10000.0 })
  {
    Punctuality kinds[2];
    for (int turn = 0; turn < turns; ++turn)
    {
      for (const bool plain : { false, true })
      {
        const BusyThreads load(busy);
        RunningLoop loop(rate, plain, model);
        loop.Wait(seconds / turns);
        Punctuality& kind = kinds[plain ? 1 : 0];
        kind.Grant = loop->GetRealTimePriority();
        kind.Ticks += static_cast<double>(loop->GetTickCost().GetTotal());
        kind.Missed += static_cast<double>(loop->GetMissedTicks());
        for (int i = 0; i < 4; ++i)
        {
          kind.Wake[i].push_back(1e-3 * loop->GetWakeLatency().GetPercentile(WakeShares[i]));
        }
      }
    }
    for (const bool plain : { false, true })
    {
      const Punctuality& kind = kinds[plain ? 1 : 0];
      std::printf("%8.0f  %-22s %7.3f %%", rate, NameScheduling(plain, kind.Grant),
        100.0 * kind.Missed / (kind.Missed + kind.Ticks));
      for (const std::vector<double>& wake : kind.Wake)
      {
        std::printf(" %8.1f", Median(wake));
      }
      std::printf("\n");
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  const bool asked = argc == 3 && std::strcmp(argv[1], "--seconds") == 0;
  const double seconds = asked ? std::atof(argv[2]) : 2.0;
  if ((argc > 1 && !asked) || !(seconds > 0.0))
  {
    std::fprintf(stderr, "usage: %s [--seconds S]\n", argv[0]);
    return 2;
  }
  const TestVolume volume = MakeRamp(64);
  HapticModelDescription description = Describe(volume);
  description.Material.Friction = ConstantPolyline(0.3);
  const auto model = std::make_shared<const HapticModel>(description);
  PrintCost(model, seconds);
  PrintHandOff(model);
  // Of the second row of each pair the kernel is told nothing.
  PrintTimeKeeping(model, seconds, 0);
  PrintTimeKeeping(model, seconds, std::thread::hardware_concurrency());
  return 0;
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The servo's cost in addition to the solver, and its punctuality on this machine: with all
 * privileges that the user may have, and in turns without any; alone, and beside as many busy
 * threads as the machine has processors. To see it without a privilege, run it as an ordinary user.
 *
 * usage: volumehaptics-servo-benchmark [--seconds S] [--drilling [SIZE]]
 *
 * S is the time of a line of the table, 2 s by default. With --drilling, it measures the
 * punctuality of burrs instead, in turns with the same burrs at rest, in volumes of 256^3 samples
 * to SIZE^3; SIZE is 1024 (1 GiB) by default.
 */

#include "Core/Realtime/ServoClock.h"
#include "Core/Servo/ServoLoop.h"
#include "Core/Tools/Burr/BakedBurr.h"
#include "Rigs/BusyThreads.h"
#include "Rigs/CoreScene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <pthread.h>
#include <sys/prctl.h>
#include <thread>
#include <utility>
#include <vector>

using namespace coretest;

namespace
{

/**
 * A device that slides over the ramp at 0.1 m/s and 1 kHz. In a plain slide, the loop gives up its
 * scheduling privileges.
 */
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
      pthread_setschedparam(pthread_self(), SCHED_OTHER, &none); // also resets the slack
                                                                 // slice
      prctl(PR_SET_TIMERSLACK, 0UL);                             // restores the default timer slack
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

/**
 * A hand that goes 2 mm deep into the volume's upper half within half a second, while it moves to
 * and fro at up to 20 mm/s. If its button is pressed, it drills.
 */
class Drill : public DeviceBackend
{
public:
  Drill(const Vector3& start, bool isPressed)
    : Start(start)
    , IsPressed(isPressed)
  {
  }
  bool Open(std::string&) override { return true; }
  void Close() override {}
  std::string GetName() const override { return "drill"; }
  DeviceLimits GetLimits() const override { return {}; }
  DeviceState Read(double, DeviceSample& sample) noexcept override
  {
    const double seconds = 1e-3 * static_cast<double>(this->Tick++);
    const double deep = std::min(6e-3 * seconds, 3e-3);
    sample.Tip = this->Start + Vector3{ 0.02 * std::sin(seconds), 0.0, deep };
    sample.Buttons = this->IsPressed ? 1 : 0;
    sample.Fresh = true;
    return DeviceState::Running;
  }
  DeviceState Write(const Vector3&) noexcept override { return DeviceState::Running; }
  void Quench() noexcept override {}

private:
  const Vector3 Start; ///< m; 1 mm above the surface
  const bool IsPressed;
  std::uint64_t Tick = 0;
};

class RunningLoop
{
public:
  RunningLoop(double rate, bool plain, std::shared_ptr<const HapticModel> model)
    : RunningLoop(std::make_unique<Slide>(plain), rate, std::move(model), !plain)
  {
  }
  RunningLoop(std::unique_ptr<DeviceBackend> device, double rate,
    std::shared_ptr<const HapticModel> model, bool isWatched = true)
    : Device(std::move(device))
    , Loop(*this->Device, rate)
  {
    SafetyLimits limits;
    limits.MaximumForce = 4.0;
    this->Loop.SetLimits(limits);
    this->Loop.Publish(std::move(model));
    this->Loop.Arm();
    this->Thread = std::thread([this] { this->Loop.Run(); });
    if (isWatched)
    {
      this->Watcher = std::thread([this] { this->Loop.WatchSleep(); });
    }
    this->Wait(0.1);
    this->Loop.ResetStatistics();
  }
  ~RunningLoop()
  {
    this->Loop.RequestStop();
    this->Thread.join();
    if (this->Watcher.joinable())
    {
      this->Watcher.join();
    }
  }
  void Wait(double seconds) { std::this_thread::sleep_for(std::chrono::duration<double>(seconds)); }
  ServoLoop* operator->() { return &this->Loop; }

private:
  std::unique_ptr<DeviceBackend> Device;
  ServoLoop Loop;
  std::thread Thread;
  std::thread Watcher;
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

const char* NameScheduling(bool plain, RealTimeGrant grant)
{
  return plain                            ? "SCHED_OTHER"
    : grant == RealTimeGrant::Kernel      ? "SCHED_FIFO"
    : grant == RealTimeGrant::RealtimeKit ? "RealtimeKit"
                                          : "short slices";
}

/** Accumulated results of several short runs of one kind. */
struct Punctuality
{
  double Ticks = 0.0;
  double Missed = 0.0;
  std::vector<double> Wake[4];
  RealTimeGrant Grant = RealTimeGrant::Unknown;
};
constexpr double WakeFractions[4] = { 0.5, 0.9, 0.99, 0.999 };

/**
 * Measures the kinds of scheduling in turns, so that other work of the machine affects all of them
 * equally.
 */
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
        const devicetest::BusyThreads load(busy);
        RunningLoop loop(rate, plain, model);
        loop.Wait(seconds / turns);
        Punctuality& kind = kinds[plain ? 1 : 0];
        kind.Grant = loop->GetRealTimePriority();
        kind.Ticks += static_cast<double>(loop->GetTickCost().GetTotal());
        kind.Missed += static_cast<double>(loop->GetMissedTicks());
        for (int i = 0; i < 4; ++i)
        {
          kind.Wake[i].push_back(1e-3 * loop->GetWakeLatency().GetPercentile(WakeFractions[i]));
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

/** A cube with voxels of 1 mm, whose upper half is bone. */
class HalfCube
{
public:
  explicit HalfCube(std::int64_t size)
    : Size(size)
    , Samples(static_cast<std::size_t>(size * size * size), 0)
  {
    std::fill(this->Samples.begin() + size * size * (size / 2), this->Samples.end(), 200);
  }
  std::shared_ptr<const HapticModel> MakeModel(double radius, double energy) const
  {
    HapticModelDescription d;
    d.View.Type = ScalarType::UInt8;
    d.View.Data = this->Samples.data();
    std::fill_n(d.View.Dimensions, 3, this->Size);
    d.View.Stride[0] = 1;
    d.View.Stride[1] = this->Size;
    d.View.Stride[2] = this->Size * this->Size;
    d.DeviceToWorld.Linear = 1000.0 * Matrix3{};
    d.Removal = std::make_shared<TissueRemoval>();
    BurrDescription tool;
    tool.Settings.Radius = radius;
    tool.SpecificEnergy = ConstantPolyline(energy);
    tool.Head.Points = std::make_shared<const PointShell>(BakedBurr::MakeHead(radius));
    tool.Head.Touch.Level = 100.0;
    tool.Head.Touch.ContactArea = 0.1;
    d.Tool = std::make_shared<const BakedBurr>(tool);
    return std::make_shared<const HapticModel>(d);
  }
  /** Returns the starting position (m), 1 mm above the surface. */
  Vector3 GetStart(double radius) const
  {
    const double half = 0.5 * static_cast<double>(this->Size);
    return 0.001 * Vector3{ half + 0.3, half + 0.2, half - 0.5 - radius - 1.0 };
  }

private:
  const std::int64_t Size;
  std::vector<std::uint8_t> Samples;
};

/** Measures in turns, as PrintTimeKeeping() does. */
void PrintDrilling(double seconds, int largest)
{
  constexpr int turns = 5;
  std::printf("Drilling at 1 kHz, %.1f s each in %d turns; cost of a tick, microseconds to 1/8\n"
              "%6s %7s %7s  %-9s %9s %8s %8s %10s\n",
    seconds, turns, "size", "radius", "J/mm^3", "burr", "missed", "p50", "p99", "mm^3");
  for (int size = 256; size <= largest; size *= 2)
  {
    const HalfCube cube(size);
    for (const auto& [radius, energy] :
      { std::pair<double, double>{ 4.0, 1.0 }, { 16.0, 0.05 }, { 30.0, 0.05 } })
    {
      double missed[2] = { 0.0, 0.0 };
      double ticks[2] = { 0.0, 0.0 };
      double removed[2] = { 0.0, 0.0 };
      std::vector<double> costs[2][2];
      for (int turn = 0; turn < turns; ++turn)
      {
        for (const int drills : { 0, 1 })
        {
          const auto model = cube.MakeModel(radius, energy);
          RunningLoop loop(
            std::make_unique<Drill>(cube.GetStart(radius), drills == 1), 1000.0, model);
          loop.Wait(seconds);
          missed[drills] += static_cast<double>(loop->GetMissedTicks());
          ticks[drills] += static_cast<double>(loop->GetTickCost().GetTotal());
          costs[drills][0].push_back(1e-3 * loop->GetTickCost().GetPercentile(0.5));
          costs[drills][1].push_back(1e-3 * loop->GetTickCost().GetPercentile(0.99));
          removed[drills] += model->Baked->Removal->Journal.GetVolume();
        }
      }
      for (const int drills : { 0, 1 })
      {
        std::printf("%6d %7.0f %7.2f  %-9s %7.3f %% %8.1f %8.1f %10.2f\n", size, radius, energy,
          drills == 1 ? "spins" : "rests",
          100.0 * missed[drills] / (missed[drills] + ticks[drills]), Median(costs[drills][0]),
          Median(costs[drills][1]), removed[drills]);
      }
    }
  }
}

} // namespace

int main(int argc, char** argv)
{
  double seconds = 2.0;
  int largest = 0;
  bool isGood = true;
  for (int i = 1; i < argc; ++i)
  {
    const bool hasNumber = i + 1 < argc && std::atof(argv[i + 1]) > 0.0;
    if (std::strcmp(argv[i], "--seconds") == 0 && hasNumber)
    {
      seconds = std::atof(argv[++i]);
    }
    else if (std::strcmp(argv[i], "--drilling") == 0)
    {
      largest = hasNumber ? std::atoi(argv[++i]) : 1024;
    }
    else
    {
      isGood = false;
    }
  }
  if (!isGood)
  {
    std::fprintf(stderr, "usage: %s [--seconds S] [--drilling [SIZE]]\n", argv[0]);
    return 2;
  }
  if (largest > 0)
  {
    PrintDrilling(seconds, largest);
    return 0;
  }
  const TestVolume volume = MakeRamp(64);
  HapticModelDescription description = Describe(volume);
  description.Material.Friction = ConstantPolyline(0.3);
  const auto model = std::make_shared<const HapticModel>(description);
  PrintCost(model, seconds);
  PrintHandOff(model);
  // Print pairs of rows. In the second row of each pair, the loop runs without scheduling
  // privileges.
  PrintTimeKeeping(model, seconds, 0);
  PrintTimeKeeping(model, seconds, std::thread::hardware_concurrency());
  return 0;
}

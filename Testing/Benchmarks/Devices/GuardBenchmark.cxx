// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Measures the time from a force to the sample that answers the force, at 1 kHz, for a device that
 * answers at once. Compares a driver on a thread of this process with a driver in a guard process.
 * There is no bus, so the difference is the cost of the guard.
 *
 * usage: volumehaptics-guard-benchmark [--seconds S]   (S is the time of each line of the table, 5
 * s by default)
 */

#include "Core/Realtime/ServoClock.h"
#include "Devices/Guard/GuardMain.h"
#include "Devices/Guard/GuardedDevice.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>

using namespace VolumeHaptics;

namespace
{

constexpr std::int64_t Period = ServoClock::Millisecond;
constexpr double Microsecond = 1e3; // ns in a microsecond

/** A driver that reports each force as a position, as soon as the force arrives. */
class EchoDriver : public HardwareDriver
{
public:
  std::string GetName() const override { return "echo"; }
  DeviceLimits GetLimits() const override { return {}; }
  bool Connect(std::string&) override { return true; }
  void Serve(HardwareExchange& exchange) override
  {
    exchange.Report({});
    exchange.SetCondition(DeviceStage::Ready, "");
    while (!exchange.MustStop())
    {
      exchange.WaitForWake(2);
      DeviceSample sample;
      sample.Tip = exchange.GetForce();
      exchange.Report(sample);
    }
  }
  void Disconnect() noexcept override {}
};

struct Figures
{
  double Median = 0.0;  ///< us, from a force to its sample
  double Late = 0.0;    ///< us, 99th percentile of the time from a force to its sample
  double Call = 0.0;    ///< us, median duration of the servo's call of Write()
  std::size_t Lost = 0; ///< number of forces without an answer within a period
};

double At(std::vector<double>& times, double part)
{
  const auto place = times.begin() + static_cast<std::ptrdiff_t>(part * (times.size() - 1));
  std::nth_element(times.begin(), place, times.end());
  return *place;
}

/**
 * Polls for the answer to one force. Returns its arrival time, or a negative number if none arrives
 * within a period.
 */
double WaitFor(DeviceBackend& device, double force, std::int64_t since)
{
  DeviceSample sample;
  while (ServoClock::Now() < since + Period)
  {
    device.Read(1e-3, sample);
    if (sample.Tip.X == force)
    {
      return static_cast<double>(ServoClock::Now() - since) / Microsecond;
    }
  }
  return -1.0;
}

bool Measure(DeviceBackend& device, double seconds, Figures& figures)
{
  std::string error;
  if (!device.Open(error))
  {
    std::fprintf(stderr, "%s\n", error.c_str());
    return false;
  }
  std::vector<double> times;
  std::vector<double> calls;
  const auto ticks = static_cast<int>(1e3 * seconds);
  std::int64_t next = ServoClock::Now();
  for (int tick = 0; tick < ticks; ++tick)
  {
    next = std::max(next + Period, ServoClock::Now());
    ServoClock::SleepUntil(next);
    const double force = 1.0 + tick;
    const std::int64_t since = ServoClock::Now();
    device.Write({ force, 0.0, 0.0 });
    calls.push_back(static_cast<double>(ServoClock::Now() - since) / Microsecond);
    const double time = WaitFor(device, force, since);
    time >= 0.0 ? times.push_back(time) : void(++figures.Lost);
  }
  device.Close();
  if (times.empty())
  {
    std::fprintf(stderr, "No force was answered within a period.\n");
    return false;
  }
  figures.Median = At(times, 0.5);
  figures.Late = At(times, 0.99);
  figures.Call = At(calls, 0.5);
  return true;
}

void Print(const char* name, const Figures& figures)
{
  std::printf("%-22s %10.1f %10.1f %10.1f %10zu\n", name, figures.Median, figures.Late,
    figures.Call, figures.Lost);
}

int RunBenchmark(double seconds)
{
  // Make this program its own guard process.
  setenv("VOLUMEHAPTICS_GUARD", std::filesystem::canonical("/proc/self/exe").c_str(), 1);
  std::string error;
  HardwareDevice thread(std::make_unique<EchoDriver>());
  const auto guarded = GuardedDevice::Make(std::make_unique<EchoDriver>(), { "echo" }, error);
  Figures byThread;
  Figures byGuard;
  if (!guarded || !Measure(thread, seconds, byThread) || !Measure(*guarded, seconds, byGuard))
  {
    std::fprintf(stderr, "%s\n", error.c_str());
    return 1;
  }
  std::printf("From a force to the sample that answers it (us):\n");
  std::printf("%-22s %10s %10s %10s %10s\n", "driver", "median", "99 %", "Write()", "lost");
  Print("thread", byThread);
  Print("guard process", byGuard);
  std::printf(
    "The guard adds %.1f us to the median round trip of %.1f us (%.2f times), and %.1f us "
    "to Write().\n",
    byGuard.Median - byThread.Median, byThread.Median, byGuard.Median / byThread.Median,
    byGuard.Call - byThread.Call);
  return 0;
}

} // namespace

int main(int argc, char** argv)
{
  if (argc == 3 && std::strcmp(argv[1], "--seconds") == 0)
  {
    return RunBenchmark(std::atof(argv[2]));
  }
  if (argc == 1)
  {
    return RunBenchmark(5.0);
  }
  return RunGuard({ argv, argv + argc },
    [](const auto&, std::string&) { return std::make_unique<EchoDriver>(); });
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Medians.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

namespace benchmarks
{

namespace
{

// Returns the reason why a run has no time, or an empty text. Google Benchmark has renamed this
// reason in 1.8.0.
template <class RUN>
auto GetError(const RUN& run, int) -> decltype(run.error_occurred, std::string())
{
  return run.error_occurred ? run.error_message : std::string();
}

template <class RUN>
std::string GetError(const RUN& run, long)
{
  return run.skipped != decltype(run.skipped){} ? run.skip_message : std::string();
}

} // anonymous namespace

double ReadClock()
{
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::nano>(now).count();
}

IterationTime Summarize(std::vector<double>& times)
{
  std::sort(times.begin(), times.end());
  const std::size_t half = times.size() / 2;
  return { 0.5 * (times[half] + times[times.size() - 1 - half]), times.front() };
}

bool Medians::ReportContext(const Context& context)
{
  PrintBasicContext(&this->GetErrorStream(), context);
  std::printf("%-48s %10s %10s %10s\n", "ns an iteration", "median", "least", "most");
  return true;
}

void Medians::ReportRuns(const std::vector<Run>& runs)
{
  std::vector<double> times;
  std::vector<double> ticks;
  std::vector<double> slowest;
  for (const Run& run : runs)
  {
    if (const std::string error = GetError(run, 0); !error.empty())
    {
      std::printf("%-48s ERROR: %s\n", run.run_name.function_name.c_str(), error.c_str());
    }
    else if (run.run_type == Run::RT_Iteration)
    {
      times.push_back(1e9 * run.cpu_accumulated_time / static_cast<double>(run.iterations));
      if (const auto tick = run.counters.find("p50"); tick != run.counters.end())
      {
        ticks.push_back(tick->second);
      }
      if (const auto tick = run.counters.find("p99"); tick != run.counters.end())
      {
        slowest.push_back(tick->second);
      }
    }
  }
  if (times.empty())
  {
    return;
  }
  const std::string& name = runs.front().run_name.function_name;
  const IterationTime time = Summarize(times);
  this->Times[name] = time;
  std::printf("%-48s %10.1f %10.1f %10.1f\n", name.c_str(), time.Median, time.Least, times.back());
  if (!ticks.empty())
  {
    this->Times[name + "/p50"] = Summarize(ticks);
  }
  if (!slowest.empty())
  {
    const IterationTime slow = Summarize(slowest);
    std::printf("%-48s %10.1f %10.1f %10.1f\n", (name + "/p99").c_str(), slow.Median, slow.Least,
      slowest.back());
  }
}

IterationTime Medians::operator[](const std::string& name) const
{
  const auto found = this->Times.find(name);
  return found == this->Times.end() ? IterationTime{ NAN, NAN } : found->second;
}

} // namespace benchmarks

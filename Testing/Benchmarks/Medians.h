// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Collects what Google Benchmark measures.
 */
#ifndef Medians_h
#define Medians_h

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace benchmarks
{

/** Processor time of an iteration in ns. */
struct IterationTime
{
  double Median; ///< of the repetitions
  double Least;  ///< of the run in which the processor was least busy otherwise
};

/** Of times of at least one iteration (ns), which it sorts. */
IterationTime Summarize(std::vector<double>& times);

/** Of the clock that never goes back (ns). */
double ReadClock();

/** Prints a line for each benchmark, and keeps its times for the ratios that follow. */
class Medians : public benchmark::BenchmarkReporter
{
public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

  /**
   * NaN for what was not measured. With "/p50" after its name, what a benchmark has measured of its
   * iterations one by one: its counter p50 (ns).
   */
  IterationTime operator[](const std::string& name) const;

private:
  std::map<std::string, IterationTime> Times;
};

} // namespace benchmarks

#endif

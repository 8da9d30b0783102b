// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Collects the results of Google Benchmark.
 */
#ifndef Medians_h
#define Medians_h

#include <benchmark/benchmark.h>

#include <map>
#include <string>
#include <vector>

namespace benchmarks
{

/** Processor time (ns) of an iteration. */
struct IterationTime
{
  double Median; ///< median time of the repetitions
  double Least;  ///< shortest time, with the least interference by other work
};

/** Returns the median and the shortest of at least one time (ns). Sorts the times. */
IterationTime Summarize(std::vector<double>& times);

/** Returns the time (ns) of the monotonic clock. */
double ReadClock();

/** Prints a line for each benchmark, and stores its times for the ratios. */
class Medians : public benchmark::BenchmarkReporter
{
public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

  /**
   * Returns the time of a benchmark, or NaN if it was not measured. For a name that ends in "/p50",
   * returns the benchmark's counter p50 (ns), which is measured from single iterations.
   */
  IterationTime operator[](const std::string& name) const;

private:
  std::map<std::string, IterationTime> Times;
};

} // namespace benchmarks

#endif

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

/** A line for each benchmark, and the medians over its repetitions for the ratios after it. */
class Medians : public benchmark::BenchmarkReporter
{
public:
  bool ReportContext(const Context& context) override;
  void ReportRuns(const std::vector<Run>& runs) override;

  /** Processor time of an iteration in ns, NaN for what was not measured. */
  double operator[](const std::string& name) const;

private:
  std::map<std::string, double> Nanoseconds;
};

} // namespace benchmarks

#endif

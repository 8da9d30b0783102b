// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * volumehaptics-benchmark [--quick] [Google Benchmark's own options]
 * volumehaptics-benchmark --scale [largest size]
 * volumehaptics-benchmark --playing [size]
 *
 * Measures the cost of a servo tick and of alternatives, in repetitions that are shuffled over the
 * whole run, and prints medians and their ratios. It checks nothing. --quick leaves out the volume
 * of 1 GiB and most repetitions: it shows that everything runs, with rough figures. --scale instead
 * measures the calls of an application with volumes of 256^3 up to 2048^3 samples. --playing
 * measures a servo while frames of 256^3 change 20 times a second, in real time, beside a servo
 * without a volume.
 */
#include "Benchmarks.h"
#include "Medians.h"
#include "PlayingBenchmark.h"
#include "RatioTable.h"
#include "ScaleBenchmark.h"

#include <cstdlib>
#include <cstring>
#include <vector>

int main(int argc, char* argv[])
{
  using namespace benchmarks;
  if (argc > 1 && std::strcmp(argv[1], "--scale") == 0)
  {
    constexpr int largest = 2048;
    MeasureScale(argc > 2 ? std::atoi(argv[2]) : largest);
    return 0;
  }
  if (argc > 1 && std::strcmp(argv[1], "--playing") == 0)
  {
    constexpr int size = 256;
    MeasurePlaying(argc > 2 ? std::atoi(argv[2]) : size);
    return 0;
  }
  bool isQuick = false;
  std::vector<char*> arguments = { argv[0] };
  // Put the defaults first, so that options on the command line override them.
  char interleaved[] = "--benchmark_enable_random_interleaving=true";
  char repetitions[] = "--benchmark_repetitions=31";
  char time[] = "--benchmark_min_time=0.01";
  char fewRepetitions[] = "--benchmark_repetitions=3";
  char shortTime[] = "--benchmark_min_time=0.002";
  for (int i = 1; i < argc; ++i)
  {
    isQuick = isQuick || std::strcmp(argv[i], "--quick") == 0;
  }
  arguments.push_back(interleaved);
  arguments.push_back(isQuick ? fewRepetitions : repetitions);
  arguments.push_back(isQuick ? shortTime : time);
  for (int i = 1; i < argc; ++i)
  {
    if (std::strcmp(argv[i], "--quick") != 0)
    {
      arguments.push_back(argv[i]);
    }
  }
  int count = static_cast<int>(arguments.size());
  benchmark::Initialize(&count, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(count, arguments.data()))
  {
    return 1;
  }

  std::vector<BallVolume> volumes = { BallVolume("256^3", 256, 256, 256) };
  if (!isQuick)
  {
    // Use sizes that are not powers of two. With 1024 samples per row, all rows of a kernel compete
    // for the same cache lines (measured: 7 times the bare gather at radius 3), which would hide
    // the effect of the size.
    volumes.emplace_back("1GiB", 1016, 1016, 520);
  }
  for (const BallVolume& volume : volumes)
  {
    RegisterTickBenchmarks(volume);
    RegisterFieldBenchmarks(volume);
    RegisterPeerBenchmarks(volume);
    RegisterBurrBenchmarks(volume);
  }
  RegisterFilterBenchmarks(volumes.front());
  RegisterLabelBenchmarks(volumes.front());
  RegisterSurfaceBenchmarks(volumes.front());
  RegisterModeBenchmarks();
  RegisterShellBenchmarks(volumes.front());
  Medians medians;
  benchmark::RunSpecifiedBenchmarks(&medians);
  PrintRatios(medians);
  PrintThroughput(volumes.front(), isQuick);
  PrintMemory(volumes.front());
  benchmark::Shutdown();
  return 0;
}

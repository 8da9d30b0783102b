// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Report/TraceSound.h"

#include "Applications/Explorer/Exploration/HeardTicks.h"
#include "Applications/Explorer/Sound/ContactSound.h"
#include "Applications/Explorer/Sound/WaveFile.h"

namespace Explore
{
std::vector<float> MakeSound(const Exploration& exploration)
{
  constexpr double step = 0.001; // s, step of the ticks after the end
  constexpr int steps = 500;
  ContactSound sound(SAMPLES_PER_SECOND);
  std::vector<float> samples;
  const auto render = [&](double until)
  {
    const auto last = static_cast<std::size_t>(until * SAMPLES_PER_SECOND);
    if (last > samples.size())
    {
      const std::size_t first = samples.size();
      samples.resize(last);
      sound.Render(&samples[first], last - first);
    }
  };
  const std::vector<SoundTick> ticks = HeardTicks(exploration.Filter).Read(exploration.Trace);
  double time = 0.0; // s since the first tick
  for (const SoundTick& tick : ticks)
  {
    time = tick.Time - ticks.front().Time;
    render(time);
    sound.Feed(tick);
  }
  for (int i = 1; i <= steps; ++i)
  {
    render(time + i * step);
    sound.Rest(step);
  }
  return samples;
}

void WriteSound(const Exploration& exploration, const std::string& file)
{
  WriteWave(MakeSound(exploration), SAMPLES_PER_SECOND, file);
}
} // namespace Explore

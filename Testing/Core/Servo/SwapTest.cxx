// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Publishes a thousand models while the loop runs at 5 kHz, one thread reads states, and another
 * thread records.
 */

#include "Core/State/ServoStateNumbers.h"
#include "Rigs/PlayedDevice.h"

#include <cstring>
#include <vector>

using namespace servotest;

namespace
{
/// A device that stores the number of the tick in all values of its reports.
struct CountingDevice : PlayedDevice
{
  static Vector3 TurnOf(std::uint64_t tick)
  {
    const double number = static_cast<double>(tick);
    return { number, -number, 0.5 * number };
  }

  DeviceState Read(double period, DeviceSample& sample) noexcept override
  {
    const std::uint64_t tick = this->Reads.load();
    sample.Buttons = static_cast<std::uint32_t>(tick);
    sample.Turn = TurnOf(tick);
    return PlayedDevice::Read(period, sample);
  }
};

bool IsSame(const Vector3& a, const Vector3& b)
{
  return a.X == b.X && a.Y == b.Y && a.Z == b.Z;
}

/// Returns whether all values of a snapshot belong to the same tick.
bool IsOfOneTick(const ServoSnapshot& s)
{
  return s.Buttons == static_cast<std::uint32_t>(s.Tick) &&
    IsSame(s.Turn, CountingDevice::TurnOf(s.Tick)) &&
    IsSame(s.Record.Tip, PlayedDevice::TipOf(s.Tick)) &&
    (!s.Before.Enabled || IsSame(s.Before.PreviousTip, PlayedDevice::TipOf(s.Tick - 1)));
}

/// Returns a checksum over all numbers of a snapshot.
std::uint64_t SumOf(const ServoSnapshot& s)
{
  std::uint64_t sum = 0;
  const auto add = [&](double number)
  {
    std::uint64_t word;
    std::memcpy(&word, &number, sizeof(word));
    sum = (sum ^ word) * 0x9E3779B97F4A7C15ULL;
    sum ^= sum >> 29;
  };
  for (const Vector3& v :
    { s.Record.Tip, s.Record.Proxy, s.Record.Force, s.Record.Normal, s.Command, s.Turn })
  {
    add(v.X);
    add(v.Y);
    add(v.Z);
  }
  for (const double number : { s.Time, static_cast<double>(s.Tick),
         static_cast<double>(s.Generation), s.Record.GradientMagnitude, s.Record.SurfaceValue,
         s.Record.MediumValue, s.Record.Stiffness, s.Record.SurfaceStrength, s.Record.NormalForce,
         s.Record.FrictionForce, s.Record.DragForce, s.Residency, static_cast<double>(s.Buttons),
         static_cast<double>(s.Record.Contact), static_cast<double>(s.Device) })
  {
    add(number);
  }
  for (const bool flag : { s.Stale, s.Awaiting, s.Record.IsUnfinished, s.Record.IsRenewed })
  {
    add(flag);
  }
  for (const double number : ToNumbers(s.Before))
  {
    add(number);
  }
  return sum;
}

/// Checks a stream of snapshots, and counts the torn, repeated and skipped ones.
struct Watcher
{
  std::vector<std::pair<std::uint64_t, std::uint64_t>> Sums; ///< number and checksum of each tick
  std::uint64_t States = 0;
  std::uint64_t Torn = 0;
  std::uint64_t Backward = 0;
  std::uint64_t Skipped = 0;
  std::uint64_t Tick = 0;
  std::uint64_t Generation = 0;

  void See(const ServoSnapshot& s)
  {
    this->Torn += IsOfOneTick(s) ? 0 : 1;
    this->Sums.emplace_back(s.Tick, SumOf(s));
    this->Backward += this->States > 0 && s.Tick <= this->Tick ? 1 : 0;
    this->Backward += s.Generation < this->Generation ? 1 : 0;
    this->Skipped += this->States > 0 && s.Tick != this->Tick + 1 ? 1 : 0;
    this->Tick = s.Tick;
    this->Generation = s.Generation;
    ++this->States;
  }
};

/// Returns a model whose volume, material, kernel, method and placement depend on i. The model is
/// the only owner of its samples.
std::shared_ptr<const HapticModel> MakeModel(int i)
{
  const auto volume = std::make_shared<TestVolume>(MakeRamp(16 + i % 8));
  HapticModelDescription d = Describe(*volume);
  d.Samples = volume;
  d.Estimator = static_cast<GradientEstimator>(i % 3);
  d.KernelRadius = 1 + i % 3;
  d.Material.Stiffness = ConstantPolyline(100.0 + 400.0 * (i % 5));
  d.Material.Friction = ConstantPolyline(0.1 * (i % 4));
  d.Material.Viscosity = ConstantPolyline(0.2 * (i % 3));
  constexpr HapticMethod methods[] = { HapticMethod::ForceField, HapticMethod::LocalSurface };
  d.Settings.Method = i % 7 < 2 ? methods[i % 7] : HapticMethod::Proxy;
  d.Settings.IsoValue = 1200.0;
  d.Settings.LocalSurfaceRate = 1000.0;
  d.Settings.ForceFieldGain = 0.02;
  d.DeviceToWorld.Offset = { 0.0, 0.0, i % 2 ? -4.0 : 0.0 };
  return std::make_shared<const HapticModel>(d);
}
} // namespace

TEST(ServoSwap, AThousandModelsNeverTearJumpOrLeak)
{
  CountingDevice device;
  std::vector<std::weak_ptr<const HapticModel>> models;
  Watcher reader;
  Watcher recorder;
  std::uint64_t lost = 0;
  {
    RunningLoop loop(device);
    loop->SetRecording(true);
    loop->Arm();
    std::atomic<bool> done{ false };
    std::thread reading(
      [&]
      {
        while (!done.load())
        {
          loop->ReadState() ? reader.See(loop->GetState()) : std::this_thread::yield();
        }
      });
    std::thread recording(
      [&]
      {
        const ReaderPace pace(device);
        for (bool last = false; !last;)
        {
          last = done.load();
          pace.Drain(loop.operator->(), [&](const ServoSnapshot& s) { recorder.See(s); });
          std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
      });
    for (int i = 0; i < 1000; ++i)
    {
      auto model = i % 50 == 49 ? nullptr : MakeModel(i);
      models.push_back(model);
      const std::uint64_t generation = loop->Publish(std::move(model));
      if (i % 3 == 0) // wait for every third model; the others come in bursts
      {
        EXPECT_TRUE(Eventually([&] { return loop->GetAcknowledged() >= generation; }));
      }
    }
    EXPECT_TRUE(Eventually([&] { return loop->GetAcknowledged() == 1000; }));
    // Only the publisher frees models. When the fitter has released its model, all models except
    // the last are freed.
    for (std::size_t i = 0; i + 1 < models.size(); ++i)
    {
      const auto isFreed = [&]
      {
        loop->Collect();
        return models[i].expired();
      };
      EXPECT_TRUE(Eventually(isFreed)) << i;
    }
    auto felt = MakeModel(4);
    models.push_back(felt);
    loop->Publish(std::move(felt));
    EXPECT_TRUE(Eventually([&] { return device.LargestForce.load() > 0.5; }));
    lost = loop->GetLostRecords();
    done.store(true);
    reading.join();
    recording.join();
  }
  EXPECT_GT(reader.States, 100U);
  EXPECT_GT(recorder.States, 300U);
  EXPECT_EQ(reader.Torn + recorder.Torn, 0U);
  EXPECT_EQ(reader.Backward + recorder.Backward, 0U);
  EXPECT_EQ(lost, 0U);
  ASSERT_EQ(recorder.Skipped, 0U);
  // ReadState() and Drain() must return the same states.
  const std::uint64_t first = recorder.Sums.front().first;
  std::uint64_t compared = 0;
  for (const auto& [tick, sum] : reader.Sums)
  {
    if (tick >= first && tick - first < recorder.Sums.size())
    {
      EXPECT_EQ(sum, recorder.Sums[tick - first].second) << "tick " << tick;
      ++compared;
    }
  }
  EXPECT_GT(compared, 100U);
  EXPECT_LE(device.LargestGrowth, QuickLimits().MaximumForceRate / 5000.0 * (1.0 + 1e-9));
  EXPECT_TRUE(models.back().expired());
}

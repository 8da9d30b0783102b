// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A thousand models while the loop runs at 5 kHz, one thread reads states and another records.
 */

#include "Rigs/PlayedDevice.h"

#include <vector>

using namespace servotest;

namespace
{
/// Watches a stream of states.
struct Watcher
{
  std::uint64_t States = 0;
  std::uint64_t Torn = 0;
  std::uint64_t Backward = 0;
  std::uint64_t Skipped = 0;
  std::uint64_t Tick = 0;
  std::uint64_t Generation = 0;

  void See(const ServoSnapshot& s)
  {
    this->Torn += IsWhole(s) ? 0 : 1;
    this->Backward += this->States > 0 && s.Tick <= this->Tick ? 1 : 0;
    this->Backward += s.Generation < this->Generation ? 1 : 0;
    this->Skipped += this->States > 0 && s.Tick != this->Tick + 1 ? 1 : 0;
    this->Tick = s.Tick;
    this->Generation = s.Generation;
    ++this->States;
  }
};

/// Another volume, material, kernel, method and place each; nobody but the model owns the samples.
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
  PlayedDevice device;
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
        ServoSnapshot s;
        for (bool last = false; !last;)
        {
          last = done.load();
          while (loop->Drain(s))
          {
            recorder.See(s);
          }
          std::this_thread::sleep_for(std::chrono::milliseconds(2));
        }
      });
    for (int i = 0; i < 1000; ++i)
    {
      auto model = i % 50 == 49 ? nullptr : MakeModel(i);
      models.push_back(model);
      const std::uint64_t generation = loop->Publish(std::move(model));
      if (i % 3 == 0) // the others come in bursts
      {
        EXPECT_TRUE(Eventually([&] { return loop->GetAcknowledged() >= generation; }));
      }
    }
    EXPECT_TRUE(Eventually([&] { return loop->GetAcknowledged() == 1000; }));
    // Only the publisher frees, and it has freed all but the last, once the fitter has let go.
    for (std::size_t i = 0; i + 1 < models.size(); ++i)
    {
      const auto isFreed = [&]
      {
        loop->Collect();
        return models[i].expired();
      };
      EXPECT_TRUE(Eventually(isFreed)) << i;
    }
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
  EXPECT_EQ(recorder.Skipped, 0U);
  EXPECT_LE(device.LargestGrowth, QuickLimits().MaximumForceRate / 5000.0 * (1.0 + 1e-9));
  EXPECT_TRUE(models.back().expired());
}

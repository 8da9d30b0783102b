// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that a servo which moves through a volume of 2 GiB, mapped from a file, finds its samples
 * in memory. The tests use numbers of the kernel: page faults of the servo's thread (getrusage(2)),
 * pages of the file in memory (mincore(2)) and locked pages (/proc/self/smaps). They also compare
 * the pages of a box with those of all its samples, one by one.
 */

#include "Rigs/MappedFile.h"
#include "Rigs/PlayedDevice.h"

#include <algorithm>
#include <optional>
#include <random>
#include <set>

#include <linux/capability.h>
#include <sys/resource.h>
#include <sys/syscall.h>

using namespace servotest;

namespace
{
using Privilege = ServoLoop::Privilege;
/// Page faults can be counted only without sanitizers, whose shadow memory causes additional page
/// faults.
constexpr bool CanCount = CanLock;
constexpr std::size_t MebiByte = std::size_t{ 1 } << 20;

/// A device whose tip the test sets. Counts the page faults of the servo's thread.
class PlacedDevice : public PlayedDevice
{
public:
  DeviceState Read(double time, DeviceSample& sample) noexcept override
  {
    const DeviceState state = this->PlayedDevice::Read(time, sample);
    sample.Tip = { this->X.load(), this->Y.load(), this->Z.load() };
    rusage usage;
    getrusage(RUSAGE_THREAD, &usage);
    this->Faults.store(usage.ru_minflt + usage.ru_majflt);
    return state;
  }

  void Place(const Vector3& tip)
  {
    this->X.store(tip.X);
    this->Y.store(tip.Y);
    this->Z.store(tip.Z);
  }

  std::atomic<long> Faults{ 0 };

private:
  std::atomic<double> X{ 0.5 };
  std::atomic<double> Y{ 0.5 };
  std::atomic<double> Z{ 0.3 };
};

/// A loop on 1024^3 samples of 1 mm, with or without a sample keeper.
class MappedLoop
{
public:
  enum Keeper
  {
    Without,
    With,
    Unprivileged ///< with a keeper that obeys the limit of locked memory even if root runs the test
  };

  explicit MappedLoop(Keeper keeper)
    : HasKeeper(keeper != Without)
  {
    if (this->HasKeeper)
    {
      this->Thread = std::thread(
        [this, keeper]
        {
          if (keeper == Unprivileged)
          {
            DropCapabilities();
          }
          this->GetLoop().RunSampleKeeper();
        });
    }
    this->GetLoop().Publish(std::make_shared<const HapticModel>(Describe(this->Volume)));
    this->Settle();
  }
  ~MappedLoop() { this->Stop(); }
  MappedLoop(const MappedLoop&) = delete;
  MappedLoop& operator=(const MappedLoop&) = delete;

  void Stop()
  {
    if (this->Thread.joinable())
    {
      this->GetLoop().RequestStop();
      this->Thread.join();
    }
    this->Running.reset();
  }

  /// Waits for 4 ticks and 2 polls of the keeper, so that all ticks and polls that began before
  /// this call have ended.
  void Settle()
  {
    const std::uint64_t ticks = this->GetLoop().GetTickCount() + 4;
    ASSERT_TRUE(Eventually([&] { return this->GetLoop().GetTickCount() >= ticks; }));
    const std::uint64_t looks = this->GetLoop().GetLooksAtSamples() + 2;
    ASSERT_TRUE(
      Eventually([&] { return !this->HasKeeper || this->GetLoop().GetLooksAtSamples() >= looks; }));
  }

  /// Moves the tip by two voxels along z and one along y per step. Returns the number of page
  /// faults of the servo's thread.
  long Walk(int steps)
  {
    const long before = this->Device.Faults.load();
    for (int i = 0; i < steps; ++i)
    {
      this->Tip += Vector3{ 0.0, 0.001, 0.002 };
      this->Device.Place(this->Tip);
      this->Settle();
    }
    return this->Device.Faults.load() - before;
  }

  ServoLoop& GetLoop() { return *(*this->Running).operator->(); }

  MappedFile File{ 2048 * MebiByte };
  PlacedDevice Device;

private:
  static void DropCapabilities()
  {
    // Only this thread loses its capabilities.
    __user_cap_header_struct header{ _LINUX_CAPABILITY_VERSION_3, 0 };
    __user_cap_data_struct none[2] = {};
    syscall(SYS_capset, &header, none);
  }

  const bool HasKeeper;
  TestVolume Volume{ ScalarType::Int16, { 1024, 1024, 1024 }, 1,
    static_cast<std::byte*>(this->File.Begin) };
  Vector3 Tip{ 0.5, 0.5, 0.3 };
  std::optional<RunningLoop> Running{ std::in_place, this->Device, 1000.0 };
  std::thread Thread;
};
} // namespace

TEST(SamplePages, AreThoseOfAllSamplesOfTheBox)
{
  std::mt19937 random(1);
  const auto pick = [&random](std::int64_t first, std::int64_t last)
  { return std::uniform_int_distribution<std::int64_t>(first, last)(random); };
  for (int round = 0; round < 300; ++round)
  {
    VolumeView view;
    view.Type = round % 2 ? ScalarType::Int16 : ScalarType::Float64;
    const std::int64_t size = round % 2 ? 2 : 8;
    const std::int64_t n[3] = { pick(2, 900), pick(2, 40), pick(2, 40) };
    const std::int64_t components = pick(1, 3);
    const std::uintptr_t data = 1000000 + 8 * pick(0, 5000);
    view.Data = reinterpret_cast<const void*>(data);
    SampleBox box;
    for (int a = 0; a < 3; ++a)
    {
      view.Dimensions[a] = n[a];
      view.Stride[a] = a == 0 ? components : view.Stride[a - 1] * n[a - 1];
      view.First[a] = pick(0, 50);
      box.First[a] = pick(view.First[a], view.Last(a));
      box.Last[a] = pick(box.First[a], view.Last(a));
    }
    const std::uintptr_t page = round % 3 ? 4096 : 65536;
    std::set<std::uintptr_t> expected;
    for (std::int64_t k = box.First[2]; k <= box.Last[2]; ++k)
    {
      for (std::int64_t j = box.First[1]; j <= box.Last[1]; ++j)
      {
        for (std::int64_t i = box.First[0]; i <= box.Last[0]; ++i)
        {
          const std::int64_t index = (i - view.First[0]) * components +
            (j - view.First[1]) * components * n[0] +
            (k - view.First[2]) * components * n[0] * n[1];
          const std::uintptr_t at = data + static_cast<std::uintptr_t>(size * index);
          expected.insert(at / page);
          expected.insert((at + static_cast<std::uintptr_t>(size) - 1) / page);
        }
      }
    }
    std::vector<SamplePages> pages;
    const std::size_t all = expected.size() * page;
    ASSERT_TRUE(CollectSamplePages(view, box, page, all, pages));
    std::set<std::uintptr_t> found;
    std::uintptr_t last = 0;
    for (const SamplePages& range : pages)
    {
      EXPECT_GT(range.Begin, last) << "they are apart";
      last = range.End;
      for (std::uintptr_t at = range.Begin; at < range.End; at += page)
      {
        found.insert(at / page);
      }
    }
    ASSERT_EQ(found, expected) << round;
    EXPECT_FALSE(CollectSamplePages(view, box, page, all - 1, pages));
    std::size_t less = 0;
    for (const SamplePages& range : pages)
    {
      less += range.End - range.Begin;
    }
    EXPECT_LT(less, all);
  }
}

TEST(SampleKeeper, LetsTheServoFindItsSamplesInMemory)
{
  constexpr int steps = 60;
  long expected = 0;
  // Bytes in memory. They include the pages that the ticks read, and the pages that the kernel
  // reads ahead.
  std::size_t touchedAtRest = 0;
  std::size_t touched = 0;
  {
    MappedLoop alone(MappedLoop::Without);
    touchedAtRest = alone.File.Resident();
    expected = alone.Walk(steps);
    touched = alone.File.Resident();
    EXPECT_EQ(alone.GetLoop().GetLockedSamples(), Privilege::Unknown);
  }
  // Each step reads two slices that were not read before.
  EXPECT_GT(expected, steps) << "a servo without it waits for pages";
  MappedLoop loop(MappedLoop::With);
  EXPECT_LT(loop.File.Resident(), touchedAtRest + 16 * MebiByte) << "of 2 GiB";
  const long faults = loop.Walk(steps);
  EXPECT_TRUE(!CanCount || faults < expected / 20) << faults << " of " << expected;
  EXPECT_LT(loop.File.Resident(), touched + 16 * MebiByte);
  EXPECT_LE(loop.File.Locked(), SampleKeeper::MostBytes) << "what lies behind is let go";
  if (CanLock && loop.GetLoop().GetLockedSamples() == Privilege::Granted)
  {
    EXPECT_GT(loop.File.Locked(), MebiByte / 2);
  }
  loop.Stop();
  EXPECT_EQ(loop.File.Locked(), 0U);
}

TEST(SampleKeeper, LetsGoOfAVolumeThatIsNoLongerTouched)
{
  MappedLoop loop(MappedLoop::With);
  if (!CanLock || loop.GetLoop().GetLockedSamples() != Privilege::Granted)
  {
    GTEST_SKIP() << "memory can't be locked here";
  }
  EXPECT_GT(loop.File.Locked(), 0U);
  loop.GetLoop().Publish(nullptr);
  EXPECT_TRUE(Eventually([&] { return loop.File.Locked() == 0; }));
}

TEST(SampleKeeper, FetchesAlsoWhatItMayNotLock)
{
  rlimit before;
  ASSERT_EQ(getrlimit(RLIMIT_MEMLOCK, &before), 0);
  const rlimit small{ 65536, before.rlim_max };
  ASSERT_EQ(setrlimit(RLIMIT_MEMLOCK, &small), 0);
  {
    MappedLoop loop(MappedLoop::Unprivileged);
    constexpr int steps = 60;
    const long faults = loop.Walk(steps);
    EXPECT_TRUE(!CanCount || faults < steps / 4) << faults;
    if (CanLock)
    {
      EXPECT_EQ(loop.GetLoop().GetLockedSamples(), Privilege::Refused);
    }
    EXPECT_EQ(loop.File.Locked(), 0U);
  }
  EXPECT_EQ(setrlimit(RLIMIT_MEMLOCK, &before), 0);
}

TEST(SampleKeeper, KeepsTheLabelsToo)
{
  MappedFile file(256 * MebiByte);
  const TestVolume voxels(
    ScalarType::UInt8, { 1024, 1024, 256 }, 1, static_cast<std::byte*>(file.Begin));
  auto labels = std::make_shared<BakedLabels>();
  labels->View = LabelView(voxels.View);
  labels->IndexToWorld.Linear = 0.5 * Matrix3{};
  const TestVolume volume = MakeRamp(24);
  HapticModelDescription d = Describe(volume);
  d.Labels = labels;
  PlacedDevice device;
  device.Place({ 0.012, 0.012, 0.012 });
  RunningLoop loop(device, 1000.0);
  std::thread keeper([&loop] { loop->RunSampleKeeper(); });
  loop->Publish(std::make_shared<const HapticModel>(d));
  EXPECT_TRUE(Eventually([&] { return loop->GetLooksAtSamples() > 1; }));
  // Returns whether the page of a label is in memory.
  const auto isThere = [&file](int i, int j, int k)
  {
    unsigned char state = 0;
    const std::size_t at =
      static_cast<std::size_t>(i + 1024 * (j + 1024 * k)) / PageSize * PageSize;
    EXPECT_EQ(mincore(static_cast<char*>(file.Begin) + at, 1, &state), 0);
    return (state & 1) != 0;
  };
  for (const int step : { -20, 0, 20 })
  {
    EXPECT_TRUE(isThere(24 + step, 24, 24));
    EXPECT_TRUE(isThere(24, 24 + step, 24));
    EXPECT_TRUE(isThere(24, 24, 24 + step));
  }
  EXPECT_LT(file.Resident(), 16 * MebiByte);
  loop->RequestStop();
  keeper.join();
}

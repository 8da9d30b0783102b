// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the thread that reads regions. Its owner waits for it only if a read is in progress when
 * the reader ends. The thread must survive readers that fail, throw or are slow.
 */

#include "VTK/Regions/RegionReader.h"

#include "Rigs/Eventually.h"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <thread>

#if defined(__linux__)
#include <pthread.h>
#endif

using namespace VolumeHaptics;
using devicetest::Eventually;

namespace
{
constexpr BoxExtent Whole = { 0, 999, 0, 999, 0, 999 };
constexpr BoxExtent Here = { 10, 13, 20, 22, 30, 31 };
constexpr BoxExtent There = { 500, 503, 20, 22, 30, 31 };
constexpr BoxExtent Elsewhere = { 700, 703, 20, 22, 30, 31 };

/// A volume whose samples equal their index along x. Tests open and close the gate through which it
/// is read.
struct GatedVolume
{
  GatedVolume()
  {
    this->Volume->Extent = Whole;
    this->Volume->Name = "the gate";
    this->Volume->Read = [this](const int box[6], void* samples)
    {
      ++this->Entered;
      while (!this->IsOpen)
      {
        std::this_thread::yield();
      }
      if (this->Failures > 0)
      {
        --this->Failures;
        throw std::runtime_error("it is broken.");
      }
      std::size_t n = 0;
      for (int k = box[4]; k <= box[5]; ++k)
      {
        for (int j = box[2]; j <= box[3]; ++j)
        {
          for (int i = box[0]; i <= box[1]; ++i)
          {
            static_cast<short*>(samples)[n++] = static_cast<short>(i);
          }
        }
      }
      ++this->Left;
      return true;
    };
  }

  std::atomic<bool> IsOpen{ true };
  std::atomic<int> Failures{ 0 };
  std::atomic<int> Entered{ 0 };
  std::atomic<int> Left{ 0 };
  const std::shared_ptr<LargeVolume> Volume = std::make_shared<LargeVolume>();
};

std::optional<RegionSamples> Await(RegionReader& reader)
{
  std::optional<RegionSamples> region;
  EXPECT_TRUE(Eventually(
    [&]
    {
      region = reader.Drain();
      return region.has_value();
    }));
  return region;
}

/// Ends a reader that is waiting at a closed gate, and opens the gate slightly later.
void EndMeanwhile(std::unique_ptr<RegionReader>& reader, GatedVolume& gate)
{
  std::atomic<bool> begins{ false };
  std::atomic<bool> hasEnded{ false };
  std::thread end(
    [&]
    {
      begins = true;
      reader.reset();
      hasEnded = true;
    });
  EXPECT_TRUE(Eventually([&] { return begins.load(); }));
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_FALSE(hasEnded) << "the function must not be gone while it is called";
  gate.IsOpen = true;
  end.join();
}

const std::optional<VolumeFacts> Known = VolumeFacts{ 1.5, 2.0 };
} // namespace

TEST(RegionReader, GivesTheRegionThatWasOrderedAndThatOnce)
{
  GatedVolume gate;
  RegionReader reader(gate.Volume, Known);
  EXPECT_EQ(reader.GetFacts()->Noise, 1.5);
  EXPECT_FALSE(reader.Drain());
  reader.Order(Here);
  const std::optional<RegionSamples> region = Await(reader);
  ASSERT_TRUE(region);
  EXPECT_EQ(region->Extent, Here);
  const auto* const samples = static_cast<const short*>(region->Samples.get());
  for (int s = 0; s < 24; ++s)
  {
    EXPECT_EQ(samples[s], 10 + s % 4);
  }
  EXPECT_FALSE(reader.Drain());
  EXPECT_EQ(gate.Entered, 1) << "nothing was surveyed";
}

TEST(RegionReader, LeavesOutOrdersThatALaterOneReplaces)
{
  GatedVolume gate;
  gate.IsOpen = false;
  RegionReader reader(gate.Volume, Known);
  reader.Order(Here);
  ASSERT_TRUE(Eventually([&] { return gate.Entered == 1; }));
  reader.Order(There);
  reader.Order(Elsewhere);
  gate.IsOpen = true;
  ASSERT_TRUE(Eventually([&] { return gate.Left == 2; }));
  // The last region may have replaced the first one before the test could fetch the first one.
  std::optional<RegionSamples> region;
  ASSERT_TRUE(Eventually(
    [&]
    {
      region = Await(reader);
      return region && region->Extent == Elsewhere;
    }));
  EXPECT_EQ(gate.Entered, 2);
}

TEST(RegionReader, SurveysFirstAndFindsTheFacts)
{
  GatedVolume gate;
  RegionReader reader(gate.Volume, std::nullopt);
  ASSERT_TRUE(Eventually([&] { return reader.GetFacts().has_value(); }));
  EXPECT_EQ(reader.GetFacts()->Noise, 0.0) << "of a ramp";
  EXPECT_EQ(reader.GetFacts()->BorderValue, 0.0);
  EXPECT_EQ(gate.Entered, 512 + 8) << "blocks and corners";
}

TEST(RegionReader, TriesAgainUntilItSucceeds)
{
  GatedVolume gate;
  gate.Failures = 3;
  RegionReader reader(gate.Volume, Known);
  reader.Order(Here);
  ASSERT_TRUE(Eventually([&] { return !reader.GetTrouble().empty(); }));
  EXPECT_EQ(reader.GetTrouble(),
    "The samples (10 to 13, 20 to 22, 30 to 31) can't be read from the gate: it is broken.");
  EXPECT_EQ(Await(reader)->Extent, Here);
  EXPECT_EQ(reader.GetTrouble(), "");
  EXPECT_EQ(gate.Entered, 4);
}

#if defined(__GLIBC__)
TEST(RegionReader, GoesOnAfterAReaderHasEndedItsThread)
{
  for (const std::optional<VolumeFacts>& facts : { Known, std::optional<VolumeFacts>() })
  {
    GatedVolume gate;
    std::atomic<int> kills{ 2 };
    gate.Volume->Read = [&, read = gate.Volume->Read](const int box[6], void* samples)
    {
      if (kills-- > 0)
      {
        pthread_exit(nullptr);
      }
      return read(box, samples);
    };
    RegionReader reader(gate.Volume, facts);
    reader.Order(Here);
    ASSERT_TRUE(Eventually([&] { return !reader.GetTrouble().empty(); }));
    EXPECT_EQ(reader.GetTrouble(),
      "The samples can't be read from the gate: its reader ends the thread that calls it. Let it "
      "return instead.");
    const std::optional<RegionSamples> region = Await(reader);
    ASSERT_TRUE(region);
    EXPECT_EQ(region->Extent, Here);
    EXPECT_EQ(reader.GetTrouble(), "");
    EXPECT_LT(kills, 0) << "each thread was ended";
    EXPECT_EQ(gate.Left, facts ? 1 : 512 + 8 + 1);
  }
}

TEST(RegionReader, EndsWhereNoThreadIsLeft)
{
  GatedVolume gate;
  std::atomic<bool> isEntered{ false };
  gate.Volume->Read = [&](const int[6], void*) -> bool
  {
    isEntered = true;
    pthread_exit(nullptr);
  };
  RegionReader reader(gate.Volume, Known);
  reader.Order(Here);
  ASSERT_TRUE(Eventually([&] { return !reader.GetTrouble().empty(); }));
  EXPECT_TRUE(isEntered);
  EXPECT_FALSE(reader.Drain());
}
#endif

TEST(RegionReader, TriesASurveyAgain)
{
  GatedVolume gate;
  gate.Failures = 2;
  RegionReader reader(gate.Volume, std::nullopt);
  ASSERT_TRUE(Eventually([&] { return reader.GetFacts().has_value(); }));
  EXPECT_EQ(gate.Entered, 2 + 512 + 8);
}

TEST(RegionReader, TriesTheLatestOrderAfterAFailure)
{
  GatedVolume gate;
  gate.Failures = 1;
  RegionReader reader(gate.Volume, Known);
  reader.Order(Here);
  ASSERT_TRUE(Eventually([&] { return !reader.GetTrouble().empty(); }));
  reader.Order(There);
  EXPECT_EQ(Await(reader)->Extent, There);
}

TEST(RegionReader, WaitsForTheReadUnderWayAndNoOther)
{
  GatedVolume gate;
  gate.IsOpen = false;
  auto reader = std::make_unique<RegionReader>(gate.Volume, Known);
  reader->Order(Here);
  ASSERT_TRUE(Eventually([&] { return gate.Entered == 1; }));
  reader->Order(There);
  EndMeanwhile(reader, gate);
  EXPECT_EQ(gate.Entered, 1);
}

TEST(RegionReader, EndsBetweenTwoBoxesOfASurvey)
{
  GatedVolume gate;
  gate.IsOpen = false;
  auto reader = std::make_unique<RegionReader>(gate.Volume, std::nullopt);
  ASSERT_TRUE(Eventually([&] { return gate.Entered == 1; }));
  EndMeanwhile(reader, gate);
  EXPECT_LT(gate.Entered, 512);
}

TEST(RegionReader, DoesNotWaitForAReaderThatOwnsWhatItUses)
{
  struct Owned
  {
    explicit Owned(std::atomic<int>& ends)
      : Ends(ends)
    {
    }
    ~Owned() { ++this->Ends; }
    std::atomic<bool> IsOpen{ false };
    std::atomic<bool> IsEntered{ false };
    std::atomic<int>& Ends;
  };
  static std::atomic<int> ends{ 0 };
  auto owned = std::make_shared<Owned>(ends);
  auto volume = std::make_shared<LargeVolume>();
  volume->Extent = Whole;
  volume->IsAwaited = false;
  volume->Read = [owned](const int[6], void*)
  {
    owned->IsEntered = true;
    while (!owned->IsOpen)
    {
      std::this_thread::yield();
    }
    return true;
  };
  {
    RegionReader reader(std::move(volume), Known);
    reader.Order(Here);
    ASSERT_TRUE(Eventually([&] { return owned->IsEntered.load(); }));
  } // does not wait
  EXPECT_EQ(ends, 0);
  owned->IsOpen = true;
  owned.reset();
  EXPECT_TRUE(Eventually([&] { return ends == 1; })) << "the function goes after its last call";
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests faults of a device under force: the device is lost, its text contains the reason, its force
 * becomes zero, and it resumes only after homing.
 */

#include "Rigs/FalconRig.h"
#include "Rigs/ReadTimes.h"

using namespace emulated;

namespace
{
struct Case
{
  const char* Name;
  FalconFault Fault;
  int Packets;
  const char* Why;
};

class FalconBreaks
  : public FalconTest
  , public testing::WithParamInterface<Case>
{
};

class FalconForgives
  : public FalconTest
  , public testing::WithParamInterface<Case>
{
};

constexpr int Forever = 1 << 30;
const Case Fatal[] = { //
  { "ShortPackets", FalconFault::ShortPacket, Forever, "makes sense" },
  { "Garbage", FalconFault::Garbage, Forever, "does not begin with '<'" },
  { "Silence", FalconFault::Silence, Forever, "does not answer" },
  { "StallOut", FalconFault::StallOut, 1, "stall" },
  { "StallIn", FalconFault::StallIn, 1, "stall" },
  { "BadCable", FalconFault::BadCable, 3, "cable" },
  { "Nowhere", FalconFault::Nowhere, 1, "out of its reach" },
  { "Jump", FalconFault::Jump, 1, "jumped" },
  { "LostZero", FalconFault::LostZero, 1, "lost its zero" }
};
const Case Harmless[] = { //
  { "ShortPacket", FalconFault::ShortPacket, 1, "" },
  { "FlawedPacket", FalconFault::Garbage, 1, "" }, { "NoAnswer", FalconFault::Silence, 1, "" }
};

std::string NameOf(const testing::TestParamInfo<Case>& info)
{
  return info.param.Name;
}
} // namespace

TEST_P(FalconBreaks, AndGetsZero)
{
  this->MakeReady();
  ASSERT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
  this->Falcon.Break(this->GetParam().Fault, this->GetParam().Packets);
  this->ExpectLost(this->GetParam().Why);
  EXPECT_TRUE(Has(this->GetText(), "Home()")) << this->GetText();
  EXPECT_TRUE(this->StaysAtZero(20));
  EXPECT_EQ(this->Falcon.GetLights(), 0x09) << "red";

  this->Falcon.Break(FalconFault::None);
  EXPECT_TRUE(this->StaysAtZero(50)) << "it does not resume by itself";
  this->Device->Home();
  EXPECT_TRUE(this->IsAt(DeviceStage::Homing));
  EXPECT_TRUE(this->StaysAtZero(20)) << "not before the grip was out";
  this->Home();
  EXPECT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
}

TEST_F(FalconTest, ADeviceThatHangsFallsSilentAtOnce)
{
  this->MakeReady();
  devicetest::ReadTimes times(*this->Device);
  times.Run(0.5);
  EXPECT_GT(times.Fresh, 10);
  EXPECT_EQ(times.Signs, 0) << "it reports at rest, too";
  EXPECT_GT(times.Timing.GetRoundTrip(), 0.0);
  this->Falcon.Break(FalconFault::Silence, Forever);
  EXPECT_TRUE(times.FallsSilent(1.0, 0.05));
}
INSTANTIATE_TEST_SUITE_P(, FalconBreaks, testing::ValuesIn(Fatal), NameOf);

TEST_P(FalconForgives, OnePacket)
{
  this->MakeReady();
  ASSERT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
  for (int i = 0; i < 5; ++i)
  {
    this->Falcon.Break(this->GetParam().Fault, this->GetParam().Packets);
    const long end = this->Falcon.GetPackets() + 20;
    EXPECT_TRUE(this->Push({ 0.0, 0.0, 2.0 }, [&] { return this->Falcon.GetPackets() > end; }));
    EXPECT_EQ(this->Device->GetCondition().Stage, DeviceStage::Ready) << this->GetText();
    EXPECT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
  }
}
INSTANTIATE_TEST_SUITE_P(, FalconForgives, testing::ValuesIn(Harmless), NameOf);

using FalconStuck = FalconTest;

TEST_F(FalconStuck, ZeroLeavesBeforeAStallIsCleared)
{
  this->MakeReady();
  ASSERT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
  this->Falcon.DrainTranscript();
  this->Falcon.Break(FalconFault::StallIn, 1);
  this->ExpectLost("stall");
  EXPECT_TRUE(this->StaysAtZero(5)) << "some rounds later";
  std::string last;
  for (const std::string& line : this->Falcon.DrainTranscript())
  {
    if (line.rfind("c 02 01", 0) == 0)
    {
      EXPECT_EQ(last.rfind("o 3c 41 41 41 41 41 41 41 41 41 41 41 41", 0), 0u) << last;
      return;
    }
    last = line;
  }
  FAIL() << "it was not cleared";
}

TEST_F(FalconStuck, TransfersAreTakenBack)
{
  this->MakeReady();
  ASSERT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
  this->Falcon.Break(FalconFault::StuckOut);
  EXPECT_TRUE(this->Push(
    { 0.0, 0.0, 2.0 }, [&] { return this->Device->GetCondition().Stage == DeviceStage::Lost; }));
  EXPECT_TRUE(Has(this->GetText(), "does not answer")) << this->GetText();
  this->Falcon.Break(FalconFault::None);
  EXPECT_TRUE(Eventually([&] { return this->Falcon.GetCommands() == Numbers{}; }));
  this->Falcon.Break(FalconFault::StuckOut);
  this->Device->Close();
  EXPECT_FALSE(this->Usb.IsClaimed());
}

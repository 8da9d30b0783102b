// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests faults of a stick: the force becomes zero, and the text contains the reason. */

#include "StickRig.h"

#include <limits>

using namespace emulated;

namespace
{
class PidFaults : public Pid
{
protected:
  void Break(FfbFault fault)
  {
    ASSERT_TRUE(this->Bench.Open("pid", this->Options)) << this->Bench.Error;
    ASSERT_NO_FATAL_FAILURE(this->Feel());
    this->Model.Fault = fault;
  }
  bool IsQuiet()
  {
    return Eventually([&] { return Size(this->Model.GetForce()) == 0.0; });
  }
};

struct Refusal
{
  FfbFault Fault;
  const char* Text;
};
class PidRefusals
  : public PidFaults
  , public testing::WithParamInterface<Refusal>
{
};
} // namespace

TEST_F(PidFaults, ShortReport)
{
  this->Break(FfbFault::ShortReport);
  this->Bench.ExpectLost("sent a report that is shorter than the device's descriptor says");
  EXPECT_TRUE(this->IsQuiet());
}

TEST_F(PidFaults, PlacesThatNoHandReachesAreOverSpeed)
{
  this->Break(FfbFault::None);
  SafetyLimits limits = QuickLimits();
  limits.MaximumSpeed = this->Bench.Device->GetLimits().MaximumSpeed;
  this->Bench->SetLimits(limits);
  this->Model.Fault = FfbFault::Garbage;
  EXPECT_TRUE(this->Bench.WaitForFault(GateReason::OverSpeed));
  EXPECT_TRUE(this->IsQuiet());
}

TEST_F(PidFaults, AStickThatReportedAllTheTimeMayNotFallSilent)
{
  this->Model.Streams = true;
  ASSERT_TRUE(this->Bench.Open("pid", this->Options)) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << "it says where it is by itself";
  this->Bench.Start(this->Ground.Model);
  ASSERT_TRUE(this->Bench.WaitForTicks(100));
  this->Bench->Arm();
  this->Model.SetGoal(Wall + 0.01, 0.0);
  ASSERT_TRUE(Eventually([&] { return this->Model.GetForce()[0] < -1.0; }));
  this->Model.Fault = FfbFault::Silence;
  this->Bench.ExpectLost("no longer reports its position");
  EXPECT_TRUE(this->IsQuiet());
  this->Model.Fault = FfbFault::None;
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  this->Bench->Arm();
  EXPECT_TRUE(this->Bench.WaitForFault(GateReason::None));
}

TEST_F(PidFaults, AStickThatOnlySaysNewsIsAskedToBeMovedAndMayRest)
{
  this->Model.OnlySaysNews = true;
  ASSERT_TRUE(this->Bench.Open("pid", this->Options)) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitForText("move it a little")) << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
  this->Model.SetGoal(Wall - 0.005, 0.0);
  ASSERT_NO_FATAL_FAILURE(this->Feel());
  EXPECT_TRUE(this->Bench.WaitForTicks(3000));
  EXPECT_TRUE(this->Bench.WaitForFault(GateReason::None));
}

TEST_F(PidFaults, AfterAWriteErrorEffectsEndByThemselves)
{
  this->Break(FfbFault::WriteError);
  this->Bench.ExpectLost("does not accept what is sent to it");
  EXPECT_TRUE(Eventually([&] { return this->Model.CountPlaying() == 0; }));
  EXPECT_EQ(Size(this->Model.GetForce()), 0.0);
}

TEST_F(PidFaults, ForcesThatAreNotRenewedFadeAndQuenchIsAtOnce)
{
  this->Model.Streams = true;
  ASSERT_TRUE(this->Bench.Open("pid", this->Options)) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready));
  const auto push = [&]
  {
    DeviceSample sample;
    this->Bench.Device->Read(0.001, sample);
    this->Bench.Device->Write({ 0.5, 0.0, 0.0 });
    // Expect a force to the right: for 0.5 N of 4 N, block 1 gets -4096 of 32767.
    return this->Model.GetForce()[0] > 0.4 &&
      this->Model.GetLast(5) == std::vector<std::uint8_t>{ 5, 1, 0x00, 0xF0 };
  };
  EXPECT_TRUE(Eventually(push));
  EXPECT_TRUE(this->IsQuiet()) << "the servo fell silent";
  EXPECT_TRUE(Eventually([&] { return this->Model.CountPlaying() > 0; }))
    << "with no magnitude, and ready for the next force";
  EXPECT_TRUE(Eventually(push));
  this->Bench.Device->Quench();
  EXPECT_TRUE(this->IsQuiet());
}

TEST_P(PidRefusals, AreSaid)
{
  this->Model.Fault = this->GetParam().Fault;
  ASSERT_TRUE(this->Bench.Open("pid", this->Options)) << this->Bench.Error;
  EXPECT_TRUE(this->Bench.WaitForText(this->GetParam().Text)) << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Lost);
  EXPECT_TRUE(Has(this->Bench.Text(), "plug it in again, then Open() and Start() it"));
}

INSTANTIATE_TEST_SUITE_P(All, PidRefusals,
  testing::Values(Refusal{ FfbFault::NoBlockLoad, "does not say whether it has made the effect" },
    Refusal{ FfbFault::FullPool, "has no room for another effect" }));

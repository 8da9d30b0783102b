// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that no force acts while the clutch is on. When the clutch is released, the force rises
 * from zero, with the proxy at the tip, unless the device was disarmed before or meanwhile.
 */

#include "Rigs/DeviceRig.h"
#include "Rigs/EventCounter.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkTable.h>

#include <functional>
#include <vector>

using namespace devicetest;

namespace
{
class Clutch : public DeviceTest
{
protected:
  /// Presses into the ramp with 1.5 N, turns on the clutch, and waits until the force is off.
  void Press()
  {
    ASSERT_NO_FATAL_FAILURE(this->BeginPressed());
    this->Device->SetClutch(true);
    ASSERT_TRUE(this->Device->GetClutch());
    ASSERT_TRUE(this->Wait([this] { return Length(this->Device->GetState()->GetForce()) == 0.0; }));
  }
  bool IsForceless()
  {
    this->WaitTicks(100);
    return Length(this->Device->GetState()->GetForce()) == 0.0 &&
      this->Device->GetStatus() == vtkHapticDevice::READY;
  }
  std::string Text() { return this->Device->GetStatusText(); }
};
} // namespace

TEST_F(Clutch, TakesTheForceAndGivesItBackFromZero)
{
  this->Press();
  EXPECT_TRUE(this->IsForceless());
  EXPECT_NE(this->Text().find("the clutch is held"), std::string::npos) << this->Text();
  EXPECT_TRUE(this->Device->ArmsAfterClutch());
  EXPECT_TRUE(this->Device->IsArmOrdered()) << "the clutch only delays it";
  vtkNew<vtkTable> states;
  this->Device->GetState()->Drain(states);
  this->Device->SetClutch(false);
  EXPECT_GE(this->Device->GetStatus(), vtkHapticDevice::ARMED) << "at once, as after Arm()";
  ASSERT_TRUE(this->WaitTicks(10));
  EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0) << "the proxy begins at the tip";
  ASSERT_TRUE(this->Lead(7.0, 7.0, 9.0));
  ASSERT_TRUE(this->WaitFullyArmed());
  ASSERT_TRUE(this->LeadInto(11.0));
  ASSERT_TRUE(this->WaitForce());
  this->Device->GetState()->Drain(states);
  auto* const force = vtkDataArray::SafeDownCast(states->GetColumnByName("Command"));
  auto* const tip = vtkDataArray::SafeDownCast(states->GetColumnByName("Tip"));
  ASSERT_TRUE(force && tip);
  double before = 0.0;
  for (vtkIdType i = 0; i < states->GetNumberOfRows() && tip->GetTuple3(i)[2] < 9.1; ++i)
  {
    const double now = Length(force->GetTuple3(i));
    EXPECT_LE(now, before + 0.02) << "it rises over half a second";
    before = now;
  }
}

TEST_F(Clutch, BringsNoForceBackThatWasTakenOtherwise)
{
  const std::vector<std::function<void()>> ways = {
    [this] { this->Device->Disarm(); },
    [this] { this->Device->FadeOut(); },
    [this] { this->Device->Home(); },
    [this]
    {
      this->Device->Stop();
      this->Device->Start();
    },
  };
  for (const auto& way : ways)
  {
    this->Press();
    way();
    EXPECT_FALSE(this->Device->ArmsAfterClutch());
    EXPECT_FALSE(this->Device->IsArmOrdered());
    this->Device->SetClutch(false);
    EXPECT_TRUE(this->IsForceless()) << this->Text();
    this->Device->Close();
  }
}

TEST_F(Clutch, OfWhatIsNotArmedBringsNothing)
{
  this->Begin();
  this->Device->SetClutch(true);
  EXPECT_FALSE(this->Device->ArmsAfterClutch());
  ASSERT_TRUE(this->WaitTicks(5));
  this->Device->SetClutch(false);
  EXPECT_TRUE(this->IsForceless()) << this->Text();
}

TEST_F(Clutch, LetsArmTakeEffectAfterIt)
{
  this->Device->SetClutch(true); // turns the clutch on before the servo runs
  this->Begin();
  this->Device->Arm();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
  EXPECT_TRUE(this->IsForceless()) << this->Text();
  this->Device->SetClutch(false);
  ASSERT_TRUE(this->WaitFullyArmed());
  ASSERT_TRUE(this->Lead(7.0, 7.0, 11.0));
  EXPECT_TRUE(this->WaitForce());
}

TEST_F(Clutch, KeepsAFault)
{
  this->BeginFast();
  this->Device->GetVirtualHand()->SetPosition(500.0, 7.0, 5.0);
  const auto hasFault = [this] { return this->Device->GetStatus() == vtkHapticDevice::FAULT; };
  ASSERT_TRUE(this->Wait(hasFault));
  this->Device->SetClutch(true);
  ASSERT_TRUE(this->WaitTicks(5));
  this->Device->SetClutch(false);
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_TRUE(hasFault()) << this->Text();
}

TEST_F(Clutch, TellsObserversThatItDisarms)
{
  apitest::EventCounter told(this->Device, vtkCommand::DisableEvent);
  this->Press();
  this->Device->SetClutch(false);
  told.Count = 0;
  this->Device->SetClutch(true);
  this->Device->SetClutch(true);
  this->Device->SetClutch(false);
  EXPECT_EQ(told.Count, 1);
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that the proxy starts at the place where the user picks up the stylus. */

#include "Rigs/DeviceRig.h"

using namespace devicetest;

TEST_F(DeviceTest, APlacedTipFeelsNothingOfTheWay)
{
  // The device's origin is at a corner of the ramp, and the first tip is deep inside the ramp. The
  // force must not be as if the hand had come from the origin.
  this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 12.0);
  ASSERT_TRUE(this->Device->Open("virtual") && this->Device->Start());
  this->Log.Errors.clear();
  this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 12.0);
  const auto isAt = [&](double z)
  { return this->Wait([&] { return this->Device->GetState()->GetTipPosition()[2] == z; }); };
  ASSERT_TRUE(isAt(12.0));
  EXPECT_EQ(this->Device->GetState()->GetProxyPosition()[2], 12.0)
    << "the hand did not come from the origin";
  ASSERT_TRUE(this->Lead(7.0, 7.0, 13.0));
  EXPECT_NEAR(this->Device->GetState()->GetProxyPosition()[2], 12.0, 1e-6) << "held";
  for (const double z : { 3.0, 10.0 })
  {
    this->Device->GetVirtualHand()->Place(7.0, 7.0, z);
    ASSERT_TRUE(isAt(z));
    EXPECT_EQ(this->Device->GetState()->GetProxyPosition()[2], z);
  }
  EXPECT_EQ(this->Device->GetUnfinishedTicks(), 0);
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a signal that ends the application while a hand feels the face. The device must receive
 * zero force before the signal is passed on.
 */

#include "PhantomFalconRig.h"

#include <csignal>

using namespace emulated;

namespace
{
volatile std::sig_atomic_t HasSignal = 0;

class PhantomSignal
  : public PhantomFalcon
  , public testing::WithParamInterface<int>
{
protected:
  PhantomSignal()
    : PhantomFalcon(true)
  {
  }
};
} // namespace

TEST_P(PhantomSignal, GoesOnOnceTheDeviceHasGotZero)
{
  // The application installs its own handler before it opens the device.
  HasSignal = 0;
  std::signal(this->GetParam(), [](int) { HasSignal = 1; });
  ASSERT_TRUE(this->Device->Open("falcon"));
  ASSERT_TRUE(this->Device->Start());
  ASSERT_NO_FATAL_FAILURE(this->Home());
  ASSERT_NO_FATAL_FAILURE(this->Press(0.0, 0.0, 0.006));
  EXPECT_NE(this->Falcon.GetCommands(), Numbers{});
  std::raise(this->GetParam());
  ASSERT_TRUE(Eventually([] { return HasSignal != 0; }));
  EXPECT_EQ(this->Falcon.GetCommands(), Numbers{});
  EXPECT_TRUE(this->Hand.WaitTicks(100));
  EXPECT_EQ(this->Falcon.GetCommands(), Numbers{}) << "and none comes back";
  EXPECT_NE(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
}

INSTANTIATE_TEST_SUITE_P(Signals, PhantomSignal, testing::Values(SIGTERM, SIGSEGV, SIGABRT));

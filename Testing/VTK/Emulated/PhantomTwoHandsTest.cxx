// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests two devices in one scene. Each has its own proxy on the same phantom, and a fault of one
 * device must not disturb the other.
 */

#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "Emulators/OpenFfboardModel.h"
#include "PhantomFalconRig.h"

#include <vtkHapticRepresentation.h>
#include <vtkRenderer.h>

using namespace emulated;

namespace
{
class PhantomTwoHands : public PhantomFalcon
{
protected:
  PhantomTwoHands()
    : PhantomFalcon(true)
  {
  }
  /** Moves the stick's hand in and out until it feels the face. Returns false if it never does. */
  bool FeelsStick()
  {
    bool felt = false;
    for (int attempt = 0; attempt < 20 && !felt; ++attempt)
    {
      this->Stick.SetGoal(-0.01, 0.0);
      Eventually([&] { return this->Stick.GetTip()[0] < -0.008; });
      this->Stick.SetGoal(0.006, 0.0);
      for (int i = 0; i < 2000 && !felt; ++i)
      {
        this->Other.WaitTicks(1);
        const double force = -this->Second->GetState()->GetForce()[1];
        felt = force > 0.1 && std::abs(this->Stick.GetForce()[0] + force) < 0.05;
      }
    }
    return felt;
  }

  OpenFfboardModel Stick;
  EmulatedHid Hid{ this->Stick };
  ModelClock Clock{ [this] { this->Stick.Step(); } };
  PhantomHand Other{ this->Phantom, 0, -1.0 };
  vtkHapticDevice* const Second = this->Other.Device;
};
} // namespace

TEST_F(PhantomTwoHands, FeelTheSameFaceAndLiveTheirOwnLives)
{
  this->Second->SetNewtonsPerFullScale(FfbHandle::FullScale, 0.0);
  ASSERT_TRUE(this->Device->Open("falcon"));
  ASSERT_TRUE(this->Second->Open("pid"));
  ASSERT_TRUE(this->Device->Start());
  ASSERT_TRUE(this->Second->Start());
  ASSERT_NO_FATAL_FAILURE(this->Home());
  this->Stick.SetGoal(-0.01, 0.0);
  ASSERT_TRUE(this->Other.WaitFor(vtkHapticDevice::READY)) << this->Second->GetStatusText();
  this->Second->Arm();
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::READY) << "arming is for one";

  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkHapticRepresentation> first;
  vtkNew<vtkHapticRepresentation> second;
  first->SetDevice(this->Device);
  second->SetDevice(this->Second);
  renderer->AddViewProp(first);
  renderer->AddViewProp(second);

  ASSERT_NO_FATAL_FAILURE(this->Press(0.01, 0.01, 0.006));
  EXPECT_TRUE(this->FeelsStick()) << this->Stick.GetForce()[0];
  EXPECT_TRUE(this->Hand.WaitTicks(1000));
  EXPECT_EQ(this->Second->GetStatus(), vtkHapticDevice::ACTIVE);
  // The two proxies are about 15 mm apart.
  this->Device->UpdateState();
  this->Second->UpdateState();
  const double* const a = this->Device->GetState()->GetProxyPosition();
  const double* const b = this->Second->GetState()->GetProxyPosition();
  EXPECT_GT(std::hypot(a[0] - b[0], a[2] - b[2]), 8.0);
  EXPECT_LT(std::hypot(a[0] - b[0], a[2] - b[2]), 22.0);

  this->Usb.Unplug();
  EXPECT_TRUE(this->Hand.WaitFor(vtkHapticDevice::FAULT));
  EXPECT_TRUE(this->Other.WaitTicks(200));
  EXPECT_EQ(this->Second->GetStatus(), vtkHapticDevice::ACTIVE) << "the other one goes on";
  EXPECT_TRUE(this->FeelsStick());
}

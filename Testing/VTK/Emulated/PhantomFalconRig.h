// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture with an emulated Falcon in front of the phantom's face, and the hand that holds it. */
#ifndef PhantomFalconRig_h
#define PhantomFalconRig_h

#include "Emulators/EmulatedUsb.h"
#include "Emulators/FalconModel.h"
#include "PhantomRig.h"

namespace emulated
{
inline constexpr double SkinHeight = 0.125; ///< height of the skin (m) in the Falcon's coordinates

class PhantomFalcon : public testing::Test
{
protected:
  explicit PhantomFalcon(bool runs = false)
    : Falcon(runs)
  {
  }
  bool LeadTo(double x, double y, double z)
  {
    this->Falcon.SetAim({ x, y, z });
    return Eventually(
      [&]
      {
        const Numbers hand = this->Falcon.GetHand();
        return std::hypot(hand[0] - x, hand[1] - y, hand[2] - z) < 1e-6;
      });
  }
  void Home()
  {
    ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::HOMING)) << this->Device->GetStatusText();
    ASSERT_TRUE(this->LeadTo(0.0, 0.0, 0.1735));
    ASSERT_TRUE(this->LeadTo(0.0, 0.0, 0.08));
    this->Device->Arm();
    EXPECT_EQ(this->Log.Errors.size(), 1u) << "not before it is homed";
    this->Log.Errors.clear();
    ASSERT_TRUE(this->LeadTo(0.0, 0.0, 0.172));
    ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::READY)) << this->Device->GetStatusText();
  }
  /** Returns the height of the skin at a distance from the line, where the face recedes. */
  double HeightOfSkin(double x, double y) const
  {
    return SkinHeight - 1e-3 * this->Phantom.SkinBehind(-1e3 * y, 1e3 * x);
  }
  /**
   * Presses from in front of the skin to `beyond` (m) behind it. Expects the force to balance the
   * hand's spring. Retries, because the force starts again from zero after a pause of a busy
   * machine.
   */
  void Press(double x, double y, double beyond)
  {
    this->Device->Arm();
    const double skin = this->HeightOfSkin(x, y);
    const double end = skin - beyond;
    const auto isFelt = [&]
    {
      this->Device->UpdateState();
      const double spring = FalconGrip::HandStiffness * (this->Falcon.GetGrip()[2] - end);
      const double force = -this->Device->GetState()->GetForce()[1];
      return force > 0.1 && std::abs(force - spring) < 0.05 &&
        std::abs(this->Falcon.GetForce()[2] - force) < 0.05;
    };
    bool felt = false;
    for (int attempt = 0; attempt < 20 && !felt; ++attempt)
    {
      ASSERT_TRUE(this->LeadTo(x, y, skin + 0.01));
      ASSERT_TRUE(this->LeadTo(x, y, end));
      for (int i = 0; i < 2000 && !(felt = isFelt()); ++i)
      {
        this->Hand.WaitTicks(1);
      }
    }
    EXPECT_TRUE(felt) << this->Falcon.GetForce()[2] << " N, told "
                      << this->Device->GetState()->GetForce()[1];
    EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
    EXPECT_NE(this->Device->GetState()->GetContact(), 0);
    EXPECT_GT(Phantom.DepthOf(this->Device->GetState()->GetTipPosition()),
      Phantom.DepthOf(this->Device->GetState()->GetProxyPosition()));
  }
  /** Expects that the force is 0 for this number of ticks. */
  void ExpectNoForce(vtkIdType ticks)
  {
    const vtkIdType end = this->Device->GetState()->GetTick() + ticks;
    EXPECT_TRUE(this->Hand.Wait(
      [&]
      {
        EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
        return this->Device->GetState()->GetTick() >= end;
      }));
  }

  emulated::Phantom Phantom;
  FalconModel Falcon;
  EmulatedUsb Usb{ this->Falcon, "1-2" };
  PhantomHand Hand{ this->Phantom, 2, 1.0 };
  vtkHapticDevice* const Device = this->Hand.Device;
  apitest::MessageLog Log{ this->Device };
};
} // namespace emulated

#endif

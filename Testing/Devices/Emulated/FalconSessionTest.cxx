// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a whole session: a device without firmware becomes ready, a hand feels a wall, the device
 * is lost, and the hand feels the wall again.
 */

#include "Rigs/FalconRig.h"
#include "Rigs/SurfaceRig.h"

#include <iostream>

using namespace emulated;

namespace
{
constexpr double Stiffness = 500.0; // N/m, stiffness of the wall
constexpr double Radius = 0.001;    // m, radius of the proxy's sphere
constexpr double Middle = 0.125;    // m, position of the wall in the device's own frame

class FalconSession : public FalconTest
{
protected:
  FalconSession()
    : FalconTest(false)
    , Image(MakeImage(5000))
    , File(Image)
  {
    this->Options.FirmwareFile = this->File.Path.string();
  }
  void OpenAndHome()
  {
    ASSERT_TRUE(this->Open()) << this->Error;
    ASSERT_TRUE(Eventually([&] { return this->Falcon.IsRunning(); })) << this->GetText();
    EXPECT_EQ(this->Falcon.GetImage(), this->Image);
    this->Home();
  }
  /**
   * Moves the hand's goal to `beyond` (m) behind the wall at x, y. Expects the grip where the
   * hand's spring balances the wall's spring.
   */
  void PressAt(double x, double y, double beyond)
  {
    const double depth =
      FalconGrip::HandStiffness * (beyond + Radius) / (FalconGrip::HandStiffness + Stiffness);
    this->Falcon.SetAim({ x, y, Middle - beyond });
    EXPECT_TRUE(Eventually(
      [&] {
        return AreClose(this->Falcon.GetGrip(), { x, y, Middle + Radius - depth }, 1e-4);
      }))
      << this->Falcon.GetGrip()[2] << " instead of " << Middle + Radius - depth;
    const Numbers force{ 0.0, 0.0, Stiffness * depth };
    EXPECT_TRUE(Eventually([&] { return AreClose(this->Falcon.GetForce(), force, 0.06); }))
      << this->Falcon.GetForce()[2] << " N instead of " << force[2] << ". " << this->GetText();
  }
  /** Expects that no command has pointed into the wall. */
  void ExpectPushedOut(servotest::RunningLoop& loop)
  {
    ServoSnapshot snapshot;
    double most = 0.0;
    while (loop->Drain(snapshot))
    {
      EXPECT_GE(snapshot.Command.Z, 0.0);
      // A sideways force can only come from the triangles' edges, if the sphere overlaps them when
      // the loop resumes after a pause.
      EXPECT_LT(std::hypot(snapshot.Command.X, snapshot.Command.Y), 0.01);
      most = std::max(most, snapshot.Command.Z);
    }
    EXPECT_GT(most, 1.0);
  }
  static SafetyLimits Limits()
  {
    SafetyLimits limits = servotest::QuickLimits();
    limits.MaximumSpeed = 2.5;
    return limits;
  }

  const std::vector<std::uint8_t> Image;
  const TemporaryFile File;
  const coretest::TestVolume Volume = coretest::MakeRamp();
  const std::shared_ptr<const HapticModel> Model =
    std::make_shared<HapticModel>(coretest::DescribeMesh(this->Volume, coretest::MakeFloor()));
};
} // namespace

TEST_F(FalconSession, FromFirmwareToFeelingAndBack)
{
  this->OpenAndHome();
  {
    servotest::RunningLoop loop(*this->Device, 1000.0, Limits());
    loop->SetRecording(true);
    loop->Publish(this->Model);
    loop->Arm();
    // Run some ticks first, so that the proxy starts outside the wall.
    ASSERT_TRUE(Eventually([&] { return loop->GetTickCount() > 20; }));
    const long before = this->Falcon.GetPackets();
    const std::uint64_t from = loop->GetTickCount();
    this->PressAt(0.0, 0.0, 0.005);
    this->PressAt(0.02, -0.01, 0.005);
    this->PressAt(-0.02, 0.015, 0.004);
    ASSERT_TRUE(Eventually([&] { return loop->GetTickCount() > from + 5000; }));
    this->PressAt(-0.02, 0.015, 0.005);
    std::cout << loop->GetTickCount() - from << " ticks, " << this->Falcon.GetPackets() - before
              << " packets, " << loop->GetTickRate() << " ticks/s\n";
    this->ExpectPushedOut(loop);

    this->Usb.Unplug();
    const auto isFault = [&]
    { return loop->ReadState() && loop->GetState().GetFault() == GateReason::DeviceLost; };
    EXPECT_TRUE(Eventually(isFault));
    EXPECT_TRUE(this->IsAt(DeviceStage::Lost));
    EXPECT_TRUE(Has(this->GetText(), "unplugged")) << this->GetText();
    this->Usb.PlugIn();
    this->Device->Home();
    const std::uint64_t later = loop->GetTickCount() + 100;
    EXPECT_TRUE(Eventually([&] { return loop->GetTickCount() > later; }));
    EXPECT_TRUE(Eventually(isFault)) << "it stays, plugged in again or not";
    EXPECT_EQ(Norm(loop->GetState().Command), 0.0);
  }
  this->Device->Close();

  this->Falcon.SwitchOff();
  this->OpenAndHome();
  servotest::RunningLoop loop(*this->Device, 1000.0, Limits());
  loop->Publish(this->Model);
  EXPECT_TRUE(Eventually([&] { return loop->GetTickCount() > 50; }));
  EXPECT_EQ(this->Falcon.GetForce(), Numbers{}) << "not before it is armed";
  loop->Arm();
  this->PressAt(0.01, 0.01, 0.005);
  this->LeadTo(Rest);
  EXPECT_TRUE(Eventually([&] { return this->Falcon.GetCommands() == Numbers{}; }));
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests sessions with hfab arms over pseudo-terminals: each arm presses on a floor in closed loop,
 * and each fault ends in zero force and a text. Controllers and arms follow the published firmware
 * and host program (Emulators/HfabEmulator.h).
 */

#include "Devices/Emulated/DeviceBench.h"
#include "Devices/Hfab/HfabDriver.h"
#include "Emulators/HfabEmulator.h"
#include "Rigs/TemporaryFolder.h"

#include <filesystem>

#include <gtest/gtest.h>

using namespace emulated;

namespace
{
// Maps the device's axes (right, up, towards the hand) to the arm's y, z and x.
const Matrix3 ToTheHfabArm = Matrix3::FromColumns({ 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 });
const std::array<int, 3> NoCurrents{};

struct HfabRig
{
  explicit HfabRig(int model)
    : Arm(model)
    , Home(HfabEmulator::TipOf(model, HfabEmulator::AnglesOf(model, HfabEmulator::HomeOf(model))))
    // Polhem's calibration pose is at the edge of its workspace, so use another pose as the middle.
    , Middle(model == 1 ? Triple{} : Triple{ this->Home[0] + 0.02, 0.0, this->Home[2] })
    , Height(this->Middle[2] - 0.01)
    , Ground(this->Height, ToTheHfabArm)
  {
  }
  std::string GetId() const { return "hfab:" + this->Arm.GetPort(); }
  bool IsQuiet()
  {
    return Eventually([&] { return this->Arm.GetCurrents() == NoCurrents; });
  }
  bool IsAt(DeviceStage stage) { return this->Bench.Device->GetCondition().Stage == stage; }
  /// Calibrates the arm. Retries if a busy machine has delayed the controller's answers.
  void Calibrate()
  {
    for (int attempt = 0; attempt < MostAttempts && !this->IsAt(DeviceStage::Ready); ++attempt)
    {
      if (this->IsAt(DeviceStage::Lost))
      {
        this->Bench.Device->Home();
      }
      ASSERT_TRUE(this->Bench.WaitForText("needs to know where its arm is")) << this->Bench.Text();
      this->Arm.PlaceAtHome();
      this->Bench.Device->Home();
      EXPECT_TRUE(Eventually(
        [&] { return this->IsAt(DeviceStage::Ready) || this->IsAt(DeviceStage::Lost); }));
    }
    ASSERT_TRUE(this->IsAt(DeviceStage::Ready)) << this->Bench.Text();
  }
  /// Returns the position (m) at a height above the middle of the floor.
  Triple At(double above) const
  {
    return { this->Middle[0], this->Middle[1], this->Height + above };
  }
  /// Moves the hand slowly to a goal (m). Returns false if the device is lost on the way, because
  /// no more positions are reported then.
  bool Lead(const Triple& goal)
  {
    this->Arm.SetGoal(goal);
    const auto isThere = [&] { return IsNear(this->Arm.GetTip(), goal, 1e-3); };
    return Eventually([&] { return isThere() || this->IsAt(DeviceStage::Lost); }) && isThere();
  }
  /// Calibrates and arms the device, and moves the hand's goal 5 mm deep into the floor.
  void Feel()
  {
    bool isAbove = false;
    for (int attempt = 0; attempt < MostAttempts && !isAbove; ++attempt)
    {
      ASSERT_NO_FATAL_FAILURE(this->Calibrate());
      isAbove = this->Lead(this->At(0.005));
    }
    ASSERT_TRUE(isAbove) << this->Bench.Text();
    this->Bench.Start(this->Ground.Model);
    ASSERT_TRUE(this->Bench.WaitForTicks(20));
    this->Bench->Arm();
    EXPECT_TRUE(this->Bench.Press([&] { this->Lead(this->At(0.005)); },
      [&] { this->Arm.SetGoal(this->At(-0.005)); }, [&] { return this->IsHeld(); }))
      << this->Arm.GetForce()[2] << " " << this->Bench.Text();
  }
  /// Returns whether the floor's force balances a hand whose goal is 5 mm inside.
  bool IsHeld()
  {
    const double force = FloorStiffness * BalancedDepth(0.005);
    return IsNear(this->Arm.GetForce(), { 0.0, 0.0, force }, 0.06);
  }

  static constexpr int MostAttempts = 5;
  HfabEmulator Arm;
  const Triple Home;
  const Triple Middle;
  const double Height;
  const Floor Ground;
  DeviceBench Bench;
};

class HfabArms : public testing::TestWithParam<int>
{
};

class Hfab : public testing::Test
{
protected:
  void Break(HfabFault fault, const char* text)
  {
    ASSERT_TRUE(this->Rig.Bench.Open(this->Rig.GetId())) << this->Rig.Bench.Error;
    ASSERT_NO_FATAL_FAILURE(this->Rig.Feel());
    this->Rig.Arm.Fault = fault;
    this->Rig.Bench.ExpectLost(text);
    EXPECT_TRUE(this->Rig.IsQuiet());
  }
  HfabRig Rig{ 3 };
};
} // namespace

TEST_P(HfabArms, PressAFloorAndLetGo)
{
  HfabRig rig(GetParam());
  ASSERT_TRUE(rig.Bench.Open(rig.GetId())) << rig.Bench.Error;
  const char* const names[] = { "Polhem", "PHANToM", "WoodenHaptics" };
  EXPECT_EQ(rig.Bench.Device->GetName(),
    std::string(names[GetParam() - 1]) + " (" + rig.Arm.GetPort() + ")");
  EXPECT_TRUE(rig.Arm.IsRaw());
  ASSERT_NO_FATAL_FAILURE(rig.Feel());
  rig.Bench.Stop();
  rig.Bench.Device->Close();
  EXPECT_TRUE(rig.IsQuiet());
  EXPECT_EQ(rig.Arm.GetErrors(), 0) << "the firmware took all messages";
}

INSTANTIATE_TEST_SUITE_P(Models, HfabArms, testing::Values(1, 2, 3));

TEST_F(Hfab, IsUncalibratedWheneverItIsOpened)
{
  DeviceBench& bench = this->Rig.Bench;
  ASSERT_TRUE(bench.Open(this->Rig.GetId())) << bench.Error;
  EXPECT_EQ(bench.Device->GetLimits().MaximumForce, 2.5);
  bench.Start(this->Rig.Ground.Model);
  bench->Arm();
  ASSERT_TRUE(bench.WaitForTicks(100));
  EXPECT_EQ(bench.Device->GetCondition().Stage, DeviceStage::Homing);
  EXPECT_FALSE(bench.State().IsArmed());
  EXPECT_EQ(this->Rig.Arm.GetCurrents(), NoCurrents);
  bench.Stop();
  ASSERT_NO_FATAL_FAILURE(this->Rig.Calibrate());
  ASSERT_TRUE(bench.Reopen()) << bench.Error;
  EXPECT_TRUE(bench.WaitForText("needs to know where its arm is")) << bench.Text();
}

TEST_F(Hfab, AFirmwareThatWantsItsButtonIsNotCalibratedBeforeIt)
{
  this->Rig.Arm.NeedButton();
  DeviceBench& bench = this->Rig.Bench;
  ASSERT_TRUE(bench.Open(this->Rig.GetId())) << bench.Error;
  ASSERT_TRUE(bench.WaitForText("needs to know where its arm is")) << bench.Text();
  this->Rig.Arm.PlaceAtHome();
  bench.Device->Home();
  ASSERT_TRUE(bench.WaitForText("press the button of its controller")) << bench.Text();
  EXPECT_EQ(bench.Device->GetCondition().Stage, DeviceStage::Homing);
  this->Rig.Arm.PressButton();
  bench.Device->Home();
  ASSERT_TRUE(bench.WaitFor(DeviceStage::Ready)) << bench.Text();
  ASSERT_NO_FATAL_FAILURE(this->Rig.Feel());
}

TEST_F(Hfab, TheFirmwaresWatchdogIsTheLastResort)
{
  // Act like a program that sends one message and then hangs.
  SerialPort port;
  std::string error;
  ASSERT_TRUE(port.Open(this->Rig.Arm.GetPort(), error)) << error;
  const HfabMessage message = EncodeHfab({ 100, 0, 0 });
  ASSERT_TRUE(port.Write(message.Bytes.data(), message.Size, 100));
  EXPECT_TRUE(Eventually([&] { return this->Rig.Arm.GetWatchdogs() == 1; }));
  EXPECT_TRUE(this->Rig.IsQuiet());
}

TEST_F(Hfab, SilenceCutsTheForceAndCalibrationBringsItBack)
{
  this->Break(HfabFault::Silence, "does not answer");
  this->Rig.Arm.Fault = HfabFault::None;
  this->Rig.Bench.Device->Home();
  ASSERT_TRUE(this->Rig.Bench.WaitForText("needs to know where its arm is"));
  ASSERT_NO_FATAL_FAILURE(this->Rig.Calibrate());
}

TEST_F(Hfab, JunkCutsTheForce)
{
  this->Break(HfabFault::Junk, "does not answer");
}

TEST_F(Hfab, AJumpCutsTheForce)
{
  DeviceBench& bench = this->Rig.Bench;
  ASSERT_TRUE(bench.Open(this->Rig.GetId())) << bench.Error;
  ASSERT_NO_FATAL_FAILURE(this->Rig.Feel());
  // Repeat the jump: after a pause of a busy machine, the driver may accept a single one as a
  // motion of the hand.
  EXPECT_TRUE(Eventually(
    [&]
    {
      const bool isThere = this->Rig.Arm.Fault == HfabFault::Jump;
      this->Rig.Arm.Fault = isThere ? HfabFault::None : HfabFault::Jump;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      return bench.Device->GetCondition().Stage == DeviceStage::Lost;
    }));
  bench.ExpectLost("a jump of its arm that no hand can make");
  EXPECT_TRUE(this->Rig.IsQuiet());
  this->Rig.Arm.Fault = HfabFault::None;
  bench.Device->Home();
  ASSERT_TRUE(bench.WaitForText("needs to know where its arm is")) << bench.Text();
  ASSERT_NO_FATAL_FAILURE(this->Rig.Calibrate());
}

TEST_F(Hfab, AnotherArmCutsTheForce)
{
  this->Break(HfabFault::OtherArm, "says that it drives another arm now");
  this->Rig.Arm.Fault = HfabFault::None;
  this->Rig.Bench.Stop();
  ASSERT_TRUE(this->Rig.Bench.Reopen()) << this->Rig.Bench.Error;
  ASSERT_NO_FATAL_FAILURE(this->Rig.Feel());
}

TEST_F(Hfab, AControllerThatRefusesMessagesCutsTheForce)
{
  this->Break(HfabFault::Refusal, "does not understand what is sent to it");
}

TEST_F(Hfab, ItsButtonElsewhereCutsTheForce)
{
  const char* const text = "its button was pressed";
  constexpr int answers = 5;
  bool isSeen = false;
  for (int attempt = 0; attempt < HfabRig::MostAttempts && !isSeen; ++attempt)
  {
    HfabRig rig(3);
    const Triple atPower = rig.Arm.GetTip();
    ASSERT_TRUE(rig.Bench.Open(rig.GetId())) << rig.Bench.Error;
    ASSERT_NO_FATAL_FAILURE(rig.Feel());
    const Triple tip = rig.Arm.GetTip();
    // The button resets the encoder counts to zero, like power-up, so the arm seems to be in its
    // power-up pose.
    const double jump = Size({ tip[0] - atPower[0], tip[1] - atPower[1], tip[2] - atPower[2] });
    rig.Arm.DrainLongestPause();
    const int messages = rig.Arm.GetMessages();
    rig.Arm.PressButton();
    EXPECT_TRUE(Eventually(
      [&] { return rig.IsAt(DeviceStage::Lost) || rig.Arm.GetMessages() >= messages + answers; }));
    isSeen = Has(rig.Bench.Text(), text);
    if (isSeen)
    {
      rig.Bench.ExpectLost(text);
      EXPECT_TRUE(rig.IsQuiet());
    }
    else
    {
      // The driver may accept the jump as a motion of the hand only if a busy machine has caused a
      // pause.
      EXPECT_GT(rig.Arm.DrainLongestPause(), 0.5 * jump / HfabDriver::FastestHand);
    }
  }
  EXPECT_TRUE(isSeen);
}

TEST_F(Hfab, UnpluggingIsSaidAndNothingComesBackByItself)
{
  ASSERT_TRUE(this->Rig.Bench.Open(this->Rig.GetId())) << this->Rig.Bench.Error;
  ASSERT_NO_FATAL_FAILURE(this->Rig.Feel());
  this->Rig.Arm.Unplug();
  this->Rig.Bench.ExpectLost("was unplugged.");
  this->Rig.Bench.Device->Home();
  EXPECT_TRUE(this->Rig.Bench.WaitForText("was unplugged")) << this->Rig.Bench.Text();
}

TEST_F(Hfab, ThePhantomsHandleTellsItsOrientationOnceItHasTurned)
{
  HfabRig rig(2);
  ASSERT_TRUE(rig.Bench.Open(rig.GetId())) << rig.Bench.Error;
  ASSERT_NO_FATAL_FAILURE(rig.Calibrate());
  DeviceSample sample;
  const auto isRead = [&]
  { return rig.Bench.Device->Read(1e-3, sample) == DeviceState::Running && sample.Fresh; };
  for (int i = 0; i < 20; ++i)
  {
    ASSERT_TRUE(Eventually(isRead)) << rig.Bench.Text();
    EXPECT_FALSE(sample.HasOrientation) << "as with a thimble, which has no encoders";
  }
  rig.Arm.SetHandle({ 0, 0, 500 });
  EXPECT_TRUE(Eventually([&] { return isRead() && sample.HasOrientation; })) << rig.Bench.Text();
}

TEST_F(Hfab, AnArmThatIsBackAsksForItsPose)
{
  const std::string port =
    (std::filesystem::temp_directory_path() / ("hfab-" + std::to_string(getpid()))).string();
  std::filesystem::remove(port);
  std::filesystem::create_symlink(this->Rig.Arm.GetPort(), port);
  DeviceBench& bench = this->Rig.Bench;
  ASSERT_TRUE(bench.Open("hfab:" + port)) << bench.Error;
  ASSERT_NO_FATAL_FAILURE(this->Rig.Feel());
  this->Rig.Arm.Unplug();
  std::filesystem::remove(port);
  bench.ExpectLost("was unplugged. Plug it in again");
  // The driver must refuse a different arm at the port.
  HfabRig other(2);
  std::filesystem::create_symlink(other.Arm.GetPort(), port);
  bench.Device->Home();
  EXPECT_TRUE(bench.WaitForText("drives another arm than before")) << bench.Text();
  EXPECT_EQ(bench.Device->GetCondition().Stage, DeviceStage::Lost);
  std::filesystem::remove(port);
  // The same kind of arm is plugged in again, at another pseudo-terminal and with a restarted
  // controller.
  HfabRig again(3);
  std::filesystem::create_symlink(again.Arm.GetPort(), port);
  bench.ExpectBack();
  EXPECT_TRUE(bench.WaitForText("needs to know where its arm is")) << bench.Text();
  EXPECT_TRUE(Eventually([&] { return again.Arm.GetMessages() > 50; }));
  EXPECT_EQ(again.Arm.GetCurrents(), NoCurrents);
  bench.Stop();
  again.Bench.Device = std::move(bench.Device);
  ASSERT_NO_FATAL_FAILURE(again.Feel());
  again.Bench.Stop();
  std::filesystem::remove(port);
}

TEST_F(Hfab, LateAnswersAreNotTakenForTheNextOnes)
{
  DeviceBench& bench = this->Rig.Bench;
  ASSERT_TRUE(bench.Open(this->Rig.GetId())) << bench.Error;
  ASSERT_NO_FATAL_FAILURE(this->Rig.Calibrate());
  this->Rig.Arm.Fault = HfabFault::Late;
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
  this->Rig.Arm.Fault = HfabFault::None;
  // Expect that the reported tip follows the arm again.
  const Triple goal{ this->Rig.Home[0] + 0.02, 0.0, this->Rig.Home[2] - 0.005 };
  this->Rig.Arm.SetGoal(goal);
  EXPECT_TRUE(Eventually(
    [&]
    {
      DeviceSample sample;
      bench.Device->Read(0.001, sample);
      const Vector3 tip = HfabModel::ToArm(sample.Tip);
      return IsNear({ tip.X, tip.Y, tip.Z }, goal, 1e-3);
    }))
    << bench.Text();
  EXPECT_EQ(bench.Device->GetCondition().Stage, DeviceStage::Ready) << bench.Text();
}

TEST_F(Hfab, ForcesThatAreNotRenewedFadeAndQuenchIsAtOnce)
{
  DeviceBench& bench = this->Rig.Bench;
  ASSERT_TRUE(bench.Open(this->Rig.GetId())) << bench.Error;
  ASSERT_NO_FATAL_FAILURE(this->Rig.Calibrate());
  const auto push = [&]
  {
    DeviceSample sample;
    bench.Device->Read(0.001, sample);
    bench.Device->Write({ 0.0, 0.5, 0.0 });
    return Size(this->Rig.Arm.GetForce()) > 0.4;
  };
  EXPECT_TRUE(Eventually(push));
  EXPECT_TRUE(this->Rig.IsQuiet()) << "the servo fell silent";
  EXPECT_TRUE(Eventually(push));
  bench.Device->Quench();
  EXPECT_TRUE(this->Rig.IsQuiet());
}

TEST_F(Hfab, APortThatCannotBeUsedIsAnErrorWithACure)
{
  EXPECT_TRUE(Has(ErrorOf("hfab:ttyACM0"), "is not a device id"));
  EXPECT_TRUE(Has(ErrorOf("hfab:/dev/no-such-port"), "not plugged in"));
  EXPECT_TRUE(Has(ErrorOf("hfab:/dev/null"), "not a serial port"));
  ASSERT_TRUE(this->Rig.Bench.Open(this->Rig.GetId())) << this->Rig.Bench.Error;
  EXPECT_TRUE(Has(ErrorOf(this->Rig.GetId()), "in use by another program"));
  EXPECT_EQ(SerialPort::StateOf(this->Rig.Arm.GetPort()), "in use");
  this->Rig.Bench.Device->Close();
  EXPECT_EQ(SerialPort::StateOf(this->Rig.Arm.GetPort()), "available");
  this->Rig.Arm.Fault = HfabFault::Silence;
  EXPECT_TRUE(Has(ErrorOf(this->Rig.GetId()), "does not answer"));
  this->Rig.Arm.Fault = HfabFault::Junk;
  EXPECT_TRUE(Has(ErrorOf(this->Rig.GetId()), "an hfab controller does not send"));
  const HfabEmulator other(7);
  EXPECT_TRUE(Has(ErrorOf("hfab:" + other.GetPort()), "the model 7"));
}

/// The names of udev's links are those of chohh7391/lerobot_teleoperator_inverse3 99063dc,
/// SETUP.md: a Haply Inverse3 there has ID_VENDOR Teensyduino, ID_MODEL Haply_inverse3 and
/// ID_SERIAL_SHORT 16894910.
TEST_F(Hfab, NothingIsWrittenToAHaplyArm)
{
  namespace fs = std::filesystem;
  const fs::path folder = TemporaryPath("by-id-haply");
  fs::create_directories(folder);
  HfabEmulator haply(3);
  fs::create_symlink(haply.GetPort(), folder / "usb-Teensyduino_Haply_inverse3_16894910-if00");
  std::string error;
  const auto open = [&](const std::string& port)
  {
    HfabDriver driver(port, folder.string());
    return driver.Connect(error);
  };
  EXPECT_FALSE(open(""));
  EXPECT_TRUE(Has(error, "No hfab controller is plugged in")) << error;
  EXPECT_FALSE(open(haply.GetPort()));
  EXPECT_TRUE(Has(error, "Open it as \"haply\"")) << error;
  fs::create_symlink(this->Rig.Arm.GetPort(), folder / "usb-Teensyduino_USB_Serial_11037800-if00");
  EXPECT_TRUE(open("")) << error;
  EXPECT_GT(this->Rig.Arm.GetMessages(), 0);
  EXPECT_EQ(haply.GetMessages(), 0);
  const HfabEmulator second(2);
  fs::create_symlink(second.GetPort(), folder / "usb-Teensyduino_USB_Serial_22037800-if00");
  EXPECT_FALSE(open(""));
  EXPECT_TRUE(Has(error, ("Give the port: hfab:" + this->Rig.Arm.GetPort()).c_str())) << error;
  EXPECT_TRUE(Has(error, ("hfab:" + second.GetPort()).c_str())) << error;
  EXPECT_EQ(second.GetMessages(), 0);
  EXPECT_TRUE(open(second.GetPort())) << error;
}

TEST_F(Hfab, BoardsAreFoundByTheirNames)
{
  namespace fs = std::filesystem;
  const fs::path folder = TemporaryPath("by-id");
  fs::create_directories(folder);
  const std::string name = "usb-Teensyduino_USB_Serial_11037800-if00";
  fs::create_symlink(this->Rig.Arm.GetPort(), folder / name);
  fs::create_symlink("/dev/null", folder / "usb-Other_board");
  fs::create_symlink("/dev/no-such-port", folder / "usb-Teensyduino_gone");
  const auto boards = SerialPort::List(HfabDriver::Board, folder.string());
  ASSERT_EQ(boards.size(), 1U);
  EXPECT_EQ(boards[0].Path, this->Rig.Arm.GetPort());
  EXPECT_EQ(boards[0].Name, name);
  EXPECT_EQ(HfabDriver::MakeIdentity(boards[0]), "hfab:" + name);
  EXPECT_EQ(HfabDriver::MakeIdentity({ "/dev/ttyACM0", "" }), "hfab:port:/dev/ttyACM0");
  EXPECT_EQ(SerialPort::NameOf(this->Rig.Arm.GetPort(), folder.string()), name);
  EXPECT_TRUE(SerialPort::List(HfabDriver::Board, (folder / "none").string()).empty());
}

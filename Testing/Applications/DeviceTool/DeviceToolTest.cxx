// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Runs volumehaptics-device with an emulated Falcon, following the steps of a first-time user. */

#include "Emulators/EmulatedUsb.h"
#include "Emulators/FalconModel.h"
#include "Emulators/ModelClock.h"
#include "PageRig.h"

#include <cmath>
#include <fstream>

using namespace emulated;

namespace
{
class DeviceToolTest : public PageTest
{
protected:
  /// Moves the hand by one step in each call: homes the device when it requests homing, otherwise
  /// goes to 0.172 m or presses in and out.
  void MoveHand()
  {
    const int lights = this->Falcon.GetLights();
    const bool homes = (lights & 8) != 0; // red light: the device requests homing
    this->IsHomed = this->IsHomed || (this->WasHoming && !homes);
    this->WasHoming = this->WasHoming || homes;
    const double t = 0.001 * this->Steps++;
    const double z = this->IsHomed ? 0.172 : 0.127 + 0.0465 * std::cos(4.0 * t);
    // Keep moving in and out of the wall, so that a new contact begins even if a busy machine
    // missed one.
    const double pressed = 0.12 + 0.02 * std::cos(4.0 * t);
    this->Falcon.SetAim({ 0.0, 0.0, this->IsPressing && this->IsHomed ? pressed : z });
  }

  FalconModel Falcon;
  EmulatedUsb Usb{ this->Falcon, "1-2" };
  std::atomic<bool> IsPressing{ false };

private:
  bool WasHoming = false;
  bool IsHomed = false;
  int Steps = 0;
};
} // namespace

TEST_F(DeviceToolTest, ListsWhatIsPluggedIn)
{
  EXPECT_EQ(this->Run({ "list" }), 0);
  EXPECT_TRUE(this->Shows("falcon")) << this->Out;
  EXPECT_TRUE(this->Shows("Novint Falcon")) << this->Out;
  EXPECT_TRUE(this->Shows("available")) << this->Out;
  this->Usb.Unplug();
  EXPECT_EQ(this->Run({ "list" }), 0);
  EXPECT_TRUE(this->Shows("No haptic device is plugged in.")) << this->Out;
}

TEST_F(DeviceToolTest, TheLinesOfItsPageLeadToTheFirstForce)
{
  const ModelClock hand([this] { this->MoveHand(); });
  const std::string firmware = TemporaryPath("nvent.bin");
  std::ofstream(firmware) << std::string(2000, 'f');
  this->Falcon.SwitchOff();
  EXPECT_EQ(this->Type("falcon.md", "falcon", "", firmware), 5);
  EXPECT_GT(this->Falcon.DrainLargestCommand(), 0);
  EXPECT_EQ(this->Falcon.GetCommands(), Numbers{}) << "and it let go";
}

TEST_F(DeviceToolTest, HomesMonitorsAndRecords)
{
  const ModelClock hand([this] { this->MoveHand(); });
  EXPECT_EQ(this->Run({ "home", "falcon" }), 0) << this->Errors;
  EXPECT_TRUE(this->Shows("Homing of falcon")) << this->Out;
  EXPECT_TRUE(this->Shows("falcon is ready")) << this->Out;
  this->Falcon.SetButtons(4); // the centre button
  EXPECT_EQ(this->Run({ "monitor", "falcon", "--seconds", "0.5" }), 0) << this->Errors;
  EXPECT_TRUE(this->Shows("buttons 01")) << this->Out;
  EXPECT_TRUE(this->Shows("force   0.00   0.00   0.00 N")) << this->Out;
  EXPECT_TRUE(this->Shows("   uncalibrated")) << this->Out;
  const std::string file = TemporaryPath("DeviceTool.csv");
  EXPECT_EQ(this->Run({ "record", "falcon", file, "--seconds", "0.5" }), 0) << this->Errors;
  std::ifstream recorded(file);
  std::string line;
  int lines = 0;
  while (std::getline(recorded, line))
  {
    ++lines;
  }
  EXPECT_GT(lines, 20);
}

TEST_F(DeviceToolTest, FeelsAWallOfANewton)
{
  const ModelClock hand([this] { this->MoveHand(); });
  EXPECT_EQ(this->Run({ "test", "falcon", "--seconds", "0.3" }), 1);
  EXPECT_TRUE(this->Complains("Enter was not pressed")) << this->Errors;
  EXPECT_EQ(this->Falcon.GetForce(), Numbers{}) << "it was not armed";
  this->IsPressing = true;
  this->Falcon.DrainLargestCommand();
  EXPECT_EQ(this->Run({ "test", "falcon", "--seconds", "6" }, "\n"), 0) << this->Errors;
  EXPECT_TRUE(this->Shows("on the negative side of z")) << this->Out;
  EXPECT_TRUE(this->Shows("  1.00 N")) << this->Out;
  EXPECT_EQ(this->Falcon.GetCommands(), Numbers{}) << "and it let go";
}

TEST_F(DeviceToolTest, ConfirmsThatItMovesWithTheForceAndRemembersIt)
{
  const std::string file = TemporaryPath("devices.txt");
  setenv("VOLUMEHAPTICS_DEVICES", file.c_str(), 1);
  const ModelClock hand([this] { this->MoveHand(); });
  EXPECT_EQ(this->Run({ "confirm", "falcon" }), 1);
  EXPECT_TRUE(this->Complains("Enter was not pressed")) << this->Errors;
  EXPECT_EQ(this->Run({ "confirm", "falcon" }, "\n"), 0) << this->Errors;
  EXPECT_TRUE(this->Shows("moves with the force along every axis")) << this->Out;
  std::string line;
  std::ifstream lines(file);
  bool isRemembered = false;
  while (std::getline(lines, line))
  {
    isRemembered = isRemembered || line.find("falcon:port:1-2 confirmed=") == 0;
  }
  EXPECT_TRUE(isRemembered);
  EXPECT_EQ(this->Falcon.GetCommands(), Numbers{}) << "and it let go";

  this->Falcon.SetMotorSign(-1.0);
  EXPECT_EQ(this->Run({ "confirm", "falcon" }, "\n"), 1);
  EXPECT_TRUE(this->Complains("moves against the force on axis")) << this->Errors;
  EXPECT_EQ(this->Run({ "confirm", "virtual" }, "\n"), 1);
  EXPECT_TRUE(this->Complains("there is nothing to confirm")) << this->Errors;
}

TEST_F(DeviceToolTest, ListsWhetherNewtonsAreTrue)
{
  const std::string file = TemporaryPath("calibrated.txt");
  setenv("VOLUMEHAPTICS_DEVICES", file.c_str(), 1);
  EXPECT_EQ(this->Run({ "list" }), 0);
  EXPECT_TRUE(this->Shows("force: uncalibrated")) << this->Out;
  std::ofstream(file) << "falcon:port:1-2 scale=0.83 calibrated=2026-11-20\n";
  EXPECT_EQ(this->Run({ "list" }), 0);
  EXPECT_TRUE(this->Shows("force: calibrated 0.83 on 2026-11-20")) << this->Out;
}

TEST_F(DeviceToolTest, SaysWhatIsWrong)
{
  EXPECT_EQ(this->Run({ "monitor", "falcon:3" }), 1);
  EXPECT_TRUE(this->Complains("number 3")) << this->Errors;
  EXPECT_EQ(this->Run({ "monitor", "phantom" }), 1);
  EXPECT_TRUE(this->Complains("the kinds are")) << this->Errors;
  EXPECT_EQ(this->Run({ "feel" }), 2);
  EXPECT_TRUE(this->Complains("--help")) << this->Errors;
  this->Falcon.SwitchOff();
  EXPECT_EQ(this->Run({ "home", "falcon", "--firmware", "nowhere.bin" }), 1);
  EXPECT_TRUE(this->Complains("nowhere.bin")) << this->Errors;
}

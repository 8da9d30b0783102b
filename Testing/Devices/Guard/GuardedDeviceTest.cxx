// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a device behind a guard from the view of its owner and the servo. The guard is a real
 * process with a simulated device (PlayedGuard.cxx). Emulated/FalconGuardTest.cxx tests that the
 * guard outlives a program.
 */

#include "Devices/Guard/GuardedDevice.h"
#include "Core/Platform/OwnFile.h"
#include "Devices/Guard/GuardProcess.h"
#include "Rigs/Eventually.h"
#include "Rigs/PlayedDevice.h"
#include "Rigs/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace VolumeHaptics;
using devicetest::Eventually;

namespace
{

/** The driver in this process. It counts the requests to send zero in the guard's place. */
class Rescuer : public HardwareDriver
{
public:
  explicit Rescuer(std::atomic<int>& count)
    : Count(count)
  {
  }
  std::string GetName() const override { return "not open"; }
  DeviceLimits GetLimits() const override
  {
    DeviceLimits limits;
    limits.MaximumForce = 3.0;
    return limits;
  }
  std::string GetIdentity() const override { return "played"; }
  bool KeepsIdentity() const override { return false; }
  bool Connect(std::string&) override { return false; }
  bool Reconnect(
    const std::string& identity, const std::function<bool()>& /*mustStop*/, std::string&) override
  {
    EXPECT_EQ(identity, "played:SN1") << "as the guard has told it";
    // The third attempt succeeds, as on a system that needs time to release the device.
    return ++this->Count >= 3;
  }
  void Serve(HardwareExchange&) override {}
  void Disconnect() noexcept override {}

private:
  std::atomic<int>& Count;
};

class Guarded : public testing::Test
{
protected:
  Guarded()
  {
    setenv("VOLUMEHAPTICS_GUARD", VOLUME_HAPTICS_PLAYED_GUARD, 1);
    this->Make("echo");
  }
  void Make(const std::string& way)
  {
    this->Device =
      GuardedDevice::Make(std::make_unique<Rescuer>(this->Rescues), { way }, this->Error);
  }
  bool IsAt(DeviceStage stage)
  {
    return Eventually([&] { return this->Device->GetCondition().Stage == stage; });
  }
  std::string GetText() { return this->Device->GetCondition().Text.data(); }
  pid_t GetGuard() const
  {
    const std::string name = this->Device->GetName();
    return std::atoi(name.substr(name.rfind(' ') + 1).c_str());
  }
  void OpenIt()
  {
    ASSERT_TRUE(this->Device->Open(this->Error)) << this->Error;
    ASSERT_TRUE(this->IsAt(DeviceStage::Ready)) << this->GetText();
    ASSERT_GT(this->GetGuard(), 1);
  }
  /** Writes a force until the device returns it as its position. */
  bool Feels(const Vector3& force)
  {
    return Eventually(
      [&]
      {
        this->Device->Read(0.001, this->Sample);
        this->Device->Write(force);
        return Norm(this->Sample.Tip - force) == 0.0;
      });
  }

  std::atomic<int> Rescues{ 0 };
  std::unique_ptr<GuardedDevice> Device;
  std::string Error;
  DeviceSample Sample;
};

} // namespace

TEST_F(Guarded, IsRememberedAndGivesTrueNewtons)
{
  this->OpenIt();
  EXPECT_EQ(this->Device->GetIdentity(), "played:SN1");
  EXPECT_FALSE(this->Device->KeepsIdentity()) << "as its driver says";
  EXPECT_TRUE(this->Feels({ 1.0, 0.0, 0.0 }));
  const auto gets = [this](const Vector3& force, const Vector3& asked)
  {
    return Eventually(
      [&]
      {
        this->Device->Read(0.001, this->Sample);
        this->Device->Write(force);
        return Norm(this->Sample.Tip - asked) < 1e-12;
      });
  };
  // With a scale of 2, the device exerts 2 N for each requested newton. Its own limit stays 3 N.
  this->Device->SetForceScale(2.0);
  EXPECT_EQ(this->Device->GetLimits().MaximumForce, 3.0);
  EXPECT_TRUE(gets({ 2.0, -1.0, 0.0 }, { 1.0, -0.5, 0.0 }));
  // With a scale of 0.5, the device exerts half of the requested force, and requests are limited to
  // 3 N.
  this->Device->SetForceScale(0.5);
  EXPECT_EQ(this->Device->GetLimits().MaximumForce, 1.5);
  EXPECT_TRUE(gets({ 1.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }));
  EXPECT_TRUE(gets({ 2.0, 0.0, 0.0 }, { 3.0, 0.0, 0.0 }));
}

TEST_F(Guarded, IsTheSameToTheServo)
{
  EXPECT_EQ(this->Device->GetName(), "not open");
  EXPECT_EQ(this->Device->GetLimits().MaximumForce, 3.0);
  for (int again = 0; again < 3; ++again)
  {
    this->OpenIt();
    EXPECT_NE(this->GetGuard(), getpid());
    EXPECT_TRUE(this->Feels({ 1.0, 2.0, 3.0 + again }));
    this->Device->SetLights(5);
    EXPECT_TRUE(Eventually(
      [&] {
        return this->Feels({ 1.0, 0.0, 0.0 }) && this->Sample.Buttons == 5;
      }));
    EXPECT_TRUE(this->Sample.HasOrientation);
    EXPECT_EQ(this->Sample.Orientation.W, 0.5);
    EXPECT_EQ(this->Sample.Orientation.Y, -0.5);
    EXPECT_EQ(this->Sample.Orientation.Z, 0.5);
    this->Device->Home();
    EXPECT_TRUE(Eventually([&] { return this->GetText() == "homed"; }));
    this->Device->Quench();
    EXPECT_TRUE(Eventually([&] { return this->Device->IsAtRest(); }));
    EXPECT_TRUE(Eventually(
      [&]
      {
        this->Device->Read(0.001, this->Sample);
        return Norm(this->Sample.Tip) == 0.0;
      }));
    this->Device->Close();
    this->Device->Close();
  }
  EXPECT_EQ(this->Rescues, 0);
}

TEST_F(Guarded, AForceThatIsNotRenewedFades)
{
  this->OpenIt();
  ASSERT_TRUE(this->Feels({ 1.0, 2.0, 3.0 }));
  EXPECT_TRUE(Eventually(
    [&]
    {
      this->Device->Read(0.001, this->Sample);
      return Norm(this->Sample.Tip) == 0.0;
    }));
}

TEST_F(Guarded, SaysWhyItCantBeOpened)
{
  this->Make("refuse");
  EXPECT_FALSE(this->Device->Open(this->Error));
  EXPECT_EQ(this->Error, "The played device is refused.");
  this->Make("throw");
  ASSERT_TRUE(this->Device->Open(this->Error));
  ASSERT_TRUE(this->IsAt(DeviceStage::Lost));
  EXPECT_NE(this->GetText().find("out of order"), std::string::npos) << this->GetText();
  // After the guard has ended, the text still contains the first reason.
  ASSERT_TRUE(Eventually([this] { return this->Rescues > 0 && this->Device->IsAtRest(); }));
  EXPECT_NE(this->GetText().find("out of order"), std::string::npos) << this->GetText();
}

TEST_F(Guarded, IsLostWithItsGuardAndGetsZeroFromHere)
{
  for (const int signal : { SIGKILL, SIGTERM, SIGSTOP })
  {
    this->Rescues = 0;
    this->OpenIt();
    ASSERT_TRUE(this->Feels({ 1.0, 0.0, 0.0 }));
    const pid_t guard = this->GetGuard();
    ASSERT_GT(guard, 1) << "0 and below would be many processes";
    kill(guard, signal);
    ASSERT_TRUE(this->IsAt(DeviceStage::Lost));
    EXPECT_NE(this->GetText().find("guard process"), std::string::npos) << this->GetText();
    EXPECT_EQ(this->Device->Read(0.001, this->Sample), DeviceState::Lost);
    EXPECT_EQ(this->Device->Write({ 1.0, 0.0, 0.0 }), DeviceState::Lost);
    EXPECT_TRUE(Eventually([&] { return this->Device->IsAtRest(); }));
    EXPECT_EQ(this->Rescues, 3) << "tried until it was possible";
    this->Device->Home();
    EXPECT_EQ(this->Device->GetCondition().Stage, DeviceStage::Lost);
  }
  this->OpenIt();
  EXPECT_TRUE(this->Feels({ 1.0, 0.0, 0.0 }));
}

TEST_F(Guarded, ItsSignsAreCheckedThroughTheGuard)
{
  for (const bool isCrossed : { false, true })
  {
    this->Make(isCrossed ? "crossed" : "held");
    this->OpenIt();
    {
      servotest::RunningLoop loop(*this->Device, 1000.0);
      loop->RequireConfirmation(2, 8.0); // axis y only
      loop->Arm();
      const auto state = [&]
      {
        loop->ReadState();
        return loop->GetState();
      };
      EXPECT_TRUE(Eventually([&] { return state().Gate == GateState::Confirming; }));
      EXPECT_TRUE(Eventually([&] { return state().Gate != GateState::Confirming; }));
      const SignResult result = state().Signs.Result;
      EXPECT_EQ(result, isCrossed ? SignResult::Wrong : SignResult::Confirmed);
      EXPECT_EQ(state().GetFault(), isCrossed ? GateReason::WrongSign : GateReason::None);
      EXPECT_TRUE(!isCrossed || state().Signs.Axis == 1);
    }
    this->Device->Close();
  }
}

TEST_F(Guarded, IsTheParentsAfterAFork)
{
  this->OpenIt();
  const pid_t child = fork();
  if (child == 0)
  {
    this->Device->Home();
    const bool isRefused =
      !this->Device->Open(this->Error) && this->Error.find("forked") != std::string::npos;
    this->Device.reset();
    _exit(isRefused ? 0 : 3);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(this->Feels({ 1.0, 0.0, 0.0 }));
  EXPECT_EQ(this->GetText(), "") << "the child did not ask the parent's device to home";
}

TEST_F(Guarded, OfAnotherVersionIsRefused)
{
  // Start the guard like an older library would; the descriptors in its arguments are not open.
  const int status = std::system(VOLUME_HAPTICS_PLAYED_GUARD " 0.0 3 4 1 0 echo");
  EXPECT_EQ(WEXITSTATUS(status), 1);
  EXPECT_EQ(WEXITSTATUS(std::system(VOLUME_HAPTICS_PLAYED_GUARD " 2> /dev/null")), 2);
}

/// Expects that the rule for plug-ins in OwnFile.h also applies to the guard: a program that
/// another user could have written would run with all permissions of this user, who may be root.
TEST(GuardProgram, OneThatAnotherUserCouldHaveWrittenIsPassedOver)
{
  namespace fs = std::filesystem;
  const fs::path top = fs::canonical(TemporaryPath(""));
  // The library is as many folders below the top as the search goes up.
  const fs::path library = top / "app" / "a" / "b" / "c" / "d" / "lib" / "library.so";
  const fs::path planted = top / "volumehaptics-guard";
  const fs::path own = top / "app" / "bin" / "volumehaptics-guard";
  fs::create_directories(library.parent_path());
  fs::create_directories(own.parent_path());
  for (const fs::path& file : { library, planted, own })
  {
    std::ofstream(file) << "#!/bin/sh\n";
    ASSERT_EQ(chmod(file.c_str(), 0700), 0);
  }
  const auto find = [&](std::string& obstacle)
  { return FindProgramNear(library.string(), "volumehaptics-guard", obstacle); };
  std::string obstacle;
  EXPECT_EQ(find(obstacle), own.string());
  EXPECT_EQ(obstacle, "");
  fs::remove(own);
  EXPECT_EQ(find(obstacle), planted.string());

  for (const fs::path& open : { planted, top })
  {
    ASSERT_EQ(chmod(open.c_str(), 0777), 0);
    obstacle.clear();
    EXPECT_EQ(find(obstacle), "");
    EXPECT_NE(obstacle.find("others may write \"" + open.string() + "\""), std::string::npos)
      << obstacle;
    ASSERT_EQ(chmod(open.c_str(), 0700), 0);
  }
  // The path contains a link in a folder that other users can write to.
  fs::rename(planted, top / "safe");
  fs::create_directory(top / "open");
  ASSERT_EQ(chmod((top / "open").c_str(), 0777), 0);
  fs::create_symlink(top / "safe", top / "open" / "link");
  fs::create_symlink(top / "open" / "link", planted);
  obstacle.clear();
  EXPECT_EQ(find(obstacle), "");
  EXPECT_NE(obstacle.find("others may write"), std::string::npos) << obstacle;
  fs::remove(planted);
  fs::rename(top / "safe", planted);
  if (geteuid() == 0)
  {
    ASSERT_EQ(chown(planted.c_str(), 65534, 65534), 0);
    obstacle.clear();
    EXPECT_EQ(find(obstacle), "");
    EXPECT_NE(obstacle.find("belongs to another user"), std::string::npos) << obstacle;
    ASSERT_EQ(chown(planted.c_str(), 0, 0), 0);
  }
  EXPECT_EQ(find(obstacle), planted.string());
}

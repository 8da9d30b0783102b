// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the guard process itself: it may end or fail to start, and is independent of the
 * application's signals, files and forks.
 */

#include "GuardProcesses.h"
#include "Rigs/FalconRig.h"

#include <csignal>
#include <cstdlib>

#include <sys/wait.h>
#include <unistd.h>

using namespace emulated;

namespace
{
class FalconGuardEnds : public FalconTest
{
protected:
  ~FalconGuardEnds() override { unsetenv("VOLUMEHAPTICS_GUARD"); }

  /**
   * Sends a signal to one process. Rejects a process id of 0 or below, which would address many
   * processes.
   */
  static void Signal(pid_t process, int number)
  {
    ASSERT_GT(process, 1);
    kill(process, number);
  }
  void BeginForce()
  {
    this->MakeReady();
    ASSERT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
    ASSERT_GT(FindGuard(), 1);
  }
  /** Kills or stops the guard by a signal that it can't handle. */
  void BreakOff(int signal)
  {
    const pid_t guard = FindGuard();
    Signal(guard, signal);
    EXPECT_TRUE(Eventually([=] { return FindGuard() != guard; }));
    this->Usb.ForgetProgram();
  }
  void ExpectLostUntilOpenedAgain()
  {
    this->ExpectLost("guard process");
    EXPECT_TRUE(Has(this->GetText(), "Open()")) << this->GetText();
    EXPECT_TRUE(Eventually([&] { return this->Device->IsAtRest(); }));
    EXPECT_EQ(FindGuard(), 0);
    this->Falcon.DrainLargestCommand();
    this->Device->Home();
    for (int i = 0; i < 100; ++i)
    {
      EXPECT_EQ(this->Device->Write({ 0.0, 0.0, 1.0 }), DeviceState::Lost);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    EXPECT_EQ(this->Falcon.DrainLargestCommand(), 0.0);
    EXPECT_FALSE(this->Usb.IsClaimed());
    ASSERT_TRUE(this->Device->Open(this->Error)) << this->Error;
    this->Home();
    EXPECT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
  }
  void ExpectRefusal(const char* program, const std::string& part)
  {
    setenv("VOLUMEHAPTICS_GUARD", program, 1);
    EXPECT_FALSE(this->Open());
    EXPECT_TRUE(Has(this->Error, part)) << this->Error;
    EXPECT_TRUE(Has(this->Error, "VOLUMEHAPTICS_GUARD")) << this->Error;
    EXPECT_TRUE(Has(this->Error, "\"off\"")) << this->Error;
  }
};
} // namespace

TEST_F(FalconGuardEnds, Killed)
{
  this->BeginForce();
  this->BreakOff(SIGKILL);
  this->ExpectLostUntilOpenedAgain();
}

TEST_F(FalconGuardEnds, KilledWhenAnotherDeviceHasItsNumber)
{
  FalconModel other;
  EmulatedUsb port(other, "1-7");
  ASSERT_TRUE(this->Open("falcon:1")) << this->Error;
  EXPECT_EQ(this->Device->GetIdentity(), "falcon:port:1-7");
  // Unplug the first device, and plug in two new devices, which are listed before the second
  // device.
  this->Usb.Unplug();
  FalconModel near;
  FalconModel far;
  const EmulatedUsb first(near, "1-3");
  const EmulatedUsb second(far, "1-4");
  const pid_t guard = FindGuard();
  Signal(guard, SIGKILL);
  EXPECT_TRUE(Eventually([=] { return FindGuard() != guard; }));
  EXPECT_EQ(this->Device->GetIdentity(), "falcon:port:1-7");
  // Let this process claim the device only now.
  const long packets = other.GetPackets();
  port.ForgetProgram();
  EXPECT_TRUE(Eventually([&] { return this->Device->IsAtRest(); }));
  EXPECT_GT(other.GetPackets(), packets) << "it got zero from here";
  EXPECT_EQ(near.GetPackets() + far.GetPackets(), 0);
}

TEST_F(FalconGuardEnds, Stopped)
{
  this->BeginForce();
  this->BreakOff(SIGSTOP);
  this->ExpectLostUntilOpenedAgain();
}

TEST_F(FalconGuardEnds, Terminated)
{
  this->BeginForce();
  Signal(FindGuard(), SIGTERM);
  this->ExpectLostUntilOpenedAgain();
}

TEST_F(FalconGuardEnds, WithTheDevice)
{
  this->BeginForce();
  const pid_t guard = FindGuard();
  this->Device->Close();
  EXPECT_EQ(this->Falcon.GetCommands(), Numbers{});
  EXPECT_FALSE(this->Usb.IsClaimed());
  EXPECT_FALSE(std::filesystem::exists("/proc/" + std::to_string(guard)));
}

TEST_F(FalconGuardEnds, BeforeItBegins)
{
  this->ExpectRefusal("/nowhere/at/all", "\"/nowhere/at/all\"");
  this->ExpectRefusal("/bin/false", "status 1");
  this->ExpectRefusal("/etc/hostname", "/etc/hostname");
  EXPECT_FALSE(this->Usb.IsClaimed());
  unsetenv("VOLUMEHAPTICS_GUARD");
  EXPECT_TRUE(this->Open()) << this->Error;
}

TEST_F(FalconGuardEnds, NeverWithoutOne)
{
  setenv("VOLUMEHAPTICS_GUARD", "off", 1);
  this->MakeReady();
  EXPECT_EQ(FindGuard(), 0);
  EXPECT_TRUE(this->Feels({ 0.0, 0.0, 2.0 })) << "by explicit wish only";
}

TEST_F(FalconGuardEnds, NeverIfTheApplicationWantsNone)
{
  this->Options.UseGuard = false;
  this->MakeReady();
  EXPECT_EQ(FindGuard(), 0);
  EXPECT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
}

TEST_F(FalconGuardEnds, NotByTheApplicationsSignalsAndFiles)
{
  int open[2];
  ASSERT_EQ(pipe(open), 0);
  this->BeginForce();
  const pid_t guard = FindGuard();
  EXPECT_NE(getpgid(guard), getpgid(0)) << "Ctrl+C and Ctrl+Z are not for it";
  for (const int number : { SIGINT, SIGHUP, SIGTSTP, SIGPIPE, SIGUSR1 })
  {
    Signal(guard, number);
  }
  EXPECT_TRUE(this->Feels({ 0.0, 1.0, 2.0 }));
  EXPECT_EQ(this->Device->GetCondition().Stage, DeviceStage::Ready) << this->GetText();
  close(open[1]);
  char byte = 0;
  EXPECT_EQ(read(open[0], &byte, 1), 0) << "the guard does not keep the pipe open";
  close(open[0]);
}

TEST_F(FalconGuardEnds, NotWithAForkedCopy)
{
  this->BeginForce();
  const pid_t child = fork();
  if (child == 0)
  {
    std::string error;
    this->Device->Home();
    this->Device->Quench();
    const bool isRefused = !this->Device->Open(error) && Has(error, "forked");
    this->Device.reset();
    _exit(isRefused ? 0 : 3);
  }
  int status = 0;
  EXPECT_TRUE(
    this->Push({ 0.0, 0.0, 2.0 }, [&] { return waitpid(child, &status, WNOHANG) == child; }));
  EXPECT_EQ(status, 0);
  EXPECT_EQ(this->Device->GetCondition().Stage, DeviceStage::Ready) << this->GetText();
  EXPECT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
}

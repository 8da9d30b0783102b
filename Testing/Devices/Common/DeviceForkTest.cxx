// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the copy of an open device in a forked child: it neither waits for the parent's thread nor
 * ends the parent's connection.
 */

#include "Devices/Common/HardwareDevice.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <sys/wait.h>
#include <unistd.h>

using namespace VolumeHaptics;

namespace
{

/** A driver that ends a child process with exit status 5 if the child uses the parent's driver. */
class ParentsDriver : public HardwareDriver
{
public:
  ~ParentsDriver() override { this->Use(); }
  std::string GetName() const override { return "of the parent"; }
  DeviceLimits GetLimits() const override { return {}; }
  bool Connect(std::string&) override
  {
    this->Use();
    return true;
  }
  void Serve(HardwareExchange& exchange) override
  {
    while (!exchange.MustStop())
    {
      exchange.Report({});
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  void Disconnect() noexcept override { this->Use(); }

private:
  void Use() const
  {
    if (getpid() != this->Parent)
    {
      _exit(5);
    }
  }
  const pid_t Parent = getpid();
};

/**
 * Waits for a child process. Returns its exit status, or minus the number of the signal that ended
 * it.
 */
int WaitFor(pid_t child)
{
  int status = 0;
  for (int i = 0; i < 3000 && waitpid(child, &status, WNOHANG) == 0; ++i)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    if (i == 2999)
    {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
    }
  }
  return WIFSIGNALED(status) ? -WTERMSIG(status) : WEXITSTATUS(status);
}

} // namespace

TEST(DeviceFork, TheChildLeavesTheParentsDeviceAlone)
{
  auto device = std::make_unique<HardwareDevice>(std::make_unique<ParentsDriver>());
  std::string error;
  ASSERT_TRUE(device->Open(error));
  const pid_t child = fork();
  if (child == 0)
  {
    const bool isRefused = !device->Open(error) && error.find("forked") != std::string::npos;
    device->Close();
    device.reset();
    _exit(isRefused ? 0 : 3);
  }
  EXPECT_EQ(WaitFor(child), 0);
  DeviceSample sample;
  EXPECT_NE(device->Read(1e-3, sample), DeviceState::Lost);
  device->Close();
  EXPECT_TRUE(device->Open(error)) << "the parent goes on";
}

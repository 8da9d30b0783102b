// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests gamepads that can't be used: no gamepad, no motors, no permission, in use. */

#include "DeviceBench.h"
#include "Emulators/EmulatedEvdev.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <linux/input.h>
#include <sys/fsuid.h>
#include <sys/ioctl.h>
#include <unistd.h>

using namespace emulated;

namespace
{
std::string MissingText()
{
  for (const DeviceObstacle& obstacle : ListMissingKinds())
  {
    if (obstacle.Kind == "vibration")
    {
      return obstacle.Text;
    }
  }
  return {};
}
} // namespace

TEST(PadFault, WithoutAnyItIsSaidWhatToDo)
{
  EXPECT_TRUE(Has(MissingText(), "no gamepad is plugged in")) << MissingText();
  EXPECT_TRUE(Has(MissingText(), "Plug one in, or pair it.")) << MissingText();
  EXPECT_TRUE(Has(ErrorOf("vibration:pad"), "No gamepad is plugged in. Plug one in, or pair it."));
  PadModel model(PadModel::Kind::Xbox);
  const EmulatedEvdev evdev(model);
  EXPECT_EQ(MissingText(), "");
  EXPECT_TRUE(Has(ErrorOf("vibration:pad:1"), "no gamepad with this number"));
  for (const char* const id : { "vibration", "vibration:", "vibration:rumble", "vibration:pad:x" })
  {
    EXPECT_TRUE(Has(ErrorOf(id), "give \"vibration:pad\" or \"vibration:pad:N\"")) << id;
  }
}

TEST(PadFault, APadWithoutRumbleIsListedAndRefused)
{
  PadModel older(PadModel::Kind::Older);
  const EmulatedEvdev evdev(older);
  const std::vector<DeviceListing> all = ListDevices();
  ASSERT_EQ(all.size(), 1U);
  EXPECT_TRUE(Has(all[0].State, "can't vibrate: its driver offers no rumble")) << all[0].State;
  EXPECT_TRUE(Has(ErrorOf("vibration:pad"), "can't vibrate: its driver offers no rumble"));
  EXPECT_EQ(MissingText(), "");
  // Plug in a second pad, which can vibrate. Expect that this pad is opened.
  PadModel model(PadModel::Kind::PlayStation);
  const EmulatedEvdev second(model);
  EXPECT_EQ(ListDevices()[1].State, "available");
  DeviceBench bench;
  ASSERT_TRUE(bench.Open("vibration:pad")) << bench.Error;
  EXPECT_TRUE(Has(bench.Device->GetName(), "DualSense"));
  EXPECT_TRUE(Has(ErrorOf("vibration:pad:0"), "can't vibrate"));
}

TEST(PadFault, WithoutPermissionTheCureIsSaid)
{
  PadModel model(PadModel::Kind::Xbox);
  EmulatedEvdev evdev(model);
  evdev.SetPermissions(0);
  // Root may open all devices, so change the file system user, for this thread only.
  const int owner = setfsuid(65534);
  const std::vector<DeviceListing> all = ListDevices();
  EXPECT_TRUE(!all.empty() && Has(all[0].State, "no permission. Log in at the computer itself"));
  EXPECT_TRUE(Has(ErrorOf("vibration:pad"), "sudo usermod -a -G input $USER"));
  setfsuid(static_cast<uid_t>(owner));
}

TEST(PadFault, AnotherProgramMayHoldIt)
{
  PadModel model(PadModel::Kind::Xbox);
  const EmulatedEvdev evdev(model);
  const int other = open(evdev.GetNode().c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(other, 0);
  ASSERT_EQ(ioctl(other, EVIOCGRAB, 1), 0);
  EXPECT_TRUE(Has(ListDevices()[0].State, "in use: another program, such as Steam"));
  EXPECT_TRUE(Has(ErrorOf("vibration:pad"), "in use: another program, such as Steam"));
  ASSERT_EQ(ioctl(other, EVIOCGRAB, 0), 0);
  close(other);
  EXPECT_EQ(ListDevices()[0].State, "available");
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs the command lines of the documentation pages of Haply's arms, hfab's controllers, vendors'
 * libraries and devices that vibrate through a service, with emulated devices and services.
 */

#include "Emulators/ForceDimension/FakeForceDimension.h"
#include "Emulators/HaplyService.h"
#include "Emulators/HfabEmulator.h"
#include "Emulators/OpenHaptics/FakeOpenHaptics.h"
#include "Emulators/VibrationServices.h"
#include "PageRig.h"
#include "Rigs/PluginFolder.h"

#include "vtkHapticDevice.h"
#include "vtkNew.h"

#include <chrono>
#include <string>
#include <thread>
#include <vector>

using namespace emulated;

namespace
{
using ServicePages = PageTest;
}

TEST_F(ServicePages, OfHaplyLeadToTheFirstForce)
{
  HaplyService service;
  EXPECT_EQ(this->Type("haply.md", "haply"), 4);
  double largest = 0.0;
  for (const HaplySession& session : service.GetSessions())
  {
    for (const Triple& force : session.Forces)
    {
      largest = std::max(largest, std::abs(force[0]) + std::abs(force[1]) + std::abs(force[2]));
    }
  }
  EXPECT_GT(largest, 0.0);
}

TEST_F(ServicePages, OfHfabLeadToTheFirstForce)
{
  HfabEmulator arm(3);
  arm.PlaceAtHome();
  // Boards are found by name, and the emulator's pseudo-terminal is not listed, so name the port.
  EXPECT_EQ(this->Type("woodenhaptics.md", "hfab", "hfab:" + arm.GetPort()), 5);
  EXPECT_GT(arm.GetMessages(), 0);
}

TEST_F(ServicePages, OfForceDimensionLeadToTheFirstForce)
{
  FakeForceDimension::Get().Reset();
  const devicetest::PluginFolder folder;
  folder.Add("forcedimension");
  EXPECT_EQ(this->Type("forcedimension.md", "vendor:forcedimension"), 5);
}

TEST_F(ServicePages, OfOpenHapticsLeadToTheFirstForce)
{
  FakeOpenHaptics::Get().Reset();
  const devicetest::PluginFolder folder;
  folder.Add("openhaptics");
  EXPECT_EQ(this->Type("openhaptics.md", "vendor:openhaptics"), 4);
}

TEST_F(ServicePages, OfVibrationLeadToTheFirstTouch)
{
  const PlayedBhaptics player({ "GloveR" });
  const PlayedWeart weart({ "RIGHT" });
  const PlayedHapbeat hapbeat;
  EXPECT_EQ(this->Run({ "list" }), 0);
  std::vector<std::string> ids = ReadDevices("vibration.md");
  ASSERT_EQ(ids.size(), 3U);
  for (std::string& id : ids)
  {
    const bool isInNetwork = id.rfind("vibration:hapbeat:", 0) == 0; // not listed, as its page says
    EXPECT_NE(this->Shows(id.c_str()), isInNetwork) << id << this->Out;
    id = isInNetwork ? "vibration:hapbeat:127.0.0.1:" + std::to_string(hapbeat.GetPort()) : id;
    vtkNew<vtkHapticDevice> device;
    ASSERT_TRUE(device->Open(id.c_str())) << id;
    EXPECT_TRUE(device->GetVirtualHand()->MayMouseLead()) << id;
    for (int i = 0; i < 2000 && device->GetStatus() != vtkHapticDevice::READY; ++i)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    EXPECT_NE(device->GetStatusText().find("vibration, not force"), std::string::npos)
      << device->GetStatusText();
  }
  EXPECT_TRUE(this->Shows("vibration:xr")) << "as the page of headsets says" << this->Out;
  vtkNew<vtkHapticDevice> device;
  EXPECT_FALSE(device->GetVirtualHand()->MayMouseLead()) << "closed";
  ASSERT_TRUE(device->Open("vibration:xr"));
  EXPECT_FALSE(device->GetVirtualHand()->MayMouseLead()) << "a headset leads it";
  ASSERT_TRUE(device->Open("virtual"));
  EXPECT_TRUE(device->GetVirtualHand()->MayMouseLead());
}

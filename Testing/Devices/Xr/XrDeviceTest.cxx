// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a headset's controller from the servo's view: the amplitude in a frame, against the closed
 * form of the filters in Vibration.h, and the controller's entry in the list of devices.
 */

#include "Devices/Xr/XrDevice.h"
#include "Devices/Kinds/DeviceRegistry.h"
#include "Devices/Xr/XrKind.h"
#include "Rigs/TemporaryFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

using namespace VolumeHaptics;

namespace
{
constexpr double TickOfXr = 1e-3; // s

/** Writes a force for some ticks. Returns the resulting amplitude. */
double AmplitudeAfter(XrDevice& device, int ticks, const Vector3& force)
{
  DeviceSample sample;
  for (int i = 0; i < ticks; ++i)
  {
    device.Read(TickOfXr, sample);
    device.Write(force);
  }
  return device.DrainAmplitude();
}

/** Returns the strong motor's level `time` (s) after a step of 1 N. */
double StrongOfStep(double time)
{
  return std::exp(-time / 0.15) - std::exp(-time / 0.02);
}

bool HasWords(const std::string& text, const char* words)
{
  return text.find(words) != std::string::npos;
}
} // namespace

TEST(XrDevice, AFrameGetsTheLargestAmplitudeOfItsTicks)
{
  XrDevice device;
  std::string error;
  ASSERT_TRUE(device.Open(error));
  const Vector3 force{ 0.6, 0.0, -0.8 };
  // Within 20 ms after a step of the force, the weak motor's level rises to 0.70 and falls again.
  EXPECT_NEAR(AmplitudeAfter(device, 20, force), 0.70, 0.03);
  EXPECT_EQ(device.DrainAmplitude(), 0.0) << "nothing came since";
  // From 40 to 50 ms after the step, the strong motor's level is larger than the weak motor's, and
  // near its maximum.
  AmplitudeAfter(device, 20, force);
  EXPECT_NEAR(AmplitudeAfter(device, 10, force), StrongOfStep(0.046), 0.005);
  for (int frame = 0; frame < 100; ++frame)
  {
    AmplitudeAfter(device, 11, force);
  }
  EXPECT_LT(AmplitudeAfter(device, 11, force), Vibration::Least) << "a force that stays";
  EXPECT_GT(AmplitudeAfter(device, 11, {}), 0.5) << "it ends";
}

TEST(XrDevice, AShortTouchBetweenTwoFramesIsNotLost)
{
  XrDevice device;
  AmplitudeAfter(device, 1, {});
  DeviceSample sample;
  for (int i = 0; i < 400; ++i)
  {
    device.Read(TickOfXr, sample);
    device.Write(i < 5 ? Vector3{ 0.0, 2.0, 0.0 } : Vector3{});
  }
  EXPECT_GT(device.DrainAmplitude(), 0.4);
  EXPECT_LT(AmplitudeAfter(device, 11, {}), 0.1) << "it is long over";
}

TEST(XrDevice, IsSilentWithoutAServo)
{
  XrDevice device;
  EXPECT_EQ(device.DrainAmplitude(), 0.0);
  EXPECT_GT(AmplitudeAfter(device, 5, { 1.0, 0.0, 0.0 }), 0.0);
  AmplitudeAfter(device, 5, {});
  DeviceSample sample;
  device.Read(TickOfXr, sample);
  device.Write({ 3.0, 0.0, 0.0 });
  device.Quench();
  EXPECT_EQ(device.DrainAmplitude(), 0.0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(AmplitudeAfter(device, 5, { nan, 0.0, 0.0 }), 0.0);
}

TEST(XrDevice, GivesNoForceAndIsLedByTheProgram)
{
  std::string error;
  const std::unique_ptr<DeviceBackend> made = MakeDevice("vibration:xr", {}, error);
  auto* const device = dynamic_cast<XrDevice*>(made.get());
  ASSERT_NE(device, nullptr) << error;
  const DeviceLimits limits = device->GetLimits();
  EXPECT_TRUE(limits.Vibrates);
  EXPECT_FALSE(limits.MovesTip);
  EXPECT_EQ(limits.MaximumForce, 8.0);
  EXPECT_TRUE(device->GetIdentity().empty()) << "nothing to confirm or to calibrate";
  device->Lead({ 0.1, 0.2, 0.3 });
  DeviceSample sample;
  EXPECT_EQ(device->Read(TickOfXr, sample), DeviceState::Running);
  EXPECT_EQ(Norm(sample.Tip - Vector3{ 0.1, 0.2, 0.3 }), 0.0);
  // Similar ids are not valid.
  for (const char* const id : { "vibration:x", "vibration:xr:0", "vibration:xrs" })
  {
    EXPECT_EQ(MakeDevice(id, {}, error), nullptr) << id;
  }
  MakeDevice("vibration:xr:0", {}, error);
  EXPECT_TRUE(HasWords(error, "is not a device id: give \"vibration:xr\""));
}

TEST(XrDevice, TheListSaysWhatIsMissing)
{
  EXPECT_TRUE(HasWords(WhyNoXr(false, "/a.json"), "VTK_MODULE_ENABLE_VTK_RenderingOpenXR=YES"));
  EXPECT_TRUE(HasWords(WhyNoXr(false, ""), "-DVolumeHaptics_USE_OPENXR=ON"));
  EXPECT_EQ(WhyNoXr(true, "/a.json"), "");
#if defined(__linux__)
  EXPECT_TRUE(HasWords(WhyNoXr(true, ""), "no OpenXR runtime is active"));
#endif
  // The kind is either in the list of devices or in the list of missing kinds.
  const std::vector<DeviceListing> listed = ListDevices();
  const std::vector<DeviceObstacle> missing = ListMissingKinds();
  const auto count = std::count_if(listed.begin(), listed.end(),
                       [](const DeviceListing& device) { return device.Id == "vibration:xr"; }) +
    std::count_if(missing.begin(), missing.end(),
      [](const DeviceObstacle& obstacle) { return obstacle.Kind == "vibration:xr"; });
  EXPECT_EQ(count, 1);
}

TEST(XrDevice, FindsTheRuntimeAsTheLoaderOfOpenXRDoes)
{
  // Expect the order in the section "Linux Active Runtime Location" of the loader's specification.
  const std::string folder = TemporaryPath("xr");
  const std::string own = folder + "/own/openxr/1/active_runtime.json";
  const std::string other = folder + "/second/openxr/1/active_runtime.json";
  const std::string named = folder + "/named.json";
  for (const std::string& file : { own, other, named })
  {
    std::filesystem::create_directories(std::filesystem::path(file).parent_path());
    std::ofstream(file) << "{}";
  }
  setenv("XDG_CONFIG_HOME", (folder + "/own").c_str(), 1);
  setenv("XDG_CONFIG_DIRS", (folder + "/first:" + folder + "/second").c_str(), 1);
  setenv("XR_RUNTIME_JSON", named.c_str(), 1);
  EXPECT_EQ(FindXrRuntime(), named);
  setenv("XR_RUNTIME_JSON", (folder + "/none.json").c_str(), 1);
  EXPECT_EQ(FindXrRuntime(), "") << "what is named counts alone";
  unsetenv("XR_RUNTIME_JSON");
  EXPECT_EQ(FindXrRuntime(), own);
  std::filesystem::remove(own);
  EXPECT_EQ(FindXrRuntime(), other);
  unsetenv("XDG_CONFIG_HOME");
  setenv("HOME", folder.c_str(), 1);
  const std::string home = folder + "/.config/openxr/1/active_runtime.json";
  std::filesystem::create_directories(std::filesystem::path(home).parent_path());
  std::ofstream(home) << "{}";
  EXPECT_EQ(FindXrRuntime(), home);
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests kinds of devices: the list of kinds, the parsing of ids, and the errors if a device can't
 * be opened.
 */

#include "Devices/Kinds/DeviceRegistry.h"
#include "Devices/Common/DeviceTexts.h"
#include "Devices/SpaceMouse/SpaceMouse.h"
#include "Devices/Virtual/VirtualDevice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <utility>
#include <vector>

using namespace VolumeHaptics;

namespace
{
DeviceKind MakeKind(const std::string& name)
{
  return { name,
    [name] {
      return std::vector<DeviceListing>{ { name + ":7", "A device of a vendor", "available" } };
    },
    [](const std::string&, const DeviceOptions&, std::string&)
    { return std::make_unique<VirtualDevice>(); } };
}

bool Contains(const std::string& text, const char* words)
{
  return text.find(words) != std::string::npos;
}
} // namespace

TEST(DeviceRegistry, AnAddedKindIsListedAndMade)
{
  std::string error;
  ASSERT_TRUE(AddDeviceKind(MakeKind("added"), error)) << error;
  const std::vector<DeviceListing> all = ListDevices();
  const auto isIt = [](const DeviceListing& device) { return device.Id == "added:7"; };
  EXPECT_EQ(std::count_if(all.begin(), all.end(), isIt), 1);
  EXPECT_NE(MakeDevice("added:7", {}, error), nullptr);
  EXPECT_FALSE(AddDeviceKind(MakeKind("added"), error));
  EXPECT_TRUE(Contains(error, "Choose another name")) << error;
  EXPECT_TRUE(AddDeviceKind(MakeKind("renamed"), error)) << error;
  EXPECT_FALSE(AddDeviceKind(MakeKind("no 2"), error));
  EXPECT_TRUE(Contains(error, "Use letters only")) << error;
}

TEST(DeviceRegistry, AKindSaysWhatIsMissingForIt)
{
  std::string text = "its service does not run. Start it.";
  DeviceKind kind = MakeKind("served");
  kind.Missing = [&text] { return text; };
  std::string error;
  ASSERT_TRUE(AddDeviceKind(kind, error)) << error;
  const auto isIt = [](const DeviceObstacle& obstacle)
  { return obstacle.Kind == "served" && obstacle.Text == "its service does not run. Start it."; };
  const std::vector<DeviceObstacle> before = ListMissingKinds();
  EXPECT_EQ(std::count_if(before.begin(), before.end(), isIt), 1);
  text.clear();
  const std::vector<DeviceObstacle> after = ListMissingKinds();
  EXPECT_EQ(std::count_if(after.begin(), after.end(),
              [](const DeviceObstacle& obstacle) { return obstacle.Kind == "served"; }),
    0);
}

TEST(DeviceRegistry, RefusesWhatCannotBeAKind)
{
  for (const char* name :
    { "", "virtual", "replay", "falcon", "wooden", "pid", "spacemouse", "vendor", "a:b", "x y" })
  {
    std::string error;
    EXPECT_FALSE(AddDeviceKind(MakeKind(name), error)) << name;
    EXPECT_FALSE(error.empty());
  }
  std::string error;
  DeviceKind kind = MakeKind("listless");
  kind.List = nullptr;
  EXPECT_FALSE(AddDeviceKind(kind, error));
  EXPECT_TRUE(Contains(error, "needs a List and a Make")) << error;
}

TEST(DeviceRegistry, AnUnknownIdNamesTheKinds)
{
  for (const char* id : { "", "phantom", "falconer", ":", "Falcon" })
  {
    std::string error;
    EXPECT_EQ(MakeDevice(id, {}, error), nullptr);
    EXPECT_TRUE(Contains(error, "\"falcon\", \"wooden\", \"pid\", \"spacemouse\"")) << error;
  }
}

TEST(DeviceRegistry, NumbersCountFromZero)
{
  std::string error;
  EXPECT_EQ(ReadDeviceNumber("falcon", "falcon", error), 0);
  EXPECT_EQ(ReadDeviceNumber("falcon:0", "falcon", error), 0);
  EXPECT_EQ(ReadDeviceNumber("falcon:12", "falcon", error), 12);
  EXPECT_TRUE(error.empty());
  for (const char* id :
    { "falcon:", "falcon:-1", "falcon:1a", "falcon:1000", "falcon1", "falcons:1", "" })
  {
    error.clear();
    EXPECT_LT(ReadDeviceNumber(id, "falcon", error), 0) << id;
    EXPECT_TRUE(Contains(error, "counting from 0")) << error;
  }
}

TEST(DeviceRegistry, ThePermissionCureIsTheRuleToTheLetter)
{
  EXPECT_TRUE(Contains(PermissionCure("usb", 0x0403, 0xcb48),
    R"(SUBSYSTEM=="usb", ATTR{idVendor}=="0403", ATTR{idProduct}=="cb48", TAG+="uaccess")"));
  EXPECT_TRUE(Contains(PermissionCure("hidraw", 0x046d, 0xc626),
    R"(SUBSYSTEM=="hidraw", ATTRS{idVendor}=="046d", ATTRS{idProduct}=="c626", TAG+="uaccess")"));
}

TEST(DeviceRegistry, TheInstalledRulesHaveTheLineOfEveryDevice)
{
  std::ifstream file(VOLUME_HAPTICS_UDEV_RULES);
  const std::string rules{ std::istreambuf_iterator<char>(file), {} };
  const auto has = [&rules](
                     const char* subsystem, int vendor, int product, bool isBluetooth = false)
  {
    const std::string cure = PermissionCure(subsystem, static_cast<std::uint16_t>(vendor),
      static_cast<std::uint16_t>(product), isBluetooth);
    const std::size_t begin = cure.find("SUBSYSTEM");
    const std::size_t end = cure.find(" - then", begin);
    return rules.find("\n" + cure.substr(begin, end - begin) + "\n") != std::string::npos;
  };
  EXPECT_TRUE(has("usb", 0x0403, 0xcb48));
  EXPECT_TRUE(Contains(rules, "\nSUBSYSTEM==\"usb\", ATTR{idVendor}==\"1451\", TAG+=\"uaccess\"\n"))
    << "Force Dimension's devices";
  // The rule must also check the name of boards that share their numbers with other devices.
  EXPECT_TRUE(Contains(
    rules, R"(ATTRS{idProduct}=="0006", ATTRS{product}=="HID DEVICE|*[Ww]ooden[Hh]aptics*",)"));
  EXPECT_TRUE(Contains(rules,
    R"(ATTRS{idProduct}=="0486", ATTRS{product}=="Teensyduino RawHID|*[Ww]ooden[Hh]aptics*",)"));
  EXPECT_FALSE(has("hidraw", 0x1234, 0x0006));
  EXPECT_FALSE(has("hidraw", 0x16c0, 0x0486));
  for (const char* const board : { "\"2341\"", "\"2a03\"", "\"1b4f\"" })
  {
    EXPECT_FALSE(Contains(rules, board)) << "Arduino's and SparkFun's";
  }
  std::istringstream lines(rules);
  for (std::string line; std::getline(lines, line);)
  {
    EXPECT_FALSE(Contains(line, "SUBSYSTEM==\"tty\"") && Contains(line, "uaccess")) << line;
  }
  EXPECT_TRUE(has("hidraw", 0x054c, 0x0ce6));
  EXPECT_TRUE(has("hidraw", 0x054c, 0x0df2));
  EXPECT_TRUE(has("hidraw", 0x054c, 0x0ce6, true));
  EXPECT_TRUE(has("hidraw", 0x054c, 0x0df2, true));
  // Numbers of SpaceMouse Pro Wireless and SpaceMouse Wireless over Bluetooth.
  EXPECT_TRUE(has("hidraw", 0x256f, 0xc638, true));
  EXPECT_TRUE(has("hidraw", 0x256f, 0xc63a, true));
  EXPECT_TRUE(SpaceMouse::IsKnown(0x256f, 0xc641))
    << "SpaceMouse USB: PySpaceMouse 95cf9cb, devices.toml";
  // Numbers from makers' or users' rules: VPforce (TelemFFB), Simucube, AccuForce, MMOS.
  const std::pair<int, std::vector<int>> others[] = { { 0xffff, { 0x2055 } },
    { 0x16d0, { 0x0d5a, 0x0d5f, 0x0d60, 0x0d61 } }, { 0x1fc9, { 0x804c } },
    { 0xf055, { 0x0ffb } } };
  for (const auto& [vendor, products] : others)
  {
    for (const int product : products)
    {
      EXPECT_TRUE(has("hidraw", vendor, product)) << std::hex << vendor << ":" << product;
    }
  }
  // Numbers from JacKeTUs/universal-pidff, hid-ids.h, commit 9b7760c; the first one belongs to a
  // board.
  const std::pair<int, std::vector<int>> wheels[] = { { 0x1209, { 0xffb0 } },
    { 0x2433, { 0xf300, 0xf301, 0xf303, 0xf306 } },
    { 0x346e, { 0x0005, 0x0015, 0x0004, 0x0014, 0x0002, 0x0012, 0x0006, 0x0016, 0x0000, 0x0010 } },
    { 0x3416, { 0x0301, 0x0302 } }, { 0x0483, { 0xa355 } }, { 0x045b, { 0x58f9, 0x5968, 0x59d7 } },
    { 0x11ff, { 0x3245, 0x1212, 0x1112, 0x1211, 0x2141 } } };
  for (const auto& [vendor, products] : wheels)
  {
    for (const int product : products)
    {
      EXPECT_TRUE(has("hidraw", vendor, product)) << std::hex << vendor << ":" << product;
    }
  }
  int mice = 0;
  for (const int vendor : { 0x046d, 0x256f })
  {
    for (int product = 0; product <= 0xffff; ++product)
    {
      const bool isKnown = SpaceMouse::IsKnown(
        static_cast<std::uint16_t>(vendor), static_cast<std::uint16_t>(product));
      mice += isKnown ? 1 : 0;
      EXPECT_TRUE(!isKnown || has("hidraw", vendor, product)) << std::hex << product;
    }
  }
  EXPECT_GT(mice, 10);
}

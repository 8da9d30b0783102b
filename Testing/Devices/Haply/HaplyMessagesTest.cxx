// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Reads messages of Haply's Inverse service: the examples in its public documentation, complete,
 * shortened and damaged (docs.haply.co/inverseSDK: service/api/simulation of 3.1,
 * service/realtime/websocket-protocol, service/commons/types, service/events, service/api/http,
 * 3.0.2/service).
 */

#include "Devices/Haply/HaplyMessages.h"
#include "Devices/Haply/HaplyService.h"
#include "Devices/Transport/Local/LocalListener.h"

#include <gtest/gtest.h>

#include <sstream>

using namespace VolumeHaptics;

namespace
{
/// First message of a service of version 3.1, with the numbers of Haply's documentation.
constexpr const char* Inventory = R"({
  "inverse3": [ {
    "device_id": "04BA",
    "config": { "type": "inverse3", "device_info": { "minor_version": 1, "id": "04BA" },
      "port": "COM13", "gravity_compensation": { "enabled": true, "scaling_factor": 1 },
      "handedness": "right", "torque_scaling": { "enabled": true } },
    "state": {
      "angular_position": { "a0": -69.31704, "a1": 137.62952, "a2": 19.832787 },
      "body_orientation": { "x": -0.01940918, "y": 0.7026367, "z": 0.00048828125, "w": 0.7113037 },
      "cursor_position": { "x": 0.07842738, "y": -0.14836666, "z": 0.14297646 },
      "cursor_velocity": { "x": -0.011969013, "y": 0.0012009288, "z": -0.043197 },
      "mode": "idle" },
    "status": { "calibrated": false, "in_use": false, "power_supply": true, "ready": true,
      "started": true } } ],
  "verse_grip": [ { "device_id": "61548", "config": { "port": "COM3", "type": "verse_grip" },
    "state": { "button": true, "hall": 0, "orientation":
      { "x": -0.5019531, "y": 0.8632202, "z": -0.048095703, "w": -0.022338867 } } } ] })";

HaplyMessage Read(const std::string& text)
{
  HaplyMessage message;
  const char* const fault = ReadHaplyMessage(text, message);
  EXPECT_EQ(fault, nullptr) << fault;
  return message;
}

HaplyArm ReadState(const std::string& state)
{
  const HaplyMessage message = Read(R"({"inverse3":[{"device_id":"049D","state":)" + state + "}]}");
  EXPECT_EQ(message.Arms.size(), 1U);
  return message.Arms.at(0);
}

HaplyTransform ReadTransform(const std::string& transform)
{
  const HaplyArm arm = ReadState(R"({"transform":)" + transform + "}");
  EXPECT_TRUE(arm.Transform) << transform;
  return arm.Transform.value_or(HaplyTransform{});
}

void ExpectRefused(const std::string& text)
{
  HaplyMessage message;
  EXPECT_NE(ReadHaplyMessage(text, message), nullptr) << text;
}
} // namespace

TEST(HaplyMessages, AnInventoryTellsTheDevices)
{
  const HaplyMessage message = Read(Inventory);
  ASSERT_EQ(message.Arms.size(), 1U);
  const HaplyArm& arm = message.Arms[0];
  EXPECT_EQ(arm.Id, "04BA");
  EXPECT_EQ(arm.Type, "inverse3");
  EXPECT_EQ(arm.Handedness, "right");
  ASSERT_TRUE(arm.Position && arm.Velocity && arm.Orientation);
  EXPECT_EQ(arm.Position->X, 0.07842738);
  EXPECT_EQ(arm.Position->Y, -0.14836666);
  EXPECT_EQ(arm.Position->Z, 0.14297646);
  EXPECT_EQ(arm.Velocity->Z, -0.043197);
  EXPECT_EQ(arm.Orientation->W, 0.7113037);
  EXPECT_EQ(arm.Orientation->Y, 0.7026367);
  EXPECT_FALSE(arm.Force);
  EXPECT_FALSE(arm.Transform);
  EXPECT_EQ(arm.IsCalibrated, false);
  EXPECT_EQ(arm.IsReady, true);
  EXPECT_EQ(arm.IsInUse, false);
  ASSERT_EQ(message.Grips.size(), 1U);
  EXPECT_EQ(message.Grips[0].Id, "61548");
  EXPECT_EQ(message.Grips[0].Buttons, 1U);
  ASSERT_TRUE(message.Grips[0].Orientation);
  EXPECT_EQ(message.Grips[0].Orientation->X, -0.5019531);
}

TEST(HaplyMessages, WhatIsLeftOutHasItsDefault)
{
  const HaplyArm arm = ReadState(
    R"({"body_orientation":{"x":0.6,"w":0.8},"current_cursor_force":{},"cursor_position":{"z":0.1}})");
  ASSERT_TRUE(arm.Position && arm.Force && arm.Orientation);
  EXPECT_EQ(arm.Position->X, 0.0);
  EXPECT_EQ(arm.Position->Z, 0.1);
  EXPECT_EQ(Norm(*arm.Force), 0.0);
  EXPECT_EQ(arm.Orientation->W, 0.8);
  EXPECT_EQ(arm.Orientation->Y, 0.0);
  EXPECT_FALSE(arm.Velocity) << "not told at all";
  EXPECT_FALSE(arm.IsCalibrated);
  EXPECT_EQ(ReadState(R"({"body_orientation":{}})").Orientation->W, 1.0);
  EXPECT_FALSE(ReadState("{}").Position);
  EXPECT_TRUE(Read("{}").Arms.empty());
}

TEST(HaplyMessages, GripsHaveButtonsAndMaySleep)
{
  const HaplyMessage message = Read(
    R"({"wireless_verse_grip":[
      {"device_id":"a","state":{"buttons":{"c":true,"a":true,"b":false},"orientation":{"y":-1,"w":0}},
       "status":{"awake":true}},
      {"device_id":"b","state":{"buttons":{"home":true,"b":true}},"status":{"awake":false}}]})");
  ASSERT_EQ(message.Grips.size(), 2U);
  EXPECT_EQ(message.Grips[0].Buttons, 5U);
  EXPECT_EQ(message.Grips[0].Orientation->Y, -1.0);
  EXPECT_TRUE(message.Grips[0].IsAwake);
  EXPECT_EQ(message.Grips[1].Buttons, 10U);
  EXPECT_FALSE(message.Grips[1].IsAwake);
  EXPECT_FALSE(message.Grips[1].Orientation);
}

TEST(HaplyMessages, MapsAndEnvelopesHoldTheSame)
{
  const std::string device =
    R"({"state":{"cursor_position":{"x":0.5}},"config":{"handedness":"left"}})";
  for (const std::string& text : { R"({"inverse3":{"049D":)" + device + "}}",
         R"({"ok":true,"data":{"inverse3":{"049D":)" + device + "}}}" })
  {
    const HaplyMessage message = Read(text);
    ASSERT_EQ(message.Arms.size(), 1U);
    EXPECT_EQ(message.Arms[0].Id, "049D");
    EXPECT_EQ(message.Arms[0].Family, "inverse3");
    EXPECT_EQ(message.Arms[0].Type, "inverse3") << "by its family";
    EXPECT_EQ(message.Arms[0].Handedness, "left");
    EXPECT_EQ(message.Arms[0].Position->X, 0.5);
  }
}

TEST(HaplyMessages, ATransformIsReadWithItsDefaults)
{
  const HaplyTransform none;
  for (const char* const same :
    { "{}", R"({"position":{},"rotation":{"w":1.0},"scale":{"x":1,"y":1}})",
      R"({"rotation":{"w":-1.0}})", R"({"position":{"x":1e-6}})" })
  {
    EXPECT_TRUE(ReadTransform(same).IsNear(none)) << same;
    EXPECT_FALSE(ReadTransform(same).IsScaled()) << same;
  }
  for (const char* const other : { R"({"position":{"y":0.01}})",
         R"({"rotation":{"w":0.99,"z":0.14}})", R"({"scale":{"z":2.0}})" })
  {
    EXPECT_FALSE(ReadTransform(other).IsNear(none)) << other;
    EXPECT_TRUE(ReadTransform(other).IsNear(ReadTransform(other))) << other;
  }
  EXPECT_FALSE(ReadTransform(R"({"position":{"y":0.01}})").IsScaled());
  EXPECT_TRUE(ReadTransform(R"({"scale":{"z":2.0}})").IsScaled());
  EXPECT_TRUE(ReadTransform(R"({"scale":{"x":-1.0}})").IsScaled());
}

TEST(HaplyMessages, JunkIsRefused)
{
  const std::string whole = Inventory;
  for (std::size_t size = 0; size < whole.size(); size += 7)
  {
    ExpectRefused(whole.substr(0, size));
  }
  for (const char* const text : { "null", "7", "[]", "\"inverse3\"", R"({"inverse3":7})",
         R"({"inverse3":[7]})", R"({"inverse3":[[]]})", R"({"verse_grip":"none"})",
         "{\"inverse3\":[{\"x\":1e999}]}", "\xff" })
  {
    ExpectRefused(text);
  }
  for (const char* const nameless : { "{}", R"({"device_id":7})", R"({"device_id":""})" })
  {
    ExpectRefused(std::string(R"({"inverse3":[)") + nameless + "]}");
  }
  ExpectRefused(std::string(100000, '['));
  std::string many = "{\"verse_grip\":[{}";
  for (int i = 0; i < 100; ++i)
  {
    many += ",{}";
  }
  ExpectRefused(many + "]}");
}

TEST(HaplyMessages, DeepJsonIsRefused)
{
  HaplyMessage message;
  HaplyEvent event;
  HaplyVersion version;
  std::string objects;
  for (int i = 0; i < 100000; ++i)
  {
    objects += "{\"a\":";
  }
  objects += "0" + std::string(100000, '}');
  for (const std::string& deep :
    { std::string(100000, '[') + std::string(100000, ']'), std::string(100000, '['), objects })
  {
    ExpectRefused(R"({"inverse3":[{"device_id":"049D","state":)" + deep + "}]}");
    EXPECT_NE(ReadHaplyEvent(R"({"data":)" + deep + "}", event), nullptr);
    EXPECT_NE(ReadHaplyVersion(R"({"git_tag":"3.5.0","data":)" + deep + "}", version), nullptr);
  }
  // Later services may add members, even nested lists. Brackets inside strings don't count.
  const std::string texts = R"("\"[[\\":")" + std::string(100, '[') + "\"";
  EXPECT_EQ(ReadHaplyMessage(R"({"a":[[[[[[[[[[]]]]]]]]]],)" + texts + "}", message), nullptr);
}

TEST(HaplyMessages, ACoordinateThatIsNoNumberIsNotZero)
{
  // nlohmann's library writes NaN as null.
  for (const char* const junk : { "null", "\"fast\"", "true", "{}", "[1]" })
  {
    const std::string vector = std::string(R"({"x":0.1,"y":)") + junk + ",\"z\":0.2}";
    const HaplyArm arm = ReadState(R"({"cursor_position":)" + vector + R"(,"cursor_velocity":)" +
      vector + R"(,"body_orientation":)" + vector + "}");
    EXPECT_FALSE(arm.Position) << junk;
    EXPECT_FALSE(arm.Velocity) << junk;
    EXPECT_FALSE(arm.Orientation) << junk;
    EXPECT_TRUE(arm.IsSpoilt) << junk;
    for (const char* const part : { "position", "rotation", "scale" })
    {
      const HaplyArm moved =
        ReadState(std::string(R"({"transform":{")") + part + "\":" + vector + "}}");
      EXPECT_FALSE(moved.Transform) << part << " " << junk;
      EXPECT_TRUE(moved.IsSpoilt) << part << " " << junk;
    }
  }
  EXPECT_TRUE(ReadState(R"({"cursor_position":"far"})").IsSpoilt);
  EXPECT_TRUE(ReadState(R"({"transform":{"scale":2.0}})").IsSpoilt);
  EXPECT_FALSE(ReadState(R"({"cursor_velocity":{"x":null}})").IsSpoilt) << "not used";
  EXPECT_FALSE(ReadState(R"({"cursor_position":{},"transform":{}})").IsSpoilt);
}

TEST(HaplyMessages, EventsHaveALevelAndADevice)
{
  HaplyEvent event;
  ASSERT_EQ(ReadHaplyEvent(
              R"({"name":"device-safety-triggered","category":"device","level":"error",
    "data":{"device_family":"inverse","device_id":"049D","safety_type":"ebrake_triggered"},
    "message":"Emergency brake engaged"})",
              event),
    nullptr);
  EXPECT_EQ(event.Name, "device-safety-triggered");
  EXPECT_EQ(event.Level, HaplyLevel::Error);
  EXPECT_EQ(event.Device, "049D");
  EXPECT_EQ(event.Safety, "ebrake_triggered");
  EXPECT_EQ(event.Text, "Emergency brake engaged");
  ASSERT_EQ(ReadHaplyEvent(R"({"name":"device-connected","level":"whatever"})", event), nullptr);
  EXPECT_EQ(event.Level, HaplyLevel::Info);
  EXPECT_TRUE(event.Device.empty());
  EXPECT_NE(ReadHaplyEvent("[]", event), nullptr);
}

TEST(HaplyMessages, VersionsAreRead)
{
  HaplyVersion version;
  ASSERT_EQ(
    ReadHaplyVersion(R"({"git_tag":"3.0.0","project_name":"haply-inverse-service"})", version),
    nullptr);
  EXPECT_EQ(version.Major, 3);
  EXPECT_EQ(version.Minor, 0);
  EXPECT_FALSE(version.IsNew());
  ASSERT_EQ(
    ReadHaplyVersion(R"({"ok":true,"data":{"project_version":"3.5.0.0"}})", version), nullptr);
  EXPECT_TRUE(version.IsNew());
  EXPECT_TRUE(version.IsKnown());
  ASSERT_EQ(ReadHaplyVersion(R"({"git_describe":"4.0.1-2-gce34c39e"})", version), nullptr);
  EXPECT_FALSE(version.IsKnown());
  EXPECT_NE(ReadHaplyVersion("<html>", version), nullptr);
  EXPECT_NE(ReadHaplyVersion(R"({"git_tag":"main"})", version), nullptr);
}

TEST(HaplyMessages, ForcesAreWrittenAsEachVersionTakesThem)
{
  EXPECT_EQ(WriteHaplyForce({ { 3, 5 }, "inverse3", "049D" }, { 0.5, -1.0, 1.5 }),
    R"({"inverse3":[{"commands":{"set_cursor_force":{"vector":{"x":0.5,"y":-1.0,"z":1.5}}},"device_id":"049D"}]})");
  EXPECT_EQ(WriteHaplyForce({ { 3, 4 }, "minverse", "04BA" }, {}),
    R"({"minverse":[{"commands":{"set_cursor_force":{"values":{"x":0.0,"y":0.0,"z":0.0}}},"device_id":"04BA"}]})");
  const std::string greeting = WriteHaplyGreeting({ { 3, 5 }, "inverse3", "049D" });
  EXPECT_NE(greeting.find(R"("profile":{"name":"org.vtk.volumehaptics:touch"})"), std::string::npos)
    << greeting;
  EXPECT_NE(
    greeting.find(R"("session":{"configure":{"basis":{"permutation":"XYZ"},)"), std::string::npos)
    << greeting;
  EXPECT_NE(
    greeting.find(R"("configure":{"preset":{"preset":"arm_front_centered"}})"), std::string::npos)
    << greeting;
  EXPECT_NE(greeting.find(R"("vector":{"x":0.0,"y":0.0,"z":0.0})"), std::string::npos);
  const HaplyAddress old{ { 3, 1 }, "inverse3", "049D" };
  EXPECT_EQ(WriteHaplyGreeting(old), WriteHaplyForce(old, {}));
}

TEST(HaplyMessages, AxesTurnAndDoNotMirror)
{
  // Haply's axes point right, forward and up. The device's axes point right, up and towards the
  // hand.
  const Vector3 right = ToDevice(Vector3{ 1.0, 0.0, 0.0 });
  const Vector3 forward = ToDevice(Vector3{ 0.0, 1.0, 0.0 });
  const Vector3 up = ToDevice(Vector3{ 0.0, 0.0, 1.0 });
  EXPECT_EQ(right.X, 1.0);
  EXPECT_EQ(forward.Z, -1.0);
  EXPECT_EQ(up.Y, 1.0);
  EXPECT_EQ(Dot(Cross(right, forward), up), 1.0);
  const Vector3 back = FromDevice(ToDevice(Vector3{ 1.0, 2.0, 3.0 }));
  EXPECT_EQ(back.X, 1.0);
  EXPECT_EQ(back.Y, 2.0);
  EXPECT_EQ(back.Z, 3.0);
  // Rotating the grip to the left about the vertical rotates the stylus about the device's y.
  const Quaternion turn = ToDevice(Quaternion{ 0.6, 0.0, 0.0, 0.8 });
  EXPECT_EQ(turn.W, 0.6);
  EXPECT_EQ(turn.Y, 0.8);
  EXPECT_EQ(turn.X, 0.0);
  EXPECT_EQ(turn.Z, 0.0);
}

TEST(HaplyPorts, AnotherUsersListenerIsFound)
{
  // The lines are like those in the kernel's documentation of proc_net_tcp. Port 10001 is 2711 in
  // hexadecimal digits; state 0A is a listener, and 01 a connection.
  const std::string head = "  sl  local_address rem_address   st tx_queue rx_queue tr tm->when "
                           "retrnsmt   uid  timeout inode\n";
  const auto find = [&head](const char* local, const char* state, int user)
  {
    std::istringstream table(head +
      "   0: 00000000:0016 00000000:0000 0A 00000000:00000000 "
      "00:00000000 00000000  4321        0 1 1 0 100 0 0 10 0\n   1: " +
      local + " 00000000:0000 " + state + " 00000000:00000000 00:00000000 00000000  " +
      std::to_string(user) + "        0 54165785 4 cd1e6040 25 4 27 3 -1\n");
    return FindOtherListener(table, 10001, 1000);
  };
  EXPECT_EQ(find("0100007F:2711", "0A", 1001), 1001U);
  EXPECT_EQ(find("00000000000000000000000001000000:2711", "0A", 1001), 1001U);
  EXPECT_EQ(find("0100007F:2711", "0A", 1000), std::nullopt) << "this user";
  EXPECT_EQ(find("0100007F:2711", "0A", 0), std::nullopt) << "root";
  EXPECT_EQ(find("0100007F:2711", "0A", 998), std::nullopt) << "a service of the system";
  EXPECT_EQ(find("0100007F:2711", "0A", 65534), std::nullopt) << "hidden by a container";
  EXPECT_EQ(find("0100007F:2711", "01", 1001), std::nullopt) << "a connection to somewhere";
  EXPECT_EQ(find("0100007F:2712", "0A", 1001), std::nullopt) << "another port";
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares messages to bHaptics, WEART and Hapbeat with published ones (ServiceMessages.h names the
 * sources).
 */

#include "Devices/Vibration/ServiceMessages.h"

#include <gtest/gtest.h>

using namespace VolumeHaptics;

TEST(ServiceMessages, APacketOfHapbeatHasItsPublishedBytes)
{
  // Bytes according to docs/wire-format.md, little-endian: 42 48, version 1, the command, the
  // packet's number, and the length of the rest. The first packet of a stream contains 16000 Hz,
  // one channel, PCM, 0 samples, and the gain 1.0.
  const HapbeatPacket begin{ 0x42, 0x48, 0x01, 0x30, 0x02, 0x01, 0x0C, 0x00, 0x80, 0x3E, 0x01, 0x00,
    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x80, 0x3F };
  EXPECT_EQ(WriteHapbeatBegin(0x0102), begin);
  const HapbeatPacket samples{ 0x42, 0x48, 0x01, 0x31, 0x03, 0x00, 0x08, 0x00, 0x00, 0x02, 0x00,
    0x00, 0x01, 0x00, 0xFF, 0xFF };
  EXPECT_EQ(WriteHapbeatSamples(3, 512, { 1, -1 }), samples);
  EXPECT_EQ(WriteHapbeatEnd(4), (HapbeatPacket{ 0x42, 0x48, 0x01, 0x32, 0x04, 0x00, 0x00, 0x00 }));
  const HapbeatPacket ping{ 0x42, 0x48, 0x01, 0x10, 0x01, 0x00, 0x08, 0x00, 0xE8, 0x03, 0x00, 0x00,
    0x00, 0x00, 0x00, 0x00 };
  EXPECT_EQ(WriteHapbeatPing(1, 1000), ping);
}

TEST(ServiceMessages, ADeviceOfHapbeatTellsItsName)
{
  HapbeatPacket pong{ 0x42, 0x48, 0x01, 0x11, 0x01, 0x00, 0x10, 0x00 };
  pong.resize(24);
  std::string name = "old";
  EXPECT_TRUE(ReadHapbeatPong(pong, name)) << "a relay has no name";
  EXPECT_EQ(name, "");
  for (const char c : std::string("duo\n1") + '\0' + "player_1/chest")
  {
    pong.push_back(static_cast<std::uint8_t>(c));
  }
  EXPECT_TRUE(ReadHapbeatPong(pong, name));
  EXPECT_EQ(name, "duo?1");
  pong.insert(pong.begin() + 24, 1000, 'x');
  EXPECT_TRUE(ReadHapbeatPong(pong, name));
  EXPECT_EQ(name.size(), 40U);
  pong[3] = 0x10;
  EXPECT_FALSE(ReadHapbeatPong(pong, name)) << "a ping";
  pong.resize(23);
  EXPECT_FALSE(ReadHapbeatPong(pong, name)) << "too short";
}

TEST(ServiceMessages, WeartsLinesHaveTheirPublishedFields)
{
  // Fields according to WeArtMessages.cpp: index, three velocities, volume, hand, point. Numbers
  // are formatted by std::to_string().
  EXPECT_EQ(
    WriteWeartTexture("LEFT", 40), "texture:9:0.500000:0.000000:0.500000:40.000000:LEFT:INDEX");
  EXPECT_EQ(WriteWeartStop("RIGHT"), "stopTexture:RIGHT:INDEX");
  EXPECT_EQ(WriteWeartStart(), "StartFromClient:SdkLLCPP:2.0.0:TrackType1");
  EXPECT_EQ(WriteWeartEnd(), "StopFromClient");
}

TEST(ServiceMessages, WeartsStatusTellsHandsAndWhetherEffectsPass)
{
  WeartStatus status;
  EXPECT_FALSE(ReadWeartStatus("Tracking:TrackType1:0:0:0:0:0:0:0:0", status));
  EXPECT_FALSE(ReadWeartStatus(R"({"type":"RAW_DATA","ts":1,"data":{}})", status));
  EXPECT_FALSE(ReadWeartStatus(R"({"type":"MW_STATUS","ts":1)", status));
  EXPECT_FALSE(ReadWeartStatus("", status));
  EXPECT_TRUE(ReadWeartStatus(
    R"({"type":"MW_STATUS","ts":1,"data":{"status":"IDLE","version":"2.0.0","statusCode":0,
       "actuationsEnabled":false,"connectedDevices":[{"macAddress":"AA","handSide":"LEFT"}]}})",
    status));
  EXPECT_EQ(status.Status, "IDLE");
  EXPECT_FALSE(status.IsActuating);
  EXPECT_EQ(status.Hands, std::vector<std::string>{ "LEFT" });
  EXPECT_TRUE(
    ReadWeartStatus(R"({"type":"WA_STATUS","ts":1,"data":{"status":"RUNNING"}})", status));
  EXPECT_EQ(status.Status, "RUNNING");
  EXPECT_TRUE(status.Hands.empty());
}

TEST(ServiceMessages, BhapticsStatusTellsThePlaces)
{
  std::vector<std::string> places;
  EXPECT_FALSE(ReadBhapticsStatus(R"({"ConnectedPositions":7})", places));
  EXPECT_FALSE(ReadBhapticsStatus(R"({"ConnectedPositions":["GloveL")", places));
  EXPECT_FALSE(ReadBhapticsStatus(R"(["GloveL"])", places));
  EXPECT_TRUE(ReadBhapticsStatus(
    R"({"RegisteredKeys":[],"ActiveKeys":[],"ConnectedDeviceCount":2,
        "ConnectedPositions":["GloveL","Vest",3],"Status":{"GloveL":[0,0,0]}})",
    places));
  EXPECT_EQ(places, (std::vector<std::string>{ "GloveL", "Vest" }));
}

TEST(ServiceMessages, AnswersThatAreNestedDeeplyAreRead)
{
  std::string deep = R"({"ConnectedPositions":["GloveR"],"Status":)";
  constexpr int depth = 100000;
  deep += std::string(depth, '[') + std::string(depth, ']') + "}";
  std::vector<std::string> places;
  EXPECT_TRUE(ReadBhapticsStatus(deep, places));
  EXPECT_EQ(places, std::vector<std::string>{ "GloveR" });
}

TEST(ServiceMessages, AFrameOfBhapticsHasItsPublishedMembers)
{
  // A frame in the format of haptic_player.py.
  EXPECT_EQ(WriteBhapticsFrame("HandR", 60, 150),
    R"({"Submit":[{"Type":"frame","Key":"volumehaptics","Frame":{"Position":"HandR",)"
    R"("PathPoints":[],"DotPoints":[{"Index":0,"Intensity":60},{"Index":1,"Intensity":60},)"
    R"({"Index":2,"Intensity":60}],"DurationMillis":150}}]})");
  EXPECT_NE(WriteBhapticsFrame("Vest", 1, 1).find(R"("Position":"VestFront")"), std::string::npos);
  EXPECT_EQ(WriteBhapticsStop(), R"({"Submit":[{"Type":"turnOff","Key":"volumehaptics"}]})");
}

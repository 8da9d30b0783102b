// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Vibration/ServiceMessages.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <cstring>

namespace VolumeHaptics
{
namespace
{

using Json = nlohmann::json;

constexpr int DeepestValue = 6;
constexpr const char* Key = "volumehaptics";

/**
 * Parses an object, and drops values that are nested too deep. The result is null if the text is
 * not valid.
 */
Json Parse(const std::string& text)
{
  Json value = Json::parse(
    text, [](int depth, Json::parse_event_t, Json&) { return depth <= DeepestValue; }, false);
  return value.is_object() ? value : Json();
}

const Json& At(const Json& object, const char* name)
{
  static const Json none;
  const auto found = object.is_object() ? object.find(name) : object.end();
  return found == object.end() ? none : *found;
}

std::string Text(const Json& object, const char* name)
{
  const Json& value = At(object, name);
  return value.is_string() ? value.get<std::string>() : std::string();
}

/**
 * Returns the number of motors that all models for a place have; for a vest, those of its front.
 */
int CountDots(const std::string& place)
{
  return place == "Vest" ? 20 : place == "GloveL" || place == "GloveR" ? 6 : 3;
}

/** The texture that WEART's own example plays; its speed is at most 0.5. */
constexpr const char* WeartTexture = "9:0.500000:0.000000:0.500000";

/** Builds a packet for a Hapbeat. All numbers are little-endian. */
class Packet
{
public:
  Packet(std::uint8_t command, std::uint16_t number)
  {
    constexpr std::uint8_t version = 1;
    this->Add('B', 1); // the number 0x4842 ("BH" in memory order)
    this->Add('H', 1);
    this->Add(version, 1);
    this->Add(command, 1);
    this->Add(number, 2);
    this->Add(0, 2); // the length, which Finish() sets
  }
  void Add(std::uint64_t value, int bytes)
  {
    for (int i = 0; i < bytes; ++i)
    {
      this->Bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
    }
  }
  HapbeatPacket Finish()
  {
    const std::size_t length = this->Bytes.size() - HeaderSize;
    this->Bytes[6] = static_cast<std::uint8_t>(length);
    this->Bytes[7] = static_cast<std::uint8_t>(length >> 8);
    return std::move(this->Bytes);
  }

  static constexpr std::size_t HeaderSize = 8;

private:
  HapbeatPacket Bytes;
};

} // namespace

const std::vector<std::string> BhapticsPlaces{ "GloveR", "GloveL", "HandR", "HandL", "ForearmR",
  "ForearmL", "Vest", "Head", "FootR", "FootL" };

bool ReadBhapticsStatus(const std::string& text, std::vector<std::string>& places)
{
  const Json all = Parse(text);
  const Json& connected = At(all, "ConnectedPositions");
  if (!connected.is_array())
  {
    return false;
  }
  places.clear();
  for (const Json& place : connected)
  {
    if (place.is_string())
    {
      places.push_back(place.get<std::string>());
    }
  }
  return true;
}

std::string WriteBhapticsFrame(const std::string& place, int intensity, int milliseconds)
{
  std::string dots;
  for (int i = 0; i < CountDots(place); ++i)
  {
    dots += (i == 0 ? "" : ",") + std::string("{\"Index\":") + std::to_string(i) +
      ",\"Intensity\":" + std::to_string(intensity) + "}";
  }
  return std::string("{\"Submit\":[{\"Type\":\"frame\",\"Key\":\"") + Key +
    "\",\"Frame\":{\"Position\":\"" + (place == "Vest" ? "VestFront" : place) +
    "\",\"PathPoints\":[],\"DotPoints\":[" + dots +
    "],\"DurationMillis\":" + std::to_string(milliseconds) + "}}]}";
}

std::string WriteBhapticsStop()
{
  return std::string("{\"Submit\":[{\"Type\":\"turnOff\",\"Key\":\"") + Key + "\"}]}";
}

bool ReadWeartStatus(const std::string& text, WeartStatus& status)
{
  // All messages except JSON are lines of fields.
  const Json all = text.empty() || text[0] != '{' ? Json() : Parse(text);
  const std::string type = Text(all, "type");
  const Json& data = At(all, "data");
  if ((type != "MW_STATUS" && type != "WA_STATUS") || !data.is_object())
  {
    return false;
  }
  status = {};
  status.Status = Text(data, "status");
  const Json& actuations = At(data, "actuationsEnabled");
  status.IsActuating = !actuations.is_boolean() || actuations.get<bool>();
  const Json& devices = At(data, "connectedDevices");
  for (const Json& device : devices.is_array() ? devices : Json::array())
  {
    status.Hands.push_back(Text(device, "handSide"));
  }
  return true;
}

std::string WriteWeartQuestion()
{
  const auto time = std::chrono::duration_cast<std::chrono::milliseconds>(
    std::chrono::system_clock::now().time_since_epoch());
  return "{\"type\":\"MW_GET_STATUS\",\"ts\":" + std::to_string(time.count()) + "}";
}

std::string WriteWeartStart()
{
  // The messages have the format of this version of the SDK.
  return "StartFromClient:SdkLLCPP:2.0.0:TrackType1";
}

std::string WriteWeartEnd()
{
  return "StopFromClient";
}

std::string WriteWeartTexture(const std::string& hand, int volume)
{
  return std::string("texture:") + WeartTexture + ":" + std::to_string(volume) + ".000000:" + hand +
    ":INDEX";
}

std::string WriteWeartStop(const std::string& hand)
{
  return "stopTexture:" + hand + ":INDEX";
}

HapbeatPacket WriteHapbeatPing(std::uint16_t number, std::int64_t microseconds)
{
  Packet packet(0x10, number);
  packet.Add(static_cast<std::uint64_t>(microseconds), 8);
  return packet.Finish();
}

HapbeatPacket WriteHapbeatBegin(std::uint16_t number)
{
  Packet packet(0x30, number);
  packet.Add(HapbeatRate, 2);
  packet.Add(1, 1); // one channel
  packet.Add(0, 1); // 16-bit PCM
  packet.Add(0, 4); // 0: unlimited number of samples
  const float gain = 1.0F;
  std::uint32_t bits = 0;
  std::memcpy(&bits, &gain, sizeof(bits));
  packet.Add(bits, 4);
  return packet.Finish();
}

HapbeatPacket WriteHapbeatSamples(
  std::uint16_t number, std::uint32_t offset, const std::vector<std::int16_t>& samples)
{
  Packet packet(0x31, number);
  packet.Add(offset, 4);
  for (const std::int16_t sample : samples)
  {
    packet.Add(static_cast<std::uint16_t>(sample), 2);
  }
  return packet.Finish();
}

HapbeatPacket WriteHapbeatEnd(std::uint16_t number)
{
  return Packet(0x32, number).Finish();
}

bool ReadHapbeatPong(const HapbeatPacket& packet, std::string& name)
{
  constexpr std::size_t times = 16; // bytes of both times
  constexpr std::size_t begin = Packet::HeaderSize + times;
  if (packet.size() < begin || packet[0] != 'B' || packet[1] != 'H' || packet[2] != 1 ||
    packet[3] != 0x11)
  {
    return false;
  }
  // The name comes from the network and is shown to the user, so shorten it and remove control
  // characters.
  constexpr std::size_t longest = 40;
  name.clear();
  for (std::size_t i = begin; i < packet.size() && packet[i] != 0 && name.size() < longest; ++i)
  {
    name += packet[i] >= ' ' && packet[i] < 0x7F ? static_cast<char>(packet[i]) : '?';
  }
  return true;
}

} // namespace VolumeHaptics

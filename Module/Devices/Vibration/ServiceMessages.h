// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The messages of bHaptics' Player, WEART's middleware and Hapbeat's devices, without a connection.
 *
 * Written from what their makers publish:
 *
 * - bHaptics: bhaptics/haptic-library ab77d37 (samples/csharp/src/Bhaptics.Tact: WebSocketSender.cs
 *   has address and query, PlayerRequest.cs the status, HapticFeedback.cs the names of places and
 *   intensities 0 to 100; include/shared/model.h the names of members), bhaptics/tact-python
 *   49719f3 (bhaptics/haptic_player.py: a frame and its members). The later SDK 2 of bHaptics is a
 *   closed library with an account for each program.
 * - WEART: WEARTHaptics/WEART-SDK-Cpp 6a2c395 (2.0.1): WeArtClient.cpp has the separator and the
 *   first messages, WeArtMessages.cpp their fields, WeArtCommon.h port, names and the status,
 *   docs/home.md the order of calls.
 * - Hapbeat: hapbeat/hapbeat-contracts 9079da6 (specs/message-format.md, ports.md,
 *   device-addressing.md) and hapbeat/hapbeat-arduino e11a737 (docs/wire-format.md; src/Hapbeat.cpp
 *   streams a sine).
 *
 * JSON is read by nlohmann's library, without what is nested deeper than any message, because its
 * values are destroyed by recursion.
 */
#ifndef ServiceMessages_h
#define ServiceMessages_h

#include <cstdint>
#include <string>
#include <vector>

namespace VolumeHaptics
{

///@{
/** bHaptics. */
/** The places of the body at which the Player may have a device, gloves first. */
extern const std::vector<std::string> BhapticsPlaces;
/**
 * Reads the places of the connected devices from a status. Returns false if the text is none.
 */
bool ReadBhapticsStatus(const std::string& text, std::vector<std::string>& places);
/** Writes a request to vibrate with an intensity, 1 to 100, for a time (ms). */
std::string WriteBhapticsFrame(const std::string& place, int intensity, int milliseconds);
/** Writes a request to stop the vibration that WriteBhapticsFrame() has begun. */
std::string WriteBhapticsStop();
///@}

///@{
/** WEART. */
constexpr char WeartSeparator = '~';

struct WeartStatus
{
  std::string Status;             ///< such as "RUNNING"
  bool IsActuating = true;        ///< whether the middleware passes effects on
  std::vector<std::string> Hands; ///< "LEFT", "RIGHT", those that have a device
};
/** Reads a status of the middleware or of the WeArt app. Returns false if the text is none. */
bool ReadWeartStatus(const std::string& text, WeartStatus& status);
std::string WriteWeartQuestion();
std::string WriteWeartStart();
std::string WriteWeartEnd();
/** Writes the order to vibrate at the tip of the index finger with a volume, 1 to 100. */
std::string WriteWeartTexture(const std::string& hand, int volume);
std::string WriteWeartStop(const std::string& hand);
///@}

///@{
/** Hapbeat: packets, each with a number that the sender counts up. */
using HapbeatPacket = std::vector<std::uint8_t>;

constexpr int HapbeatRate = 16000; ///< samples per second
HapbeatPacket WriteHapbeatPing(std::uint16_t number, std::int64_t microseconds);
HapbeatPacket WriteHapbeatBegin(std::uint16_t number);
/** Writes samples, at most 732. `offset` is the number of bytes of all samples before them. */
HapbeatPacket WriteHapbeatSamples(
  std::uint16_t number, std::uint32_t offset, const std::vector<std::int16_t>& samples);
HapbeatPacket WriteHapbeatEnd(std::uint16_t number);
/**
 * Reads an answer to a ping: the device's name, which is empty for a relay. Returns false if the
 * packet is none.
 */
bool ReadHapbeatPong(const HapbeatPacket& packet, std::string& name);
///@}

} // namespace VolumeHaptics

#endif

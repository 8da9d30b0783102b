// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads and writes the messages of bHaptics' Player, WEART's middleware and Hapbeat's devices,
 * without a connection.
 *
 * Written from the makers' publications:
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
 * JSON is parsed by nlohmann's library. Parts that are nested deeper than any real message are
 * dropped, because the library destroys values recursively.
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
/** The places of the body for which the Player may have a device, gloves first. */
extern const std::vector<std::string> BhapticsPlaces;
/**
 * Reads the places of the connected devices from a status message. Returns false for any other
 * text.
 */
bool ReadBhapticsStatus(const std::string& text, std::vector<std::string>& places);
/** Writes a request to vibrate with an intensity, 1 to 100, for a time (ms). */
std::string WriteBhapticsFrame(const std::string& place, int intensity, int milliseconds);
/** Writes a request to stop the vibration of WriteBhapticsFrame(). */
std::string WriteBhapticsStop();
///@}

///@{
/** WEART. */
constexpr char WeartSeparator = '~';

struct WeartStatus
{
  std::string Status;             ///< such as "RUNNING"
  bool IsActuating = true;        ///< whether the middleware forwards effects
  std::vector<std::string> Hands; ///< "LEFT" and "RIGHT", if that hand has a device
};
/** Reads a status of the middleware or of the WeArt app. Returns false for any other text. */
bool ReadWeartStatus(const std::string& text, WeartStatus& status);
std::string WriteWeartQuestion();
std::string WriteWeartStart();
std::string WriteWeartEnd();
/** Writes a command to vibrate at the tip of the index finger with a volume, 1 to 100. */
std::string WriteWeartTexture(const std::string& hand, int volume);
std::string WriteWeartStop(const std::string& hand);
///@}

///@{
/** Hapbeat: packets with consecutive numbers, which the sender counts. */
using HapbeatPacket = std::vector<std::uint8_t>;

constexpr int HapbeatRate = 16000; ///< samples per second
HapbeatPacket WriteHapbeatPing(std::uint16_t number, std::int64_t microseconds);
HapbeatPacket WriteHapbeatBegin(std::uint16_t number);
/** Writes at most 732 samples. `offset` is the number of bytes of all earlier samples. */
HapbeatPacket WriteHapbeatSamples(
  std::uint16_t number, std::uint32_t offset, const std::vector<std::int16_t>& samples);
HapbeatPacket WriteHapbeatEnd(std::uint16_t number);
/**
 * Reads the answer to a ping, with the device's name, which is empty for a relay. Returns false for
 * any other packet.
 */
bool ReadHapbeatPong(const HapbeatPacket& packet, std::string& name);
///@}

} // namespace VolumeHaptics

#endif

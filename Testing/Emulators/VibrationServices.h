// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Stand-ins for bHaptics' Player, WEART's middleware and a Hapbeat, each a real server on this
 * computer, written from the makers' publications:
 *
 * - The Player: bhaptics/tact-python 49719f3, bhaptics/haptic_player.py (address, a frame with
 *   Position, DotPoints of Index and Intensity, DurationMillis; the commented example contains the
 *   names used here) and bhaptics/haptic-library ab77d37, samples/csharp/src/Bhaptics.Tact:
 *   PlayerRequest.cs (a status: ConnectedDeviceCount, RegisteredKeys, ActiveKeys,
 *   ConnectedPositions, Status), WebSocketSender.cs ("turnOff" with a key, "turnOffAll", app_id and
 *   app_name in the query), HapticFeedback.cs (places, intensities of 0 to 100). A frame lasts for
 *   its DurationMillis; a later frame with the same key replaces it.
 * - The middleware: WEARTHaptics/WEART-SDK-Cpp 6a2c395: WeArtClient.cpp (messages end with '~'),
 *   WeArtMessages.cpp (fields between ':'; "texture" has an index, three velocities, a volume, a
 *   hand and a point; JSON has "type", "ts" and "data"), WeArtCommon.h (names; ranges of index,
 *   velocity and volume), WeArtTexture.h (velocity at most 0.5), docs/home.md (effects count only
 *   after Start). A texture lasts until it is stopped. The behaviour when the client leaves is not
 *   published: here the texture then lasts forever, which is the worst case.
 * - The Hapbeat: hapbeat/hapbeat-contracts 9079da6, specs/message-format.md (header, PING, PONG
 *   with the device's name, STREAM_BEGIN, _DATA, _END; a ring of samples that drains by itself;
 *   samples are used only after STREAM_BEGIN; a packet with the same number as the last one is a
 *   duplicate) and hapbeat/hapbeat-arduino e11a737, docs/wire-format.md (a ring of 256 ms).
 */
#ifndef VibrationServices_h
#define VibrationServices_h

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace emulated
{

/** Records the messages that a service received, and their effects. */
struct Vibrations
{
  std::vector<std::string> Messages; ///< all messages, as they arrived
  std::vector<int> Levels;           ///< levels that messages set; 0 for a stop
  int Refused = 0;                   ///< number of messages that were not understood
  bool IsOpen = false;               ///< whether a client is connected
  bool EndsStopped = false; ///< whether the last message before the connection ended was a stop
};

class PlayedBhaptics
{
public:
  /** Listens, and writes its port to VOLUMEHAPTICS_BHAPTICS. */
  explicit PlayedBhaptics(std::vector<std::string> places = { "GloveL", "GloveR" });
  ~PlayedBhaptics();

  Vibrations Get();
  /** Returns the current intensity of a dot, from 0 to 100. */
  int GetDot(const std::string& place, int index);
  void SetPlaces(const std::vector<std::string>& places);
  void SendJunk();
  /** Sends messages other than statuses as fast as the client reads them, and answers nothing. */
  void Flood();
  void Die();

private:
  struct Server;
  std::unique_ptr<Server> All;
};

class PlayedWeart
{
public:
  /** Listens, and writes its port to VOLUMEHAPTICS_WEART. */
  explicit PlayedWeart(std::vector<std::string> hands = { "RIGHT" }, std::string status = "IDLE");
  ~PlayedWeart();

  Vibrations Get();
  /** Returns the current volume of the texture at the index finger, from 0 to 100. */
  double GetVolume(const std::string& hand);
  std::string GetStatus();
  void SetActuating(bool isActuating);
  void SetHands(const std::vector<std::string>& hands);
  /** Ends the connection, while the service continues to run. */
  void HangUp();
  void Die();

private:
  struct Server;
  std::unique_ptr<Server> All;
};

class PlayedHapbeat
{
public:
  PlayedHapbeat();
  ~PlayedHapbeat();

  std::uint16_t GetPort() const;
  Vibrations Get();
  /** Returns the largest sample played in the last 16 ms, as a fraction of full scale. */
  double GetLoudness();
  /** Returns the number of samples that were lost because the ring was full. */
  int CountLost();
  void SetSilent(bool isSilent); ///< stops answering pings

private:
  struct Server;
  std::unique_ptr<Server> All;
};

} // namespace emulated

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Stand-ins for bHaptics' Player, WEART's middleware and a Hapbeat, each a real server on this
 * computer, written from what their makers publish:
 *
 * - The Player: bhaptics/tact-python 49719f3, bhaptics/haptic_player.py (address, a frame with
 *   Position, DotPoints of Index and Intensity, DurationMillis; the commented example has the names
 *   as they are taken here) and bhaptics/haptic-library ab77d37, samples/csharp/src/Bhaptics.Tact:
 *   PlayerRequest.cs (a status: ConnectedDeviceCount, RegisteredKeys, ActiveKeys,
 *   ConnectedPositions, Status), WebSocketSender.cs ("turnOff" with a key, "turnOffAll",
 *   app_id and app_name in the query), HapticFeedback.cs (places, intensities of 0 to 100). A frame
 *   lasts for its DurationMillis; a later one with its key replaces it.
 * - The middleware: WEARTHaptics/WEART-SDK-Cpp 6a2c395: WeArtClient.cpp (messages end with '~'),
 *   WeArtMessages.cpp (fields between ':'; "texture" has an index, three velocities, a volume, a
 *   hand and a point; JSON has "type", "ts" and "data"), WeArtCommon.h (names; ranges of index,
 *   velocity and volume), WeArtTexture.h (velocity at most 0.5), docs/home.md (effects count only
 *   after Start). A texture lasts until it is stopped. What happens when the client leaves is not
 *   published: here it lasts for ever, the worst case.
 * - The Hapbeat: hapbeat/hapbeat-contracts 9079da6, specs/message-format.md (header, PING, PONG
 *   with the device's name, STREAM_BEGIN, _DATA, _END; a ring of samples that drains by itself;
 *   samples count only after a beginning; a packet with the number of the last one is a duplicate)
 *   and hapbeat/hapbeat-arduino e11a737, docs/wire-format.md (a ring of 256 ms).
 */
#ifndef VibrationServices_h
#define VibrationServices_h

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace emulated
{

/** Records what a service did with the messages that it received. */
struct Vibrations
{
  std::vector<std::string> Messages; ///< all messages, as they arrived
  std::vector<int> Levels;           ///< levels that messages set; 0 for a stop
  int Refused = 0;                   ///< messages that are not understood
  bool IsOpen = false;               ///< whether a client is connected
  bool EndsStopped = false;          ///< whether the last message before the end of the connection
                                     ///< was a stop
};

class PlayedBhaptics
{
public:
  /** Listens, and writes its port to VOLUMEHAPTICS_BHAPTICS. */
  explicit PlayedBhaptics(std::vector<std::string> places = { "GloveL", "GloveR" });
  ~PlayedBhaptics();

  Vibrations Get();
  /** Returns the present intensity of a dot, from 0 to 100. */
  int GetDot(const std::string& place, int index);
  void SetPlaces(const std::vector<std::string>& places);
  void SendJunk();
  /** Sends messages other than statuses as fast as they are read, and answers nothing. */
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
  /** Returns the present volume of the texture at the index finger, from 0 to 100. */
  double GetVolume(const std::string& hand);
  std::string GetStatus();
  void SetActuating(bool isActuating);
  void SetHands(const std::vector<std::string>& hands);
  /** Ends the connection. The service continues to run. */
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
  /** Returns the largest sample played in the last 16 ms, as a fraction of the largest number. */
  double GetLoudness();
  /** Returns the number of samples for which the ring had no room. */
  int CountLost();
  void SetSilent(bool isSilent); ///< answers no ping

private:
  struct Server;
  std::unique_ptr<Server> All;
};

} // namespace emulated

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A stand-in for Haply's Inverse service, with an arm that a hand holds: a real WebSocket and HTTP
 * server on this computer.
 *
 * Written from Haply's public documentation alone, docs.haply.co/inverseSDK. Of 3.5:
 * service/realtime/websocket-protocol (inventory, one state for each message),
 * service/api/simulation, service/realtime/control-commands ("vector"; forces of a tick),
 * service/commons/types (units), service/commons/basis (right, forward, up),
 * service/commons/mount-and-workspace (presets), service/session-configuration/sessions (profile),
 * service/events and service/api/events, service/api/http (version, envelope), service/tutorials/00
 * to 06 (handshake, omitted defaults, a grip's buttons and axis). Of 3.0: 3.0.2/service (maps of
 * devices, /3.0/version; up to 3.1.1 HTTP "on http://localhost:10000", which is not the WebSocket's
 * port), and /3.1/devices of the Rust client haply 0.8. That services before 3.5 take "values" is
 * from programs for them: NVIDIA Isaac Lab, isaaclab/devices/haply, and jhu-saw/sawHaplyService
 * 25f21be.
 *
 * How long a force holds without another message, and what becomes of it when a client is gone, is
 * not documented. Here it holds for ever, which is the worst.
 */
#ifndef PlayedHaplyService_h
#define PlayedHaplyService_h

#include "Emulators/EmulatedHand.h"

#include <memory>
#include <string>
#include <vector>

namespace emulated
{

struct HaplyShape
{
  std::string Version = "3.5.0";
  std::string Family = "inverse3"; ///< of both arms
  std::string Type = "inverse3";
  bool HasMaps = false;       ///< as in 3.0: maps from identifiers to devices
  bool OmitsDefaults = false; ///< numbers that have their default, and buttons that are not pressed
  bool IsReordered = false;   ///< members of objects in the other order
  bool HasEvents = true;
  bool HasOwnHttp = false;      ///< at another port than that of the states, as up to 3.1
  bool HasDeviceList = true;    ///< by HTTP
  bool OmitsFalseFlags = false; ///< of a status
  bool HasStatus = true;        ///< in states, too; else in the inventory only
  int DropTime = 0;             ///< ms, after which a session that was closed is in use no more
  /** The x of a position (m) is this times the number of the session's message that it answers. */
  double NumberScale = 0.0;
};

enum class HaplyFault
{
  None,
  Silent,   ///< it takes messages and answers none
  Slow,     ///< each state comes after 60 ms
  Junk,     ///< its states are no JSON
  Blind,    ///< its states have no position
  NoNumber, ///< a coordinate is NaN, as nlohmann's library writes it: null
  NoScale,  ///< so is one of the transform
  Twice     ///< it answers each message twice
};

/** All that the service saw of a session. */
struct HaplySession
{
  std::string Greeting;       ///< the first message
  std::string Arm;            ///< that it commands
  std::vector<Triple> Forces; ///< of each message, N
  int Refused = 0;            ///< messages that it did not understand
  bool IsOpen = true;
};

class HaplyService
{
public:
  static constexpr const char* Id = "049D";
  static constexpr const char* Other = "04BA"; ///< a second arm, which no force moves

  /** Listens, and names its ports in VOLUMEHAPTICS_HAPLY. */
  explicit HaplyService(const HaplyShape& shape = {});
  ~HaplyService();
  HaplyService(const HaplyService&) = delete;
  HaplyService& operator=(const HaplyService&) = delete;

  /** Closes all connections and listens no more. */
  void Die();
  void Break(HaplyFault fault);
  /** To everyone who listens to the events. */
  void PushEvent(const std::string& json);
  std::size_t CountListeners();
  /** Ends the connections of all who listen to the events. */
  void DropListeners();

  ///@{
  /** The hand's goal, and the tip, from the middle of the workspace, in Haply's axes (m). */
  void SetGoal(const Triple& goal);
  Triple GetTip();
  ///@}
  /** Moves the arm without its hand, as another preset would (m). */
  void Shift(const Triple& by);
  /** The force (N) that the arm has now. */
  Triple GetForce();

  void SetCalibrated(bool isCalibrated);
  void SetReady(bool isReady);
  void Unplug();
  /** The session's transform, as a program of the Hub sets it: its position (m) and its scale. */
  void SetTransform(const Triple& position, double scale);
  /** The wireless grip: orientation (w, x, y, z) and its button a. */
  void SetGrip(const std::array<double, 4>& orientation, bool isPressed);

  std::vector<HaplySession> GetSessions();

private:
  struct Server;
  std::unique_ptr<Server> All;
};

} // namespace emulated

#endif

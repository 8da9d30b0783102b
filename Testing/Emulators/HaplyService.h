// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A stand-in for Haply's Inverse service, with an arm in a hand: a real WebSocket and HTTP server
 * on this computer. It is written from Haply's public documentation alone,
 * docs.haply.co/inverseSDK.
 *
 * Version 3.5:
 * - service/realtime/websocket-protocol: inventory, one state for each message;
 * - service/api/simulation; service/realtime/control-commands: "vector", forces of a tick;
 * - service/commons/types: units; service/commons/basis: right, forward, up;
 * - service/commons/mount-and-workspace: presets and their origins;
 * - service/session-configuration/device-config: a preset is set as {"preset":{"preset":NAME}}, and
 *   is a string in the inventory's "config";
 * - service/session-configuration/sessions: profile. The Hub applies its changes to a session of a
 *   profile again to the next session;
 * - service/events and service/api/events; service/api/http: version, envelope;
 * - service/tutorials/00 to 06: handshake, omitted defaults, a grip's buttons and axis.
 *
 * Version 3.0: 3.0.2/service (maps of devices, /3.0/version; up to 3.1.1, HTTP is "on
 * http://localhost:10000", which is not the WebSocket's port), and /3.1/devices of the Rust client
 * haply 0.8. Programs for services before 3.5 send "values": NVIDIA Isaac Lab,
 * isaaclab/devices/haply, and jhu-saw/sawHaplyService 25f21be. The Rust client haply 0.7.1 asks for
 * a full state by "force_render_full_state".
 *
 * No document states how long a force lasts without another message, or after its client has left.
 * Here it lasts forever, which is the worst case.
 */
#ifndef PlayedHaplyService_h
#define PlayedHaplyService_h

#include "Emulators/HaplyState.h"

#include <memory>
#include <string>
#include <vector>

namespace emulated
{

/** Records what the service has received in a session. */
struct HaplySession
{
  std::string Greeting;       ///< the first message
  std::string Arm;            ///< id of the arm that the session controls
  std::vector<Triple> Forces; ///< N, one per message
  int Refused = 0;            ///< number of messages that were not understood
  bool IsOpen = true;
};

class HaplyService
{
public:
  static constexpr const char* Id = HaplyState::Id;
  static constexpr const char* Other = HaplyState::Other;

  /** Starts to listen, and writes its ports to VOLUMEHAPTICS_HAPLY. */
  explicit HaplyService(const HaplyShape& shape = {});
  ~HaplyService();
  HaplyService(const HaplyService&) = delete;
  HaplyService& operator=(const HaplyService&) = delete;

  /** Closes all connections, and stops listening. */
  void Die();
  void Break(HaplyFault fault);
  /** Sends an event to all clients of the event channel. */
  void PushEvent(const std::string& json);
  std::size_t CountListeners();
  /** Ends the connections of all clients of the event channel. */
  void DropListeners();

  ///@{
  /**
   * Sets the hand's goal (m) relative to the centre of the workspace, in Haply's axes. GetTip()
   * returns the tip in the same frame.
   */
  void SetGoal(const Triple& goal);
  Triple GetTip();
  ///@}
  /** Moves the arm (m) without its hand, like a change of the preset. */
  void Shift(const Triple& by);
  /** Returns the current force (N) of the arm. */
  Triple GetForce();

  void SetCalibrated(bool isCalibrated);
  void SetReady(bool isReady);
  void Unplug();
  void PlugIn();
  /** Sets the session's transform (position in m, and scale), like a program of the Hub. */
  void SetTransform(const Triple& position, double scale);
  /** Sets the wireless grip's orientation (w, x, y, z) and whether its button a is pressed. */
  void SetGrip(const std::array<double, 4>& orientation, bool isPressed);

  std::vector<HaplySession> GetSessions();

private:
  struct Server;
  std::unique_ptr<Server> All;
};

} // namespace emulated

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The arms and the grip of a simulated Inverse service, and its messages about them. HaplyService.h
 * names the sources.
 */
#ifndef HaplyState_h
#define HaplyState_h

#include "Emulators/EmulatedHand.h"

#include <array>
#include <chrono>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace emulated
{

struct HaplyShape
{
  std::string Version = "3.5.0";
  std::string Family = "inverse3"; ///< device family of both arms
  std::string Type = "inverse3";
  bool HasMaps = false;       ///< writes maps from identifiers to devices, like version 3.0
  bool OmitsDefaults = false; ///< omits numbers that equal their default, and released buttons
  bool IsReordered = false;   ///< writes the members of objects in reverse order
  bool HasEvents = true;
  bool HasOwnHttp = false;   ///< uses different ports for HTTP and states, like versions up to 3.1
  bool HasDeviceList = true; ///< lists devices by HTTP
  bool OmitsFalseFlags = false; ///< omits the false flags of a status
  bool HasStatus = true; ///< writes the status into states, too, instead of only into the inventory
  int DropTime = 0;      ///< time (ms) for which a closed session still counts as in use
  /** Basis of a session that sets none. Haply's Hub may reuse the basis of an earlier session. */
  std::string Basis = "XYZ";
  /**
   * m: number that is added to a position's x for each message of the session up to the one that
   * the state answers.
   */
  double NumberScale = 0.0;
  /** Preset of a session that sets none. */
  std::string Preset = "defaults";
  bool TakesPresets = true; ///< false: a session keeps its initial preset
  bool TellsConfig = true;  ///< writes the configuration into a requested full state
  std::string VersionNotes; ///< JSON that is sent with the version
};

enum class HaplyFault
{
  None,
  Silent,    ///< accepts messages without answering them
  Slow,      ///< delays each state by 60 ms
  Junk,      ///< sends states that are not JSON
  Blind,     ///< sends states without a position
  SlowBlind, ///< sends states without a position, each delayed by 60 ms
  NoNumber,  ///< sends NaN as a coordinate, which nlohmann's library writes as null
  NoScale,   ///< sends null as the scale of the transform
  Deep,      ///< sends states with the additional member HaplyState::DeepJson
  Twice,     ///< answers each message twice
  Wrong,     ///< answers with a frame that the protocol forbids
  TooLong,   ///< announces a message of 4 GiB
  Leaves,    ///< closes the connection with the protocol's handshake
  HalfEnds,  ///< closes its direction of the connection without a message
  Resets,    ///< resets the connection
  Pings,     ///< sends pings endlessly, and answers no messages
  DeafPings  ///< sends pings endlessly, and reads nothing
};

/// The axes and the origin of a session's vectors.
struct HaplyView
{
  /// preset that defines the origin: the arm's base, or the centre of the workspace
  std::string Preset = "defaults";
  bool IsWhole = false; ///< whether the next state includes the configuration
  /// Axes of the session. In "YZX", the session's x is Haply's y, its y is Haply's z, and its z is
  /// Haply's x. A minus before a letter reverses that axis.
  std::string Basis = "XYZ";

  Triple ToSession(const Triple& haply) const;
  Triple FromSession(const Triple& session) const;
  /// Converts a quaternion (w first) to the session's axes.
  std::array<double, 4> ToSession(const std::array<double, 4>& haply) const;
};

class HaplyState
{
public:
  static constexpr const char* Id = "049D";
  static constexpr const char* Other = "04BA"; ///< id of a second arm, which no force moves
  /// Returns 200 kB of nested lists, which are valid according to RFC 8259, but meaningless.
  static std::string DeepJson() { return std::string(100000, '[') + std::string(100000, ']'); }

  explicit HaplyState(const HaplyShape& shape)
    : Shape(shape)
  {
  }
  bool IsNew() const { return this->Shape.Version >= "3.5"; }
  /// Returns the inventory or a state, as the answer to message `number`.
  std::string MakeMessage(bool hasConfig, const HaplyView& view,
    const std::function<bool(const std::string&)>& isInUse, std::size_t number);
  /// Moves the hand for the time since the last call.
  void Step();

  const HaplyShape Shape;
  HaplyFault Fault = HaplyFault::None;
  EmulatedHand Hand;
  Triple Offset{};
  Triple Force{};
  std::array<double, 4> Grip{ 1.0, 0.0, 0.0, 0.0 };
  bool IsPressed = false;
  bool IsCalibrated = true;
  bool IsReady = true;
  bool IsPlugged = true;
  Triple Place{};
  double Scale = 1.0;

private:
  using Members = std::vector<std::pair<std::string, std::string>>;
  class Writer;

  Members MakeArm(bool hasConfig, const HaplyView& view, const Triple& tip, const Triple& force,
    bool isInUse) const;

  std::chrono::steady_clock::time_point Stepped = std::chrono::steady_clock::now();
};

} // namespace emulated

#endif

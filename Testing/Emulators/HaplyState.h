// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The arms and the grip of a played Inverse service, and its messages about them. HaplyService.h
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
  std::string Family = "inverse3"; ///< family of both arms
  std::string Type = "inverse3";
  bool HasMaps = false;       ///< maps from identifiers to devices, as in 3.0
  bool OmitsDefaults = false; ///< omits numbers equal to their default, and released buttons
  bool IsReordered = false;   ///< writes members of objects in reverse order
  bool HasEvents = true;
  bool HasOwnHttp = false;      ///< HTTP at another port than the states, as up to 3.1
  bool HasDeviceList = true;    ///< lists devices by HTTP
  bool OmitsFalseFlags = false; ///< omits false flags of a status
  bool HasStatus = true;        ///< status in states, too; else only in the inventory
  int DropTime = 0;             ///< ms until a closed session is no longer in use
  /**
   * The basis of a session that names none. Haply's Hub may apply the basis of an earlier session
   * again.
   */
  std::string Basis = "XYZ";
  /** Sets a position's x (m) to this times the number of the session's message that it answers. */
  double NumberScale = 0.0;
  /** The preset of a session that names none. */
  std::string Preset = "defaults";
  bool TakesPresets = true; ///< false: a session keeps its preset
  bool TellsConfig = true;  ///< a requested full state has the configuration
  std::string VersionNotes; ///< JSON sent with the version
};

enum class HaplyFault
{
  None,
  Silent,    ///< accepts messages and answers none
  Slow,      ///< delays each state by 60 ms
  Junk,      ///< sends states that are no JSON
  Blind,     ///< sends states without a position
  SlowBlind, ///< as Blind, and delays each state by 60 ms
  NoNumber,  ///< a coordinate is NaN, which nlohmann's library writes as null
  NoScale,   ///< the transform's scale is null
  Deep,      ///< sends states with a further member: HaplyState::DeepJson
  Twice,     ///< answers each message twice
  Wrong,     ///< answers by a frame that the protocol forbids
  TooLong,   ///< announces a message of 4 GiB
  Leaves,    ///< closes the connection by the protocol
  HalfEnds,  ///< ends its half of the connection without a word
  Resets,    ///< resets the connection
  Pings,     ///< sends pings without end, and answers no message
  DeafPings  ///< as Pings, and reads nothing meanwhile
};

/// The axes of a session's vectors.
struct HaplyView
{
  std::string Preset = "defaults"; ///< sets the origin: the arm's base, or the workspace's centre
  bool IsWhole = false;            ///< the next state includes the configuration
  /// "YZX": the session's x is Haply's y, its y Haply's z, and its z Haply's x; a minus before a
  /// letter reverses that axis.
  std::string Basis = "XYZ";

  Triple ToSession(const Triple& haply) const;
  Triple FromSession(const Triple& session) const;
  /// Converts a quaternion, w first.
  std::array<double, 4> ToSession(const std::array<double, 4>& haply) const;
};

class HaplyState
{
public:
  static constexpr const char* Id = "049D";
  static constexpr const char* Other = "04BA"; ///< a second arm; no force moves it
  /// 200 kB of nested lists: correct by RFC 8259, but useless.
  static std::string DeepJson() { return std::string(100000, '[') + std::string(100000, ']'); }

  explicit HaplyState(const HaplyShape& shape)
    : Shape(shape)
  {
  }
  bool IsNew() const { return this->Shape.Version >= "3.5"; }
  /// Returns the inventory or a state. `number` is the number of the message that it answers.
  std::string MakeMessage(bool hasConfig, const HaplyView& view,
    const std::function<bool(const std::string&)>& isInUse, std::size_t number);
  /// Moves the hand up to now.
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

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The arms and the grip of a played Inverse service, and its messages about them, for
 * HaplyService.h, which names the sources.
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
  /** Of a session that names none: Haply's Hub applies those again that it has had before. */
  std::string Basis = "XYZ";
  /** The x of a position (m) is this times the number of the session's message that it answers. */
  double NumberScale = 0.0;
  std::string VersionNotes; ///< JSON that is told with the version
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
  Deep,     ///< its states have a further member: HaplyState::DeepJson
  Twice     ///< it answers each message twice
};

/// The axes in which a session has vectors.
struct HaplyView
{
  bool IsCentred = false; ///< else from the arm's base
  /// "YZX": the session's x is Haply's y, its y Haply's z, and its z Haply's x; a minus before a
  /// letter turns that axis round.
  std::string Basis = "XYZ";

  Triple ToSession(const Triple& haply) const;
  Triple FromSession(const Triple& session) const;
  /// A quaternion, w first.
  std::array<double, 4> ToSession(const std::array<double, 4>& haply) const;
};

class HaplyState
{
public:
  static constexpr const char* Id = "049D";
  static constexpr const char* Other = "04BA"; ///< a second arm, which no force moves
  /// 200 kB of lists in lists: correct, by RFC 8259, and of use for nobody.
  static std::string DeepJson() { return std::string(100000, '[') + std::string(100000, ']'); }

  explicit HaplyState(const HaplyShape& shape)
    : Shape(shape)
  {
  }
  bool IsNew() const { return this->Shape.Version >= "3.5"; }
  /// The inventory, or a state; `number` is that of the message that it answers.
  std::string MakeMessage(bool hasConfig, const HaplyView& view,
    const std::function<bool(const std::string&)>& isInUse, std::size_t number);
  /// Moves the hand until now.
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

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The text protocol between a computer and hfab controllers, without a transport or a clock.
 *
 * The computer sends "[ma,ma,ma]" and a line feed, with the motors' currents. The controller
 * answers each message with "[model,e0,e1,e2,e3,e4,e5,error]", with its encoders' counts. Messages
 * are padded to 16 bytes with zeros, as in the published host program; the controller skips the
 * zeros.
 */
#ifndef HfabProtocol_h
#define HfabProtocol_h

#include <array>
#include <cstddef>

namespace VolumeHaptics
{

/** A controller's answer. */
struct HfabAnswer
{
  int Model = 0;
  std::array<int, 6> Counts{};
  int Error = 0; ///< error bits of the controller (below)
};

///@{
/** Bits of HfabAnswer::Error, as the firmware sets them. */
constexpr int HfabGimbalErrors = 1 | 2 | 4; ///< an encoder of the handle can't be read
/// Error bits of a refused message. The counts are then those of the last message that was
/// accepted.
constexpr int HfabMessageErrors = 8 | 128 | 256 | 512 | 1024;
///@}

/** Extracts answers from bytes that are received one by one. Does not allocate. */
class HfabReader
{
public:
  /** Processes a byte. Returns whether the byte completes an answer, which Get() then returns. */
  bool Receive(char byte) noexcept;
  const HfabAnswer& Get() const noexcept { return this->Answer; }
  /** Returns the number of lines that were not valid answers. */
  int GetBadLines() const noexcept { return this->BadLines; }
  void Reset() noexcept;
  /** Discards the current line. */
  void Discard() noexcept { this->Field = -1; }

private:
  bool Fail() noexcept;

  static constexpr int Fields = 8;
  std::array<int, Fields> Numbers{};
  HfabAnswer Answer;
  int Field = -1; ///< index of the current number; negative: waits for a bracket
  int Digits = 0;
  bool IsNegative = false;
  int BadLines = 0;
};

/** A message to the controller. */
struct HfabMessage
{
  static constexpr std::size_t LeastSize = 16;
  std::array<char, 48> Bytes{};
  std::size_t Size = 0;
};

/** Encodes currents (mA). */
HfabMessage EncodeHfab(const std::array<int, 3>& milliamperes) noexcept;

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decides whose turn it is to send, the host's or a Novint Falcon's, without a transport or a
 * clock.
 *
 * The device answers every packet with one report, after which the host sends the next packet. If
 * an answer is late, the host has to send again, and two answers may then follow. If the host
 * mistook the first one for the answer to its latest packet, it would read each position one round
 * late from then on. After a missed answer, the host therefore drains the line: after each answer,
 * it sends nothing until the line has been silent for SilentTime. This continues until as many
 * answers have arrived as packets were sent, but for at most MostDoubts rounds; missing answers
 * then count as lost.
 *
 *   turns.Sent(now);
 *   ...
 *   turns.Answered(now, reports); // or Abandon() if the transfer failed
 *   turns.CheckMissed(now, false); // true once for each answer that is late
 *   turns.MaySend(now);
 */
#ifndef FalconTurns_h
#define FalconTurns_h

#include <cstdint>

namespace VolumeHaptics
{

class FalconTurns
{
public:
  ///@{
  /**
   * Longest time (ns) for an answer, and the silence (ns) after which the line counts as drained. A
   * round of the device takes about a millisecond, and the bus and its converter add about two
   * more.
   */
  static constexpr std::int64_t AnswerTime = 10000000;
  static constexpr std::int64_t SilentTime = 4000000;
  static constexpr int MostDoubts = 3;
  ///@}

  /** Records that a packet was sent. `now` is in ns. */
  void Sent(std::int64_t now) noexcept;
  /** Records that a number of reports were received. `now` is in ns. */
  void Answered(std::int64_t now, int reports) noexcept;
  /** Records that the transfer failed, so that no answer will follow. */
  void Abandon() noexcept;

  /**
   * Returns whether an answer was missed since the last call, or whether the packet is stuck in its
   * own transfer. The host may then send again.
   */
  bool CheckMissed(std::int64_t now, bool isSending) noexcept;
  bool MaySend(std::int64_t now) noexcept;
  /**
   * Returns the time (ns) at which the result of CheckMissed() or MaySend() changes if no event
   * arrives first.
   */
  std::int64_t GetDeadline() const noexcept
  {
    return this->Since + (this->Turn == Side::Drain ? SilentTime : AnswerTime);
  }

private:
  enum class Side : std::uint8_t
  {
    Host,
    Device, ///< waiting for the device's answer
    Drain   ///< an answer has arrived, and more may follow
  };

  static constexpr int MostOwed = 1000;

  Side Turn = Side::Host;
  int Owed = 0;           ///< number of outstanding answers
  int Doubts = 0;         ///< number of remaining rounds that drain the line
  std::int64_t Since = 0; ///< time of the last packet or answer (ns)
};

} // namespace VolumeHaptics

#endif

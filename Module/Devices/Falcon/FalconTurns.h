// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The turns of the host and a Novint Falcon, without a transport and without a clock.
 *
 * The device answers every packet with one report, and the host sends the next packet after that.
 * If an answer is late, the host has to send again without it, and then two answers are on their
 * way. If the host treated the first one as the answer to its latest packet, it would be one round
 * behind from then on, and would read each position a round late. So after a missed answer the host
 * drains the line: once an answer comes, it sends nothing until the line has been silent for
 * SilentTime. It does so until as many answers have come as packets were sent, or for MostDoubts
 * rounds; missing answers then count as lost.
 *
 *   turns.Sent(now);
 *   ...
 *   turns.Answered(now, reports); // or Abandon() if the transfer failed
 *   turns.CheckMissed(now, false); // true once for each answer that did not come in time
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
   * Longest time (ns) for an answer, and the time for which the line must be silent to count as
   * drained. A round of the device takes about a millisecond, and the bus and its converter take
   * about two more.
   */
  static constexpr std::int64_t AnswerTime = 10000000;
  static constexpr std::int64_t SilentTime = 4000000;
  static constexpr int MostDoubts = 3;
  ///@}

  /** Records that a packet was sent. `now` is in ns. */
  void Sent(std::int64_t now) noexcept;
  /** Records that a number of reports came. `now` is in ns. */
  void Answered(std::int64_t now, int reports) noexcept;
  /** Records that the transfer failed, so that no answer will come. */
  void Abandon() noexcept;

  /**
   * Returns whether an answer was missed since the last call, or whether the packet itself is stuck
   * in its transfer. The host may then send again.
   */
  bool CheckMissed(std::int64_t now, bool isSending) noexcept;
  bool MaySend(std::int64_t now) noexcept;
  /**
   * Returns the time (ns) at which the result of CheckMissed() or MaySend() changes if no event
   * comes first.
   */
  std::int64_t GetDeadline() const noexcept
  {
    return this->Since + (this->Turn == Side::Drain ? SilentTime : AnswerTime);
  }

private:
  enum class Side : std::uint8_t
  {
    Host,
    Device, ///< an answer of the device is due
    Drain   ///< an answer has come, and more may come
  };

  static constexpr int MostOwed = 1000;

  Side Turn = Side::Host;
  int Owed = 0;           ///< number of answers that are still due
  int Doubts = 0;         ///< number of further rounds, at most, that drain the line
  std::int64_t Since = 0; ///< time of the last packet or answer (ns)
};

} // namespace VolumeHaptics

#endif

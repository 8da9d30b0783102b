// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The servo's clock for a moving volume.
 *
 * While the clock plays, data time advances in every tick by
 *
 *   Rate * period,
 *
 * and otherwise holds. Orders change its speed and direction, but not its present value, so that
 * the volume does not jump. Only Place sets another time; the volume then changes as with a new
 * model.
 *
 * At the end of the series
 * - Once holds;
 * - Loop continues at the first time step, through an interval that blends the last time step into
 *   it;
 * - PingPong turns around.
 *
 * If the mode is no longer Loop, a time between the last time step and the first one remains there,
 * and continues to the next time step.
 *
 * A model may contain only a part of the series (TimeStepSeries.h). If the next time step is not
 * there when it is needed, time holds at the end of that part and continues from there, without a
 * jump. Time also holds while the time steps at another Place have not arrived and, in ServoLoop,
 * while too little of a region is in memory for a tick. On the way to another Place, the model may
 * have only one time step, where time holds, too. No state is carried from the old place to this
 * time step, or from this time step to Place.
 */
#ifndef DataClock_h
#define DataClock_h

#include "Core/Model/BakedVolume.h"
#include "Core/State/ServoState.h"

#include <cstdint>

namespace VolumeHaptics
{

enum class Playback : std::uint8_t
{
  Once,
  Loop,
  PingPong
};

/** The owner's orders to the clock. */
struct DataClockOrders
{
  Playback Mode = Playback::Once;
  bool Plays = false;
  double Rate = 1.0; ///< data time per second
  /** Data time to go to. A time outside the series is moved to its nearer end. */
  double Place = 0.0;
  std::uint32_t Places = 0; ///< number that changes whenever Place is set
};

/** The clock's report after a tick. */
struct DataClockReport
{
  bool IsMoving = false;  ///< whether the volume moves; true even while time holds
  bool IsWaiting = false; ///< whether time holds because time steps are missing
  /// whether time runs backward, or would do so if it did not hold
  bool IsBackward = false;
  double Wanted = 0.0;      ///< if the clock waits, the data time for which it needs time steps
  std::uint32_t Places = 0; ///< Places of the orders that the clock has used
};

class DataClock
{
public:
  enum class Leap : std::uint8_t
  {
    None,
    Within, ///< the clock jumped to another time of the model, so that the force may jump
    /** The last time is not in the model, or the last tick's model had only one time step. */
    Away
  };
  /**
   * Sets state.DataTime for a tick of a period (s). Returns how the time jumped. Must be called
   * before the tick. After Leap::Away, the tick must begin with the proxy at the tip.
   */
  Leap Update(const BakedVolume& volume, const DataClockOrders& orders, double period,
    ServoState& state) noexcept;
  /** Records that no volume moves. Must be called before a tick whose volume does not move. */
  void Rest() noexcept;

  const DataClockReport& GetReport() const noexcept { return this->Report; }

private:
  Leap AdvanceToPlace(const TimeSpan& span, const DataClockOrders& orders, double& time) noexcept;
  void Advance(
    const TimeSpan& span, const DataClockOrders& orders, double way, double& time) noexcept;
  bool IsBackward(const DataClockOrders& orders) const noexcept
  {
    return (orders.Rate < 0.0) != this->IsReturning;
  }

  DataClockReport Report;
  std::uint64_t Number = 0; ///< BakedVolume::Number in the last tick
  std::uint32_t Places = 0; ///< Places of the last orders whose Place the clock has reached
  bool HasTime = false;
  bool IsReturning = false; ///< for PingPong: whether time runs backward
  bool WasInstant = false;  ///< whether the model of the last tick had only one time step
};

} // namespace VolumeHaptics

#endif

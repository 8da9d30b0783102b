// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A device without hardware, whose tip is moved by the program.
 *
 * Without dynamics (Mass 0, the default), the tip moves straight to its target, at most at
 * HandSpeed. With a mass, it simulates a device that a hand holds: m x'' = f + HandStiffness
 * (target - x) - Damping x'. This is integrated accurately over each period with a constant force,
 * as in a sampled-data system. To study the stability of the closed loop, measured positions can be
 * rounded to an encoder's quantum, and forces can be delayed by ticks.
 */
#ifndef VirtualDevice_h
#define VirtualDevice_h

#include "Core/Realtime/TripleBuffer.h"
#include "Core/Safety/DeviceBackend.h"

#include <array>
#include <atomic>

namespace VolumeHaptics
{

struct VirtualDynamics
{
  static constexpr int MaximumDelay = 16;

  double Mass = 0.0;           ///< in kg; 0 for no dynamics
  double Damping = 0.0;        ///< in N s/m
  double HandStiffness = 0.0;  ///< stiffness between the tip and its target (N/m)
  double EncoderQuantum = 0.0; ///< quantum in m to which positions are rounded; 0 for no rounding
  int ForceDelay = 0;          ///< delay of the force in ticks, 0 to MaximumDelay
  double HandSpeed = 2.0;      ///< largest speed in m/s without dynamics
};

class VirtualDevice : public DeviceBackend
{
public:
  bool Open(std::string& error) override;
  void Close() override;
  std::string GetName() const override { return "virtual"; }
  DeviceLimits GetLimits() const override
  {
    DeviceLimits limits = this->Limits;
    limits.MovesTip = limits.MovesTip && this->Dynamics.Mass > 0.0;
    return limits;
  }
  DeviceState Read(double period, DeviceSample& sample) noexcept override;
  DeviceState Write(const Vector3& force) noexcept override;
  void Quench() noexcept override { this->Quenched.store(true, std::memory_order_release); }

  ///@{
  /**
   * Sets the target of the tip (m). This function and the next ones must be called on the same
   * thread, outside the loop.
   */
  void Lead(const Vector3& target) noexcept;
  /**
   * Moves the stylus to another position (m) at once, as if the hand had released it and grasped it
   * again there. The first Lead() does this, too.
   */
  void Place(const Vector3& position) noexcept;
  /**
   * Sets the stylus's orientation, which takes effect at once. It must be a unit quaternion. Before
   * the first call, the stylus has no orientation.
   */
  void Turn(const Quaternion& orientation) noexcept;
  /** Removes the orientation. */
  void ForgetTurn() noexcept;
  void SetButtons(std::uint32_t buttons) noexcept { this->Buttons.store(buttons); }
  /** Sets the dynamics. Must not be called while the loop runs. */
  void SetDynamics(const VirtualDynamics& dynamics) noexcept { this->Dynamics = dynamics; }
  /**
   * Sets the limits, for example those of another device. Must not be called while the loop runs.
   */
  void SetLimits(const DeviceLimits& limits) noexcept { this->Limits = limits; }
  ///@}

  ///@{
  /** Simulate faults of a real device: samples stop, or the device is unplugged. */
  void Freeze(bool frozen) noexcept { this->Frozen.store(frozen); }
  void Unplug() noexcept { this->Unplugged.store(true); }
  ///@}

  /**
   * Returns a component (N) of the force that acts on the hand now. May be called from any thread.
   */
  double GetActingForce(int axis) const noexcept
  {
    return this->Quenched.load(std::memory_order_acquire) ? 0.0 : this->Acting[axis].load();
  }

private:
  static DeviceLimits StrongDesktopDevice();
  void Integrate(double period, const Vector3& force) noexcept;
  void Update(double period) noexcept;

  VirtualDynamics Dynamics;
  DeviceLimits Limits = StrongDesktopDevice();
  struct Order
  {
    Vector3 Target;
    std::uint64_t Places = 0; ///< number of calls of Place(), including the first Lead()
    Quaternion Orientation;
    bool HasOrientation = false;
  };
  TripleBuffer<Order> Orders;
  Order Wanted; ///< used only by the thread that moves the tip
  std::atomic<std::uint32_t> Buttons{ 0 };
  std::atomic<bool> Frozen{ false };
  std::atomic<bool> Unplugged{ false };
  std::atomic<bool> Quenched{ false };
  std::array<std::atomic<double>, 3> Acting{};

  // Members that only the servo uses.
  Vector3 Position;
  Vector3 Velocity;
  std::array<Vector3, VirtualDynamics::MaximumDelay + 1> Queue{};
  int QueueHead = 0;
  /** Simulated time (ns), which advances by one period per tick, however late the ticks are. */
  std::int64_t Time = 0;
  std::int64_t Period = 0; ///< period of the ticks (ns)
  TakenForce Taken{ -1, 0 };
  Vector3 Target;
  /** The value of Places that the servo has processed last; 0 initially. */
  std::uint64_t PlacesDone = 0;
};

} // namespace VolumeHaptics

#endif

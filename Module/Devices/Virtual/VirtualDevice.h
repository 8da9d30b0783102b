// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A device without hardware, whose tip the program leads.
 *
 * Without dynamics (Mass 0, the default) the tip goes straight to its target, at most at HandSpeed.
 * With a mass it is a device in a hand: m x'' = f + HandStiffness (target - x) - Damping x',
 * integrated accurately over each period with the force held, as in a sampled-data system. Measured
 * positions can be rounded to an encoder's quantum and forces delayed by ticks, to study the
 * stability of the closed loop.
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

  double Mass = 0.0;           ///< kg; 0: no dynamics
  double Damping = 0.0;        ///< N s/m
  double HandStiffness = 0.0;  ///< N/m, between the tip and its target
  double EncoderQuantum = 0.0; ///< m; 0: not rounded
  int ForceDelay = 0;          ///< ticks, 0 to MaximumDelay
  double HandSpeed = 2.0;      ///< m/s, without dynamics
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
   * Sets the target of the tip (m). One thread outside the loop calls this function and the next
   * ones.
   */
  void Lead(const Vector3& target) noexcept;
  /** Takes the stylus up at another position (m), as the first Lead does. */
  void Place(const Vector3& position) noexcept;
  /**
   * Sets the stylus's orientation, at once: a unit quaternion. The stylus has no orientation before
   * the first call.
   */
  void Turn(const Quaternion& orientation) noexcept;
  /** Removes the orientation. */
  void ForgetTurn() noexcept;
  void SetButtons(std::uint32_t buttons) noexcept { this->Buttons.store(buttons); }
  /** Sets the dynamics. Call it only while the loop does not run. */
  void SetDynamics(const VirtualDynamics& dynamics) noexcept { this->Dynamics = dynamics; }
  /** Sets the limits of another device. Call it only while the loop does not run. */
  void SetLimits(const DeviceLimits& limits) noexcept { this->Limits = limits; }
  ///@}

  ///@{
  /** Simulate failures of a real device: samples stop, or the device is unplugged. */
  void Freeze(bool frozen) noexcept { this->Frozen.store(frozen); }
  void Unplug() noexcept { this->Unplugged.store(true); }
  ///@}

  /** Returns the force that acts on the hand now. Any thread, for one component at a time. */
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
    std::uint64_t Places = 0; ///< how often the stylus was taken up
    Quaternion Orientation;
    bool HasOrientation = false;
  };
  TripleBuffer<Order> Orders;
  Order Wanted; ///< used by the leading thread
  std::atomic<std::uint32_t> Buttons{ 0 };
  std::atomic<bool> Frozen{ false };
  std::atomic<bool> Unplugged{ false };
  std::atomic<bool> Quenched{ false };
  std::array<std::atomic<double>, 3> Acting{};

  // Used by the servo only.
  Vector3 Position;
  Vector3 Velocity;
  std::array<Vector3, VirtualDynamics::MaximumDelay + 1> Queue{};
  int QueueHead = 0;
  std::int64_t Time = 0;   ///< ns, simulated: one period per tick, however late the ticks are
  std::int64_t Period = 0; ///< ns
  TakenForce Taken{ -1, 0 };
  Vector3 Target;
  std::uint64_t PlacesDone = 0; ///< Places that the servo has seen; 0: never taken up
};

} // namespace VolumeHaptics

#endif

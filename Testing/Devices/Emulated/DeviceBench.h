// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Opens a device by its id, and runs a servo loop in which it touches a floor. */
#ifndef DeviceBench_h
#define DeviceBench_h

#include "Devices/Kinds/DeviceRegistry.h"
#include "Emulators/EmulatedHand.h"
#include "Rigs/PlayedDevice.h"
#include "Rigs/SurfaceRig.h"

#include <optional>

namespace emulated
{
using namespace servotest;

inline constexpr double Radius = 1e-3;          ///< m, radius of the sphere that touches
inline constexpr double Friction = 0.3;         ///< friction coefficient of the floor
inline constexpr double FloorStiffness = 500.0; ///< N/m

/**
 * A floor in the device's workspace. The touching sphere rests on it with its centre at `height`
 * (m) along the outward normal.
 */
class Floor
{
public:
  /// @param linear rotation from the device's axes to the floor's axes; the floor's z points
  ///   outward
  explicit Floor(double height, const Matrix3& linear = {})
  {
    HapticModelDescription description = DescribeMesh(this->Volume, MakeFloor(), Friction);
    description.DeviceToWorld.Linear = 1000.0 * linear;
    description.DeviceToWorld.Offset = { 0.0, 0.0, 1000.0 * (Radius - height) };
    description.Material.Stiffness = ConstantPolyline(FloorStiffness);
    this->Model = std::make_shared<HapticModel>(description);
  }
  std::shared_ptr<const HapticModel> Model;

private:
  const TestVolume Volume = MakeRamp();
};

/**
 * Returns the depth (m) at which the hand's spring, whose goal is at the depth `led` (m), balances
 * the floor's spring.
 */
inline double BalancedDepth(double led)
{
  return led * EmulatedHand::Stiffness / (EmulatedHand::Stiffness + FloorStiffness);
}

/** Opens a device, runs a loop on it, and waits for states and texts. */
class DeviceBench
{
public:
  bool Open(const std::string& id, const DeviceOptions& options = {})
  {
    this->Device = MakeDevice(id, options, this->Error);
    return this->Device && this->Device->Open(this->Error);
  }
  bool Reopen() { return this->Device->Open(this->Error); }
  void Start(const std::shared_ptr<const HapticModel>& model, double rate = 1000.0)
  {
    this->Loop.emplace(*this->Device, rate);
    (*this->Loop)->Publish(model);
  }
  void Stop() { this->Loop.reset(); }
  ServoLoop* operator->() { return this->Loop->operator->(); }
  /// Opens a device that is ready at once, and arms a servo loop on it.
  void Begin(const std::string& id, const std::shared_ptr<const HapticModel>& model)
  {
    ASSERT_TRUE(this->Open(id)) << this->Error;
    ASSERT_TRUE(this->WaitFor(DeviceStage::Ready)) << this->Text();
    this->Start(model);
    ASSERT_TRUE(this->WaitForTicks(20));
    (*this)->Arm();
    ASSERT_TRUE(Eventually([&] { return this->State().IsArmed(); }));
  }

  /// Reads and returns the loop's latest state.
  const ServoSnapshot& State()
  {
    (*this)->ReadState();
    return (*this)->GetState();
  }
  bool WaitFor(DeviceStage stage)
  {
    return Eventually([&] { return this->Device->GetCondition().Stage == stage; });
  }
  /// Waits until the text of the device's condition contains `part`.
  bool WaitForText(const char* part)
  {
    return Eventually([&] { return this->Text().find(part) != std::string::npos; });
  }
  std::string Text() { return this->Device->GetCondition().Text.data(); }
  bool WaitForFault(GateReason fault)
  {
    return Eventually([&] { return this->State().GetFault() == fault; });
  }
  bool WaitForTicks(std::uint64_t ticks)
  {
    const std::uint64_t end = (*this)->GetTickCount() + ticks;
    return Eventually([&] { return (*this)->GetTickCount() >= end; });
  }

  /**
   * Moves the hand to the surface, and into it until the hand feels the expected force. If the
   * servo was delayed on a busy machine, the force restarts inside the surface and would hold the
   * hand there. In that case, moves the hand out without a force and tries again.
   */
  template <typename Approach, typename Enter, typename IsFelt>
  bool Press(Approach&& approach, Enter&& enter, IsFelt&& isFelt)
  {
    bool felt = false;
    for (int attempt = 0; attempt < 20 && !felt; ++attempt)
    {
      if (attempt > 0)
      {
        (*this)->Disarm();
      }
      approach();
      if (attempt > 0)
      {
        (*this)->Arm();
      }
      enter();
      for (int i = 0; i < 2000 && !(felt = isFelt()); ++i)
      {
        this->WaitForTicks(1);
      }
    }
    return felt;
  }

  /// Expects that the force is cut off, that the text contains the reason, and that Arm() does not
  /// restore the force.
  void ExpectLost(const char* text)
  {
    EXPECT_TRUE(this->WaitForFault(GateReason::DeviceLost));
    EXPECT_TRUE(this->WaitForText(text)) << this->Text();
    (*this)->Arm();
    EXPECT_TRUE(this->WaitForTicks(20));
    EXPECT_TRUE(this->WaitForFault(GateReason::DeviceLost));
    EXPECT_EQ(this->Device->GetCondition().Stage, DeviceStage::Lost);
  }

  /**
   * Expects that a device reconnects by itself when it is plugged in again, and exerts no force
   * before the user arms it.
   */
  void ExpectBack()
  {
    EXPECT_TRUE(
      Eventually([&] { return this->Device->GetCondition().Stage != DeviceStage::Lost; }));
    EXPECT_TRUE(this->WaitForTicks(50));
    EXPECT_EQ(this->State().GetFault(), GateReason::DeviceLost) << this->Text();
    EXPECT_EQ(Norm(this->State().Command), 0.0);
  }

  std::unique_ptr<DeviceBackend> Device;
  std::string Error;

private:
  std::optional<RunningLoop> Loop;
};

inline double Size(const Triple& v)
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// Returns whether a force is within a tolerance (N) of the expected force.
inline bool IsNear(const Triple& force, const Triple& expected, double tolerance)
{
  return Size({ force[0] - expected[0], force[1] - expected[1], force[2] - expected[2] }) <
    tolerance;
}

/// Returns the error of opening an id. Expects that the id can't be opened.
inline std::string ErrorOf(const std::string& id, const DeviceOptions& options = {})
{
  DeviceBench bench;
  EXPECT_FALSE(bench.Open(id, options)) << id;
  return bench.Error;
}

inline bool Has(const std::string& text, const char* part)
{
  return text.find(part) != std::string::npos;
}

} // namespace emulated

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Provides a simulated Inverse service, a floor that its arm feels, and a hand that is moved into
 * the floor.
 */
#ifndef HaplyRig_h
#define HaplyRig_h

#include "Devices/Emulated/DeviceBench.h"
#include "Emulators/HaplyService.h"

#include <gtest/gtest.h>

namespace emulated
{
/// Axes of the floor. The outward normal is the device's y, which points up (Haply's z).
inline const Matrix3 Upward = Matrix3::FromColumns({ 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 });

class HaplyTest : public testing::Test
{
protected:
  ~HaplyTest() override { unsetenv("VOLUMEHAPTICS_HAPLY"); }

  void Serve(const HaplyShape& shape = {}) { this->Service.emplace(shape); }
  void Open(const std::string& id = "haply")
  {
    ASSERT_TRUE(this->Bench.Open(id)) << this->Bench.Error;
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  }
  /// Arms the device, and moves the hand's goal 5 mm deep into the middle of the floor.
  void Feel(double rate = 1000.0)
  {
    // Move the hand above the floor before the loop begins. If it began below, the hand would feel
    // the floor from below.
    this->LeadAbove();
    this->Bench.Start(this->Ground.Model, rate);
    ASSERT_TRUE(this->Bench.WaitForTicks(20));
    this->Bench->Arm();
    EXPECT_TRUE(this->Bench.Press([&] { this->LeadAbove(); },
      [&] {
        this->Service->SetGoal({ 0.0, 0.0, Floor - 0.005 });
      },
      [&] { return this->IsHeld(); }))
      << this->Service->GetForce()[2];
  }
  void LeadAbove()
  {
    this->Service->SetGoal({ 0.0, 0.0, Floor + 0.005 });
    EXPECT_TRUE(Eventually(
      [&]
      {
        // On a busy machine, the service may answer so late that the device is lost. The arm then
        // no longer moves.
        if (this->Bench.Device->GetCondition().Stage == DeviceStage::Lost)
        {
          this->Bench.Device->Home();
          this->Bench.WaitFor(DeviceStage::Ready);
        }
        return std::abs(this->Service->GetTip()[2] - Floor - 0.005) < 0.001;
      }))
      << this->Bench.Text();
  }
  /// Returns whether the floor pushes straight up and balances a hand whose goal is 5 mm inside.
  bool IsHeld()
  {
    const double force = FloorStiffness * BalancedDepth(0.005);
    return IsNear(this->Service->GetForce(), { 0.0, 0.0, force }, 0.05);
  }
  /// Expects that the force is cut off, that the text contains the reason, that the device does not
  /// resume by itself, and that the last message has zero force.
  void ExpectLost(const char* text)
  {
    this->Bench.ExpectLost(text);
    EXPECT_TRUE(Eventually([&] { return Size(this->LastForce()) == 0.0; }));
  }
  /**
   * Returns how many messages the client's last position lags behind the messages sent; 1 is normal
   * (the unanswered one). The service must number its positions, and no servo loop may run.
   */
  double CountBehind()
  {
    const auto sent = static_cast<double>(this->LastSession().Forces.size());
    DeviceSample sample;
    this->Bench.Device->Read(1e-3, sample);
    return sent - sample.Tip.X / Numbered().NumberScale;
  }
  static HaplyShape Numbered()
  {
    HaplyShape shape;
    shape.NumberScale = 1e-7;
    return shape;
  }
  HaplySession LastSession() { return this->Service->GetSessions().back(); }
  Triple LastForce()
  {
    const HaplySession session = this->LastSession();
    return session.Forces.empty() ? Triple{} : session.Forces.back();
  }

  static constexpr double Floor = -0.01; ///< m, height of the floor
  std::optional<HaplyService> Service;
  emulated::Floor Ground{ Floor, Upward };
  DeviceBench Bench;
};

} // namespace emulated

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the direction of the device's force throughout the workspace, and for forces far beyond its
 * limits.
 */

#include "Rigs/FalconRig.h"

#include <random>

using namespace emulated;

namespace
{
class FalconDirection : public FalconTest
{
protected:
  Vector3 DrawInBall()
  {
    for (;;)
    {
      const Vector3 v{ this->Draw(), this->Draw(), this->Draw() };
      if (Norm(v) < 1.0 && Norm(v) > 0.1)
      {
        return v;
      }
    }
  }
  double Draw() { return static_cast<double>(this->Random() % 20001) * 1e-4 - 1.0; }

  static double Largest(const Numbers& commands)
  {
    return std::max({ std::fabs(commands[0]), std::fabs(commands[1]), std::fabs(commands[2]) });
  }
  /** Returns the force (N) that the motors exert for these commands. */
  Vector3 ForceOf(const Numbers& commands)
  {
    const Numbers made = FalconMotorForce(this->Falcon.GetGrip(), commands);
    return { made[0], made[1], made[2] };
  }
  /**
   * Writes a force until the device receives it completely, or at the motors' limit. Returns the
   * commands. A force that is renewed too late on a busy machine fades, so the function waits for
   * the whole force.
   */
  Numbers Realise(const Vector3& wanted)
  {
    const long end = this->Falcon.GetPackets() + 5;
    Numbers commands{};
    EXPECT_TRUE(Eventually(
      [&]
      {
        DeviceSample sample;
        this->Device->Read(0.001, sample);
        this->Tip = sample.Fresh ? sample.Tip : this->Tip;
        this->Device->Write(wanted);
        commands = this->Falcon.GetCommands();
        const bool isWhole = Largest(commands) == 4096.0 ||
          Norm(this->ForceOf(commands) - wanted) < 0.01 * Norm(wanted);
        return this->Falcon.GetPackets() > end && isWhole;
      }))
      << commands[0] << " " << commands[1] << " " << commands[2];
    return commands;
  }

  std::mt19937 Random{ 11 };
  Vector3 Tip; ///< m, tip as reported by the driver
};
} // namespace

TEST_F(FalconDirection, IsKeptThroughSaturation)
{
  this->MakeReady();
  this->Falcon.SetHeld(true);
  int saturated = 0;
  for (int i = 0; i < 60; ++i)
  {
    const Vector3 place = 0.035 * this->DrawInBall();
    this->LeadTo({ place.X, place.Y, place.Z + 0.125 }, 1e-6);
    const Vector3 direction = this->DrawInBall();
    for (const double size : { 2.0, 8.0, 100.0, 1000.0 })
    {
      const Vector3 wanted = (size / Norm(direction)) * direction;
      const Numbers commands = this->Realise(wanted);
      const Vector3 made = this->ForceOf(commands);
      EXPECT_LT(Norm(this->Tip - place), 1e-4) << "the tip in the same axes";
      const double largest = Largest(commands);
      EXPECT_LE(largest, 4096.0);
      EXPECT_GT(Dot(made, wanted), 0.0);
      EXPECT_LT(Norm(Cross(made, wanted)), 0.01 * Norm(made) * Norm(wanted)) << i << " " << size;
      saturated += largest == 4096.0 ? 1 : 0;
    }
  }
  EXPECT_GT(saturated, 120) << "at 100 and 1000 N always";
  EXPECT_LT(saturated, 240);
}

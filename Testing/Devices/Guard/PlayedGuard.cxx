// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A guard with a simulated device, for GuardedDeviceTest.cxx. The device reports each force as a
 * position, and its lights as an orientation. Alternatively, a hand holds the device, and the force
 * moves the hand: "held" has motors with the right sign, and "crossed" with the wrong sign.
 */

#include "Devices/Guard/GuardMain.h"
#include "Rigs/HeldDevice.h"

#include <chrono>
#include <stdexcept>

#include <unistd.h>

using namespace VolumeHaptics;

namespace
{

class PlayedDriver : public HardwareDriver
{
public:
  explicit PlayedDriver(std::string way)
    : Way(std::move(way))
  {
  }
  std::string GetName() const override { return "played in process " + std::to_string(getpid()); }
  DeviceLimits GetLimits() const override { return {}; }
  std::string GetIdentity() const override { return "played:SN1"; }
  bool Connect(std::string& error) override
  {
    error = "The played device is refused.";
    return this->Way != "refuse";
  }
  void Serve(HardwareExchange& exchange) override
  {
    if (this->Way == "throw")
    {
      throw std::runtime_error("The played device is out of order.");
    }
    exchange.Report({});
    exchange.SetCondition(DeviceStage::Ready, "");
    if (this->Way == "held" || this->Way == "crossed")
    {
      this->ServeHeld(exchange);
      return;
    }
    while (!exchange.MustStop())
    {
      exchange.WaitForWake(2);
      if (exchange.DrainHomeRequest())
      {
        exchange.SetCondition(DeviceStage::Ready, "homed");
      }
      DeviceSample sample;
      sample.Tip = exchange.GetForce();
      sample.Buttons = static_cast<std::uint32_t>(exchange.GetLights());
      sample.HasOrientation = exchange.GetLights() > 0;
      sample.Orientation = { 0.5, 0.5, -0.5, 0.1 * exchange.GetLights() };
      exchange.Report(sample);
    }
  }
  void Disconnect() noexcept override {}

private:
  /** Advances the held device up to the real time, in steps of a millisecond. */
  void ServeHeld(HardwareExchange& exchange)
  {
    using Clock = std::chrono::steady_clock;
    const double sign = this->Way == "crossed" ? -1.0 : 1.0;
    signtest::Hand hand;
    hand.Stiffness = 100.0;
    hand.Damping = 3.0;
    hand.TremorSize = 0.0;
    signtest::HeldDevice held(hand, { 1.0, sign, 1.0 }, 1);
    auto moved = Clock::now();
    while (!exchange.MustStop())
    {
      exchange.WaitForWake(1);
      const Vector3 force = exchange.GetForce();
      for (; Clock::now() - moved >= std::chrono::milliseconds(1);
           moved += std::chrono::milliseconds(1))
      {
        held.Move({ force.X, force.Y, force.Z }, 1e-3);
      }
      DeviceSample sample;
      sample.Tip = { held.GetPlace()[0], held.GetPlace()[1], held.GetPlace()[2] };
      exchange.Report(sample);
    }
  }

  const std::string Way;
};

} // namespace

int main(int argc, char** argv)
{
  return RunGuard({ argv, argv + argc },
    [](const std::vector<std::string>& words, std::string&)
    { return std::make_unique<PlayedDriver>(words.at(0)); });
}

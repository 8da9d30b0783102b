// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A guard whose device is played, for GuardedDeviceTest.cxx: it tells each force as a position.
 */

#include "Devices/Guard/GuardMain.h"

#include <stdexcept>

#include <poll.h>
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
    exchange.Tell({});
    exchange.SetCondition(DeviceStage::Ready, "");
    pollfd wake = { exchange.GetWakeDescriptor(), POLLIN, 0 };
    while (!exchange.MustStop())
    {
      poll(&wake, 1, 2);
      exchange.ClearWake();
      if (exchange.TakeHomeRequest())
      {
        exchange.SetCondition(DeviceStage::Ready, "homed");
      }
      DeviceSample sample;
      sample.Tip = exchange.GetForce();
      sample.Buttons = static_cast<std::uint32_t>(exchange.GetLights());
      exchange.Tell(sample);
    }
  }
  void Disconnect() noexcept override {}

private:
  const std::string Way;
};

} // namespace

int main(int argc, char** argv)
{
  return RunGuard({ argv, argv + argc },
    [](const std::vector<std::string>& words, std::string&)
    { return std::make_unique<PlayedDriver>(words.at(0)); });
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A kind of device under the test's control: the test sets its stage, and a simulated hand rotates
 * it.
 */
#ifndef PlayedHardware_h
#define PlayedHardware_h

#include <Devices/Common/DeviceKind.h>
#include <vtkHapticDevice.h>

#include <atomic>
#include <cmath>
#include <cstdio>

namespace devicetest
{

/** The test's input to all devices of the kind, and the devices' output. */
struct PlayedHardware
{
  std::atomic<VolumeHaptics::DeviceStage> Stage{ VolumeHaptics::DeviceStage::Ready };
  std::atomic<double> Turn{ 0.0 };  ///< rad/s, turn about the device's y
  std::atomic<int> Homings{ 0 };    ///< number of requests for homing
  std::atomic<double> Force{ 0.0 }; ///< N, norm of the latest force
  std::atomic<int> Lights{ -1 };
  VolumeHaptics::DeviceOptions Options;

  static PlayedHardware& Get()
  {
    static PlayedHardware played;
    return played;
  }
  /** Adds the kind "played". Call it once per program. */
  static bool Add();
};

class PlayedBackend : public VolumeHaptics::DeviceBackend
{
public:
  bool Open(std::string&) override { return true; }
  void Close() override {}
  std::string GetName() const override { return "played"; }
  VolumeHaptics::DeviceLimits GetLimits() const override
  {
    VolumeHaptics::DeviceLimits limits;
    limits.MaximumForce = 6.0;
    return limits;
  }
  VolumeHaptics::DeviceCondition GetCondition() override
  {
    VolumeHaptics::DeviceCondition condition;
    condition.Stage = PlayedHardware::Get().Stage;
    std::snprintf(condition.Text.data(), condition.Text.size(), "as the test plays it.");
    return condition;
  }
  void Home() noexcept override { ++PlayedHardware::Get().Homings; }
  void SetLights(int lights) noexcept override { PlayedHardware::Get().Lights = lights; }
  VolumeHaptics::DeviceState Read(
    double period, VolumeHaptics::DeviceSample& sample) noexcept override
  {
    using namespace VolumeHaptics;
    const DeviceStage stage = PlayedHardware::Get().Stage;
    this->Time += period;
    sample.Tip = { 0.007, 0.007, 0.008 + 0.003 * std::sin(10.0 * this->Time) };
    sample.Turn = { 0.0, PlayedHardware::Get().Turn, 0.0 };
    sample.Fresh = stage == DeviceStage::Ready;
    return stage == DeviceStage::Ready ? DeviceState::Running
      : stage == DeviceStage::Lost     ? DeviceState::Lost
                                       : DeviceState::NotReady;
  }
  VolumeHaptics::DeviceState Write(const VolumeHaptics::Vector3& force) noexcept override
  {
    PlayedHardware::Get().Force = VolumeHaptics::Norm(force);
    return VolumeHaptics::DeviceState::Running;
  }
  void Quench() noexcept override {}

private:
  double Time = 0.0; // s, time of the hand's motion up and down
};

inline bool PlayedHardware::Add()
{
  using namespace VolumeHaptics;
  static const bool added = vtkHapticDevice::AddDeviceKind({ "played",
    [] {
      return std::vector<DeviceListing>{ { "played:0", "A device that a test plays",
        "available" } };
    },
    [](const std::string&, const DeviceOptions& options, std::string&)
    {
      Get().Options = options;
      return std::make_unique<PlayedBackend>();
    } });
  return added;
}

} // namespace devicetest

#endif

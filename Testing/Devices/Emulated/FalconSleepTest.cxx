// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Suspends the computer while a force acts, and wakes it up. */

#include "Devices/Falcon/FalconDriver.h"
#include "Rigs/FalconRig.h"

using namespace emulated;

namespace
{
std::atomic<std::int64_t> TimeAsleep{ 0 };

/** A device on a computer whose sleep is simulated. */
class SleepyDevice : public DeviceBackend
{
public:
  explicit SleepyDevice(const DeviceOptions& options)
    : Driver(0, options)
  {
  }
  ~SleepyDevice() override { this->SleepyDevice::Close(); }
  bool Open(std::string& error) override
  {
    if (!this->Driver.Connect(error))
    {
      return false;
    }
    this->Exchange.Begin();
    this->Thread = std::thread([this] { this->Driver.Serve(this->Exchange); });
    return true;
  }
  void Close() override
  {
    if (this->Thread.joinable())
    {
      this->Exchange.RequestStop();
      this->Thread.join();
      this->Driver.Disconnect();
    }
  }
  std::string GetName() const override { return this->Driver.GetName(); }
  DeviceLimits GetLimits() const override { return this->Driver.GetLimits(); }
  DeviceCondition GetCondition() override { return this->Exchange.GetCondition(); }
  void Home() noexcept override { this->Exchange.RequestHome(); }
  DeviceState Read(double, DeviceSample& sample) noexcept override
  {
    return this->Exchange.Receive(sample);
  }
  DeviceState Write(const Vector3& force) noexcept override { return this->Exchange.Give(force); }
  void Quench() noexcept override { this->Exchange.Quench(); }

private:
  HardwareExchange Exchange{ [] { return TimeAsleep.load(); } };
  FalconDriver Driver;
  std::thread Thread;
};

class FalconSleep : public FalconTest
{
};
} // namespace

TEST_F(FalconSleep, EndsTheForceUntilHomed)
{
  this->Device = std::make_unique<SleepyDevice>(this->Options);
  ASSERT_TRUE(this->Device->Open(this->Error)) << this->Error;
  this->Home();
  this->LeadTo(Middle);
  ASSERT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
  TimeAsleep += 3000000000;
  this->ExpectLost("asleep");
  EXPECT_TRUE(this->StaysAtZero(30));
  this->Device->Home();
  ASSERT_TRUE(this->IsAt(DeviceStage::Homing));
  this->Home();
  EXPECT_TRUE(this->Feels({ 0.0, 0.0, 2.0 }));
}

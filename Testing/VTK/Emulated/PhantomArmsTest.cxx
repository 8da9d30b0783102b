// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests applications in which a hand presses a device onto the phantom's face. The devices are an
 * arm with an hfab controller behind a pseudo-terminal, and devices of fake vendors' libraries,
 * loaded as plug-ins (Emulators/HfabEmulator.h, ForceDimension/FakeForceDimension.h,
 * OpenHaptics/FakeOpenHaptics.h).
 */

#include "Emulators/ForceDimension/FakeForceDimension.h"
#include "Emulators/HfabEmulator.h"
#include "Emulators/OpenHaptics/FakeOpenHaptics.h"
#include "PhantomRig.h"
#include "Rigs/PluginFolder.h"

#include <filesystem>
#include <fstream>

using namespace emulated;

namespace
{
/** An arm with one axis that points outwards from the phantom's face. */
class PressedDevice
{
public:
  virtual ~PressedDevice() = default;
  virtual std::string GetId() const = 0;
  /** Returns the device's name in the user's file of devices. */
  virtual std::string GetIdentity() const = 0;
  /** Moves the device to its pose for calibration. Returns false if it needs none. */
  virtual bool PutIntoPose() { return false; }
  ///@{
  /**
   * Moves the hand (m) along the axis out of the face, and returns the tip's place (m) and the
   * force (N) along this axis.
   */
  virtual void Lead(double out) = 0;
  virtual double GetTip() = 0;
  virtual double GetForce() = 0;
  ///@}
  /** Breaks the device, and returns the words with which the status text reports that. */
  virtual const char* Break() = 0;
};

class PressedHfab : public PressedDevice
{
public:
  std::string GetId() const override { return "hfab:" + this->Arm.GetPort(); }
  std::string GetIdentity() const override { return "hfab:port:" + this->Arm.GetPort(); }
  bool PutIntoPose() override
  {
    this->Arm.PlaceAtHome();
    return true;
  }
  void Lead(double out) override { this->Arm.SetGoal({ out, 0.0, 0.0 }); }
  double GetTip() override
  {
    const Triple tip = this->Arm.GetTip();
    return std::hypot(tip[1], tip[2]) < 1e-3 ? tip[0] : 1.0;
  }
  double GetForce() override { return this->Arm.GetForce()[0]; }
  const char* Break() override
  {
    this->Arm.Unplug();
    return "unplugged";
  }

private:
  HfabEmulator Arm{ 3 };
};

class PressedForceDimension : public PressedDevice
{
public:
  PressedForceDimension() { this->Folder.Add("forcedimension"); }
  std::string GetId() const override { return "vendor:forcedimension"; }
  std::string GetIdentity() const override { return "vendor:forcedimension:4711"; }
  void Lead(double out) override
  {
    const std::lock_guard<std::mutex> lock(this->Fake.Mutex);
    this->Fake.Hand.Goal = { out, 0.0, 0.0 };
  }
  double GetTip() override
  {
    const std::lock_guard<std::mutex> lock(this->Fake.Mutex);
    return this->Fake.Hand.Tip[0];
  }
  double GetForce() override
  {
    const std::lock_guard<std::mutex> lock(this->Fake.Mutex);
    return this->Fake.Force[0];
  }
  const char* Break() override
  {
    const std::lock_guard<std::mutex> lock(this->Fake.Mutex);
    this->Fake.HasPower = false;
    return "has no power";
  }

private:
  const devicetest::PluginFolder Folder;
  FakeForceDimension& Fake = FakeForceDimension::Get();
};

class PressedOpenHaptics : public PressedDevice
{
public:
  PressedOpenHaptics() { this->Folder.Add("openhaptics"); }
  std::string GetId() const override { return "vendor:openhaptics"; }
  std::string GetIdentity() const override { return "vendor:openhaptics:HD_0815_7"; }
  void Lead(double out) override
  {
    const std::lock_guard<std::mutex> lock(this->Fake.Mutex);
    this->Fake.Hand.Goal = { 0.0, 0.0, out };
  }
  double GetTip() override
  {
    const std::lock_guard<std::mutex> lock(this->Fake.Mutex);
    return this->Fake.Hand.Tip[2];
  }
  double GetForce() override
  {
    const std::lock_guard<std::mutex> lock(this->Fake.Mutex);
    return this->Fake.Force[2];
  }
  const char* Break() override
  {
    const std::lock_guard<std::mutex> lock(this->Fake.Mutex);
    this->Fake.StandsStill = true;
    return "stands still";
  }

private:
  const devicetest::PluginFolder Folder;
  FakeOpenHaptics& Fake = FakeOpenHaptics::Get();
};

template <typename Pressed>
class PhantomArms : public testing::Test
{
protected:
  PhantomArms()
  {
    std::filesystem::create_directories(std::filesystem::path(this->Memory).parent_path());
    setenv("VOLUMEHAPTICS_DEVICES", this->Memory.c_str(), 1);
    std::ofstream(this->Memory) << this->Arm.GetIdentity() << " confirmed=2026-11-01\n";
  }
  ~PhantomArms() override { unsetenv("VOLUMEHAPTICS_DEVICES"); }

  bool IsAt(int status)
  {
    this->Device->UpdateState();
    return this->Device->GetStatus() == status;
  }
  /**
   * Calibrates the device if needed, and again if a busy machine has lost the device. The device
   * then reports its fault until it is armed.
   */
  void MakeReady()
  {
    ASSERT_TRUE(Eventually(
      [this]
      {
        return this->IsAt(vtkHapticDevice::READY) || this->IsAt(vtkHapticDevice::FAULT) ||
          this->IsAt(vtkHapticDevice::HOMING);
      }))
      << this->Device->GetStatusText();
    if (this->IsAt(vtkHapticDevice::FAULT))
    {
      this->Device->Home();
    }
    if (!this->IsAt(vtkHapticDevice::READY) && this->Arm.PutIntoPose())
    {
      ASSERT_TRUE(this->Hand.Wait([this] { return this->Hand.Says("know where its arm is"); }))
        << this->Device->GetStatusText();
      this->Device->Home();
    }
    ASSERT_TRUE(Eventually([this] { return !this->IsAt(vtkHapticDevice::HOMING); }))
      << this->Device->GetStatusText();
  }
  /// Moves the hand along the axis out of the face. Returns false if the tip does not follow
  /// because the device was lost.
  bool LeadTo(double out)
  {
    this->Arm.Lead(out);
    return Eventually([&] { return std::abs(this->Arm.GetTip() - out) < 0.002; });
  }
  /// Presses until a force acts, and expects the force to persist for 1000 ticks.
  bool IsFeltForLong()
  {
    this->Arm.Lead(-Depth);
    bool felt = false;
    for (int i = 0; i < 2000 && !(felt = this->IsFelt()); ++i)
    {
      this->Hand.WaitTicks(1);
    }
    return felt && this->Device->GetState()->GetContact() != 0 && this->Hand.WaitTicks(1000) &&
      !this->IsAt(vtkHapticDevice::FAULT);
  }
  /**
   * Returns whether the computed force of the skin, the force of the hand's spring and the reported
   * force agree.
   */
  bool IsFelt()
  {
    this->Device->UpdateState();
    const double force = -this->Device->GetState()->GetForce()[1];
    const double spring = EmulatedHand::Stiffness * (Depth + this->Arm.GetTip());
    return force > 0.1 && std::abs(this->Arm.GetForce() - force) < 0.05 &&
      std::abs(spring - force) < 0.1;
  }

  static constexpr double Depth = 0.004; // m, goal behind the skin
  static constexpr int MostAttempts = 5;
  const std::string Memory = TemporaryPath("arms/devices.txt");
  emulated::Phantom Phantom;
  Pressed Arm;
  PhantomHand Hand{ this->Phantom, 2, 1.0 };
  vtkHapticDevice* const Device = this->Hand.Device;
};

using PressedDevices = testing::Types<PressedHfab, PressedForceDimension, PressedOpenHaptics>;
} // namespace

TYPED_TEST_SUITE(PhantomArms, PressedDevices);

TYPED_TEST(PhantomArms, PressThePhantomAndLetGoAtAFault)
{
  vtkHapticDevice* const device = this->Device;
  ASSERT_TRUE(device->Open(this->Arm.GetId().c_str()));
  ASSERT_TRUE(device->Start());
  EXPECT_TRUE(device->GetSignsConfirmed());
  bool felt = false;
  // On a busy machine, the servo may pause, after which the force starts again from zero, so retry.
  for (int attempt = 0; attempt < this->MostAttempts && !felt; ++attempt)
  {
    device->Disarm();
    ASSERT_NO_FATAL_FAILURE(this->MakeReady());
    if (this->LeadTo(0.01))
    {
      EXPECT_TRUE(Eventually([this] { return this->Arm.GetForce() == 0.0; }))
        << "not before it is armed";
      device->Arm();
      felt = this->IsFeltForLong();
    }
  }
  EXPECT_TRUE(felt) << this->Arm.GetForce() << " N, told " << device->GetState()->GetForce()[1]
                    << ". " << device->GetStatusText();

  const char* const words = this->Arm.Break();
  EXPECT_TRUE(this->Hand.WaitFor(vtkHapticDevice::FAULT));
  EXPECT_TRUE(this->Hand.Wait([&] { return this->Hand.Says(words); })) << device->GetStatusText();
  EXPECT_TRUE(this->Hand.WaitTicks(100));
  EXPECT_EQ(Length(device->GetState()->GetForce()), 0.0);
  EXPECT_EQ(device->GetStatus(), vtkHapticDevice::FAULT) << "nothing comes back by itself";
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Applications in which a hand presses a device onto the face of the phantom: an arm with an hfab
 * controller behind a pseudo-terminal, and devices of stand-ins for vendors' libraries through
 * their plug-ins. The devices are those of the emulators' sources (Emulators/HfabEmulator.h,
 * ForceDimension/FakeForceDimension.h, OpenHaptics/FakeOpenHaptics.h).
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
/** A device of which one axis of its own points out of the face. */
class PressedDevice
{
public:
  virtual ~PressedDevice() = default;
  virtual std::string GetId() const = 0;
  /** As the user's file of devices has it. */
  virtual std::string GetIdentity() const = 0;
  /** The hand puts it into its pose for calibration. False if it needs none. */
  virtual bool PutIntoPose() { return false; }
  ///@{
  /** Out of the face: where the hand is led (m), where the tip is, and the force (N). */
  virtual void Lead(double out) = 0;
  virtual double GetTip() = 0;
  virtual double GetForce() = 0;
  ///@}
  /** Takes it away, and the words that tell it. */
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

  bool LeadTo(double out)
  {
    this->Arm.Lead(out);
    return Eventually([&] { return std::abs(this->Arm.GetTip() - out) < 0.002; });
  }
  /** The hand's spring and the skin hold each other, and the program tells the same force. */
  bool IsFelt()
  {
    this->Device->UpdateState();
    const double force = -this->Device->GetForce()[1];
    const double spring = EmulatedHand::Stiffness * (Depth + this->Arm.GetTip());
    return force > 0.1 && std::abs(this->Arm.GetForce() - force) < 0.05 &&
      std::abs(spring - force) < 0.1;
  }

  static constexpr double Depth = 0.004; // m
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
  if (this->Arm.PutIntoPose())
  {
    ASSERT_TRUE(this->Hand.Wait([&] { return this->Hand.Says("press Home()"); }));
    device->Home();
  }
  ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::READY)) << device->GetStatusText();
  EXPECT_TRUE(device->GetSignsConfirmed());
  ASSERT_TRUE(this->LeadTo(0.01));
  EXPECT_EQ(this->Arm.GetForce(), 0.0) << "not before it is armed";
  device->Arm();
  bool felt = false;
  // A busy machine may leave the device unwatched for a moment, and the force begins anew.
  for (int attempt = 0; attempt < 5 && !felt; ++attempt)
  {
    ASSERT_TRUE(this->LeadTo(0.01));
    this->Arm.Lead(-this->Depth);
    for (int i = 0; i < 2000 && !(felt = this->IsFelt()); ++i)
    {
      this->Hand.WaitTicks(1);
    }
  }
  EXPECT_TRUE(felt) << this->Arm.GetForce() << " N, told " << device->GetForce()[1] << ". "
                    << device->GetStatusText();
  EXPECT_NE(device->GetContact(), 0);
  EXPECT_TRUE(this->Hand.WaitTicks(1000));

  const char* const words = this->Arm.Break();
  EXPECT_TRUE(this->Hand.WaitFor(vtkHapticDevice::FAULT));
  EXPECT_TRUE(this->Hand.Wait([&] { return this->Hand.Says(words); })) << device->GetStatusText();
  EXPECT_TRUE(this->Hand.WaitTicks(100));
  EXPECT_EQ(Length(device->GetForce()), 0.0);
  EXPECT_EQ(device->GetStatus(), vtkHapticDevice::FAULT) << "nothing comes back by itself";
}

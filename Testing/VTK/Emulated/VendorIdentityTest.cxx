// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests what the program stores about a vendor's device, with and without a serial number. The test
 * emulates the device; the hand that holds it is a mass on a spring (Emulators/EmulatedHand.h).
 */

#include "Devices/Vendor/PlayedVendor.h"
#include "Emulators/EmulatedHand.h"
#include "Emulators/ModelClock.h"
#include "PhantomRig.h"
#include "Rigs/PluginFolder.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <dlfcn.h>

using namespace emulated;

namespace
{
class VendorIdentity : public testing::Test
{
protected:
  VendorIdentity()
  {
    std::filesystem::create_directories(std::filesystem::path(this->Memory).parent_path());
    std::filesystem::remove(this->Memory);
    setenv("VOLUMEHAPTICS_DEVICES", this->Memory.c_str(), 1);
    this->Holder.Place({ 0.0, 0.0, 0.02 });
  }
  ~VendorIdentity() override { unsetenv("VOLUMEHAPTICS_DEVICES"); }

  static PlayedVendor& Load(const std::filesystem::path& file)
  {
    void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    using Getter = PlayedVendor* (*)();
    return *reinterpret_cast<Getter>(dlsym(library, "GetPlayedVendor"))();
  }
  void Step()
  {
    const std::lock_guard<std::mutex> lock(this->Played.Mutex);
    this->Holder.Step(1e-3, this->Played.Force);
    std::copy(this->Holder.Tip.begin(), this->Holder.Tip.end(), this->Played.Pose.Position);
  }
  void SetSerial(const char* serial)
  {
    const std::lock_guard<std::mutex> lock(this->Played.Mutex);
    this->Played.Serial = serial;
  }
  /// Arms until the device's signs are confirmed. Retries, because the machine may be busy.
  void ArmForTheFirstTime()
  {
    ASSERT_FALSE(this->Device->GetSignsConfirmed());
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::READY)) << this->Device->GetStatusText();
    for (int attempt = 0; attempt < 5 && !this->Device->GetSignsConfirmed(); ++attempt)
    {
      this->Device->Arm();
      ASSERT_TRUE(this->Hand.Wait(
        [this]
        {
          return this->Device->GetSignsConfirmed() ||
            this->Device->GetStatus() == vtkHapticDevice::FAULT;
        }));
    }
    ASSERT_TRUE(this->Device->GetSignsConfirmed()) << this->Device->GetStatusText();
    this->Device->Stop();
    EXPECT_TRUE(this->Device->GetSignsConfirmed()) << "as long as it is open";
  }
  std::string ReadMemory() const
  {
    std::ostringstream text;
    text << std::ifstream(this->Memory).rdbuf();
    return text.str();
  }

  const std::string Memory = TemporaryPath("identity/devices.txt");
  const devicetest::PluginFolder Folder;
  PlayedVendor& Played = Load(Folder.Add("played"));
  EmulatedHand Holder;
  const ModelClock Clock{ [this] { this->Step(); } };
  const emulated::Phantom Phantom;
  PhantomHand Hand{ this->Phantom, 2, 1.0 };
  vtkHapticDevice* const Device = this->Hand.Device;
};
} // namespace

TEST_F(VendorIdentity, TheDefaultForceIsOneThatLasts)
{
  const auto open = [this](double continuous)
  {
    {
      const std::lock_guard<std::mutex> lock(this->Played.Mutex);
      this->Played.Limits.ContinuousForce = continuous;
    }
    return this->Device->Open("vendor:played");
  };
  ASSERT_TRUE(open(1.0));
  EXPECT_EQ(this->Device->GetMaximumForce(), 1.0);
  this->Device->SetMaximumForce(10.0);
  EXPECT_EQ(this->Device->GetMaximumForce(), 4.0) << "the peak, if the user asks for it";
  this->Device->ResetMaximumForce();
  EXPECT_EQ(this->Device->GetMaximumForce(), 1.0);
  this->Device->Close();
  ASSERT_TRUE(open(3.0));
  EXPECT_EQ(this->Device->GetMaximumForce(), 2.0) << "half, if that is less";
}

TEST_F(VendorIdentity, WithASerialNumberItIsRemembered)
{
  ASSERT_TRUE(this->Device->Open("vendor:played"));
  EXPECT_TRUE(this->Device->IsRemembered());
  ASSERT_NO_FATAL_FAILURE(this->ArmForTheFirstTime());
  ASSERT_TRUE(this->Device->CalibrateForce(0.5));
  EXPECT_NE(this->ReadMemory().find("vendor:played:SN_1_2 confirmed=20"), std::string::npos)
    << this->ReadMemory();
  this->Device->Close();
  EXPECT_FALSE(this->Device->IsRemembered()) << "none is open";
  ASSERT_TRUE(this->Device->Open("vendor:played"));
  EXPECT_TRUE(this->Device->GetSignsConfirmed());
  EXPECT_EQ(this->Device->GetForceScale(), 0.5);
}

TEST_F(VendorIdentity, WithoutASerialNumberItIsConfirmedAnewEachTime)
{
  // Several devices can have the number 0, so the line may refer to another device.
  const std::string line =
    "vendor:played:number:0 confirmed=2026-11-01 scale=0.25 calibrated=2026-11-01\n";
  std::ofstream(this->Memory) << line;
  this->SetSerial("");
  ASSERT_TRUE(this->Device->Open("vendor:played"));
  EXPECT_FALSE(this->Device->IsRemembered());
  EXPECT_EQ(this->Device->GetForceScale(), 1.0);
  ASSERT_NO_FATAL_FAILURE(this->ArmForTheFirstTime());
  ASSERT_TRUE(this->Device->CalibrateForce(0.5));
  EXPECT_EQ(this->Device->GetForceScale(), 0.5);

  this->Device->Close();
  ASSERT_TRUE(this->Device->Open("vendor:played"));
  EXPECT_FALSE(this->Device->GetSignsConfirmed());
  EXPECT_EQ(this->Device->GetForceScale(), 1.0);
  EXPECT_EQ(this->Device->GetCalibrationText(), "uncalibrated");
  ASSERT_TRUE(this->Device->Start());
  ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::READY)) << this->Device->GetStatusText();
  this->Device->Arm();
  EXPECT_TRUE(this->Hand.Wait([this] { return this->Hand.Says("Confirming the signs"); }))
    << this->Device->GetStatusText();
  EXPECT_EQ(this->ReadMemory(), line) << "nothing is written under a name that others may have";
}

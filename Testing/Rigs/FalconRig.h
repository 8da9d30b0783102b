// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Provides an emulated Novint Falcon that a hand holds, plugged in, and opened as an application
 * does.
 */
#ifndef FalconRig_h
#define FalconRig_h

#include "Devices/Kinds/DeviceRegistry.h"
#include "Emulators/EmulatedUsb.h"
#include "Emulators/FalconModel.h"
#include "PlayedDevice.h"
#include "TemporaryFolder.h"

#include <filesystem>
#include <fstream>
#include <numeric>

namespace emulated
{
using namespace VolumeHaptics;
using servotest::Eventually;

inline const Numbers Rest = { 0.0, 0.0, 0.172 }; ///< m, start of a session
inline const Numbers Middle = { 0.0, 0.0, 0.125 };

inline bool AreClose(const Numbers& a, const Numbers& b, double distance)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]) < distance;
}

inline bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

class FalconTest : public testing::Test
{
protected:
  explicit FalconTest(bool runs = true)
    : Falcon(runs)
    , Usb(Falcon, "1-2")
  {
    this->Options.HomingTime = 60.0;
  }

  /** Opens a device. On failure, sets this->Error and returns false. */
  bool Open(const std::string& id = "falcon")
  {
    this->Device = MakeDevice(id, this->Options, this->Error);
    return this->Device && this->Device->Open(this->Error);
  }
  void LeadTo(const Numbers& place, double distance = 0.001)
  {
    this->Falcon.SetAim(place);
    ASSERT_TRUE(Eventually([&] { return AreClose(this->Falcon.GetGrip(), place, distance); }));
  }
  bool IsAt(DeviceStage stage)
  {
    return Eventually([&] { return this->Device->GetCondition().Stage == stage; });
  }
  std::string GetText() { return this->Device->GetCondition().Text.data(); }
  void Home()
  {
    ASSERT_TRUE(Eventually([&] { return this->Falcon.IsRunning(); })) << this->GetText();
    ASSERT_TRUE(this->IsAt(DeviceStage::Homing)) << this->GetText();
    this->LeadTo({ 0.0, 0.0, 0.1735 });
    this->LeadTo({ 0.0, 0.0, 0.08 });
    this->LeadTo(Rest);
    ASSERT_TRUE(this->IsAt(DeviceStage::Ready)) << this->GetText();
  }
  /** Homes the device, and moves its grip to the middle of the workspace. */
  void MakeReady()
  {
    ASSERT_TRUE(this->Open()) << this->Error;
    this->Home();
    this->LeadTo(Middle);
  }
  /** Writes a force repeatedly, as a servo does, until `holds` returns true. */
  template <typename F>
  bool Push(const Vector3& force, F&& holds)
  {
    return Eventually(
      [&]
      {
        DeviceSample sample;
        this->Device->Read(0.001, sample);
        this->Device->Write(force);
        return holds();
      });
  }
  bool Feels(const Vector3& force)
  {
    return this->Push(force,
      [&] {
        return AreClose(this->Falcon.GetForce(), { force.X, force.Y, force.Z }, 0.05);
      });
  }
  /**
   * Returns whether the commands stay zero during a number of packets, whatever force the servo
   * writes. Ignores the packet that may already be in transit.
   */
  bool StaysAtZero(long packets)
  {
    const auto pass = [this](long more)
    {
      const long end = this->Falcon.GetPackets() + more;
      return this->Push({ 0.0, 0.0, 2.0 }, [&] { return this->Falcon.GetPackets() >= end; });
    };
    const bool arrived = pass(1);
    this->Falcon.DrainLargestCommand();
    return arrived && pass(packets) && this->Falcon.DrainLargestCommand() == 0.0;
  }
  /** Expects that the device is lost, reports `why`, and received zero as its last commands. */
  void ExpectLost(const std::string& why)
  {
    EXPECT_TRUE(this->Push(
      { 0.0, 0.0, 2.0 }, [&] { return this->Device->GetCondition().Stage == DeviceStage::Lost; }));
    EXPECT_TRUE(Has(this->GetText(), why)) << this->GetText();
    DeviceSample sample;
    EXPECT_EQ(this->Device->Read(0.001, sample), DeviceState::Lost);
    EXPECT_TRUE(Eventually([&] { return this->Falcon.GetCommands() == Numbers{}; }));
  }

  FalconModel Falcon;
  EmulatedUsb Usb;
  DeviceOptions Options;
  std::unique_ptr<DeviceBackend> Device;
  std::string Error;
};

/** A file that the destructor deletes. */
class TemporaryFile
{
public:
  explicit TemporaryFile(const std::vector<std::uint8_t>& bytes)
    : Path(
        TemporaryPath("falcon-" + std::to_string(reinterpret_cast<std::uintptr_t>(this)) + ".bin"))
  {
    std::ofstream(this->Path, std::ios::binary)
      .write(
        reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  }
  ~TemporaryFile() { std::filesystem::remove(this->Path); }
  const std::filesystem::path Path;
};

/** Returns a firmware image for tests, which contains every byte value in an irregular order. */
inline std::vector<std::uint8_t> MakeImage(std::size_t size)
{
  std::vector<std::uint8_t> image(size);
  unsigned int seed = 7;
  for (std::uint8_t& byte : image)
  {
    seed = seed * 1664525u + 1013904223u;
    byte = static_cast<std::uint8_t>(seed >> 24);
  }
  return image;
}
} // namespace emulated

#endif

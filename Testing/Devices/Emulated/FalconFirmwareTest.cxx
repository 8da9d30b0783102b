// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests a device that has no firmware yet: the source of the image, and possible faults. */

#include "Rigs/FalconRig.h"

using namespace emulated;

namespace
{
class FalconFirmware : public FalconTest
{
protected:
  FalconFirmware()
    : FalconTest(false)
  {
  }
  void ExpectRefusal(const std::string& file, const std::vector<std::string>& parts)
  {
    this->Options.FirmwareFile = file;
    EXPECT_FALSE(this->Open());
    for (const std::string& part : parts)
    {
      EXPECT_TRUE(Has(this->Error, part)) << part << ": " << this->Error;
    }
    EXPECT_TRUE(Has(this->Error, "SetFirmwareFile()")) << this->Error;
    EXPECT_TRUE(Has(this->Error, "--firmware")) << this->Error;
    EXPECT_FALSE(this->Usb.IsClaimed()) << "it lets go of the device";
  }
  /** Makes every attempt to load an image fail with this fault. */
  void Break(FalconFault fault, const std::string& why)
  {
    const TemporaryFile file(MakeImage(2000));
    this->Options.FirmwareFile = file.Path.string();
    this->Falcon.Break(fault);
    ASSERT_TRUE(this->Open()) << this->Error;
    EXPECT_TRUE(this->IsAt(DeviceStage::Lost));
    EXPECT_TRUE(Has(this->GetText(), why)) << this->GetText();
    EXPECT_TRUE(Has(this->GetText(), "Home()")) << this->GetText();
    EXPECT_EQ(this->Falcon.GetPackets(), 0) << "no run packet for what does not run";
    // The driver stores the firmware's image, so it does not need the file again.
    this->Falcon.Break(FalconFault::None);
    this->Device->Home();
    EXPECT_TRUE(Eventually([&] { return this->Falcon.IsRunning(); })) << this->GetText();
    EXPECT_EQ(this->Falcon.GetImage(), MakeImage(2000));
    ASSERT_TRUE(this->IsAt(DeviceStage::Homing)) << this->GetText();
  }
};
} // namespace

TEST_F(FalconFirmware, IsLoadedByteForByte)
{
  const std::vector<std::uint8_t> image = MakeImage(28 * 1024 + 7);
  const TemporaryFile file(image);
  this->Options.FirmwareFile = file.Path.string();
  ASSERT_TRUE(this->Open()) << this->Error;
  std::string text;
  EXPECT_TRUE(Eventually(
    [&]
    {
      const DeviceCondition condition = this->Device->GetCondition();
      text = condition.Stage == DeviceStage::Firmware ? condition.Text.data() : text;
      DeviceSample sample;
      return !text.empty() && this->Device->Read(0.001, sample) == DeviceState::NotReady;
    }));
  EXPECT_TRUE(Has(text, "Loading the firmware: ") && Has(text, "%")) << text;
  ASSERT_TRUE(this->IsAt(DeviceStage::Homing)) << this->GetText();
  EXPECT_EQ(this->Falcon.GetImage(), image);
  this->Home();
  // Without a firmware file, the firmware that is still in the device is used.
  this->Device->Close();
  this->Options.FirmwareFile.clear();
  this->Falcon.DrainTranscript();
  ASSERT_TRUE(this->Open()) << this->Error;
  this->Device->Close();
  for (const std::string& line : this->Falcon.DrainTranscript())
  {
    EXPECT_NE(line, "o 0a 43 0d") << "it runs, and is not loaded again";
  }
}

TEST_F(FalconFirmware, HasToBeGiven)
{
  this->ExpectRefusal("", { "legal" });
  this->ExpectRefusal("/nowhere/at/all.bin", { "\"/nowhere/at/all.bin\"", "does not exist" });
  const std::string folder = TemporaryPath("");
  this->ExpectRefusal(folder, { folder, "is a folder" });
  this->ExpectRefusal("/dev/null", { "no regular file" });
  const std::string pipe = TemporaryPath("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  this->ExpectRefusal(pipe, { pipe, "no regular file" });
  std::filesystem::remove(pipe);
}

TEST_F(FalconFirmware, HasToBeOfAPossibleSize)
{
  for (const std::size_t size : { 0, 1023, 128 * 1024 + 1 })
  {
    const TemporaryFile file(MakeImage(size));
    this->ExpectRefusal(file.Path.string(),
      { file.Path.string(), "has " + std::to_string(size) + " bytes", "1024 to 131072" });
  }
  for (const std::size_t size : { 1024, 128 * 1024 })
  {
    const TemporaryFile file(MakeImage(size));
    this->Options.FirmwareFile = file.Path.string();
    EXPECT_TRUE(this->Open()) << this->Error;
    this->Device->Close();
  }
}

TEST_F(FalconFirmware, WrongEcho)
{
  this->Break(FalconFault::WrongEcho, "came back different");
}

TEST_F(FalconFirmware, NoEcho)
{
  this->Break(FalconFault::NoEcho, "did not come back");
}

TEST_F(FalconFirmware, DoesNotRun)
{
  this->Break(FalconFault::DeadImage, "loaded, but does not answer");
}

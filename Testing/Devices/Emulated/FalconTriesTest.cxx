// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a loader that fails as often as libnifalcon describes (see FalconModel.h). After a failure,
 * the driver reopens the device and loads again. The text contains the number of the attempt, and
 * the driver gives up after ten attempts.
 */

#include "Rigs/FalconRig.h"

#include <set>

using namespace emulated;

namespace
{
class FalconTries : public FalconTest
{
protected:
  FalconTries()
    : FalconTest(false)
    , Image(MakeImage(2000))
    , File(this->Image)
  {
    this->Options.FirmwareFile = this->File.Path.string();
  }
  void ExpectLoaded()
  {
    ASSERT_TRUE(this->Open()) << this->Error;
    EXPECT_TRUE(Eventually(
      [&]
      {
        this->Texts.insert(this->GetText());
        return this->Falcon.IsRunning() || this->Device->GetCondition().Stage == DeviceStage::Lost;
      }));
    EXPECT_EQ(this->Falcon.GetImage(), this->Image) << this->GetText();
    EXPECT_TRUE(this->IsAt(DeviceStage::Homing)) << this->GetText();
  }
  bool HasTold(const std::string& part) const
  {
    return std::any_of(this->Texts.begin(), this->Texts.end(),
      [&](const std::string& text) { return Has(text, part); });
  }

  const std::vector<std::uint8_t> Image;
  const TemporaryFile File;
  std::set<std::string> Texts;
};
} // namespace

TEST_F(FalconTries, AZeroBeforeTheGreeting)
{
  this->Falcon.Break(FalconFault::LeadingZero);
  this->ExpectLoaded();
}

TEST_F(FalconTries, AByteBeforeTheAnswerAtTheLoadingRate)
{
  this->Falcon.Break(FalconFault::LeadingShake);
  this->ExpectLoaded();
  const std::vector<std::string> lines = this->Falcon.DrainTranscript();
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "c 40 03 4138"), 1) << "tries";
}

TEST_F(FalconTries, ALateAnswerToTheGreetingIsDropped)
{
  this->Falcon.Break(FalconFault::LateGreeting, 1);
  this->ExpectLoaded();
  const std::vector<std::string> lines = this->Falcon.DrainTranscript();
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "o 0a 43 0d"), 2);
  EXPECT_EQ(std::count(lines.begin(), lines.end(), "c 40 03 4138"), 1) << "tries";
}

TEST_F(FalconTries, AWrongEchoOnTheFirstTries)
{
  using Fault = FalconFault;
  this->Falcon.BreakAttempts({ Fault::WrongEcho, Fault::WrongEcho, Fault::None });
  this->ExpectLoaded();
}

TEST_F(FalconTries, NoEchoOnTheFirstTry)
{
  this->Falcon.BreakAttempts({ FalconFault::NoEcho, FalconFault::None });
  this->ExpectLoaded();
  EXPECT_TRUE(this->HasTold("try 2 of 10")) << *this->Texts.rbegin();
}

TEST_F(FalconTries, NoGreetingOnTheFirstTry)
{
  this->Falcon.BreakAttempts({ FalconFault::NoGreeting, FalconFault::None });
  this->ExpectLoaded();
}

TEST_F(FalconTries, StuckUntilTheDeviceWasClosed)
{
  this->Falcon.Break(FalconFault::StuckLoader, 1);
  this->ExpectLoaded();
}

TEST_F(FalconTries, EndAfterTen)
{
  this->Falcon.Break(FalconFault::WrongEcho);
  ASSERT_TRUE(this->Open()) << this->Error;
  ASSERT_TRUE(this->IsAt(DeviceStage::Lost));
  EXPECT_TRUE(Has(this->GetText(), "failed 10 times")) << this->GetText();
  int attempts = 0;
  for (const std::string& line : this->Falcon.DrainTranscript())
  {
    attempts += line == "c 40 03 4138" ? 1 : 0;
  }
  EXPECT_EQ(attempts, 10);
}

TEST_F(FalconTries, EndWhenItIsClosed)
{
  this->Falcon.Break(FalconFault::NoGreeting);
  ASSERT_TRUE(this->Open()) << this->Error;
  ASSERT_TRUE(this->IsAt(DeviceStage::Firmware));
  this->Device->Close();
  EXPECT_FALSE(this->Usb.IsClaimed());
}

TEST_F(FalconTries, EndWhenItIsUnplugged)
{
  this->Falcon.Break(FalconFault::WrongEcho);
  ASSERT_TRUE(this->Open()) << this->Error;
  this->Usb.Unplug();
  EXPECT_TRUE(this->IsAt(DeviceStage::Lost));
  EXPECT_TRUE(Has(this->GetText(), "unplugged")) << this->GetText();
}

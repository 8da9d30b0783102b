// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Moves a tip into a floor in sessions with simulated vibrating services, over real sockets of this
 * computer.
 */

#include "Devices/Emulated/DeviceBench.h"
#include "Devices/Emulated/GuardProcesses.h"
#include "Devices/Vibration/HapbeatService.h"
#include "Devices/Vibration/VibrationDriver.h"
#include "Devices/Virtual/VirtualDevice.h"
#include "Emulators/VibrationServices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <new>
#include <thread>

using namespace emulated;

namespace
{
class VibrationSession : public testing::Test
{
protected:
  /// Opens and arms a device, with the tip above the floor.
  void Begin(const std::string& id, bool usesGuard = false)
  {
    DeviceOptions options;
    options.UseGuard = usesGuard;
    ASSERT_TRUE(this->Bench.Open(id, options)) << this->Bench.Error;
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
    this->Lead(0.01);
    this->Bench.Start(this->Ground.Model);
    ASSERT_TRUE(this->Bench.WaitForTicks(20));
    this->Bench->Arm();
    ASSERT_TRUE(Eventually([&] { return this->Bench.State().IsArmed(); }));
  }
  /// Moves the tip to a height (m) above the floor.
  void Lead(double height)
  {
    auto* const led = dynamic_cast<VirtualDevice*>(this->Bench.Device.get());
    ASSERT_NE(led, nullptr) << "the mouse has to lead it";
    led->Lead({ 0.0, 0.0, height });
  }
  /// Moves the tip in and out of the floor until `isFelt` returns true. Returns false after too
  /// many tries.
  template <typename IsFelt>
  bool Knock(IsFelt&& isFelt, int tries = 50)
  {
    bool felt = false;
    for (int i = 0; i < tries && !felt; ++i)
    {
      this->Lead(-0.005);
      for (int k = 0; k < 100 && !(felt = isFelt()); ++k)
      {
        this->Bench.WaitForTicks(1);
      }
      this->Lead(0.01);
      this->Bench.WaitForTicks(50);
    }
    return felt;
  }
  static int Largest(const Vibrations& told)
  {
    return told.Levels.empty() ? 0 : *std::max_element(told.Levels.begin(), told.Levels.end());
  }

  emulated::Floor Ground{ 0.0 };
  DeviceBench Bench;
};
} // namespace

TEST_F(VibrationSession, BhapticsFeelsAContactAndEndsStopped)
{
  PlayedBhaptics player;
  ASSERT_NO_FATAL_FAILURE(this->Begin("vibration:bhaptics:GloveL"));
  EXPECT_EQ(this->Bench.Device->GetName(), "bHaptics GloveL, vibration, not force");
  EXPECT_TRUE(this->Bench.Device->GetLimits().Vibrates);
  EXPECT_EQ(Largest(player.Get()), 0) << "in the air";
  EXPECT_TRUE(this->Knock([&] { return player.GetDot("GloveL", 1) > 20; }));
  EXPECT_EQ(player.GetDot("GloveR", 1), 0);
  // A constant force causes no vibration.
  this->Lead(-0.005);
  EXPECT_TRUE(Eventually([&] { return Norm(this->Bench.State().Command) > 1.0; }));
  EXPECT_TRUE(Eventually([&] { return player.GetDot("GloveL", 1) == 0; }));
  EXPECT_GT(Norm(this->Bench.State().Command), 1.0);
  EXPECT_TRUE(this->Knock([&] { return player.GetDot("GloveL", 1) > 20; }));
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_TRUE(Eventually([&] { return !player.Get().IsOpen; }));
  const Vibrations told = player.Get();
  EXPECT_TRUE(told.EndsStopped) << told.Messages.back();
  EXPECT_EQ(told.Refused, 0);
  for (const std::string& message : told.Messages)
  {
    EXPECT_TRUE(Has(message, "\"DurationMillis\":150") || Has(message, "turnOff")) << message;
  }
}

TEST_F(VibrationSession, NothingVibratesBeforeItIsArmed)
{
  PlayedBhaptics player;
  ASSERT_TRUE(this->Bench.Open("vibration:bhaptics")) << this->Bench.Error;
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetName(), "bHaptics GloveR, vibration, not force") << "the first";
  this->Bench.Start(this->Ground.Model);
  EXPECT_FALSE(this->Knock([&] { return Largest(player.Get()) > 0; }, 3));
}

TEST_F(VibrationSession, AServoThatStandsStillEndsTheVibration)
{
  PlayedWeart weart;
  ASSERT_NO_FATAL_FAILURE(this->Begin("vibration:weart"));
  ASSERT_TRUE(this->Knock([&] { return weart.GetVolume("RIGHT") > 20.0; }));
  this->Lead(-0.005);
  this->Bench.Stop();
  EXPECT_TRUE(Eventually([&] { return weart.GetVolume("RIGHT") == 0.0; }));
  EXPECT_TRUE(weart.Get().IsOpen) << "only the servo has ended";
}

TEST_F(VibrationSession, ThePlayerIsLostAndComesBackWithoutForce)
{
  auto player = std::make_unique<PlayedBhaptics>();
  ASSERT_NO_FATAL_FAILURE(this->Begin("vibration:bhaptics"));
  player.reset();
  this->Bench.ExpectLost("bHaptics' Player has ended");
  player = std::make_unique<PlayedBhaptics>();
  this->Bench.ExpectBack();
  EXPECT_FALSE(this->Knock([&] { return Largest(player->Get()) > 0; }, 3)) << "not armed";
  this->Bench->Arm();
  EXPECT_TRUE(this->Knock([&] { return Largest(player->Get()) > 0; })) << this->Bench.Text();
}

TEST_F(VibrationSession, AGloveThatIsSwitchedOffIsLost)
{
  PlayedBhaptics player;
  ASSERT_NO_FATAL_FAILURE(this->Begin("vibration:bhaptics:GloveR"));
  player.SendJunk();
  EXPECT_TRUE(this->Knock([&] { return Largest(player.Get()) > 0; })) << "junk is no status";
  player.SetPlaces({ "GloveL" });
  this->Bench.ExpectLost("is no longer connected to bHaptics' Player");
  player.SetPlaces({ "GloveL", "GloveR" });
  this->Bench.ExpectBack();
}

TEST_F(VibrationSession, APlayerThatTellsEverythingButItsStatusIsGivenUp)
{
  PlayedBhaptics player;
  player.Flood();
  EXPECT_TRUE(Has(ErrorOf("vibration:bhaptics"), "does not list the connected devices"));
}

TEST_F(VibrationSession, ThereIsALastWordEvenWithoutMemory)
{
  struct Service : VibrationService
  {
    explicit Service(int& stops)
      : Stops(stops)
    {
    }
    std::string GetName() const override { return "played"; }
    bool Connect(std::string&) override { return true; }
    State Show(double) override { throw std::bad_alloc(); }
    std::string GetText() const override { return {}; }
    void StopAtCrash() noexcept override { ++this->Stops; }
    void Disconnect() noexcept override {}
    int& Stops;
  };
  int stops = 0;
  VibrationDriver driver(std::make_unique<Service>(stops));
  HardwareExchange exchange;
  EXPECT_THROW(driver.Serve(exchange), std::bad_alloc);
  EXPECT_EQ(stops, 1);
}

TEST_F(VibrationSession, WeartThatHangsUpIsStoppedInTheEnd)
{
  PlayedWeart weart;
  ASSERT_NO_FATAL_FAILURE(this->Begin("vibration:weart"));
  weart.HangUp();
  this->Bench.ExpectLost("WEART's middleware has ended");
  this->Bench.ExpectBack();
  EXPECT_EQ(weart.GetStatus(), "RUNNING") << "nobody has stopped it";
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_TRUE(Eventually([&] { return weart.GetStatus() == "IDLE"; }));
}

TEST_F(VibrationSession, WeartIsStartedAndStoppedAgain)
{
  PlayedWeart weart({ "LEFT", "RIGHT" });
  ASSERT_NO_FATAL_FAILURE(this->Begin("vibration:weart:LEFT"));
  EXPECT_EQ(this->Bench.Device->GetName(), "WEART TouchDIVER (LEFT), vibration, not force");
  EXPECT_EQ(weart.GetStatus(), "RUNNING");
  EXPECT_TRUE(this->Knock([&] { return weart.GetVolume("LEFT") > 20.0; }));
  EXPECT_EQ(weart.GetVolume("RIGHT"), 0.0);
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_TRUE(Eventually([&] { return !weart.Get().IsOpen; }));
  EXPECT_EQ(weart.GetVolume("LEFT"), 0.0);
  EXPECT_EQ(weart.GetStatus(), "IDLE");
  EXPECT_TRUE(weart.Get().EndsStopped);
  EXPECT_EQ(weart.Get().Refused, 0);
}

TEST_F(VibrationSession, WeartThatRunsForAnotherProgramGoesOn)
{
  PlayedWeart weart({ "RIGHT" }, "RUNNING");
  ASSERT_NO_FATAL_FAILURE(this->Begin("vibration:weart"));
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_TRUE(Eventually([&] { return !weart.Get().IsOpen; }));
  EXPECT_EQ(weart.GetStatus(), "RUNNING");
}

TEST_F(VibrationSession, WeartWaitsWhileItsActuationsAreOff)
{
  PlayedWeart weart;
  ASSERT_NO_FATAL_FAILURE(this->Begin("vibration:weart"));
  weart.SetActuating(false);
  EXPECT_TRUE(this->Bench.WaitForText("actuations are switched off")) << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
  weart.SetActuating(true);
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
}

TEST_F(VibrationSession, WeartIsLostWithItsDeviceAndWithItsMiddleware)
{
  PlayedWeart weart;
  ASSERT_NO_FATAL_FAILURE(this->Begin("vibration:weart"));
  weart.SetHands({});
  this->Bench.ExpectLost("is no longer connected to WEART's middleware");
  weart.SetHands({ "RIGHT" });
  this->Bench.ExpectBack();
  weart.Die();
  EXPECT_TRUE(this->Bench.WaitForText("WEART's middleware has ended")) << this->Bench.Text();
}

TEST_F(VibrationSession, WeartsGuardStopsTheVibrationOfAProgramThatIsKilledOrStopped)
{
  for (const int signal : { SIGKILL, SIGSTOP })
  {
    PlayedWeart weart;
    GuardedProgram program("wait", "vibration:weart");
    ASSERT_TRUE(Eventually([&] { return weart.GetVolume("RIGHT") > 20.0; })) << signal;
    program.Signal(signal);
    EXPECT_TRUE(Eventually([&] { return weart.GetVolume("RIGHT") == 0.0; })) << signal;
    EXPECT_EQ(weart.Get().Refused, 0);
  }
}

TEST_F(VibrationSession, HapbeatHearsASineAndFallsSilent)
{
  PlayedHapbeat hapbeat;
  const std::string id = "vibration:hapbeat:127.0.0.1:" + std::to_string(hapbeat.GetPort());
  ListDevices();
  EXPECT_TRUE(hapbeat.Get().Messages.empty()) << "nobody has named it yet";
  ASSERT_NO_FATAL_FAILURE(this->Begin(id));
  EXPECT_EQ(this->Bench.Device->GetName(), "Hapbeat duo_wl at 127.0.0.1, vibration, not force");
  EXPECT_EQ(hapbeat.GetLoudness(), 0.0);
  EXPECT_TRUE(this->Knock([&] { return hapbeat.GetLoudness() > 0.2; }));
  EXPECT_LE(hapbeat.GetLoudness(), 0.81);
  EXPECT_TRUE(Eventually([&] { return hapbeat.GetLoudness() == 0.0; })) << "in the air again";
  EXPECT_TRUE(this->Knock([&] { return hapbeat.GetLoudness() > 0.2; }));
  this->Bench.Stop();
  this->Bench.Device->Close();
  EXPECT_TRUE(Eventually([&] { return hapbeat.Get().EndsStopped; }));
  EXPECT_EQ(hapbeat.Get().Refused, 0);
  EXPECT_EQ(hapbeat.CountLost(), 0) << "the ring of the device never overflows";
}

TEST_F(VibrationSession, HapbeatHearsOneStreamOfALevelThatFlickers)
{
  PlayedHapbeat hapbeat;
  HapbeatService service("127.0.0.1", hapbeat.GetPort());
  std::string error;
  ASSERT_TRUE(service.Connect(error)) << error;
  const auto count = [&](char type)
  {
    int packets = 0;
    for (const std::string& packet : hapbeat.Get().Messages)
    {
      packets += packet.size() > 3 && packet[3] == type ? 1 : 0;
    }
    return packets;
  };
  for (int i = 0; i < 200; ++i)
  {
    EXPECT_EQ(service.Show(i % 2 == 0 ? 0.05 : 0.03), VibrationService::State::Ready);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(Eventually([&] { return count('\x30') == 3; })) << "one, sent three times";
  EXPECT_EQ(count('\x32'), 3) << "at the beginning";
  EXPECT_TRUE(Eventually(
    [&]
    {
      service.Show(0.0);
      return count('\x32') == 6;
    }));
}

TEST_F(VibrationSession, HapbeatThatAnswersNoMoreIsLostAndComesBack)
{
  PlayedHapbeat hapbeat;
  ASSERT_NO_FATAL_FAILURE(
    this->Begin("vibration:hapbeat:127.0.0.1:" + std::to_string(hapbeat.GetPort())));
  hapbeat.SetSilent(true);
  this->Bench.ExpectLost("no longer answers");
  hapbeat.SetSilent(false);
  this->Bench.ExpectBack();
}

TEST_F(VibrationSession, ServicesAreListedWithWhatIsConnected)
{
  const auto rows = []
  {
    std::string all;
    for (const DeviceListing& listing : ListDevices())
    {
      all += Has(listing.Id, "vibration:") ? listing.Id + " " + listing.State + "\n" : "";
    }
    return all;
  };
  const auto missing = [](const std::string& kind)
  {
    for (const DeviceObstacle& obstacle : ListMissingKinds())
    {
      if (obstacle.Kind == kind)
      {
        return obstacle.Text;
      }
    }
    return std::string();
  };
  PlayedBhaptics player({ "FootL", "GloveR" });
  PlayedWeart weart({ "LEFT" });
  EXPECT_TRUE(Has(rows(), "vibration:bhaptics:GloveR available\n")) << rows();
  EXPECT_TRUE(Has(rows(), "vibration:bhaptics:FootL available\n")) << rows();
  EXPECT_TRUE(Has(rows(), "vibration:weart:LEFT available\n")) << rows();
  EXPECT_EQ(missing("vibration:bhaptics"), "");
  player.Die();
  weart.Die();
  EXPECT_TRUE(Has(missing("vibration:bhaptics"), "Start bHaptics' Player"));
  EXPECT_TRUE(Has(missing("vibration:weart"), "Start WEART's middleware"));
  EXPECT_EQ(weart.GetStatus(), "IDLE") << "to list starts nothing";
}

TEST_F(VibrationSession, IdsThatCantBeAreRefusedWithTheirCure)
{
  EXPECT_TRUE(Has(ErrorOf("vibration:bhaptics:Glove"), "Give one of vibration:bhaptics:GloveR"));
  EXPECT_TRUE(Has(ErrorOf("vibration:weart:right"), "give \"vibration:weart\""));
  EXPECT_TRUE(Has(ErrorOf("vibration:hapbeat:"), "give the address of a Hapbeat"));
  EXPECT_TRUE(Has(ErrorOf("vibration:hapbeat:127.0.0.1:x"), "give the address of a Hapbeat"));
  EXPECT_TRUE(Has(ErrorOf("vibration:hapbeat:127.0.0.1:1"), "No Hapbeat answers at 127.0.0.1"));
  for (const char* const wide : { "255.255.255.255", "224.0.0.1", "0.0.0.0", "hapbeat.local" })
  {
    EXPECT_TRUE(
      Has(ErrorOf(std::string("vibration:hapbeat:") + wide), "is not the address of one device"))
      << wide;
  }
  {
    const PlayedBhaptics player({ "GloveL" });
    EXPECT_TRUE(
      Has(ErrorOf("vibration:bhaptics:Head"), "No Head is connected to bHaptics' Player"));
    const PlayedWeart weart({ "LEFT" });
    DeviceOptions options;
    options.UseGuard = false;
    EXPECT_TRUE(Has(ErrorOf("vibration:weart:RIGHT", options), "No TouchDIVER for the hand RIGHT"));
  }
  setenv("VOLUMEHAPTICS_BHAPTICS", "no", 1);
  setenv("VOLUMEHAPTICS_WEART", "70000", 1);
  EXPECT_TRUE(Has(ErrorOf("vibration:bhaptics"), "Give the port of bHaptics' Player"));
  EXPECT_TRUE(Has(ErrorOf("vibration:weart"), "Give the port of WEART's middleware"));
  unsetenv("VOLUMEHAPTICS_BHAPTICS");
  unsetenv("VOLUMEHAPTICS_WEART");
}

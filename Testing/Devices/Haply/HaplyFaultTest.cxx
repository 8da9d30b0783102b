// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that every fault of a simulated Inverse service ends in zero force and a text.
 */

#include "HaplyRig.h"

#include <csignal>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

using namespace emulated;

namespace
{
class HaplyFaults : public HaplyTest
{
protected:
  void SetUp() override
  {
    this->Serve(Numbered());
    ASSERT_NO_FATAL_FAILURE(this->Open());
    ASSERT_NO_FATAL_FAILURE(this->Feel());
  }
};

/// Returns the reason why this computer has no Haply device, from the list of missing kinds.
std::string MissingText()
{
  std::string text;
  for (const DeviceObstacle& obstacle : ListMissingKinds())
  {
    text += obstacle.Kind == "haply" ? obstacle.Text : "";
  }
  return text;
}

std::string MakeEvent(const char* name, const char* level, const char* device, const char* message)
{
  return std::string(R"({"name":")") + name + R"(","category":"device","level":")" + level +
    R"(","data":{"device_id":")" + device + R"("},"message":")" + message + "\"}";
}
} // namespace

TEST_F(HaplyFaults, TheServiceDiesAndIsStartedAgain)
{
  this->Service->Die();
  this->Bench.ExpectLost("the Inverse service ended or closed the connection");
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitForText("does not answer at port")) << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Lost);

  this->Service.reset();
  this->Serve();
  this->Bench.ExpectBack();
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  this->Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
}

TEST_F(HaplyFaults, TheServiceFallsSilent)
{
  this->Service->Break(HaplyFault::Silent);
  this->ExpectLost("the Inverse service does not answer");
  this->Service.reset();
  this->Serve();
  this->Bench.Device->Home();
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  this->Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
}

TEST_F(HaplyFaults, TheServiceIsSlow)
{
  this->Service->Break(HaplyFault::Slow);
  // The service is slow. A force computed from an old position must not act. Once the service is
  // fast again, the client must catch up.
  EXPECT_TRUE(Eventually([&] { return Size(this->LastForce()) == 0.0; }));
  this->Service->Break(HaplyFault::None);
  EXPECT_TRUE(this->Bench.Press(
    [&]
    {
      if (this->Bench.Device->GetCondition().Stage == DeviceStage::Lost)
      {
        this->Bench.Device->Home();
      }
      this->Bench.WaitFor(DeviceStage::Ready);
      this->Bench->Arm();
    },
    [] {}, [&] { return this->IsHeld(); }));
  this->Bench.Stop();
  EXPECT_TRUE(Eventually([&] { return this->CountBehind() < 1.5; }));
}

TEST_F(HaplyFaults, TheServiceAnswersTwice)
{
  this->Bench.Stop();
  const std::size_t before = this->LastSession().Forces.size();
  this->Service->Break(HaplyFault::Twice);
  ASSERT_TRUE(Eventually([&] { return this->LastSession().Forces.size() > before + 600; }));
  // Each of 600 messages gets an additional state. A client that reads one state per message would
  // be 300 states behind.
  EXPECT_LT(this->CountBehind(), 100.0);
  this->Service->Break(HaplyFault::None);
  EXPECT_TRUE(Eventually([&] { return this->CountBehind() < 1.5; })) << this->CountBehind();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Ready) << this->Bench.Text();
}

class HaplyConnectionEnds
  : public HaplyFaults
  , public testing::WithParamInterface<HaplyFault>
{
};

TEST_P(HaplyConnectionEnds, AfterZeroForce)
{
  this->Service->Break(this->GetParam());
  this->ExpectLost("the Inverse service ended or closed the connection");
}

INSTANTIATE_TEST_SUITE_P(All, HaplyConnectionEnds,
  testing::Values(
    HaplyFault::Wrong, HaplyFault::TooLong, HaplyFault::Leaves, HaplyFault::HalfEnds));

TEST_F(HaplyFaults, TheConnectionIsReset)
{
  this->Service->Break(HaplyFault::Resets);
  this->Bench.ExpectLost("the Inverse service ended or closed the connection");
  this->Service->Break(HaplyFault::None);
  this->Bench.Device->Home();
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
}

TEST_F(HaplyFaults, TheServiceSendsPingsWithoutEnd)
{
  this->Service->Break(HaplyFault::Pings);
  this->ExpectLost("the Inverse service does not answer");
}

TEST_F(HaplyFaults, TheServiceSendsPingsWithoutEndAndReadsNothing)
{
  this->Service->Break(HaplyFault::DeafPings);
  this->Bench.ExpectLost("the Inverse service does not answer");
  this->Service->Break(HaplyFault::Silent); // the service now reads all pending messages
  EXPECT_TRUE(Eventually([&] { return Size(this->LastForce()) == 0.0; }));
}

TEST_F(HaplyFaults, ThePositionIsNoNumber)
{
  this->Service->Break(HaplyFault::NoNumber);
  this->ExpectLost("reports a position that is not a number");
}

TEST_F(HaplyFaults, TheTransformIsNoNumber)
{
  this->Service->Break(HaplyFault::NoScale);
  this->ExpectLost("reports a position that is not a number");
}

TEST_F(HaplyFaults, TheServiceSendsJunk)
{
  this->Service->Break(HaplyFault::Junk);
  this->ExpectLost("sent something that is not a JSON object");
}

TEST_F(HaplyFaults, TheServiceSendsDeepJson)
{
  this->Service->Break(HaplyFault::Deep);
  this->ExpectLost("sent JSON with too many brackets in brackets");
}

TEST_F(HaplyFaults, AnEventOfDeepJsonIsPassedOver)
{
  ASSERT_TRUE(Eventually([&] { return this->Service->CountListeners() == 1; }));
  this->Service->PushEvent("{\"data\":" + HaplyState::DeepJson() + "}");
  this->Service->PushEvent(MakeEvent("device-safety-triggered", "warning", "049D", "Stall"));
  EXPECT_TRUE(this->Bench.WaitForText("warns: Stall"));
}

TEST_F(HaplyFaults, ThePositionIsNotTold)
{
  this->Service->Break(HaplyFault::Blind);
  this->ExpectLost("does not report its position");
}

TEST_F(HaplyFaults, ThePositionIsNotToldAndTheServiceIsSlow)
{
  // The service answers slowly, so nearly always a message is unanswered.
  this->Service->Break(HaplyFault::SlowBlind);
  this->ExpectLost("does not report its position");
}

TEST_F(HaplyFaults, TheArmIsUnplugged)
{
  this->Service->Unplug();
  this->ExpectLost("was unplugged");
  this->Bench.Device->Home();
  EXPECT_TRUE(this->Bench.WaitForText("was unplugged")) << this->Bench.Text();
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Lost);
  this->Service->PlugIn();
  this->Bench.ExpectBack();
  EXPECT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  EXPECT_EQ(Size(this->LastForce()), 0.0);
  this->Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
}

TEST_F(HaplyFaults, TheCalibrationIsLost)
{
  this->Service->SetCalibrated(false);
  this->ExpectLost("has lost its calibration");
}

TEST_F(HaplyFaults, TheArmIsNotReadyAnyMore)
{
  this->Service->SetReady(false);
  this->ExpectLost("is no longer ready");
}

TEST_F(HaplyFaults, ThePositionSteps)
{
  this->Service->Shift({ 0.0, 0.3, 0.0 });
  this->ExpectLost("jumped while no hand moved it");
}

TEST_F(HaplyFaults, TheWorkspaceIsScaled)
{
  this->Service->SetTransform({}, 2.0);
  this->ExpectLost("has a scaled workspace");
  this->Bench.Device->Home();
  EXPECT_TRUE(Eventually([&] { return this->Service->GetSessions().size() == 2; }));
  EXPECT_TRUE(this->Bench.WaitForText("has a scaled workspace")) << "still";
  this->Service->SetTransform({}, 1.0);
  this->Bench.Device->Home();
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  this->Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
}

TEST_F(HaplyFaults, TheWorkspaceIsMovedUnderTheHand)
{
  this->Service->SetTransform({ 0.0, 0.001, 0.0 }, 1.0);
  this->ExpectLost("jumped while no hand moved it");
  // The new position is accepted if it persists.
  this->Bench.Device->Home();
  ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
  this->Bench.Stop();
  ASSERT_NO_FATAL_FAILURE(this->Feel());
}

TEST_F(HaplyFaults, AnEventOfTheArmStopsIt)
{
  ASSERT_TRUE(Eventually([&] { return this->Service->CountListeners() == 1; }));
  this->Service->PushEvent("no JSON");
  this->Service->PushEvent(MakeEvent("device-safety-triggered", "error", "04BA", "of another arm"));
  this->Service->PushEvent(
    MakeEvent("device-safety-triggered", "warning", "049D", "Motor stall detected"));
  EXPECT_TRUE(this->Bench.WaitForText("warns: Motor stall detected"));
  EXPECT_TRUE(this->Bench.Press([] {}, [] {}, [&] { return this->IsHeld(); })) << "it goes on";
  this->Service->PushEvent(
    MakeEvent("device-safety-triggered", "error", "049D", "Emergency brake engaged"));
  this->ExpectLost("was stopped by the Inverse service: Emergency brake engaged.");
}

TEST_F(HaplyFaults, TheEventsEndWithAWord)
{
  ASSERT_TRUE(Eventually([&] { return this->Service->CountListeners() == 1; }));
  this->Service->DropListeners();
  EXPECT_TRUE(this->Bench.WaitForText("goes on without the Inverse service's warnings"));
  EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Ready);
  EXPECT_TRUE(this->Bench.Press([] {}, [] {}, [&] { return this->IsHeld(); })) << "it goes on";
  this->Bench.Device->Home();
  EXPECT_TRUE(Eventually([&] { return this->Service->CountListeners() == 1; }));
}

TEST_F(HaplyFaults, AnotherSessionTakesTheArm)
{
  ASSERT_TRUE(Eventually([&] { return this->Service->CountListeners() == 1; }));
  this->Service->PushEvent(MakeEvent("device-busy", "warning", "049D", ""));
  this->ExpectLost("was stopped by the Inverse service: device-busy");
}

TEST_F(HaplyFaults, TheServoStandsStill)
{
  this->Bench.Stop();
  EXPECT_TRUE(Eventually([&] { return Size(this->LastForce()) == 0.0; }));
}

/// Before the service starts, any user of this computer can listen at its port.
TEST(HaplyErrors, AnotherUsersProgramIsNotAsked)
{
  if (geteuid() != 0)
  {
    GTEST_SKIP() << "takes a process of another user";
  }
  int ports[2];
  ASSERT_EQ(pipe(ports), 0);
  const pid_t other = fork();
  if (other == 0)
  {
    constexpr uid_t otherUser = 12345;
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof(address);
    const bool isOther = setuid(otherUser) == 0;
    const int listener = socket(AF_INET, SOCK_STREAM, 0);
    const bool isListening = isOther &&
      bind(listener, reinterpret_cast<sockaddr*>(&address), size) == 0 &&
      listen(listener, 4) == 0 &&
      getsockname(listener, reinterpret_cast<sockaddr*>(&address), &size) == 0;
    const int port = isListening ? ntohs(address.sin_port) : 0;
    (void)!write(ports[1], &port, sizeof(port));
    pause();
    _exit(0);
  }
  int port = 0;
  ASSERT_EQ(read(ports[0], &port, sizeof(port)), static_cast<ssize_t>(sizeof(port)));
  setenv("VOLUMEHAPTICS_HAPLY", std::to_string(port).c_str(), 1);
  EXPECT_TRUE(Has(ErrorOf("haply"), "belongs to another user (number 12345)")) << ErrorOf("haply");
  unsetenv("VOLUMEHAPTICS_HAPLY");
  kill(other, SIGKILL);
  waitpid(other, nullptr, 0);
  close(ports[0]);
  close(ports[1]);
}

TEST(HaplyErrors, SayWhatToDo)
{
  // Find a free port: that of a service that has just ended.
  emulated::HaplyShape shape;
  {
    const HaplyService service(shape);
  }
  EXPECT_TRUE(ListDevices().empty());
  EXPECT_TRUE(Has(MissingText(), "does not answer at port")) << MissingText();
  EXPECT_TRUE(Has(MissingText(), "Start Haply's Hub"));
  EXPECT_TRUE(Has(ErrorOf("haply"), "Start Haply's Hub")) << ErrorOf("haply");
  setenv("VOLUMEHAPTICS_HAPLY", "10001,events", 1);
  EXPECT_TRUE(Has(ErrorOf("haply"), "Give the ports")) << ErrorOf("haply");
  for (const char* const ports : { "65536", "10001,", "1,2,http", "1,2,3,4" })
  {
    setenv("VOLUMEHAPTICS_HAPLY", ports, 1);
    EXPECT_TRUE(Has(ErrorOf("haply"), "Give the ports")) << ports;
  }
  EXPECT_TRUE(Has(ErrorOf("haply:"), "is not a device id"));
  {
    const HaplyService service(shape);
    EXPECT_EQ(MissingText(), "") << "a service that runs";
    EXPECT_TRUE(Has(ErrorOf("haply:7777"), "It has haply:049D, haply:04BA"))
      << ErrorOf("haply:7777");
  }
  {
    HaplyShape listless;
    listless.HasDeviceList = false;
    const HaplyService service(listless);
    EXPECT_TRUE(ListDevices().empty());
    EXPECT_TRUE(Has(MissingText(), "Start it again")) << MissingText();
  }
  {
    shape.Version = "4.0.0";
    const HaplyService service(shape);
    EXPECT_TRUE(Has(ErrorOf("haply"), "is of version 4.0")) << ErrorOf("haply");
    EXPECT_TRUE(ListDevices().empty());
  }
  {
    shape.Version = "main";
    const HaplyService service(shape);
    EXPECT_TRUE(Has(ErrorOf("haply"), "does not report its version")) << ErrorOf("haply");
  }
  shape.Version = "3.5.0";
  {
    shape.VersionNotes = HaplyState::DeepJson();
    const HaplyService service(shape);
    EXPECT_TRUE(Has(ErrorOf("haply"), "too many brackets in brackets")) << ErrorOf("haply");
  }
  {
    shape.VersionNotes = "\"" + std::string(2 << 20, 'x') + "\"";
    const HaplyService service(shape);
    EXPECT_TRUE(Has(ErrorOf("haply"), "body limit exceeded")) << ErrorOf("haply");
  }
  unsetenv("VOLUMEHAPTICS_HAPLY");
}

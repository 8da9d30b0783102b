// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests an application in which a hand presses an arm of an emulated Inverse service onto the
 * phantom's face. Haply's y axis points forward, into the face.
 */

#include "Emulators/HaplyService.h"
#include "OverflowRig.h"

#include <filesystem>
#include <fstream>
#include <numeric>
#include <optional>
#include <sstream>

using namespace emulated;

namespace
{
class PhantomHaply : public testing::Test
{
protected:
  PhantomHaply()
  {
    std::filesystem::create_directories(std::filesystem::path(this->Memory).parent_path());
    setenv("VOLUMEHAPTICS_DEVICES", this->Memory.c_str(), 1);
    this->Remember("haply:049D confirmed=2026-11-01\n");
  }
  ~PhantomHaply() override
  {
    unsetenv("VOLUMEHAPTICS_HAPLY");
    unsetenv("VOLUMEHAPTICS_DEVICES");
  }
  void Remember(const char* text) const { std::ofstream(this->Memory) << text; }

  bool LeadTo(double beyond)
  {
    this->Service->SetGoal({ 0.0, beyond, 0.0 });
    return Eventually([&] { return std::abs(this->Service->GetTip()[1] - beyond) < 0.002; });
  }
  void OpenAndPress()
  {
    ASSERT_TRUE(this->Device->Open("haply"));
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::READY)) << this->Device->GetStatusText();
    this->Device->Arm();
    EXPECT_TRUE(this->Log.Errors.empty());
    ASSERT_NO_FATAL_FAILURE(this->Press());
  }
  void Press()
  {
    const auto isFelt = [&]
    {
      this->Device->UpdateState();
      const double force = -this->Device->GetState()->GetForce()[1];
      const double shown = -this->Service->GetForce()[1];
      const double spring = EmulatedHand::Stiffness * (Depth - this->Service->GetTip()[1]);
      return force > 0.1 && std::abs(shown - force) < 0.05 && std::abs(spring - force) < 0.1;
    };
    bool felt = false;
    // On a busy machine, the servo may pause, after which the force starts again from zero, so
    // retry.
    for (int attempt = 0; attempt < 5 && !felt; ++attempt)
    {
      ASSERT_TRUE(this->LeadTo(-0.01));
      this->Service->SetGoal({ 0.0, Depth, 0.0 });
      for (int i = 0; i < 2000 && !(felt = isFelt()); ++i)
      {
        this->Hand.WaitTicks(1);
      }
    }
    EXPECT_TRUE(felt) << this->Service->GetForce()[1] << " N, told "
                      << this->Device->GetState()->GetForce()[1];
    EXPECT_NE(this->Device->GetState()->GetContact(), 0);
  }

  static constexpr double Depth = 0.004; // m, goal behind the skin
  const std::string Memory = TemporaryPath("haply/devices.txt");
  emulated::Phantom Phantom;
  std::optional<HaplyService> Service{ std::in_place };
  PhantomHand Hand{ this->Phantom, 2, 1.0 };
  vtkHapticDevice* const Device = this->Hand.Device;
  apitest::MessageLog Log{ this->Device };
};
} // namespace

TEST_F(PhantomHaply, IsFeltLostAndFeltAgain)
{
  ASSERT_NO_FATAL_FAILURE(this->OpenAndPress());
  EXPECT_TRUE(this->Hand.WaitTicks(2000));

  this->Service->Die();
  EXPECT_TRUE(this->Hand.WaitFor(vtkHapticDevice::FAULT));
  EXPECT_TRUE(this->Hand.Says("ended or closed the connection")) << this->Device->GetStatusText();
  EXPECT_TRUE(this->Hand.WaitTicks(5));
  EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
  this->Service.reset();
  this->Service.emplace();
  // The device must be opened again automatically.
  ASSERT_TRUE(this->Hand.Wait([&] { return this->Hand.Says("is back. Arm() again"); }))
    << this->Device->GetStatusText();
  EXPECT_TRUE(this->Hand.WaitTicks(100));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::FAULT) << "no force comes back by itself";
  EXPECT_EQ(Length(this->Service->GetForce().data()), 0.0);

  this->Device->Arm();
  ASSERT_NO_FATAL_FAILURE(this->Press());
  const double half = std::sqrt(0.5);
  ASSERT_TRUE(this->Device->GetState()->HasTipOrientation());
  const std::vector<double> start(this->Device->GetState()->GetTipOrientation(),
    this->Device->GetState()->GetTipOrientation() + 4);
  this->Service->SetGrip({ half, 0.0, 0.0, half }, false);
  EXPECT_TRUE(this->Hand.Wait(
    [&]
    {
      // The arm is rotated by 90 degrees about the vertical, and so is the handle in world
      // coordinates. The product of the two quaternions is the cosine of half of the angle.
      const double* const turn = this->Device->GetState()->GetTipOrientation();
      const double same = std::inner_product(start.begin(), start.end(), turn, 0.0);
      return std::abs(std::abs(same) - half) < 1e-6;
    }));
  this->Device->Close();
  EXPECT_EQ(Length(this->Service->GetForce().data()), 0.0);
  const HaplySession session = this->Service->GetSessions().back();
  EXPECT_EQ(Length(session.Forces.front().data()), 0.0);
  EXPECT_EQ(Length(session.Forces.back().data()), 0.0);
}

TEST_F(PhantomHaply, TheFirstArmingIsGentle)
{
  this->Remember("");
  ASSERT_TRUE(this->Device->Open("haply"));
  ASSERT_TRUE(this->Device->Start());
  ASSERT_TRUE(this->Hand.WaitFor(vtkHapticDevice::READY)) << this->Device->GetStatusText();
  ASSERT_TRUE(this->LeadTo(Depth)) << "in the skin, which is not felt";
  EXPECT_FALSE(this->Device->GetSignsConfirmed());
  this->Device->Arm();
  EXPECT_TRUE(this->Hand.Wait([&] { return this->Hand.Says("Confirming the signs"); }))
    << this->Device->GetStatusText();
  ASSERT_TRUE(this->Hand.Wait([&] { return this->Device->GetSignsConfirmed(); }))
    << this->Device->GetStatusText();
  // Until the signs are confirmed, the limit is a tenth of 2 N.
  double largest = 0.0;
  for (const Triple& force : this->Service->GetSessions().back().Forces)
  {
    largest = std::max(largest, Length(force.data()));
  }
  EXPECT_GT(largest, 0.0);
  EXPECT_LE(largest, 0.2 + 1e-9);
  std::ostringstream memory;
  memory << std::ifstream(this->Memory).rdbuf();
  EXPECT_NE(memory.str().find("haply:049D confirmed=20"), std::string::npos) << memory.str();
  ASSERT_NO_FATAL_FAILURE(this->Press());
}

TEST_F(PhantomHaply, AStackThatOverflowsLeavesNoForce)
{
  EXPECT_EQ(OverflowDeviceThread(this->Hand, "haply",
              [this](bool isIn) {
                this->Service->SetGoal({ 0.0, isIn ? Depth : -0.01, 0.0 });
              }),
    SIGSEGV);
  EXPECT_TRUE(Eventually([&] { return Length(this->Service->GetForce().data()) == 0.0; }))
    << Length(this->Service->GetForce().data());
}

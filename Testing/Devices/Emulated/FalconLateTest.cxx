// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests an answer that arrives a round late, as libnifalcon describes (see FalconModel.h). Driver
 * and device must soon be synchronised again, instead of staying a round apart.
 */

#include "Rigs/FalconRig.h"

using namespace emulated;

namespace
{
class FalconLate : public FalconTest
{
protected:
  ~FalconLate() override { this->Falcon.SetTimed(false); }

  /**
   * Writes forces at more than 1 kHz, like a fast servo, until the device has received `packets`
   * packets.
   */
  bool PushFor(long packets)
  {
    const long end = this->Falcon.GetPackets() + packets;
    const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(30);
    while (this->Falcon.GetPackets() < end && std::chrono::steady_clock::now() < limit)
    {
      DeviceSample sample;
      this->Device->Read(0.001, sample);
      this->Device->Write({ 0.0, 0.0, 1.0 });
      std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    return this->Falcon.GetPackets() >= end;
  }
};
} // namespace

TEST_F(FalconLate, OneAnswerDoesNotStayARoundBehind)
{
  this->MakeReady();
  this->Falcon.SetTimed(true);
  ASSERT_TRUE(this->PushFor(50));
  ASSERT_GT(this->Falcon.GetInStep(), 20) << "the driver waits for each answer";
  // On a busy machine, a pause of a whole period looks like a silent line, so some of the ten
  // attempts may fail.
  int inStep = 0;
  for (int i = 0; i < 10; ++i)
  {
    this->Falcon.Break(FalconFault::LateAnswer, 1);
    ASSERT_TRUE(this->PushFor(100));
    inStep += this->Falcon.GetInStep() > 50 ? 1 : 0;
    EXPECT_EQ(this->Device->GetCondition().Stage, DeviceStage::Ready) << this->GetText();
  }
  EXPECT_GE(inStep, 6);
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the servo fades out the force and reports a fault if the program stops updating the
 * device while a hand is held.
 */

#include "Rigs/DeviceRig.h"

#include <vtkDataArray.h>
#include <vtkTable.h>

#include <chrono>
#include <limits>
#include <thread>

using namespace devicetest;

namespace
{
class Attention : public DeviceTest
{
protected:
  /// Makes no calls for a while, and returns whether the servo has released the hand. Retries with
  /// longer times, because the servo's loop may have had no processor.
  bool IsLetGo(std::chrono::milliseconds silence = std::chrono::milliseconds(400))
  {
    for (int i = 0; i < 5; ++i, silence *= 2)
    {
      std::this_thread::sleep_for(silence);
      this->Device->UpdateState();
      if (this->Device->GetStatus() == vtkHapticDevice::FAULT)
      {
        return true;
      }
    }
    return false;
  }
};
} // namespace

TEST_F(Attention, AnUnattendedForceFadesAndIsArmedAgain)
{
  vtkNew<vtkTable> table;
  this->BeginPressed();
  this->Device->GetState()->Drain(table);
  this->Device->SetAttentionTime(0.2);
  ASSERT_TRUE(this->IsLetGo()) << this->Device->GetStatusText();
  EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
  EXPECT_NE(this->Device->GetStatusText().find("AttentionTime"), std::string::npos);
  EXPECT_NE(this->Device->GetStatusText().find("Arm() again"), std::string::npos);
  this->Device->GetState()->Drain(table);
  auto* const command = vtkDataArray::SafeDownCast(table->GetColumnByName("Command"));
  ASSERT_TRUE(command && command->GetNumberOfTuples() > 100);
  int falling = 0;
  for (vtkIdType i = 1; i < command->GetNumberOfTuples(); ++i)
  {
    const double now = Length(command->GetTuple3(i));
    const double before = Length(command->GetTuple3(i - 1));
    EXPECT_LE(std::abs(now - before), 0.5 + 1e-9);
    falling += now > 0.0 && now < before;
  }
  EXPECT_GE(falling, 40) << "it fades rather than ends";
  ASSERT_TRUE(this->WaitTicks(100));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::FAULT) << "it does not resume by itself";
  this->Device->SetAttentionTime(60.0);
  this->Device->Arm();
  // The force starts again, with the proxy at the tip.
  EXPECT_TRUE(this->PressAgain());
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
}

TEST_F(Attention, IsAskedForByDefault)
{
  EXPECT_EQ(this->Device->GetAttentionTime(), 2.0);
  this->BeginPressed();
  ASSERT_TRUE(this->IsLetGo(std::chrono::milliseconds(2100))) << this->Device->GetStatusText();
  EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
}

TEST_F(Attention, IsNotAskedForWithZero)
{
  this->Device->SetAttentionTime(1e-6);
  EXPECT_EQ(this->Device->GetAttentionTime(), 0.05);
  for (const double never : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN() })
  {
    this->Device->SetAttentionTime(never);
    EXPECT_EQ(this->Device->GetAttentionTime(), 0.0);
  }
  this->BeginPressed();
  std::this_thread::sleep_for(std::chrono::milliseconds(2300));
  this->Device->UpdateState();
  EXPECT_NE(this->Device->GetStatus(), vtkHapticDevice::FAULT);
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/// Expects that a display receives every state exactly once, in order, and with its position.

#include "Rigs/RecordingRig.h"

#include <vtkTable.h>

using namespace devicetest;

namespace
{
class States : public Recording
{
protected:
  double At(const char* column, vtkIdType row, int component = 0)
  {
    return vtkDataArray::SafeDownCast(this->Table->GetColumnByName(column))
      ->GetComponent(row, component);
  }
  /// Drains at least `least` states, and expects them to be consecutive.
  void Take(int least)
  {
    for (vtkIdType taken = 0; taken < least;)
    {
      ASSERT_TRUE(this->WaitTicks(3));
      this->Device->GetState()->Drain(this->Table);
      for (vtkIdType i = 0; i < this->Table->GetNumberOfRows(); ++i)
      {
        const double tick = this->At("Tick", i);
        if (this->Last >= 0.0)
        {
          ASSERT_EQ(tick, this->Last + 1.0);
        }
        this->Last = tick;
        this->LargestForce = std::max(this->LargestForce, this->At("NormalForce", i));
      }
      taken += this->Table->GetNumberOfRows();
    }
  }

  vtkNew<vtkTable> Table;
  double Last = -1.0;
  double LargestForce = 0.0;
};
} // namespace

TEST_F(States, ComeOnceAndInOrderAlsoWhileRecording)
{
  this->Device->GetState()->Drain(this->Table);
  EXPECT_EQ(this->Table->GetNumberOfRows(), 0) << "nothing runs";
  EXPECT_TRUE(this->Table->GetColumnByName("NormalForce"));
  this->Device->GetState()->Drain(nullptr);
  this->Begin();
  this->Device->GetState()->Drain(this->Table);
  this->Wander(5);
  this->Take(20);
  this->StartRecording();
  this->Wander(10);
  this->Take(40);
  this->ExpectSame();
  EXPECT_GT(this->LargestForce, 0.2);

  this->Begin();
  this->Last = -1.0;
  this->Device->GetState()->Drain(this->Table);
  this->Take(10);
  EXPECT_LT(this->Last, 1e5) << "a new count";
}

TEST_F(States, ComeToEveryReader)
{
  this->Begin();
  vtkNew<vtkTable> others;
  double last = -1.0;
  for (int take = 0; take < 3; ++take)
  {
    this->Device->GetState()->Drain(others, 1);
    for (vtkIdType i = 0; i < others->GetNumberOfRows(); ++i, ++last)
    {
      const double tick = others->GetValue(i, 1).ToDouble();
      last = last < 0.0 ? tick - 1.0 : last;
      ASSERT_EQ(tick, last + 1.0);
    }
    EXPECT_GE(last, this->Last);
    this->Take(10);
  }
  this->Device->GetState()->Drain(nullptr, 1); // from now on, states for this reader are discarded
  this->Take(10);
  this->Device->GetState()->Drain(others, 1);
  const double first = others->GetNumberOfRows() ? others->GetValue(0, 1).ToDouble() : VTK_INT_MAX;
  EXPECT_GT(first, this->Last);
}

TEST_F(States, GoOnAfterARecording)
{
  this->Begin();
  this->Device->GetState()->Drain(this->Table);
  this->Take(5);
  this->StartRecording();
  this->Take(5);
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  this->Take(20);
}

TEST_F(States, AreWhereTheDeviceWas)
{
  this->Begin();
  this->Device->GetState()->Drain(this->Table);
  ASSERT_TRUE(this->WaitTicks(3));
  for (int i = 1; i < 30; ++i)
  {
    this->Turn(12.0 * i, 0.5 * i); // publishes before the earlier states are drained
    if (i % 3 == 0)
    {
      this->Device->UpdateState();
    }
  }
  const double* const tip = this->Device->GetState()->GetTipPosition();
  ASSERT_TRUE(this->WaitTicks(3));
  this->Device->GetState()->Drain(this->Table);
  ASSERT_GT(this->Table->GetNumberOfRows(), 1);
  // The hand rests, so the first state has the tip at the first placement, and the last state has
  // it at the last placement.
  EXPECT_NEAR(this->At("Tip", 0, 0), 7.0, 1e-9);
  EXPECT_NEAR(this->At("Tip", 0, 2), 5.0, 1e-9);
  const vtkIdType last = this->Table->GetNumberOfRows() - 1;
  EXPECT_NEAR(this->At("Tip", last, 0), tip[0], 1e-9);
  EXPECT_NEAR(this->At("Tip", last, 1), tip[1], 1e-9);
}

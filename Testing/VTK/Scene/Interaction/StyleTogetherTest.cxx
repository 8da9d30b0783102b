// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests two styles with one device, as for two windows that display one volume. Each style must
 * receive every state and every event.
 */

#include "StyleRig.h"

#include <vtkGenericRenderWindowInteractor.h>

using namespace scenetest;

namespace
{
/// Expects that a style's states contain every tick exactly once.
struct Follower
{
  vtkInteractorStyleHaptic* Style;
  double Last = -1.0;
  int News = 0;

  void Update()
  {
    this->News += this->Style->UpdateHaptics();
    vtkTable* const states = this->Style->GetStates();
    auto* const ticks = vtkDataArray::SafeDownCast(states->GetColumnByName("Tick"));
    for (vtkIdType i = 0; ticks && i < ticks->GetNumberOfTuples(); ++i)
    {
      const double tick = ticks->GetComponent(i, 0);
      ASSERT_TRUE(this->Last < 0.0 || tick == this->Last + 1.0) << this->Last << ", " << tick;
      this->Last = tick;
    }
  }
};

class StyleTogether : public StyleTest
{
protected:
  StyleTogether()
  {
    this->OtherWindow->SetOffScreenRendering(1);
    this->OtherInteractor->SetRenderWindow(this->OtherWindow);
    this->Other->SetDevice(this->Device);
    this->OtherInteractor->SetInteractorStyle(this->Other);
    vtkNew<vtkCallbackCommand> note;
    note->SetClientData(&this->OtherEvents);
    note->SetCallback([](vtkObject*, unsigned long event, void* events, void*)
      { static_cast<std::vector<unsigned long>*>(events)->push_back(event); });
    using S = vtkInteractorStyleHaptic;
    for (const unsigned long event :
      { S::ContactBeginEvent, S::ContactEndEvent, S::ArmedEvent, S::DisarmedEvent, S::FaultEvent })
    {
      this->Other->AddObserver(event, note);
    }
  }
  ~StyleTogether() override { this->OtherInteractor->SetInteractorStyle(nullptr); }

  vtkNew<vtkRenderWindow> OtherWindow;
  vtkNew<vtkGenericRenderWindowInteractor> OtherInteractor;
  vtkNew<vtkInteractorStyleHaptic> Other;
  std::vector<unsigned long> OtherEvents;
};
} // namespace

TEST_F(StyleTogether, EachGetsEveryStateAndEvent)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  Follower first{ this->Style };
  Follower second{ this->Other };
  first.Update();
  second.Update();
  this->Pointer(150, 150);
  this->Style->TouchModeOn();
  for (int i = 0; i < 20; ++i)
  {
    this->Pointer(
      150, 150, i < 10 ? vtkCommand::MouseWheelForwardEvent : vtkCommand::MouseWheelBackwardEvent);
    const vtkIdType end = this->Device->GetState()->GetTick() + 10;
    ASSERT_TRUE(Eventually(
      [&]
      {
        first.Update();
        second.Update();
        return this->Device->GetState()->GetTick() >= end;
      }));
  }
  this->Press("Escape");
  ASSERT_TRUE(Eventually(
    [&]
    {
      first.Update();
      second.Update();
      return !this->Events.empty() && !this->OtherEvents.empty() &&
        this->Events.back() == vtkInteractorStyleHaptic::DisarmedEvent &&
        this->OtherEvents.back() == vtkInteractorStyleHaptic::DisarmedEvent;
    }));
  EXPECT_GT(first.Last, 100.0);
  EXPECT_GT(second.Last, 100.0);
  EXPECT_EQ(this->Events, this->OtherEvents);
  EXPECT_GE(this->Events.size(), 2U);
  EXPECT_GT(first.News, 10);
  EXPECT_GT(second.News, 10) << "states that the other one has looked at are new to this one";
}

TEST_F(StyleTogether, EachHasANumberOfItsOwn)
{
  // The two styles are the readers 0 and -1, so the next readers are -2 and -3.
  EXPECT_EQ(this->Device->GetState()->AddReader(), -2);
  EXPECT_EQ(this->Device->GetState()->AddReader(), -3);
  this->Device->GetState()->RemoveReader(-2);
  EXPECT_EQ(this->Device->GetState()->AddReader(), -2);
  this->Other->SetDevice(nullptr);
  EXPECT_EQ(this->Device->GetState()->AddReader(), -1);
  vtkNew<vtkHapticDevice> fresh;
  this->Other->SetDevice(fresh);
  EXPECT_EQ(fresh->GetState()->AddReader(), -1) << "the only style has 0";
}

TEST_F(StyleTogether, ADeviceThatAStyleLeavesIsDisarmed)
{
  ASSERT_NO_FATAL_FAILURE(this->PushIn());
  this->Run(5);
  ASSERT_GE(this->Device->GetStatus(), vtkHapticDevice::ARMED);
  vtkNew<vtkHapticDevice> other;
  this->Style->SetDevice(other);
  EXPECT_TRUE(Eventually(
    [this]
    {
      this->Device->UpdateState();
      return this->Device->GetStatus() < vtkHapticDevice::ARMED;
    }));
}

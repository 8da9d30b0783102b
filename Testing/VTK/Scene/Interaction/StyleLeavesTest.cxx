// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that a style that leaves its interactor leaves no observers, and no force, because no user
 * moves the tip any more.
 */

#include "StyleRig.h"

#include "Rigs/EventCounter.h"

#include <vtkGenericRenderWindowInteractor.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkInteractorStyleTrackballCamera.h>

using namespace scenetest;

using StyleLeaves = StyleTest;

TEST_F(StyleLeaves, DisarmsForAnotherStyle)
{
  this->PushIn();
  this->Run(5);
  ASSERT_GE(this->Device->GetStatus(), vtkHapticDevice::ARMED);
  const apitest::EventCounter changes(this->Style, vtkCommand::ModifiedEvent);

  vtkNew<vtkInteractorStyleTrackballCamera> other;
  this->Interactor->SetInteractorStyle(other);
  EXPECT_FALSE(this->Style->GetTouchMode());
  EXPECT_GT(changes.Count, 0);
  this->Run(5);
  EXPECT_LT(this->Device->GetStatus(), vtkHapticDevice::ARMED);
  EXPECT_TRUE(this->Device->IsRunning());

  this->Interactor->SetInteractorStyle(this->Style);
  this->Run(5);
  EXPECT_LT(this->Device->GetStatus(), vtkHapticDevice::ARMED) << "only the user may";
}

TEST_F(StyleLeaves, TellsOfNoForceAtOnce)
{
  vtkNew<vtkHapticHeadUpDisplay> display;
  display->SetDevice(this->Device);
  this->PushIn();
  this->Run(5);
  ASSERT_GT(Length(this->Device->GetState()->GetForce()), 0.3) << "N";
  EXPECT_NE(display->GetText().find(" N"), std::string::npos) << display->GetText();
  vtkNew<vtkInteractorStyleTrackballCamera> other;
  this->Interactor->SetInteractorStyle(other);
  // The removed style no longer updates the device, so it must have disarmed it.
  EXPECT_EQ(Length(this->Device->GetState()->GetForce()), 0.0);
  EXPECT_LT(this->Device->GetStatus(), vtkHapticDevice::ARMED);
  EXPECT_EQ(display->GetText().find(" N"), std::string::npos) << display->GetText();
}

TEST_F(StyleLeaves, LeavesNoObserverWithoutTimers)
{
  // an interactor whose timers the application manages
  vtkNew<vtkGenericRenderWindowInteractor> generic;
  generic->SetRenderWindow(this->Window);
  {
    vtkNew<vtkInteractorStyleHaptic> style;
    generic->SetInteractorStyle(style);
    generic->SetInteractorStyle(nullptr);
  }
  EXPECT_FALSE(generic->HasObserver(vtkCommand::TimerEvent));
  generic->InvokeEvent(vtkCommand::TimerEvent);
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the style in a real event loop. This test is a separate program, because VTK's X11
 * interactors that never ran a loop leave a dangling pointer in the list that every loop traverses.
 */

#include "StyleRig.h"

using namespace scenetest;

using StyleLoop = StyleTest;

TEST_F(StyleLoop, IsDrivenByTheInteractorsLoop)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Interactor->Initialize();
  vtkNew<vtkCallbackCommand> count;
  int updates = 0;
  count->SetClientData(&updates);
  count->SetCallback(
    [](vtkObject* style, unsigned long, void* updates, void*)
    {
      if (++*static_cast<int*>(updates) == 20)
      {
        static_cast<vtkInteractorStyle*>(style)->GetInteractor()->TerminateApp();
      }
    });
  this->Style->AddObserver(vtkInteractorStyleHaptic::StatesEvent, count);
  this->Interactor->Start(); // runs the loop, which ends after 20 updates
  EXPECT_EQ(updates, 20);
}

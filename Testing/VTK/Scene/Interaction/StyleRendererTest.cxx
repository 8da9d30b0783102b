// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that in a window with several renderers, the renderer that the application has chosen is
 * touched, starting with the first key.
 */

#include "StyleRig.h"

using namespace scenetest;

using StyleRenderer = StyleTest;

TEST_F(StyleRenderer, DefaultOneIsTouchedBeforeAnyButton)
{
  vtkNew<vtkRenderer> beside;
  beside->SetViewport(0.5, 0.0, 1.0, 1.0);
  beside->SetActiveCamera(this->Renderer->GetActiveCamera());
  this->Window->AddRenderer(beside);
  this->Style->SetDefaultRenderer(beside);
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  // the middle of `beside`, and 15 mm from the middle of the first renderer
  this->Pointer(225, 150);
  this->Style->TouchModeOn();
  this->Run(20);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[0], 0.0, 0.3);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[1], 0.0, 0.3);
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[2], 30.0, 5.0);
}

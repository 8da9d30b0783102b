// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that rotating a device's cap rotates the volume, and that the hand keeps its position on
 * the screen.
 */

#include "Rigs/PlayedHardware.h"
#include "StyleRig.h"

using namespace scenetest;

using StyleTurn = StyleTest;

TEST_F(StyleTurn, TheVolumeTurnsWithTheCap)
{
  PlayedHardware::Add();
  PlayedHardware& played = PlayedHardware::Get();
  ASSERT_TRUE(this->Device->Open("played:0"));
  ASSERT_TRUE(this->Device->Start());
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  this->Run(10);
  EXPECT_EQ(camera->GetPosition()[0], 0.0) << "not turned yet";

  played.Turn = 2.0;
  double angle = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    const double before = this->Device->GetState()->GetTime();
    this->Style->UpdateHaptics();
    const double time = this->Device->GetState()->GetTime() - before;
    angle += this->Device->GetState()->GetTurnRate()[1] * std::min(time, 0.1);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  played.Turn = 0.0;
  ASSERT_GT(angle, 0.1);
  // If the front of the scene rotates to the right, the eye must move to the left.
  const double* const eye = camera->GetPosition();
  EXPECT_NEAR(eye[0], -200.0 * std::sin(angle), 1e-6);
  EXPECT_NEAR(eye[1], 0.0, 1e-6);
  EXPECT_NEAR(eye[2], 200.0 * std::cos(angle), 1e-6);
  EXPECT_NEAR(camera->GetViewUp()[1], 1.0, 1e-9);

  // The workspace must follow the camera: the device's z axis points towards the eye.
  this->Run(10);
  const vtkMatrix4x4* const place = this->Device->GetDeviceToWorld();
  ASSERT_NE(place, nullptr);
  EXPECT_NEAR(place->GetElement(0, 2), 1000.0 / 200.0 * eye[0], 1e-6);
  EXPECT_NEAR(place->GetElement(2, 2), 1000.0 / 200.0 * eye[2], 1e-6);
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that a surface that changes during a touch reaches the servo. */

#include "StyleRig.h"

#include <vtkSphereSource.h>

using namespace scenetest;

TEST_F(StyleTest, ASurfaceThatShrinksIsNoLongerTouched)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(30.0);
  sphere->SetThetaResolution(40);
  sphere->SetPhiResolution(40);
  this->Filter->SetSurfaceConnection(sphere->GetOutputPort());
  this->Filter->SetMethodToSurfaceProxy();
  ASSERT_TRUE(this->Device->Open("virtual"));
  this->Device->GetVirtualHand()->SetPosition(0.0, 0.0, 40.0);
  ASSERT_TRUE(this->Device->Start());
  this->Run(3);
  this->Device->GetVirtualHand()->SetPosition(0.0, 0.0, 28.0);
  ASSERT_TRUE(Eventually(
    [this]
    {
      this->Style->UpdateHaptics();
      return this->Device->GetState()->GetNormalForce() > 0.9;
    }));
  sphere->SetRadius(20.0);
  EXPECT_TRUE(Eventually(
    [this]
    {
      this->Style->UpdateHaptics();
      return this->Device->GetState()->GetNormalForce() == 0.0 &&
        this->Device->GetState()->GetContact() == 0;
    }));
}

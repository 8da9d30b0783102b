// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects that hidden tissue is not felt: when the soft tissue becomes invisible, the hand on the
// skin must move through to the skull and rest there.
#include "TouchedHead.h"

#include "vtkPiecewiseFunction.h"
#include "vtkRegressionTestImage.h"

#include <iostream>

namespace
{
/// The most recent state with a force; zero if something is wrong.
struct Felt
{
  double OnSkin = 0.0;
  double OnSkull = 0.0;
  const char* Wrong = nullptr;
};

Felt PressThroughTheSkin(TouchedHead& head, vtkPiecewiseFunction* opacity)
{
  vtkHapticDevice* const device = head.Touch.Device;
  Felt felt;
  head.Press(165, 160, 2);
  felt.OnSkin = device->GetState()->GetSurfaceValue();
  if (device->GetState()->GetContact() == 0)
  {
    felt.Wrong = "the skin is not touched";
    return felt;
  }
  opacity->RemoveAllPoints();
  opacity->AddPoint(300.0, 0.0);
  opacity->AddPoint(600.0, 1.0);
  head.Run(20);
  if (device->GetState()->GetContact() != 0)
  {
    felt.Wrong = "the skin is still felt";
    return felt;
  }
  for (int i = 0; i < 12 && device->GetState()->GetContact() == 0; ++i)
  {
    head.Event(165, 160, vtkCommand::MouseWheelForwardEvent);
    head.Run(30);
  }
  felt.OnSkull = device->GetState()->GetSurfaceValue();
  if (device->GetState()->GetContact() == 0 || felt.OnSkull < felt.OnSkin + 100.0)
  {
    felt.Wrong = "the skull is not felt";
  }
  return felt;
}
} // namespace

int TestTouchHidden(int argc, char* argv[])
{
  TouchedHead head(argc, argv, Explore::MapperChoice::GPU);
  vtkPiecewiseFunction* const opacity = head.Touch.Scene.Look->GetScalarOpacity();
  vtkNew<vtkPiecewiseFunction> all;
  all->DeepCopy(opacity);
  Felt felt;
  head.TouchAt(165, 160,
    [&]
    {
      opacity->DeepCopy(all);
      head.Run(20);
      felt = PressThroughTheSkin(head, opacity);
    });
  if (felt.Wrong)
  {
    std::cerr << felt.Wrong << ": contact " << head.Touch.Device->GetState()->GetContact()
              << ", values " << felt.OnSkin << " and " << felt.OnSkull << "\n";
    return EXIT_FAILURE;
  }
  vtkRenderWindow* const window = head.Touch.Scene.Window;
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}

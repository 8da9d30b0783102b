// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects that hand and eye meet the same surface first: along the line of sight, half of the
// opacity is reached within a voxel of the proxy. The key O shows the inside; the hand must then
// move through the hidden skin to the skull.
#include "Applications/Explorer/Analysis/ValueProbe.h"
#include "Applications/Explorer/Live/LookSwitch.h"
#include "TouchedHead.h"

#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace
{
/// Computes how many voxels behind the proxy a ray from the camera reaches half of the opacity. By
/// the definition of vtkVolumeProperty, a layer of the unit distance has the function's opacity.
double MeasureHalfOpacity(TouchedHead& head)
{
  vtkVolumeProperty* const look = head.Touch.Scene.Look;
  const double unit = look->GetScalarOpacityUnitDistance();
  double proxy[3], way[3];
  std::copy_n(head.Touch.Device->GetState()->GetProxyPosition(), 3, proxy);
  head.Touch.Scene.Renderer->GetActiveCamera()->GetPosition(way);
  vtkMath::Subtract(proxy, way, way);
  vtkMath::Normalize(way);
  const Explore::ValueProbe probe(head.Exploration.Body, 0.0);
  constexpr double reach = 200.0, step = 0.1; // mm
  double depth = 0.0;
  std::vector<double> opacity;
  for (double t = -reach; t < reach; t += step)
  {
    const double at[3] = { proxy[0] + t * way[0], proxy[1] + t * way[1], proxy[2] + t * way[2] };
    bool isInside = false;
    const double value = probe.Value(at, isInside);
    depth -= isInside ? std::log(1.0 - look->GetScalarOpacity()->GetValue(value)) * step / unit : 0;
    opacity.push_back(1.0 - std::exp(-depth));
  }
  std::size_t half = 0;
  while (opacity[half] < 0.5 * opacity.back())
  {
    ++half;
  }
  return (step * static_cast<double>(half) - reach) / head.Exploration.Values.Voxel;
}

/// Presses until there is contact. Returns false without contact.
bool Meet(TouchedHead& head, int x, int y)
{
  for (int i = 0; i < 12 && head.Touch.Device->GetState()->GetContact() == 0; ++i)
  {
    head.Event(x, y, vtkCommand::MouseWheelForwardEvent);
    head.Run(30);
  }
  head.Run(600);
  return head.Touch.Device->GetState()->GetContact() != 0;
}
} // namespace

int TestTouchInside(int argc, char* argv[])
{
  TouchedHead head(argc, argv, Explore::MapperChoice::CPU);
  Explore::LookSwitch look(head.Touch, head.Exploration.Values);
  vtkHapticDevice* const device = head.Touch.Device;
  double outside = 0.0, skin = 0.0, skull = 0.0;
  bool isFelt = false;
  head.TouchAt(150, 230,
    [&]
    {
      head.Press(150, 230, 2);
      isFelt = device->GetState()->GetContact() != 0;
      outside = MeasureHalfOpacity(head);
      skin = device->GetState()->GetSurfaceValue();
    });
  const auto press = [&]
  {
    head.Interactor->SetKeySym("o");
    head.Interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    head.Interactor->SetKeySym(nullptr);
  };
  press();
  head.Run(20);
  head.TouchAt(150, 230,
    [&]
    {
      isFelt = Meet(head, 150, 230) && isFelt;
      skull = device->GetState()->GetSurfaceValue();
    });
  press();
  const bool isBack = head.Touch.Scene.Look->GetScalarOpacity()->GetValue(40.0) > 0.99;
  if (!isFelt || std::abs(outside) > 1.0 || skull < skin + 100.0 || !isBack)
  {
    std::cerr << "felt: " << isFelt << ", the skin is seen " << outside
              << " voxels behind the proxy; values " << skin << " and " << skull
              << ", the skin is back: " << isBack << "\n";
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders what guides the hand in modes: the stream line through the proxy, the core of the vortex,
// a guide and a front. The flow is a helix around the z axis, which is its core. Its lines have a
// constant distance from the axis, and rise in proportion to the angle.
#include "FollowedHand.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkHapticDevice.h>
#include <vtkHapticGuideMode.h>
#include <vtkHapticMode.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkVolumeHapticsFilter.h>

#include <cmath>
#include <initializer_list>

using scenetest::Fail;

namespace
{
constexpr double Pitch = 0.12; // climb (mm) per millimetre around the axis, at a distance of 1 mm

vtkSmartPointer<vtkImageData> MakeHelix()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(41, 41, 41);
  image->SetOrigin(-20.0, -20.0, -20.0);
  vtkNew<vtkDoubleArray> flow;
  flow->SetName("flow");
  flow->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* const x = image->GetPoint(i);
    flow->InsertNextTuple3(-x[1], x[0], 10.0 * Pitch);
  }
  image->GetPointData()->AddArray(flow);
  return image;
}

/// Makes a vertical line at x = y = -12.
vtkSmartPointer<vtkPolyData> MakeGuide()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-12.0, -12.0, -15.0);
  points->InsertNextPoint(-12.0, -12.0, 15.0);
  auto guide = vtkSmartPointer<vtkPolyData>::New();
  guide->SetPoints(points);
  return guide;
}

/// Expects a helix through the proxy for mode 0, the z axis for mode 1, and the guide for mode 2.
bool CheckLines(vtkPolyData* shapes, const double* proxy)
{
  vtkDataArray* const modes = shapes->GetCellData()->GetArray("Mode");
  const double radius = std::hypot(proxy[0], proxy[1]);
  int lines = 0;
  for (vtkIdType cell = 0; modes && cell < shapes->GetNumberOfLines(); ++cell)
  {
    const int mode = static_cast<int>(modes->GetComponent(cell, 0));
    vtkNew<vtkIdList> ids;
    shapes->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      const double* const x = shapes->GetPoint(ids->GetId(i));
      const double r = std::hypot(x[0], x[1]);
      const double wanted = mode == 0 ? radius : mode == 1 ? 0.0 : std::hypot(12.0, 12.0);
      if (std::abs(r - wanted) > 0.01)
      {
        return Fail("the distance from the axis", r, wanted);
      }
      const double angle =
        std::atan2(x[1] * proxy[0] - x[0] * proxy[1], x[0] * proxy[0] + x[1] * proxy[1]);
      const double turns = (x[2] - proxy[2]) / (10.0 * Pitch) - angle;
      const double whole = std::round(turns / (2.0 * std::acos(-1.0)));
      if (mode == 0 && std::abs(turns - whole * 2.0 * std::acos(-1.0)) > 0.01)
      {
        return Fail("the height on the helix", x[2], proxy[2] + 10.0 * Pitch * angle);
      }
    }
    ++lines;
  }
  const vtkIdType cells = shapes->GetNumberOfCells();
  return (lines == 3 || Fail("the number of lines", lines, 3)) &&
    (cells == 4 || Fail("the number of lines and fronts", static_cast<double>(cells), 4));
}
} // namespace

int TestFollowedModes(int argc, char* argv[])
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputData(MakeHelix());
  vtkNew<vtkHapticMode> follow;
  vtkNew<vtkHapticMode> vortex;
  vortex->SetKindToVortex();
  vtkNew<vtkHapticGuideMode> guide;
  vtkNew<vtkHapticMode> front;
  front->SetKindToVectorFront();
  guide->SetPath(MakeGuide());
  for (vtkHapticMode* const mode : std::initializer_list<vtkHapticMode*>{ follow, vortex, front })
  {
    mode->SetArrayName("flow");
  }
  filter->AddMode(follow);
  filter->AddMode(vortex);
  filter->AddMode(guide);
  filter->AddMode(front);
  filter->SetMethodToPrimitives();
  vtkNew<vtkHapticDevice> device;
  if (!scenetest::FeelAt(filter, 9.0, -3.0, -2.0, device))
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkPolyData> shapes;
  device->GetState()->GetFollowed(shapes, 48.0);
  if (!CheckLines(shapes, device->GetState()->GetProxyPosition()))
  {
    return EXIT_FAILURE;
  }
  return scenetest::CompareFollowed(device, 18.0, -70.0, 30.0, argc, argv);
}

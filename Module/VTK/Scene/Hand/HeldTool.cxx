// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/HeldTool.h"

#include "vtkAppendPolyData.h"
#include "vtkHapticBurr.h"
#include "vtkHapticDevice.h"
#include "vtkHapticPointShell.h"
#include "vtkLineSource.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** The shaft of a burr, in radii of its head; it goes to the handle along +z. */
constexpr double ShaftRadius = 0.35;
constexpr double ShaftLength = 9.0;
/** The number of blades of the head, and the depth between them, in radii. */
constexpr int Blades = 8;
constexpr double BladeDepth = 0.12;
constexpr int HeadResolution = 64;

vtkSmartPointer<vtkPolyData> MakeHead(double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(HeadResolution);
  sphere->SetPhiResolution(HeadResolution / 2);
  sphere->Update();
  vtkPolyData* const head = sphere->GetOutput();
  vtkPoints* const points = head->GetPoints();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double x[3];
    points->GetPoint(i, x);
    // Blades twist with the height; between them the surface is below the radius.
    const double turn = std::atan2(x[1], x[0]) + x[2] / radius;
    const double between = 0.5 - 0.5 * std::cos(Blades * turn);
    const double share = 1.0 - BladeDepth * between * std::hypot(x[0], x[1]) / radius;
    points->SetPoint(i, share * x[0], share * x[1], share * x[2]);
  }
  return head;
}

vtkSmartPointer<vtkPolyData> MakeBurr(double radius)
{
  vtkNew<vtkLineSource> line;
  line->SetPoint1(0.0, 0.0, 0.0);
  line->SetPoint2(0.0, 0.0, ShaftLength * radius);
  vtkNew<vtkTubeFilter> shaft;
  shaft->SetInputConnection(line->GetOutputPort());
  shaft->SetRadius(ShaftRadius * radius);
  shaft->SetNumberOfSides(24);
  shaft->CappingOn();
  vtkNew<vtkAppendPolyData> both;
  both->AddInputData(MakeHead(radius));
  both->AddInputConnection(shaft->GetOutputPort());
  both->Update();
  return both->GetOutput();
}

} // namespace

vtkHapticTool* FindHeldTool(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  return filter ? filter->GetTool() : nullptr;
}

bool IsTurnable(vtkHapticTool* tool)
{
  return vtkHapticPointShell::SafeDownCast(tool) || vtkHapticBurr::SafeDownCast(tool);
}

double FindToolReach(vtkHapticTool* tool)
{
  if (auto* const burr = vtkHapticBurr::SafeDownCast(tool))
  {
    return burr->GetRadius();
  }
  auto* const shell = vtkHapticPointShell::SafeDownCast(tool);
  if (!shell || !shell->GetMesh() || shell->GetMesh()->GetNumberOfPoints() == 0)
  {
    return 0.0;
  }
  double bounds[6];
  shell->GetMesh()->GetBounds(bounds);
  double reach = 0.0;
  for (const double bound : bounds)
  {
    reach = std::max(reach, std::abs(bound));
  }
  return reach;
}

vtkSmartPointer<vtkPolyData> MakeToolShape(vtkHapticTool* tool)
{
  if (auto* const burr = vtkHapticBurr::SafeDownCast(tool))
  {
    return MakeBurr(burr->GetRadius());
  }
  auto* const shell = vtkHapticPointShell::SafeDownCast(tool);
  return shell ? shell->GetMesh() : nullptr;
}

} // namespace VolumeHaptics

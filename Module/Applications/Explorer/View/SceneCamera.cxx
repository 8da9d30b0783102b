// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/View/SceneCamera.h"

#include "vtkCamera.h"
#include "vtkMath.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr double VIEW_ANGLE = 24.0; // degrees: a long focal length, so that a head is not distorted
// factor of the camera's distance, below 1 because the content is smaller than its bounding box
constexpr double MARGIN = 0.88;
constexpr double BOX_MARGIN = 1.05; // the factor for scenes in which the box itself is visible
} // namespace

namespace Explore
{
void AimCamera(vtkRenderer* renderer, const ViewFrame& view, double distance)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetViewAngle(VIEW_ANGLE);
  const vtkVector3d position = view.Centre + distance * view.Toward;
  camera->SetFocalPoint(view.Centre.GetData());
  camera->SetPosition(position.GetData());
  camera->SetViewUp(view.Up.GetData());
  renderer->ResetCameraClippingRange();
}

void FitCamera(vtkRenderer* renderer, const ViewFrame& view, const double bounds[6], double aspect,
  bool isBoxSeen)
{
  ViewFrame middle = view;
  middle.Centre = vtkVector3d(
    0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]), 0.5 * (bounds[4] + bounds[5]));
  const double slope = std::tan(0.5 * vtkMath::RadiansFromDegrees(VIEW_ANGLE));
  double distance = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const vtkVector3d offset = vtkVector3d(bounds[corner & 1], bounds[2 + ((corner >> 1) & 1)],
                                 bounds[4 + ((corner >> 2) & 1)]) -
      middle.Centre;
    const double across = std::abs(offset.Dot(view.Right)), along = std::abs(offset.Dot(view.Up));
    distance =
      std::max(distance, offset.Dot(view.Toward) + std::max(along, across / aspect) / slope);
  }
  AimCamera(renderer, middle, (isBoxSeen ? BOX_MARGIN : MARGIN) * distance);
}
} // namespace Explore

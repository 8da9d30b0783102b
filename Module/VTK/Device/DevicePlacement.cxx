// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/DevicePlacement.h"

#include "vtkLandmarkTransform.h"
#include "vtkLine.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace VolumeHaptics
{
namespace
{

using Coordinates = double[3];

/** Returns what is wrong with the points of one space; empty if they span a triangle. */
std::string DetectFlaw(vtkPoints* points, const std::string& space)
{
  Coordinates a, b, c;
  Coordinates ends[2] = {};
  double longest2 = 0.0;
  double size2 = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, a);
    size2 = std::max(size2, vtkMath::Dot(a, a));
    if (!std::isfinite(vtkMath::Dot(a, a)))
    {
      return "Point " + std::to_string(i) + " " + space +
        " is not finite, or too far away. Touch again, while the device is ready.";
    }
    for (vtkIdType j = 0; j < i; ++j)
    {
      points->GetPoint(j, b);
      const double distance2 = vtkMath::Distance2BetweenPoints(a, b);
      if (distance2 > longest2)
      {
        longest2 = distance2;
        std::copy(a, a + 3, ends[0]);
        std::copy(b, b + 3, ends[1]);
      }
    }
  }
  constexpr double rounding = 1e-9;
  if (!(longest2 > rounding * rounding * size2))
  {
    return "The points " + space + " are all in one place. Touch three or more different ones.";
  }
  double height2 = 0.0;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    points->GetPoint(i, c);
    height2 = std::max(height2, vtkLine::DistanceToLine(c, ends[0], ends[1]));
  }
  // Smallest height of the points above their longest line, as a fraction of its length; below it,
  // the rotation about the line would be a guess.
  constexpr double thinnest = 0.01;
  if (!(height2 > thinnest * thinnest * longest2))
  {
    return "The points " + space +
      " lie on one line, which leaves a rotation about that line open. Touch a point well off the "
      "line.";
  }
  return {};
}

} // namespace

std::string ComputePlacement(vtkPoints* touched, vtkPoints* known, double scale,
  vtkMatrix4x4* deviceToWorld, double& largestDistance)
{
  const vtkIdType count = touched ? touched->GetNumberOfPoints() : 0;
  const vtkIdType wanted = known ? known->GetNumberOfPoints() : 0;
  if (count != wanted)
  {
    return "There are " + std::to_string(count) + " touched points and " + std::to_string(wanted) +
      " known ones. Give each touched point its known position.";
  }
  if (count < 3)
  {
    return "There are " + std::to_string(count) + " points; three or more are needed. Touch more.";
  }
  if (!std::isfinite(scale) || scale < 0.0)
  {
    return "The scale is negative or not finite. Set it to world units per metre, or to 0.";
  }
  std::string flaw = DetectFlaw(touched, "of the device");
  flaw = flaw.empty() ? DetectFlaw(known, "of the world") : flaw;
  if (!flaw.empty())
  {
    return flaw;
  }

  // With a fixed scale, first scale the device's points to world units.
  const bool fixed = scale > 0.0;
  const double factor = fixed ? scale : 1.0;
  vtkNew<vtkPoints> source;
  source->SetDataTypeToDouble();
  Coordinates x;
  for (vtkIdType i = 0; i < count; ++i)
  {
    touched->GetPoint(i, x);
    vtkMath::MultiplyScalar(x, factor);
    source->InsertNextPoint(x);
  }
  vtkNew<vtkLandmarkTransform> landmarks;
  landmarks->SetSourceLandmarks(source);
  landmarks->SetTargetLandmarks(known);
  fixed ? landmarks->SetModeToRigidBody() : landmarks->SetModeToSimilarity();
  landmarks->Update();

  double largest2 = 0.0;
  for (vtkIdType i = 0; i < count; ++i)
  {
    landmarks->TransformPoint(source->GetPoint(i), x);
    largest2 = std::max(largest2, vtkMath::Distance2BetweenPoints(x, known->GetPoint(i)));
  }
  largestDistance = std::sqrt(largest2);
  deviceToWorld->DeepCopy(landmarks->GetMatrix());
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      deviceToWorld->SetElement(
        row, column, factor * landmarks->GetMatrix()->GetElement(row, column));
    }
  }
  return {};
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticCalibration.h"

#include "VTK/Device/HapticDeviceSettings.h"

#include "vtkLandmarkTransform.h"
#include "vtkLine.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkHapticCalibration);

namespace
{

using Coordinates = double[3];

/** Returns the fault in the points of one space; empty if they span a triangle. */
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
  // smallest height of the points above their line, as a fraction of the line's length; below it,
  // the rotation about the line is guessed
  constexpr double thinnest = 0.01;
  if (!(height2 > thinnest * thinnest * longest2))
  {
    return "The points " + space +
      " lie on one line, about which the device could be turned at will. Touch one well beside it.";
  }
  return {};
}

} // namespace

//------------------------------------------------------------------------------
vtkHapticCalibration::vtkHapticCalibration()
{
  this->DevicePoints->SetDataTypeToDouble();
  this->WorldPoints->SetDataTypeToDouble();
}

vtkHapticCalibration::~vtkHapticCalibration() = default;

//------------------------------------------------------------------------------
void vtkHapticCalibration::AddPoint(const double device[3], const double world[3])
{
  if (!device || !world)
  {
    vtkErrorMacro("AddPoint() needs three numbers of the device and three of the world, but got a "
                  "null pointer.");
    return;
  }
  this->DevicePoints->InsertNextPoint(device);
  this->WorldPoints->InsertNextPoint(world);
  this->Modified();
}

//------------------------------------------------------------------------------
void vtkHapticCalibration::RemoveAllPoints()
{
  this->DevicePoints->Reset();
  this->WorldPoints->Reset();
  this->Modified();
}

//------------------------------------------------------------------------------
int vtkHapticCalibration::GetNumberOfPoints()
{
  return static_cast<int>(this->DevicePoints->GetNumberOfPoints());
}

//------------------------------------------------------------------------------
bool vtkHapticCalibration::Compute()
{
  const int count = this->GetNumberOfPoints();
  std::string flaw;
  if (count < 3)
  {
    flaw = "There are " + std::to_string(count) + " points; three or more are needed. Touch more.";
  }
  else if (!std::isfinite(this->FixedScale))
  {
    flaw = "FixedScale is not finite. Set it to world units per metre, or to 0.";
  }
  else
  {
    flaw = DetectFlaw(this->DevicePoints, "of the device");
    flaw = flaw.empty() ? DetectFlaw(this->WorldPoints, "of the world") : flaw;
  }
  if (!flaw.empty())
  {
    vtkErrorMacro(<< flaw);
    return false;
  }

  // With a fixed scale the device's points are first scaled to world units.
  const bool fixed = this->FixedScale > 0.0;
  const double scale = fixed ? this->FixedScale : 1.0;
  vtkNew<vtkPoints> source;
  source->SetDataTypeToDouble();
  Coordinates x;
  for (int i = 0; i < count; ++i)
  {
    this->DevicePoints->GetPoint(i, x);
    vtkMath::MultiplyScalar(x, scale);
    source->InsertNextPoint(x);
  }
  vtkNew<vtkLandmarkTransform> landmarks;
  landmarks->SetSourceLandmarks(source);
  landmarks->SetTargetLandmarks(this->WorldPoints);
  fixed ? landmarks->SetModeToRigidBody() : landmarks->SetModeToSimilarity();
  landmarks->Update();

  double sum2 = 0.0;
  double largest2 = 0.0;
  for (int i = 0; i < count; ++i)
  {
    landmarks->TransformPoint(source->GetPoint(i), x);
    const double distance2 = vtkMath::Distance2BetweenPoints(x, this->WorldPoints->GetPoint(i));
    sum2 += distance2;
    largest2 = std::max(largest2, distance2);
  }
  this->Residual = std::sqrt(sum2 / count);
  this->LargestResidual = std::sqrt(largest2);
  this->DeviceToWorld->DeepCopy(landmarks->GetMatrix());
  for (int row = 0; row < 3; ++row)
  {
    for (int column = 0; column < 3; ++column)
    {
      this->DeviceToWorld->SetElement(
        row, column, scale * landmarks->GetMatrix()->GetElement(row, column));
    }
  }
  this->Modified();
  return true;
}

//------------------------------------------------------------------------------
vtkMatrix4x4* vtkHapticCalibration::GetDeviceToWorld()
{
  return this->DeviceToWorld;
}

//------------------------------------------------------------------------------
void vtkHapticCalibration::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DevicePoints: " << this->GetNumberOfPoints() << "\n";
  os << indent << "WorldPoints: " << this->GetNumberOfPoints() << "\n";
  VolumeHaptics::PrintSettings(os, indent, this, VolumeHaptics::CalibrationSettings);
  os << indent << "Residual: " << this->Residual << "\n";
  os << indent << "LargestResidual: " << this->LargestResidual << "\n";
  os << indent << "DeviceToWorld:\n";
  this->DeviceToWorld->PrintSelf(os, indent.GetNextIndent());
}

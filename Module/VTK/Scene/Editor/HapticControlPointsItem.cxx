// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticControlPointsItem.h"

#include "VTK/Scene/Base/HapticHistogram.h"

#include "vtkBrush.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>

namespace
{
constexpr double Farthest = VolumeHaptics::FarthestShown;
} // namespace

vtkStandardNewMacro(HapticControlPointsItem);

//------------------------------------------------------------------------------
HapticControlPointsItem::HapticControlPointsItem()
{
  this->SetScreenPointRadius(4.0f);
  this->SetEndPointsXMovable(false);
  this->GetPen()->SetColor(0, 92, 175, 255);
  this->GetBrush()->SetColor(255, 255, 255, 255);
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::SetRange(double from, double to, double scale)
{
  this->From = from;
  this->To = to;
  this->Scale = scale;
  this->SetUserBounds(from, to, 0.0, 1.0);
  this->SetValidBounds(from, to, 0.0, 1.0);
  this->ComputePoints();
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::SetEmptyValue(double value)
{
  this->EmptyValue = value;
  this->SetCurrentPoint(-1);
  this->DeselectAllPoints();
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::GetControlPoint(vtkIdType index, double* point) const
{
  this->Superclass::GetControlPoint(index, point);
  point[0] = std::isnan(point[0]) ? Farthest : std::clamp(point[0], -Farthest, Farthest);
  point[1] = ToShare(point[1], this->Scale);
}

//------------------------------------------------------------------------------
double HapticControlPointsItem::ToShare(double value, double scale)
{
  return std::isnan(value) ? 0.0 : std::clamp(value / scale, -1.0, 1.0);
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::SetControlPoint(vtkIdType index, double* point)
{
  double node[4];
  this->Superclass::GetControlPoint(index, node);
  const bool staysAbove = point[1] >= 1.0 && node[1] > this->Scale;
  const bool staysAway = !(std::abs(node[0]) <= Farthest);
  node[0] = staysAway ? node[0] : point[0];
  node[1] = staysAbove ? node[1] : point[1] * this->Scale;
  this->Superclass::SetControlPoint(index, node);
}

//------------------------------------------------------------------------------
vtkIdType HapticControlPointsItem::AddPoint(double* newPos)
{
  if (!this->PiecewiseFunction)
  {
    return -1;
  }
  this->StartChanges();
  if (this->PiecewiseFunction->GetSize() == 0)
  {
    this->PiecewiseFunction->AddPoint(this->From, this->EmptyValue);
    this->PiecewiseFunction->AddPoint(this->To, this->EmptyValue);
  }
  double point[2] = { newPos[0], newPos[1] * this->Scale };
  const vtkIdType added = this->Superclass::AddPoint(point);
  this->EndChanges();
  return added;
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::DrawPoint(vtkContext2D* painter, vtkIdType index)
{
  double point[4];
  this->GetControlPoint(index, point);
  if (point[0] >= this->From && point[0] <= this->To)
  {
    this->Superclass::DrawPoint(painter, index);
  }
}

//------------------------------------------------------------------------------
std::string HapticControlPointsItem::DescribeCurrentPoint()
{
  const vtkIdType current = this->GetCurrentPoint();
  if (current < 0 || current >= this->GetNumberOfPoints())
  {
    return {};
  }
  double node[4];
  this->Superclass::GetControlPoint(current, node);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(3) << node[1] << " at " << std::setprecision(5) << node[0];
  return text.str();
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "From: " << this->From << "\n";
  os << indent << "To: " << this->To << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "EmptyValue: " << this->EmptyValue << "\n";
}

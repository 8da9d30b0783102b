// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/SpringCoil.h"

#include "vtkCellArray.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr double FullTurn = 6.283185307179586; ///< rad
constexpr int Windings = 8;
constexpr int WindingSides = 24;    ///< segments per winding
constexpr double WireRadius = 0.09; ///< radius of the wire, as a fraction of the proxy's radius
/** Radius of the windings of a coil at rest, in radii of the proxy. */
constexpr double RestRadius = 0.5;
/// Shortest drawn spring, in radii of the proxy; the proxy hides a shorter one.
constexpr double Shortest = 0.2;
/// Smallest radius of windings, in radii of the proxy; below it, the wire is drawn straight.
constexpr double LeastWinding = 0.03;

} // namespace

SpringCoil::SpringCoil()
  : Marker(Tube->GetOutputPort(), 0.75, 0.75, 0.75)
{
  this->Tube->SetInputData(this->Wire);
  this->Tube->SetNumberOfSides(8);
  this->Tube->CappingOn();
}

void SpringCoil::Place(const Vector3& proxy, const Vector3& tip, double slack, double radius)
{
  const Vector3 way = tip - proxy;
  const double length = Norm(way);
  if (!(length > Shortest * radius))
  {
    this->Marker.Show(false);
    return;
  }
  if (IsIdentical(proxy, this->Proxy) && IsIdentical(tip, this->Tip) && slack == this->Slack &&
    radius == this->Radius)
  {
    return;
  }
  this->Proxy = proxy;
  this->Tip = tip;
  this->Slack = slack;
  this->Radius = radius;
  const Vector3 along = (1.0 / length) * way;
  const Vector3 side = UnitAcross(along);
  const Vector3 up = Cross(along, side);

  const double straight = std::clamp(slack, 0.0, length);
  const double stretch = length - straight;
  const double wire = Windings * FullTurn * RestRadius * radius;
  const double winding =
    std::sqrt(std::max(0.0, wire * wire - stretch * stretch)) / (Windings * FullTurn);

  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(0);
  const auto add = [&](const Vector3& x)
  { line->InsertCellPoint(points->InsertNextPoint(x.X, x.Y, x.Z)); };
  add(proxy);
  const bool isCoil = stretch > 0.0 && winding > LeastWinding * radius;
  if (isCoil && straight > 0.0)
  {
    add(proxy + straight * along);
  }
  for (int i = 0; isCoil && i <= Windings * WindingSides; ++i)
  {
    const double fraction = static_cast<double>(i) / (Windings * WindingSides);
    const double angle = FullTurn * Windings * fraction;
    add(proxy + (straight + fraction * stretch) * along +
      winding * (std::cos(angle) * side + std::sin(angle) * up));
  }
  add(tip);
  line->UpdateCellCount(static_cast<int>(points->GetNumberOfPoints()));
  this->Wire->SetPoints(points);
  this->Wire->SetLines(line);
  this->Tube->SetRadius(WireRadius * radius);
}

} // namespace VolumeHaptics

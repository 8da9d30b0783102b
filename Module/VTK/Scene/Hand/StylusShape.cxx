// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/StylusShape.h"

#include "Core/Math/Vector3.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

///@{
/** Distances from the point along z, and radii, of a stylus of length 1. */
constexpr double ConeEnd = 0.16;
constexpr double HandleRadius = 0.032;
constexpr double HandleEnd = 1.0 - HandleRadius; ///< a dome closes the handle
constexpr double ButtonMiddle = 0.28;
constexpr double ButtonLength = 0.13;
constexpr double ButtonWidth = 0.034;
constexpr double ButtonHeight = 0.016; ///< heights relative to the handle's surface
///@}

constexpr unsigned char Metal[3] = { 214, 218, 224 };
constexpr unsigned char Handle[3] = { 96, 116, 150 };
constexpr unsigned char Button[3] = { 240, 242, 245 };

constexpr double Turn = 6.283185307179586; ///< rad
constexpr int Around = 48;

class Surface
{
public:
  Surface()
  {
    this->Normals->SetNumberOfComponents(3);
    this->Colors->SetNumberOfComponents(3);
  }

  /**
   * A grid over u and v in [0, 1]: `place` sets a position and a normal of any length. The surface
   * looks outwards if u, v and the normal are right-handed.
   */
  template <typename Place>
  void Add(int alongU, int alongV, const unsigned char color[3], Place&& place)
  {
    const vtkIdType first = this->Points->GetNumberOfPoints();
    for (int i = 0; i <= alongU; ++i)
    {
      for (int j = 0; j <= alongV; ++j)
      {
        Vector3 x;
        Vector3 n;
        place(static_cast<double>(i) / alongU, static_cast<double>(j) / alongV, x, n);
        n = (1.0 / Norm(n)) * n;
        this->Points->InsertNextPoint(x.X, x.Y, x.Z);
        this->Normals->InsertNextTuple3(n.X, n.Y, n.Z);
        this->Colors->InsertNextTypedTuple(color);
      }
    }
    const auto at = [&](int i, int j) { return first + i * (alongV + 1) + j; };
    for (int i = 0; i < alongU; ++i)
    {
      for (int j = 0; j < alongV; ++j)
      {
        const vtkIdType cell[4] = { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
        this->Cells->InsertNextCell(4, cell);
      }
    }
  }

  vtkSmartPointer<vtkPolyData> Finish()
  {
    auto shape = vtkSmartPointer<vtkPolyData>::New();
    shape->SetPoints(this->Points);
    shape->SetPolys(this->Cells);
    shape->GetPointData()->SetNormals(this->Normals);
    shape->GetPointData()->SetScalars(this->Colors);
    return shape;
  }

private:
  vtkNew<vtkPoints> Points;
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkFloatArray> Normals;
  vtkNew<vtkUnsignedCharArray> Colors;
};

} // namespace

vtkSmartPointer<vtkPolyData> MakeStylusShape()
{
  Surface surface;
  const auto direction = [](double u) {
    return Vector3{ std::cos(Turn * u), std::sin(Turn * u), 0.0 };
  };
  const Vector3 axis{ 0.0, 0.0, 1.0 };
  surface.Add(Around, 1, Metal,
    [&](double u, double v, Vector3& x, Vector3& n)
    {
      x = v * (ConeEnd * axis + HandleRadius * direction(u));
      n = ConeEnd * direction(u) - HandleRadius * axis;
    });
  surface.Add(Around, 1, Handle,
    [&](double u, double v, Vector3& x, Vector3& n)
    {
      x = (ConeEnd + v * (HandleEnd - ConeEnd)) * axis + HandleRadius * direction(u);
      n = direction(u);
    });
  surface.Add(Around, Around / 4, Handle,
    [&](double u, double v, Vector3& x, Vector3& n)
    {
      n = std::cos(0.25 * Turn * v) * direction(u) + std::sin(0.25 * Turn * v) * axis;
      x = HandleEnd * axis + HandleRadius * n;
    });
  // Half an ellipsoid that stands out of the handle.
  surface.Add(Around, Around / 4, Button,
    [&](double u, double v, Vector3& x, Vector3& n)
    {
      const double level = std::cos(0.25 * Turn * v);
      const double side = level * std::sin(Turn * u);
      const double along = level * std::cos(Turn * u);
      const double up = std::sin(0.25 * Turn * v);
      x = { 0.5 * ButtonWidth * side, HandleRadius - ButtonHeight + 2.0 * ButtonHeight * up,
        ButtonMiddle + 0.5 * ButtonLength * along };
      n = { side / ButtonWidth, 0.25 * up / ButtonHeight, along / ButtonLength };
    });
  return surface.Finish();
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Surfaces.h"

#include "Shapes.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"

#include <algorithm>

namespace evaluation
{
namespace
{
constexpr double HalfTurn = 0.5 * TwoPi;

/** Returns a sample's position in world coordinates. */
Vector3 WorldPosition(vtkImageData* image, int i, int j, int k)
{
  double position[3];
  image->TransformIndexToPhysicalPoint(i, j, k, position);
  return { position[0], position[1], position[2] };
}

/** The centre of all samples of a label, and their bounding box, which is empty without samples. */
struct LabelPlace
{
  Vector3 Middle;
  double Box[6] = { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 };
};

LabelPlace FindLabel(vtkImageData* labels, int label)
{
  LabelPlace place;
  double count = 0.0;
  int n[3];
  labels->GetDimensions(n);
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        if (labels->GetScalarComponentAsDouble(i, j, k, 0) != label)
        {
          continue;
        }
        const Vector3 at = WorldPosition(labels, i, j, k);
        place.Middle = place.Middle + at;
        const double x[3] = { at.X, at.Y, at.Z };
        for (int axis = 0; axis < 3; ++axis)
        {
          double* const range = place.Box + 2 * axis;
          range[0] = count > 0.0 ? std::min(range[0], x[axis]) : x[axis];
          range[1] = count > 0.0 ? std::max(range[1], x[axis]) : x[axis];
        }
        count += 1.0;
      }
    }
  }
  place.Middle = (1.0 / std::max(count, 1.0)) * place.Middle;
  return place;
}

/**
 * Returns planes through the dome of a liver, whose surface has a level and is seen from inside.
 */
Course OverLiver(const LabelPlace& liver, double level, const Effort& effort)
{
  Course up;
  up.Level = level;
  up.Up = { 0.0, 0.0, 1.0 };
  up.FirstAngle = 0.2 * HalfTurn;
  up.LastAngle = 0.8 * HalfTurn;
  up.IsSeenFromInside = true;
  const int planes = effort.Pick(1, 6);
  for (int plane = 0; plane < planes; ++plane)
  {
    const double fraction = 0.3 + 0.4 * (plane + 0.5) / planes;
    up.Middles.push_back(
      { liver.Middle.X, liver.Box[2] + fraction * (liver.Box[3] - liver.Box[2]), liver.Middle.Z });
  }
  return up;
}

/** Returns a copy of an image in which all other labels are 0. */
vtkSmartPointer<vtkImageData> KeepLabel(vtkImageData* labels, int label)
{
  auto kept = vtkSmartPointer<vtkImageData>::New();
  kept->CopyStructure(labels);
  kept->AllocateScalars(VTK_SHORT, 1);
  auto* to = static_cast<short*>(kept->GetScalarPointer());
  vtkDataArray* const from = labels->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < from->GetNumberOfTuples(); ++i)
  {
    to[i] = static_cast<short>(from->GetTuple1(i) == label ? label : 0);
  }
  return kept;
}
} // namespace

std::vector<FeltSurface> FindHeadSurfaces(vtkImageData* volume, const Effort& effort)
{
  FeltSurface scalp{ "head CT", "scalp", "CT contrast", volume, -300.0, {} };
  FeltSurface skull{ "head CT", "skull", "CT contrast", volume, 300.0, {} };
  scalp.Arcs = FindArcs(volume, AroundHead(volume, scalp.Level, 0.0, effort));
  skull.Arcs = FindArcs(volume, AroundHead(volume, skull.Level, 10.0, effort));
  scalp.IsRequired = skull.IsRequired = true;
  scalp.RoughestFraction = 0.6;
  return { scalp, skull };
}

std::vector<FeltSurface> FindChestSurfaces(
  vtkImageData* volume, vtkImageData* labels, int liver, const Effort& effort)
{
  double box[6];
  volume->GetBounds(box);
  FeltSurface skin{ "chest CT", "skin", "CT contrast", volume, -300.0, {} };
  Course front;
  front.Level = skin.Level;
  front.Up = { 0.0, -1.0, 0.0 }; // the face looks along -y
  front.FirstAngle = 0.15 * HalfTurn;
  front.LastAngle = 0.85 * HalfTurn;
  front.Radius = 130.0;
  const int heights = effort.Pick(1, 4);
  for (int height = 0; height < heights; ++height)
  {
    front.Middles.push_back({ 0.5 * (box[0] + box[1]), 0.5 * (box[2] + box[3]),
      box[4] + (0.3 + 0.4 * (height + 0.5) / heights) * (box[5] - box[4]) });
  }
  skin.Arcs = FindArcs(volume, front);
  std::vector<FeltSurface> surfaces = { skin };
  const LabelPlace place = labels ? FindLabel(labels, liver) : LabelPlace{};
  if (place.Box[0] <= place.Box[1])
  {
    FeltSurface dome{ "chest CT", "liver", "CT contrast", volume, -400.0, {} };
    dome.Arcs = FindArcs(volume, OverLiver(place, dome.Level, effort));
    surfaces.push_back(dome);
  }
  return surfaces;
}

std::vector<FeltSurface> FindMriSurfaces(vtkImageData* volume, const Effort& effort)
{
  FeltSurface scalp{ "head MRI", "scalp", "MRI", volume, 50.0, {}, 30.0 };
  FeltSurface cortex{ "head MRI", "cortex", "MRI", volume, 70.0, {}, 30.0 };
  scalp.Arcs = FindArcs(volume, AroundHead(volume, scalp.Level, 0.0, effort));
  Course inside = AroundHead(volume, cortex.Level, 10.0, effort);
  inside.IsSeenFromInside = true;
  cortex.Arcs = FindArcs(volume, inside);
  return { scalp, cortex };
}

std::vector<FeltSurface> FindLabelSurfaces(vtkImageData* labels, int liver, const Effort& effort)
{
  const LabelPlace place = FindLabel(labels, liver);
  if (place.Box[0] > place.Box[1])
  {
    return {};
  }
  const vtkSmartPointer<vtkImageData> alone = KeepLabel(labels, liver);
  FeltSurface one{ "chest labels", "liver alone", "Labels", alone, 0.5 * liver, {}, LabelRamp };
  one.Arcs = FindArcs(alone, OverLiver(place, one.Level, effort));
  FeltSurface all{ "chest labels", "liver among all", "Labels", labels, 0.5, one.Arcs, LabelRamp };
  return { one, all };
}

} // namespace evaluation

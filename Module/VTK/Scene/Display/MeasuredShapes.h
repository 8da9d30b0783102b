// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measurements in the scene: points as spheres, lines as tubes, areas as patches. They shine
 * faintly through objects in front of them.
 */
#ifndef MeasuredShapes_h
#define MeasuredShapes_h

#include "vtkActor.h"
#include "vtkGlyph3D.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkTubeFilter.h"

#include <array>

class vtkBoundingBox;
class vtkViewport;
class vtkWindow;

namespace VolumeHaptics
{

class MeasuredShapes
{
public:
  MeasuredShapes(double red, double green, double blue);
  ~MeasuredShapes();

  /** Clears the shapes, and sets the radius of spheres (world units). */
  void Clear(double radius);
  /** Adds a shape of one of vtkHapticMeasurements' kinds. */
  void Add(int kind, vtkPolyData* shape);

  void RenderOpaque(vtkViewport* viewport);
  /** Draws the faint copy. */
  void RenderHidden(vtkViewport* viewport);
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box);

private:
  /** The line without points that are too close to be told apart. */
  void AddLine(vtkPolyData* shape);
  void AddArc(vtkPolyData* angle);
  void AddPatch(vtkPolyData* shape);

  struct Part
  {
    vtkNew<vtkPolyData> Data;
    vtkNew<vtkPolyDataMapper> Mapper;
    vtkNew<vtkActor> Solid;
    vtkNew<vtkActor> Ghost;
  };
  std::array<Part, 3> Parts;
  Part& Spheres = Parts[0];
  Part& Tubes = Parts[1];
  Part& Patches = Parts[2];
  vtkNew<vtkSphereSource> Sphere;
  vtkNew<vtkGlyph3D> Glyphs;
  vtkNew<vtkTubeFilter> Tube;
  double Radius = 1.0;
};

} // namespace VolumeHaptics

#endif

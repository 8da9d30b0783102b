// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The shapes that hold the hand in modes, in the scene: lines as tubes, fronts as discs, tensors as
 * ellipsoids, in the colours of their modes.
 */
#ifndef FollowedScene_h
#define FollowedScene_h

#include "VTK/Scene/Hand/ColoredTubes.h"

#include "vtkActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkTensorGlyph.h"

#include <cstddef>

class vtkBoundingBox;
class vtkHapticDevice;

namespace VolumeHaptics
{

class FollowedScene
{
public:
  using Color = unsigned char[3];
  /** Borrows the colours of modes by number; there is at least one. */
  FollowedScene(const Color* colors, std::size_t count);
  ~FollowedScene();

  /** Shows the latest state; nothing without a device. The proxy's radius is in world units. */
  void Update(vtkHapticDevice* device, double reach, double radius);

  void RenderOpaque(vtkViewport* viewport) { this->Lines.RenderOpaque(viewport); }
  bool HasFronts() const
  {
    return this->Shapes->GetNumberOfPolys() > 0 || this->Tensors->GetNumberOfPoints() > 0;
  }
  /** Draws translucent discs and ellipsoids where nothing is in front of them. */
  void RenderFronts(vtkViewport* viewport);
  /** Draws the faint copy of the lines. */
  void RenderHidden(vtkViewport* viewport) { this->Lines.RenderHidden(viewport); }
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box);

private:
  void Draw();
  void DrawTensors();
  /** Draws tensors longer than the proxy, so that their axes can be seen. */
  void ScaleTensors(double radius);

  vtkNew<vtkPolyData> Shapes;
  ColoredTubes Lines{ 10 }; ///< lines, and the rims of fronts
  vtkNew<vtkPolyData> Discs;
  vtkNew<vtkPolyData> Tensors;
  vtkNew<vtkTensorGlyph> Ellipsoids;
  vtkNew<vtkPolyDataNormals> Outward;
  vtkNew<vtkPolyDataMapper> DiscMapper;
  vtkNew<vtkActor> Fronts;
  vtkNew<vtkPolyDataMapper> EllipsoidMapper;
  vtkNew<vtkActor> EllipsoidActor;
  const Color* const Colors;
  const std::size_t ColorCount;
  double Proxy[3] = { 0.0, 0.0, 0.0 }; ///< state of the shapes, with the next two members
  double Time = -1.0;
  double Reach = 0.0;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws the shapes on which modes hold the hand, in the colours of the modes: lines as tubes,
 * fronts as discs, tensors as ellipsoids.
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
  /**
   * `colors` are the colours of modes, by index; at least one. The array must outlive this object.
   */
  FollowedScene(const Color* colors, std::size_t count);
  ~FollowedScene();

  /**
   * Shows the latest state, or nothing without a device. `radius` is that of the proxy (world
   * units).
   */
  void Update(vtkHapticDevice* device, double reach, double radius);

  void RenderOpaque(vtkViewport* viewport) { this->Lines.RenderOpaque(viewport); }
  bool HasFronts() const
  {
    return this->Shapes->GetNumberOfPolys() > 0 || this->Tensors->GetNumberOfPoints() > 0;
  }
  /** Draws translucent discs and ellipsoids, except where objects are in front of them. */
  void RenderFronts(vtkViewport* viewport);
  /** Draws a faint copy of the lines over objects that hide them. */
  void RenderHidden(vtkViewport* viewport) { this->Lines.RenderHidden(viewport); }
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box);

private:
  void Draw();
  void DrawTensors();
  /** Scales the ellipsoids of tensors so that their axes extend beyond the proxy's sphere. */
  void ScaleTensors(double radius);

  vtkNew<vtkPolyData> Shapes;
  ColoredTubes Lines{ 10 }; ///< lines and rims of fronts
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
  double Proxy[3] = { 0.0, 0.0, 0.0 }; ///< proxy, time and reach of the drawn shapes
  double Time = -1.0;
  double Reach = 0.0;
};

} // namespace VolumeHaptics

#endif

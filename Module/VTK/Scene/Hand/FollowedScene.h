// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws the shapes that hold the hand in modes: lines as tubes, fronts as discs, tensors as
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
  /**
   * `colors` are the colours of modes by number, at least one; the array must outlive this object.
   */
  FollowedScene(const Color* colors, std::size_t count);
  ~FollowedScene();

  /**
   * Shows the latest state, or nothing without a device. `radius` is the proxy's radius in world
   * units.
   */
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
  /** Scales the tensors' ellipsoids so that their axes stick out of the proxy's sphere. */
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
  double Proxy[3] = { 0.0, 0.0, 0.0 }; ///< proxy, time and reach for which the shapes were drawn
  double Time = -1.0;
  double Reach = 0.0;
};

} // namespace VolumeHaptics

#endif

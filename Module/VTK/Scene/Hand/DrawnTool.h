// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws a tool in the scene: the mesh of its kind (ToolKind::MakeShape) at the tool's pose. The
 * pose may lag behind the hand, and a burr spins. A needle is drawn with its shaft and its hub, and
 * in tissue with its track in the colours of the labels.
 */
#ifndef DrawnTool_h
#define DrawnTool_h

#include "Core/Math/Quaternion.h"
#include "VTK/Scene/Hand/ColoredTubes.h"

#include "vtkActor.h"
#include "vtkHapticTool.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkTubeFilter.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

class vtkBoundingBox;
class vtkHapticDevice;
class vtkViewport;
class vtkWindow;

namespace VolumeHaptics
{

/** Returns the tool in the hand of a device; null if the hand touches with a point. */
vtkHapticTool* GetHeldTool(vtkHapticDevice* device);

/** Returns whether a tool looks different when it is turned. */
bool IsTurnable(vtkHapticTool* tool);

/**
 * Returns the distance (world units) from the hand to the farthest touching point of a tool; 0
 * without a shape.
 */
double ComputeToolReach(vtkHapticTool* tool);

class DrawnTool
{
public:
  DrawnTool();

  /**
   * Shows the latest state, or nothing without a device.
   * @param leaning pose of a tool that turns with the stylus, if the device measures no
   * orientation; or NoOrientation
   */
  void Update(vtkHapticDevice* device, const Quaternion& leaning);

  /** Returns whether the hand holds a tool that has a mesh. */
  bool IsShown() const { return this->Shown; }
  void RenderOpaque(vtkViewport* viewport);
  /** Draws the faint copy. */
  void RenderHidden(vtkViewport* viewport);
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box);

private:
  vtkNew<vtkPolyDataNormals> Normals;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkMatrix4x4> Pose;
  vtkNew<vtkActor> Solid;
  vtkNew<vtkActor> Ghost;
  vtkWeakPointer<vtkHapticTool> Tool; ///< the tool whose shape is drawn
  vtkMTimeType ToolTime = 0;
  bool Shown = false;
};

class DrawnNeedle
{
public:
  DrawnNeedle();

  /**
   * Shows the latest state, or nothing without a device. Lengths are in world units.
   * @param handle direction from the tip to the hand while the needle is in the air (unit vector);
   * 0 if it is unknown
   */
  void Update(vtkHapticDevice* device, double radius, double length, const Vector3& handle);

  /** Returns whether the hand holds a needle, or a needle is in tissue. */
  bool IsShown() const { return this->Lines.AreShown(); }
  void RenderOpaque(vtkViewport* viewport);
  /** Draws the faint copy. */
  void RenderHidden(vtkViewport* viewport) { this->Lines.RenderHidden(viewport); }
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box) { this->Lines.AddTo(box); }

private:
  void Draw(vtkHapticDevice* device, double length, const Vector3& handle);

  vtkNew<vtkPolyData> Track;
  ColoredTubes Lines{ 12 }; ///< pieces of the track, then the shaft outside the tissue
  vtkNew<vtkPolyData> HubLine;
  vtkNew<vtkTubeFilter> Hub;
  vtkNew<vtkPolyDataMapper> HubMapper;
  vtkNew<vtkActor> HubActor;
  double Time = -1.0; ///< time, length and direction of the drawn lines
  double Length = 0.0;
  Vector3 Handle;
};

} // namespace VolumeHaptics

#endif

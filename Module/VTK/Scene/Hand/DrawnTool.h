// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws the tool in the hand: the mesh of its kind (ToolKind::MakeShape) at the tool's pose, which
 * may lag behind the hand. A burr spins. A needle has a shaft and a hub, and in tissue also its
 * track in the colours of the labels.
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

/** Returns the tool held with a device; null if the hand touches with a point. */
vtkHapticTool* GetHeldTool(vtkHapticDevice* device);

/** Returns whether turning a tool changes what is drawn. */
bool IsTurnable(vtkHapticTool* tool);

/**
 * Returns the distance (world units) from the hand to the farthest touching point of a tool; 0 for
 * a tool without a shape.
 */
double ComputeToolReach(vtkHapticTool* tool);

class DrawnTool
{
public:
  DrawnTool();

  /**
   * Shows the latest state, or nothing without a device.
   * @param leaning orientation for a tool that turns with the stylus if the device measures none;
   * or NoOrientation
   */
  void Update(vtkHapticDevice* device, const Quaternion& leaning);

  /** Returns whether the hand holds a tool with a mesh. */
  bool IsShown() const { return this->Shown; }
  void RenderOpaque(vtkViewport* viewport);
  /** Draws a faint copy of the tool over objects that hide it. */
  void RenderHidden(vtkViewport* viewport);
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box);

private:
  vtkNew<vtkPolyDataNormals> Normals;
  vtkNew<vtkPolyDataMapper> Mapper;
  vtkNew<vtkMatrix4x4> Pose;
  vtkNew<vtkActor> Solid;
  vtkNew<vtkActor> Ghost;
  vtkWeakPointer<vtkHapticTool> Tool; ///< tool whose shape is drawn
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
  /** Draws a faint copy of the needle over objects that hide it. */
  void RenderHidden(vtkViewport* viewport) { this->Lines.RenderHidden(viewport); }
  void Release(vtkWindow* window);
  void AddTo(vtkBoundingBox& box) { this->Lines.AddTo(box); }

private:
  void Draw(vtkHapticDevice* device, double length, const Vector3& handle);

  vtkNew<vtkPolyData> Track;
  ColoredTubes Lines{ 12 }; ///< parts of the track, then the shaft outside the tissue
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

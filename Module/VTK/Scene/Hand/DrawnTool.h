// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws a tool in the scene: the mesh of its kind (ToolKind::MakeShape) at the tool's pose. The
 * pose may lag behind the hand, and a burr spins.
 */
#ifndef DrawnTool_h
#define DrawnTool_h

#include "Core/Math/Quaternion.h"

#include "vtkActor.h"
#include "vtkHapticTool.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataNormals.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

class vtkBoundingBox;
class vtkHapticDevice;
class vtkViewport;
class vtkWindow;

namespace VolumeHaptics
{

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

  /** Whether the hand holds a tool that has a mesh. */
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

} // namespace VolumeHaptics

#endif

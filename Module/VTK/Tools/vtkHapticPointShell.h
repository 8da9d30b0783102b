// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticPointShell
 * @brief   a tool with the shape of any closed surface, which feels force and torque
 *
 * Gives the hand a tool with a shape, such as that of an STL file. The hand feels the force and the
 * torque of all contacts of its surface:
 *
 *   vtkNew<vtkHapticPointShell> tool;
 *   tool->SetMesh(reader->GetOutput()); // world units
 *   filter->SetTool(tool);
 *
 * The surface becomes points with areas, spread evenly. Each point that is in solid material is
 * pressed out of it (equations: Documentation/method.md, "Tools with a shape"):
 *
 * - **solid** is what is beyond a contact value of the scalars. By default it follows from the
 *   surface strength of vtkHapticProperty: see vtkHapticShapedTool;
 * - **the pressure** grows with the depth of a point, with the stiffness of the material per
 *   ContactArea, up to its surface strength per ContactArea. A tool that touches with the
 *   ContactArea thus feels like the point without a tool. Stiffness and strength are those of the
 *   material behind the surface, or of its label;
 * - **the coupling**: the tool lags behind the hand on a spring and a turning spring, and rests
 *   where these and the pressure are in balance (a quasi-static coupling; Wan and McNeely 2003).
 *   The hand feels the springs' force and torque. It gets back at most the energy that it has put
 *   in.
 *
 * The origin of the mesh is at the device's tip, and its axes are those of the stylus (see
 * vtkHapticTool), which points along its own -z. A device that measures no orientation holds the
 * tool as vtkHapticVirtualHand::SetToolOrientation says, and a device without torque only gives the
 * force. A tool that begins in solid material is free to leave it.
 *
 * It needs the method PROXY, and a volume that does not move. Friction is not felt. In the trace,
 * the points (proxies) are the origins of the tool, Force and Torque act on the hand, and Contact
 * says whether the tool is free (0), held (1), or yields at all points of contact (3). There is an
 * array that only this tool has:
 *
 *   ToolOrientation (4)  of the tool in the world: w, x, y, z
 *
 * @sa vtkHapticShapedTool
 */
#ifndef vtkHapticPointShell_h
#define vtkHapticPointShell_h

#include "vtkHapticShapedTool.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkPolyData;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticPointShell : public vtkHapticShapedTool
{
public:
  static vtkHapticPointShell* New();
  vtkTypeMacro(vtkHapticPointShell, vtkHapticShapedTool);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The surface of the tool, in world units: polygons or strips that are closed and face outwards.
   * Coinciding corners are merged. Default: no mesh, which can't be felt.
   */
  void SetMesh(vtkPolyData* mesh);
  vtkPolyData* GetMesh();
  ///@}

  ///@{
  /**
   * The number of points on the surface. From 1 to 100000 can be felt; points that would represent
   * no area are left out. Default 2000.
   *
   * The distance between points is about the square root of the tool's area over their number:
   * smaller details of the volume are missed. One core of a PC ticks 10 000 points at 1 kHz, and a
   * few thousand of them may be in contact; the time grows with their number. Spreading 2000 points
   * takes a quarter of a second, 100 000 points some seconds: a vtkHapticDevice does this in the
   * background, and the hand feels the old model until vtkHapticDevice::IsPublished().
   */
  vtkSetClampMacro(NumberOfPoints, int, 0, 1000000);
  vtkGetMacro(NumberOfPoints, int);
  ///@}

  ///@{
  /**
   * The stiffness of the turning spring between hand and tool (N m/rad), more than 0. Default 0.5.
   */
  vtkSetClampMacro(TurningStiffness, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(TurningStiffness, double);
  ///@}

  /** Returns the latest modification time of this tool and its mesh. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticPointShell();
  ~vtkHapticPointShell() override;

  vtkSmartPointer<vtkPolyData> Mesh;
  int NumberOfPoints = 2000;
  double TurningStiffness = 0.5;

private:
  vtkHapticPointShell(const vtkHapticPointShell&) = delete;
  void operator=(const vtkHapticPointShell&) = delete;
};

#endif

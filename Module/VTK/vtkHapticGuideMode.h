// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticGuideMode
 * @brief   a path that guides the hand
 *
 * A virtual fixture: the hand is drawn to the nearest place on a polyline, and held there, with the
 * Strength (N), a function of the distance from it (world units). It moves freely along the line. A
 * trace of vtkVolumeHapticsFilter, or a stream line of vtkStreamTracer, may be such a path.
 *
 * Corners are rounded over a voxel as far as directions go, so that a hand outside of a corner
 * rests at it; places stay those of the line. Lines with many small corners feel rough: smooth
 * them, for example with vtkSplineFilter.
 *
 * @sa vtkHapticMode
 */
#ifndef vtkHapticGuideMode_h
#define vtkHapticGuideMode_h

#include "vtkHapticMode.h"
#include "vtkSmartPointer.h"        // for ivars
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkPolyData;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticGuideMode : public vtkHapticMode
{
public:
  static vtkHapticGuideMode* New();
  vtkTypeMacro(vtkHapticGuideMode, vtkHapticMode);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The polylines, in world units: the lines of a polydata or, if it has none, all its points in
   * their order as one line. Of several lines, the nearest one guides. A line that ends at its
   * first point is closed; others hold the hand at their ends.
   */
  void SetPath(vtkPolyData* path);
  vtkPolyData* GetPath();
  ///@}

  /** Includes the path. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticGuideMode();
  ~vtkHapticGuideMode() override;

  vtkSmartPointer<vtkPolyData> Path;

private:
  vtkHapticGuideMode(const vtkHapticGuideMode&) = delete;
  void operator=(const vtkHapticGuideMode&) = delete;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Shows a large volume coarsely, and finely where its samples are in memory.
 *
 * A vtkVolume shows the coarse image of a vtkHapticRegionSource. The box of the resident region is
 * cut out of it, and the felt samples are shown there. Before each frame, the box follows the hand.
 * A worker copies the samples of the box, so that neither the servo nor the GUI thread waits; at
 * most two copies exist, the shown one and the next one. The coarse image alone is shown while it
 * stands in for late samples, and if the axes of the two images are not parallel.
 *
 * The planes of the box divide the coarse volume around it into 26 parts. The parts behind the box
 * are drawn first, then the box, then the parts in front of it, so that the picture looks like one
 * volume from all sides. The mappers of box and parts have the class of the volume's mapper.
 */
#ifndef RegionPicture_h
#define RegionPicture_h

#include "vtkType.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory>

class vtkHapticRegionSource;
class vtkRenderer;
class vtkVolume;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

class VTKVOLUMEHAPTICS_EXPORT RegionPicture
{
public:
  RegionPicture();
  ~RegionPicture();
  RegionPicture(const RegionPicture&) = delete;
  RegionPicture& operator=(const RegionPicture&) = delete;

  /** Sets the source of the felt samples; null: none. */
  void SetSource(vtkHapticRegionSource* source);
  /**
   * Sets the filter that feels the source. Tissue that its tools have removed (vtkHapticBurr) is
   * then hidden, both at full and at coarse resolution: the volume's mapper gets a copy of its
   * image in which each coarse voxel has the mean of the remaining tissue. The mapper gets its own
   * image back when the volume is released. Null: all tissue is shown.
   */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  ///@{
  /**
   * Sets the volume that shows the coarse image, and its mapper's cropping. The mapper's image must
   * not have a direction matrix; use the volume's matrix to rotate it.
   */
  void SetVolume(vtkVolume* volume);
  vtkVolume* GetVolume() const;
  ///@}
  /** Sets the renderer that shows the box, without a reference; null removes the box. */
  void SetRenderer(vtkRenderer* renderer);
  /**
   * Sets the largest number of voxels in the box; 262144 by default. A larger box shows every
   * second voxel along each axis, or every third, and so on, because mappers compute all gradients
   * within one frame.
   */
  void SetMaximumVoxels(vtkIdType voxels) { this->MaximumVoxels = voxels; }

  /** Updates the picture to source and camera. The renderer calls this before each frame. */
  void Update();
  /** Returns whether a box is shown at full resolution. */
  bool IsRefined() const;
  /** Returns the volume that shows the box, with the property of the coarse volume. */
  vtkVolume* GetFineVolume() const;

private:
  class Internal;
  std::unique_ptr<Internal> Internals;
  vtkIdType MaximumVoxels = 262144;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Shows a large volume coarsely, and finely where its samples are in memory.
 *
 * A vtkVolume shows the coarse image of a vtkHapticRegionSource. The box of the resident region is
 * cut out of it, and the felt samples are shown there. The box follows the hand, before each
 * picture. A thread copies the samples of the box, so that neither servo nor GUI thread waits; at
 * most two copies exist, the shown and the next one. Only the coarse image is shown where it
 * replaces late samples, and if the axes of the two images are not parallel.
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

  /** Sets the source of the felt samples; null for none. */
  void SetSource(vtkHapticRegionSource* source);
  /**
   * Sets the filter that feels the source. Tissue that its tools have removed (vtkHapticBurr) is
   * then shown neither finely nor coarsely: the volume's mapper gets a copy of its image in which
   * each coarse voxel has the mean of what is left. The mapper gets its image back when the volume
   * is released. Null: all tissue is shown.
   */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  ///@{
  /**
   * The volume that shows the coarse image. The image of its mapper has no direction of its own;
   * the volume's matrix may turn it. This class sets the mapper's cropping.
   */
  void SetVolume(vtkVolume* volume);
  vtkVolume* GetVolume() const;
  ///@}
  /** Sets the renderer that shows the box, which is not kept alive; null removes the box. */
  void SetRenderer(vtkRenderer* renderer);
  /**
   * Sets the most voxels of the box, 262144 at first. A larger box shows every second voxel along
   * each axis, or every third one, and so on, because mappers compute all gradients within one
   * picture.
   */
  void SetMaximumVoxels(vtkIdType voxels) { this->MaximumVoxels = voxels; }

  /** Follows source and camera. The renderer calls this before each picture. */
  void Update();
  /** Returns whether a box is shown finely. */
  bool IsRefined() const;
  /** Returns the volume of the box, which has the property of the coarse volume. */
  vtkVolume* GetFineVolume() const;

private:
  class Internal;
  std::unique_ptr<Internal> Internals;
  vtkIdType MaximumVoxels = 262144;
};

} // namespace VolumeHaptics

#endif

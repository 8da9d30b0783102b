// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticRegionPicture
 * @brief   shows a large volume coarsely, and finely where its samples are in memory
 *
 * A vtkVolume shows the coarse image of a vtkHapticRegionSource. In the box of the resident region,
 * this class shows the felt samples instead:
 *
 *   coarse->SetMapper(mapper); // of source->GetCoarseImage()
 *   renderer->AddVolume(coarse);
 *   picture->SetSource(source);
 *   picture->SetVolumeHaptics(filter);
 *   picture->SetVolume(coarse);
 *   picture->SetRenderer(renderer);
 *
 * From then on, the box follows the hand: it is updated before each frame. A thread copies the
 * samples of the box, so that neither the servo nor the GUI thread waits. At most two copies exist:
 * the shown one and the next one. The coarse image alone is shown while samples are late, and if
 * the axes of the two images are not parallel.
 *
 * The planes of the box divide the coarse volume around it into 26 parts. The parts behind the box
 * are drawn first, then the box, then the parts in front of it, so that they look like one volume
 * from all sides. The mappers of the box and of the parts have the same class as the volume's
 * mapper.
 *
 * @sa vtkHapticRegionSource
 */
#ifndef vtkHapticRegionPicture_h
#define vtkHapticRegionPicture_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#ifndef __VTK_WRAP__
#include <memory> // for std::unique_ptr
#endif

class vtkHapticRegionSource;
class vtkRenderer;
class vtkVolume;
class vtkVolumeHapticsFilter;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticRegionPicture : public vtkObject
{
public:
  static vtkHapticRegionPicture* New();
  vtkTypeMacro(vtkHapticRegionPicture, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The source of the felt samples. Default: none. */
  void SetSource(vtkHapticRegionSource* source);
  vtkHapticRegionSource* GetSource();
  ///@}

  ///@{
  /**
   * The filter that feels the source. If it is set, tissue that its tools have removed
   * (vtkHapticBurr) is shown neither finely nor coarsely. For this, the volume's mapper gets a copy
   * of its image in which each coarse voxel has the mean of the remaining tissue; it gets its image
   * back when this object releases the volume. Default: none, so that all tissue is shown.
   */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  vtkVolumeHapticsFilter* GetVolumeHaptics();
  ///@}

  ///@{
  /**
   * The volume that shows the coarse image. The image of its mapper must have no direction of its
   * own, but the volume's matrix may turn it. This class sets the mapper's cropping. Default: none.
   */
  void SetVolume(vtkVolume* volume);
  vtkVolume* GetVolume();
  ///@}

  ///@{
  /**
   * The renderer in which the box is shown; nullptr removes the box. The renderer is not kept
   * alive. Default: none.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * The most voxels that the box shows, 1000 to 2^30. Default 262144. Of a larger box, only every
   * second or third voxel (and so on) along each axis is shown, because mappers compute all
   * gradients within one frame.
   */
  vtkSetClampMacro(MaximumVoxels, vtkIdType, 1000, 1073741824);
  vtkGetMacro(MaximumVoxels, vtkIdType);
  ///@}

  /** Update the box for the source and the camera. The renderer calls this before each frame. */
  void Update();

  /** Get whether a box is shown finely. */
  bool IsRefined();

  /** Get the volume of the box, which has the property of the coarse volume. */
  vtkVolume* GetFineVolume();

protected:
  vtkHapticRegionPicture();
  ~vtkHapticRegionPicture() override;

private:
  vtkIdType MaximumVoxels = 262144;
#ifndef __VTK_WRAP__
  class Internal;
  std::unique_ptr<Internal> Internals;
#endif

  vtkHapticRegionPicture(const vtkHapticRegionPicture&) = delete;
  void operator=(const vtkHapticRegionPicture&) = delete;
};

#endif

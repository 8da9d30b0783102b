// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticRegionPicture
 * @brief   shows a large volume coarsely, and finely where its samples are in memory
 *
 * A vtkVolume shows the coarse image of a vtkHapticRegionSource. This class cuts the box of the
 * resident region out of the coarse image, and shows the felt samples there:
 *
 *   coarse->SetMapper(mapper); // of source->GetCoarseImage()
 *   renderer->AddVolume(coarse);
 *   picture->SetSource(source);
 *   picture->SetVolumeHaptics(filter);
 *   picture->SetVolume(coarse);
 *   picture->SetRenderer(renderer);
 *
 * From then on the box follows the hand, before each picture. A thread copies the samples of the
 * box, so that neither servo nor GUI thread waits; at most two copies exist, the shown and the next
 * one. Only the coarse image is shown where it replaces late samples, and if the axes of the two
 * images are not parallel.
 *
 * The planes of the box divide the coarse volume around it into 26 parts. The parts behind the box
 * are drawn first, then the box, then the parts in front of it, so that the picture looks like one
 * volume from all sides. The mappers of box and parts have the class of the volume's mapper.
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
   * The filter that feels the source. Tissue that its tools have removed (vtkHapticBurr) is then
   * shown neither finely nor coarsely: the volume's mapper gets a copy of its image in which each
   * coarse voxel has the mean of what is left. The mapper gets its image back when this object
   * releases the volume. Default: none, so that all tissue is shown.
   */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  vtkVolumeHapticsFilter* GetVolumeHaptics();
  ///@}

  ///@{
  /**
   * The volume that shows the coarse image. The image of its mapper has no direction of its own;
   * the volume's matrix may turn it. This class sets the mapper's cropping. Default: none.
   */
  void SetVolume(vtkVolume* volume);
  vtkVolume* GetVolume();
  ///@}

  ///@{
  /**
   * The renderer that shows the box; nullptr removes it. The renderer is not kept alive. Default:
   * none.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * The most voxels of the box, 1000 to 2^30. Default 262144. A larger box shows every second voxel
   * along each axis, or every third one, and so on, because mappers compute all gradients within
   * one picture.
   */
  vtkSetClampMacro(MaximumVoxels, vtkIdType, 1000, 1073741824);
  vtkGetMacro(MaximumVoxels, vtkIdType);
  ///@}

  /** Follow source and camera. The renderer calls this before each picture. */
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

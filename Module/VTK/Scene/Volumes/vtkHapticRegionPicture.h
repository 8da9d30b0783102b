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
 * From then on the box follows the hand, before each frame. A thread copies its samples, so that
 * neither servo nor GUI thread waits; there are two copies at most: the shown one and the next one.
 * Only the coarse image is shown where it replaces late samples, and if the axes of the two images
 * are not parallel.
 *
 * The parts of the coarse volume behind the box are drawn first, then the box, then the parts in
 * front of it: whichever of the 26 parts around the box lies on the viewer's side of all planes
 * that divide it from the box. So the picture looks like one volume from all sides. The mappers of
 * box and parts have the class of the volume's mapper.
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
  /** What is felt. Default: none. */
  void SetSource(vtkHapticRegionSource* source);
  vtkHapticRegionSource* GetSource();
  ///@}

  ///@{
  /**
   * The filter that feels the source. What its tools have removed (vtkHapticBurr) is then neither
   * shown finely nor coarsely: the volume's mapper gets a copy of its image with what is left, of
   * each coarse voxel the mean, until this leaves it. Default: none, so that all tissue is shown.
   */
  void SetVolumeHaptics(vtkVolumeHapticsFilter* filter);
  vtkVolumeHapticsFilter* GetVolumeHaptics();
  ///@}

  ///@{
  /**
   * What shows the coarse image, with a mapper whose image has no direction of its own (the
   * volume's matrix may turn it). Its cropping belongs to this. Default: none.
   */
  void SetVolume(vtkVolume* volume);
  vtkVolume* GetVolume();
  ///@}

  ///@{
  /** Where it is shown; null takes the box out of it again. It is not kept alive. Default: none. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * The most voxels of the box, 1000 to 2^30. Default 262144. Of a larger one every second one is
   * shown along each axis, or every third one, and so on: mappers compute gradients within a frame.
   */
  vtkSetClampMacro(MaximumVoxels, vtkIdType, 1000, 1073741824);
  vtkGetMacro(MaximumVoxels, vtkIdType);
  ///@}

  /** Follow source and camera. It is called before each frame of the renderer. */
  void Update();

  /** Whether a box is shown finely. */
  bool IsRefined();

  /** The volume of the box; it shares the property of the coarse one. */
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

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticFrameSource
 * @brief   images in memory as the time steps of a volume that moves
 *
 * Gives a vtkVolumeHapticsFilter a volume that moves from images that are in memory, such as the
 * phases of a breath, each of which another reader has read:
 *
 *   source->AddFrame(exhaled, 0.0);
 *   source->AddFrame(inhaled, 2.0);
 *   filter->SetInputConnection(source->GetOutputPort());
 *   device->SetPlaybackToPingPong();
 *   device->Play();
 *
 * The output shares the arrays of the frame at the requested time (UPDATE_TIME_STEP), or of the
 * last one before it. Nothing is copied, not even if it is felt: do not change the arrays
 * meanwhile. All frames need the same extent, spacing, origin and direction; the filter tells if
 * one has others.
 *
 * @sa vtkVolumeHapticsFilter, vtkHapticDevice
 */
#ifndef vtkHapticFrameSource_h
#define vtkHapticFrameSource_h

#include "vtkImageAlgorithm.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr

class VTKVOLUMEHAPTICS_EXPORT vtkHapticFrameSource : public vtkImageAlgorithm
{
public:
  static vtkHapticFrameSource* New();
  vtkTypeMacro(vtkHapticFrameSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Add an image at a time (finite, in any unit), which the source keeps by reference; in any
   * order. An image at the time of another one replaces it. False, with an error, if there is no
   * image or the time is not finite.
   */
  bool AddFrame(vtkImageData* image, double time);
  void RemoveAllFrames();

  ///@{
  /** The frames in the order of their times; nullptr and 0 for a number that there is not. */
  int GetNumberOfFrames();
  vtkImageData* GetFrame(int number);
  double GetFrameTime(int number);
  ///@}

  /** Changes of the frames' images count. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticFrameSource();
  ~vtkHapticFrameSource() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkHapticFrameSource(const vtkHapticFrameSource&) = delete;
  void operator=(const vtkHapticFrameSource&) = delete;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticFrameSource
 * @brief   images in memory as the time steps of a volume that moves
 *
 * Makes a moving volume for a vtkVolumeHapticsFilter from images in memory, such as the phases of a
 * breath, each read by a reader of its own:
 *
 *   source->AddFrame(exhaled, 0.0);
 *   source->AddFrame(inhaled, 2.0);
 *   filter->SetInputConnection(source->GetOutputPort());
 *   device->GetPlayback()->SetModeToPingPong();
 *   device->GetPlayback()->Play();
 *
 * The output shares the arrays of the frame at the requested time (UPDATE_TIME_STEP), or of the
 * last one before it. Nothing is copied, not even for the servo: do not change the arrays
 * meanwhile. All frames need the same extent, spacing, origin and direction; the filter reports one
 * that differs.
 *
 * A program that receives the frames one by one, for example to animate them, passes the last two;
 * a device then moves from one to the other (SetStreamed):
 *
 *   source->StreamedOn();
 *   source->RemoveAllFrames();
 *   source->AddFrame(lastOne, lastTime);
 *   source->AddFrame(nextOne, nextTime);
 *   device->Publish();
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
   * Add an image at a time (finite, in any unit); the order of the calls does not matter. The
   * source keeps a reference to the image. An image at the time of an earlier one replaces it.
   * False, with an error, if there is no image or the time is not finite.
   */
  bool AddFrame(vtkImageData* image, double time);
  void RemoveAllFrames();

  ///@{
  /**
   * Get the frames in the order of their times; nullptr and 0 if there is no frame of this number.
   */
  int GetNumberOfFrames();
  vtkImageData* GetFrame(int number);
  double GetFrameTime(int number);
  ///@}

  ///@{
  /**
   * Whether frames that come and go belong to one volume. A device that plays them then moves from
   * its frames to the new ones without a step of the force, with the noise and the material of the
   * first frames. Frames that arrive before the device has reached the end of the last frames wait
   * until then, as the status text says. If frames were left out, the last frame is blended to the
   * next one; with SURFACE_PROXY, or if the next frames are of another region, the contact begins
   * anew instead. Frames may also be regions of a volume, if all frames at a time are of the same
   * region. Off (default): a change of the frames is another volume.
   */
  vtkSetMacro(Streamed, bool);
  vtkGetMacro(Streamed, bool);
  vtkBooleanMacro(Streamed, bool);
  ///@}

  /** Includes the change times of the frames' images. */
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

  bool Streamed = false;
  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif

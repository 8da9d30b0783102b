// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticTimeStepSource
 * @brief   images in memory as the time steps of a volume that moves
 *
 * Makes a moving volume for a vtkVolumeHapticsFilter from images in memory, such as the phases of a
 * breath, each read by a reader of its own:
 *
 *   source->AddTimeStep(exhaled, 0.0);
 *   source->AddTimeStep(inhaled, 2.0);
 *   filter->SetInputConnection(source->GetOutputPort());
 *   device->GetPlayback()->SetModeToPingPong();
 *   device->GetPlayback()->Play();
 *
 * The output shares the arrays of the time step at the requested time (UPDATE_TIME_STEP), or of the
 * last one before it. Nothing is copied, not even for the servo: do not change the arrays while
 * they are felt. All time steps need the same extent, spacing, origin and direction; the filter
 * reports a time step that differs.
 *
 * A program that receives the time steps one by one, for example to animate them, passes the last
 * two; a device then moves from one to the other (SetStreamed):
 *
 *   source->StreamedOn();
 *   source->RemoveAllTimeSteps();
 *   source->AddTimeStep(lastOne, lastTime);
 *   source->AddTimeStep(nextOne, nextTime);
 *   device->Publish();
 *
 * @sa vtkVolumeHapticsFilter, vtkHapticDevice
 */
#ifndef vtkHapticTimeStepSource_h
#define vtkHapticTimeStepSource_h

#include "vtkImageAlgorithm.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <memory> // for std::unique_ptr

class VTKVOLUMEHAPTICS_EXPORT vtkHapticTimeStepSource : public vtkImageAlgorithm
{
public:
  static vtkHapticTimeStepSource* New();
  vtkTypeMacro(vtkHapticTimeStepSource, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Add an image at a time (finite, in any unit); the order of the calls does not matter. The
   * source keeps a reference to the image. An image at the time of an earlier one replaces it.
   * Returns false and reports an error without an image or a finite time.
   */
  bool AddTimeStep(vtkImageData* image, double time);
  void RemoveAllTimeSteps();

  ///@{
  /**
   * Get the time steps in ascending order of time. For an index out of range, the image is nullptr
   * and the value is 0.
   */
  int GetNumberOfTimeSteps();
  vtkImageData* GetTimeStepImage(int number);
  double GetTimeStepValue(int number);
  ///@}

  ///@{
  /**
   * Whether time steps that are added and removed belong to one volume. A device that plays them
   * then moves from its time steps to the new ones without a step of the force, with the noise and
   * the material of the first time steps. Time steps that arrive before the device has reached the
   * end of the last time steps wait until then, as the status text says. If time steps were left
   * out, the last time step is blended to the next one; with SURFACE_PROXY, or if the next time
   * steps are of another region, the contact begins anew instead. Time steps may also be regions of
   * a volume, if all time steps at a time are of the same region. Off (default): changed time steps
   * are another volume.
   */
  vtkSetMacro(Streamed, bool);
  vtkGetMacro(Streamed, bool);
  vtkBooleanMacro(Streamed, bool);
  ///@}

  /** Returns the latest modification time of the source and its images. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticTimeStepSource();
  ~vtkHapticTimeStepSource() override;

  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkHapticTimeStepSource(const vtkHapticTimeStepSource&) = delete;
  void operator=(const vtkHapticTimeStepSource&) = delete;

  bool Streamed = false;
  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif

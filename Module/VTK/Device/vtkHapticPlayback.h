// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticPlayback
 * @brief   plays the time steps of a moving volume while a hand feels it
 *
 * Plays the time steps of the volume that a hand feels with a vtkHapticDevice:
 *
 *   device->SetVolumeHaptics(filter);        // its source has several time steps
 *   device->Start();
 *   vtkHapticPlayback* playback = device->GetPlayback();
 *   playback->SetModeToLoop();
 *   playback->SetSpeed(0.5);                 // half as fast as the filter says
 *   playback->Play();
 *   ... in the GUI's timer: device->UpdateState(); show playback->GetTimeStepImage() ...
 *   playback->Hold();
 *
 * @sa vtkHapticDevice, vtkHapticTimeStepSource
 */
#ifndef vtkHapticPlayback_h
#define vtkHapticPlayback_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkImageData;

#ifndef __VTK_WRAP__
namespace VolumeHaptics
{
struct DeviceParts;
} // namespace VolumeHaptics
#endif

class VTKVOLUMEHAPTICS_EXPORT vtkHapticPlayback : public vtkObject
{
public:
  static vtkHapticPlayback* New();
  vtkTypeMacro(vtkHapticPlayback, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Play a volume that moves: a volume whose source has several time steps, or whose components are
   * time steps (SetFramesToComponents of the filter). Before the first Play or SetDataTime the
   * volume stands still, and the time step that the source shows, or the component that the
   * property names, is felt.
   *
   * While it plays, data time advances in every tick of the servo by TimeUnitsPerSecond of the
   * filter for each second, also backwards, and time steps are blended. Play, Hold, another speed
   * and another end never step the data time nor the force. At the end of the time steps, it holds
   * (ModeToOnce, the default), blends the last step into the first one during a mean interval and
   * plays again (ModeToLoop), or plays backwards (ModeToPingPong).
   *
   * SetDataTime jumps to another time, in the units of the source; beyond the time steps, the
   * nearest step is used. The volume there is felt as a new one: a force that would jump begins
   * again at zero. GetDataTime returns the data time of the latest state, or the time of
   * SetDataTime until it is felt; default 0. In the interval after the last step, it is above the
   * last step's time.
   *
   * vtkHapticDevice::UpdateState reads the time steps ahead of the servo, three in memory at most:
   * when SetDataTime jumps to a pair of two other steps, one of them may be felt alone for a
   * moment. If steps are late, data time stands still: IsWaitingForData becomes true, and
   * vtkHapticDevice::GetStatusText says which steps are awaited. Components are felt in their
   * array, without a copy.
   */
  void Play();
  void Hold();
  bool IsPlaying(); ///< Get whether Play was called last, not Hold. Default false.
  enum ModeType
  {
    ONCE = 0,
    LOOP = 1,
    PING_PONG = 2
  };
  void SetMode(int mode);
  int GetMode();
  void SetModeToOnce() { this->SetMode(ONCE); }
  void SetModeToLoop() { this->SetMode(LOOP); }
  void SetModeToPingPong() { this->SetMode(PING_PONG); }
  void SetDataTime(double time);
  double GetDataTime();
  bool IsWaitingForData();
  ///@}

  ///@{
  /**
   * The speed of playback, as a multiple of the filter's TimeUnitsPerSecond; negative plays
   * backwards. Unlike TimeUnitsPerSecond, it needs no Publish. -1e6 to 1e6, default 1.
   */
  void SetSpeed(double factor);
  double GetSpeed();
  ///@}

  ///@{
  /**
   * Get the felt time step, the one nearest to GetDataTime: an image whose scalars are the touched
   * array of this time step (or the component that is this time step), and its time. The image
   * stays the same until the time step changes; do not change its samples. vtkInteractorStyleHaptic
   * shows it automatically. nullptr if HasTimeSteps is false, because no moving volume is felt.
   */
  bool HasTimeSteps();
  vtkImageData* GetTimeStepImage();
  double GetTimeStepValue();
  ///@}

protected:
  vtkHapticPlayback() = default;
  ~vtkHapticPlayback() override = default;

private:
#ifndef __VTK_WRAP__
  friend struct VolumeHaptics::DeviceParts;

  /** Returns the parts of the device. Without a device, reports an error and returns null. */
  VolumeHaptics::DeviceParts* GetParts();

  VolumeHaptics::DeviceParts* Parts = nullptr; // null without a device
#endif

  vtkHapticPlayback(const vtkHapticPlayback&) = delete;
  void operator=(const vtkHapticPlayback&) = delete;
};

#endif

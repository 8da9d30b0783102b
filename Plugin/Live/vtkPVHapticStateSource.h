// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHapticStateSource
 * @brief   the state of a device in ParaView's client, as geometry on the data server
 *
 * The output is the same as that of vtkHapticStateSource. The state comes from the client, through
 * vtkSMHapticDeviceProxy. If there are several processes, the first one has the output.
 */
#ifndef vtkPVHapticStateSource_h
#define vtkPVHapticStateSource_h

#include "VolumeHapticsLiveModule.h" // for export macro
#include "vtkHapticStateSource.h"

class VOLUMEHAPTICSLIVE_EXPORT vtkPVHapticStateSource : public vtkHapticStateSource
{
public:
  static vtkPVHapticStateSource* New();
  vtkTypeMacro(vtkPVHapticStateSource, vtkHapticStateSource);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Set the touched filter. This does nothing but show in ParaView that the two belong together.
   */
  void SetTouch(vtkObject*) {}

  /** The number of values in a state. */
  static constexpr int Length = 30;

  /**
   * Set the values of a state: 1 (0 if there is no state); tip, proxy, x_s, x_v (world units);
   * commanded and computed force (N); normal; force of the surface and of friction (N); contact;
   * value at the surface; orientation of the stylus (w, x, y, z; all 0 if there is none).
   */
  void SetState(const double state[30]);

  /** Get whether the state is newer than the output. ParaView calls this for every live source. */
  bool GetNeedsUpdate();

protected:
  vtkPVHapticStateSource() = default;
  ~vtkPVHapticStateSource() override = default;

#ifndef __VTK_WRAP__
  bool ReadState(ShownState& state) override;
#endif
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPVHapticStateSource(const vtkPVHapticStateSource&) = delete;
  void operator=(const vtkPVHapticStateSource&) = delete;

  double State[Length] = {};
  bool IsNew = false;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVHapticStateSource
 * @brief   the state of a device in ParaView's client, as geometry on the data server
 *
 * The output equals that of vtkHapticState::GetGeometry. The state comes from the client, through
 * vtkSMHapticDeviceProxy. Of several processes, only the first one has an output.
 */
#ifndef vtkPVHapticStateSource_h
#define vtkPVHapticStateSource_h

#include "VolumeHapticsLiveModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

class VOLUMEHAPTICSLIVE_EXPORT vtkPVHapticStateSource : public vtkPolyDataAlgorithm
{
public:
  static vtkPVHapticStateSource* New();
  vtkTypeMacro(vtkPVHapticStateSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Set the touched filter. This has no effect except that ParaView shows the connection. */
  void SetTouch(vtkObject*) {}

  ///@{
  /** Newtons per world unit in the output. Default 0.1: a line of 10 world units for 1 N. */
  vtkSetClampMacro(ForceScale, double, 1e-9, VTK_DOUBLE_MAX);
  vtkGetMacro(ForceScale, double);
  ///@}

  ///@{
  /**
   * Whether the output shows the force that was sent to the device, or (default) the computed
   * force, armed or not.
   */
  vtkSetMacro(ShowCommandedForce, bool);
  vtkGetMacro(ShowCommandedForce, bool);
  ///@}

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
  vtkPVHapticStateSource();
  ~vtkPVHapticStateSource() override = default;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkPVHapticStateSource(const vtkPVHapticStateSource&) = delete;
  void operator=(const vtkPVHapticStateSource&) = delete;

  double State[Length] = {};
  double ForceScale = 0.1;
  bool ShowCommandedForce = false;
  bool IsNew = false;
};

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticStateSource
 * @brief   the latest state of a device as geometry, for any pipeline
 *
 * Shows the latest state of a device in any pipeline:
 *
 *   source->SetDevice(device);
 *   mapper->SetInputConnection(source->GetOutputPort());
 *
 * The output consists of plain cells with the content of vtkHapticRepresentation: vertices for the
 * tip, the proxy and the positions x_s and x_v at which the materials were read, and lines for the
 * spring and the forces. The cell array "Part" identifies them (see Parts); "Newtons" (N) is the
 * size of a force. Lines begin at the point on which a force acts and are Newtons / ForceScale
 * world units long. The field arrays "Contact", "SurfaceValue" and "Orientation" hold the state's
 * values; the last one is w, x, y, z as in vtkHapticState::GetTipOrientation, all 0 if the device
 * has none. The output is empty without a device or before its first state.
 *
 * The owner of the device calls its UpdateState(); the output is out of date whenever this call
 * found a new state.
 *
 * @sa vtkHapticDevice, vtkHapticRepresentation
 */
#ifndef vtkHapticStateSource_h
#define vtkHapticStateSource_h

#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"        // for vtkSmartPointer
#include "vtkVector.h"              // for vtkVector3d
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkHapticDevice;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticStateSource : public vtkPolyDataAlgorithm
{
public:
  static vtkHapticStateSource* New();
  vtkTypeMacro(vtkHapticStateSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The meaning of a cell. */
  enum Parts
  {
    TIP = 0,
    PROXY = 1,
    SURFACE_POSITION = 2, ///< x_s
    MEDIUM_POSITION = 3,  ///< x_v
    SPRING = 4,           ///< line from the tip to the proxy
    FORCE = 5,            ///< line from the tip: the force on the hand
    NORMAL_FORCE = 6,     ///< line from the proxy: the push of the surface
    FRICTION_FORCE = 7    ///< line from the proxy: the friction of the surface
  };

  ///@{
  void SetDevice(vtkHapticDevice* device);
  vtkHapticDevice* GetDevice();
  ///@}

  ///@{
  /**
   * Newtons per world unit in the output. Default 0.1: a line of 10 world units for 1 N.
   */
  vtkSetClampMacro(ForceScale, double, 1e-9, VTK_DOUBLE_MAX);
  vtkGetMacro(ForceScale, double);
  ///@}

  ///@{
  /**
   * Whether the output shows the force that went to the device, or (default) the computed force,
   * armed or not.
   */
  vtkSetMacro(ShowCommandedForce, bool);
  vtkGetMacro(ShowCommandedForce, bool);
  vtkBooleanMacro(ShowCommandedForce, bool);
  ///@}

  /** Includes the modification time of the device's latest state. */
  vtkMTimeType GetMTime() override;

protected:
  vtkHapticStateSource();
  ~vtkHapticStateSource() override;

#ifndef __VTK_WRAP__
  /** The shown state: positions in world units, forces in N along the world's axes. */
  struct ShownState
  {
    vtkVector3d Tip;
    vtkVector3d Proxy;
    vtkVector3d SurfacePosition;
    vtkVector3d MediumPosition;
    vtkVector3d Force;
    vtkVector3d ComputedForce;
    vtkVector3d Normal;
    double NormalForce = 0.0;
    double FrictionForce = 0.0;
    double Contact = 0.0;
    double SurfaceValue = 0.0;
    double Orientation[4] = {}; ///< w, x, y, z; all 0 if there is none
  };

  /**
   * Read the device's state. Returns false if there is none. Subclasses may read the state from
   * another source.
   */
  virtual bool ReadState(ShownState& state);
#endif

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  vtkSmartPointer<vtkHapticDevice> Device;
  double ForceScale = 0.1;
  bool ShowCommandedForce = false;

private:
  vtkHapticStateSource(const vtkHapticStateSource&) = delete;
  void operator=(const vtkHapticStateSource&) = delete;

  vtkTimeStamp StateTime;
  double SeenTime = -1.0;
};

#endif

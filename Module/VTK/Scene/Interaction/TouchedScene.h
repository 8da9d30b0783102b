// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The device, the props and the view that the parts of an interaction share.
 */
#ifndef TouchedScene_h
#define TouchedScene_h

#include "Core/Math/Vector3.h"

#include "vtkHapticDevice.h"
#include "vtkHapticFunctionEditor.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticMeasurements.h"
#include "vtkHapticSliceView.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkImageData;
class vtkInteractorStyleHaptic;
class vtkRenderer;

namespace VolumeHaptics
{

/**
 * The objects that the parts of a HapticInteraction share. The application may set each of them to
 * null at any time, even in an observer of an event that a part causes.
 */
class TouchedScene
{
public:
  explicit TouchedScene(vtkInteractorStyleHaptic* style)
    : Style(style)
  {
  }

  vtkInteractorStyleHaptic* const Style; ///< owns the interaction
  vtkSmartPointer<vtkHapticDevice> Device;
  vtkSmartPointer<vtkHapticHeadUpDisplay> Display;
  vtkSmartPointer<vtkHapticFunctionEditor> Editor;
  vtkSmartPointer<vtkHapticSliceView> Slices;
  vtkSmartPointer<vtkHapticMeasurements> Measurements;
  const TouchedScene* Second = nullptr; ///< the scene with the second hand's device
  bool TurnsView = true; ///< whether the right button turns the view in the touch mode
  /** why the touched volume is not visible, and the cure; empty if it is visible */
  std::string Hidden;

  /**
   * Returns the renderer of the last button event. VTK has none before the first button event; then
   * returns the default renderer, or if there is none, the window's first.
   */
  vtkRenderer* ChooseRenderer() const;

  /** Returns the image of the device's filter; null if there is no device, filter or image. */
  vtkImageData* GetImage() const;

  /** Returns whether the mouse leads the tip. */
  bool IsVirtual() const { return this->Device && this->Device->GetVirtualHand()->MayMouseLead(); }
  bool IsReal() const { return this->Device && this->Device->IsOpen() && !this->IsVirtual(); }
  /** Returns whether the device in either hand is real. */
  bool IsAnyReal() const { return this->IsReal() || (this->Second && this->Second->IsReal()); }

  ///@{
  /** Return parts of the device's last state. There must be a device. */
  bool IsArmed() const;
  Vector3 GetTip() const; ///< world
  Vector3 GetProxy() const;
  ///@}
};

} // namespace VolumeHaptics

#endif

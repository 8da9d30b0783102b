// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Stores the device, the props and the view that the parts of an interaction share.
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
 * Objects that the parts of a HapticInteraction share. The application may set any of them to null
 * at any time, even in an observer of an event that a part invokes.
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
  const TouchedScene* Second = nullptr; ///< scene with the second hand's device
  bool TurnsView = true; ///< whether the right button turns the view in the touch mode
  /** Reason and cure if the touched volume is not visible; empty if it is visible. */
  std::string Hidden;

  /**
   * Returns the renderer of the last button event. Before the first one, returns the default
   * renderer, or the window's first renderer if there is none.
   */
  vtkRenderer* ChooseRenderer() const;

  /** Returns the image of the device's filter; null without a device, filter or image. */
  vtkImageData* GetImage() const;

  /** Returns whether the mouse may move the tip. */
  bool IsVirtual() const { return this->Device && this->Device->GetVirtualHand()->MayMouseLead(); }
  bool IsReal() const { return this->Device && this->Device->IsOpen() && !this->IsVirtual(); }
  /** Returns whether the device in either hand is real. */
  bool IsAnyReal() const { return this->IsReal() || (this->Second && this->Second->IsReal()); }

  ///@{
  /** Return parts of the device's last state. Require a device. */
  bool IsArmed() const;
  Vector3 GetTip() const; ///< world
  Vector3 GetProxy() const;
  ///@}
};

} // namespace VolumeHaptics

#endif

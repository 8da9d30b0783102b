// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticViewStyle
 * @brief   vtkInteractorStyleHaptic in a render view of ParaView
 *
 * Draws with the view's StillRender and InteractiveRender, never with the window's Render, so that
 * data on servers are rendered, too. Picks in the renderer that shows the data, whichever of the
 * view's renderers is under the pointer. Of VTK's keys, only "r" remains, which resets the view's
 * camera, because the other keys would change actors that belong to ParaView. Keys arm the device
 * through its property Armed, which becomes 0 when the device is disarmed in another way. The key
 * for the next method sets Method and Solver of the touched filter.
 *
 * With software OpenGL, ParaView's volumes are drawn by VTK's ray caster for the CPU while the
 * scene is touched: without speckles, and at 20 frames a second. AutoAdjustVolumeQualityOff()
 * disables this.
 *
 * @sa vtkHapticViewLink
 */
#ifndef vtkHapticViewStyle_h
#define vtkHapticViewStyle_h

#include "VolumeHapticsViewModule.h" // for export macro
#include "vtkInteractorStyleHaptic.h"
#include "vtkWeakPointer.h" // for vtkWeakPointer

#include <memory> // for std::unique_ptr

namespace VolumeHaptics
{
class HapticSlices;
class HapticVolumeFrames;
} // namespace VolumeHaptics
class vtkSMHapticDeviceProxy;
class vtkSMRenderViewProxy;

class VOLUMEHAPTICSVIEW_EXPORT vtkHapticViewStyle : public vtkInteractorStyleHaptic
{
public:
  static vtkHapticViewStyle* New();
  vtkTypeMacro(vtkHapticViewStyle, vtkInteractorStyleHaptic);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The view, and the devices of the first and the second hand. They are weak references: a deleted
   * view is no longer drawn, and a deleted device no longer polled.
   */
  void SetView(vtkSMRenderViewProxy* view);
  void SetDeviceProxy(vtkSMHapticDeviceProxy* device);
  void SetSecondDeviceProxy(vtkSMHapticDeviceProxy* device);
  ///@}

  /**
   * Discards the list of volumes without restoring them. Call this before the end of a session,
   * because nothing may be sent to a server that may be lost.
   */
  void ForgetVolumes();

  ///@{
  /**
   * Whether the slices of the Orthographic Slice Views in the view's session move with the tip.
   * Default on.
   */
  vtkSetMacro(SlicesFollowTip, bool);
  vtkGetMacro(SlicesFollowTip, bool);
  vtkBooleanMacro(SlicesFollowTip, bool);
  ///@}

  /**
   * Sets a function that returns the pointer's position on the screen, in pixels. It is called
   * while a frame is drawn at rest; if the pointer has moved, the frame is aborted. Use it in
   * programs whose mouse events wait in a queue outside VTK. The dock window sets a function that
   * returns Qt's position. Null (default): frames are always completed.
   */
  static void SetPointerQuery(void (*query)(int position[2]));

  /** Sets the property Armed of the first device's proxy. */
  void SetArmed(bool on);

  /**
   * Sets the interactor. If the interactor releases this style (null), invokes
   * vtkCommand::DisableEvent.
   */
  void SetInteractor(vtkRenderWindowInteractor* interactor) override;
  void OnTimer() override;
  void OnKeyPress() override;
  void OnChar() override;

protected:
  vtkHapticViewStyle();
  ~vtkHapticViewStyle() override;

  void DrawScene(bool quickly) override;

private:
  vtkHapticViewStyle(const vtkHapticViewStyle&) = delete;
  void operator=(const vtkHapticViewStyle&) = delete;

  void ReportMethod();
  /** Arms the hands that are not armed; if both are armed, disarms both. */
  void ToggleArmed();
  void MoveSlices();

  vtkWeakPointer<vtkSMRenderViewProxy> View;
  vtkWeakPointer<vtkSMHapticDeviceProxy> DeviceProxy;
  vtkWeakPointer<vtkSMHapticDeviceProxy> SecondProxy;
  bool SlicesFollowTip = true;
  std::unique_ptr<VolumeHaptics::HapticSlices> Slices;
  std::unique_ptr<VolumeHaptics::HapticVolumeFrames> Frames;
  /**
   * Whether a timer event is being handled; another one may arrive while a view that renders waits
   * for its server.
   */
  bool IsBusy = false;
};

#endif

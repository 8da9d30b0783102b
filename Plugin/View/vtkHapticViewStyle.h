// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticViewStyle
 * @brief   vtkInteractorStyleHaptic in a render view of ParaView
 *
 * Draws with the view's StillRender and InteractiveRender, never with the window's Render, so that
 * data on servers are rendered, too. Picks in the renderer that shows the data, whichever of the
 * view's renderers is under the pointer. Of VTK's keys, only "r" remains, which resets the view's
 * camera: the others would change actors that belong to ParaView. Keys arm through the device's
 * property Armed, which follows the device when something disarms it; the key for the next method
 * sets Method and Solver of the touched filter.
 *
 * While the scene is touched, ParaView's volumes are drawn by VTK's ray caster for processors where
 * OpenGL runs on the processor, too, without speckles and as quickly as 20 frames a second allow.
 * AutoAdjustVolumeQualityOff() leaves them to ParaView.
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
   * The view and the device. They are not kept alive: a deleted view is not drawn, a deleted device
   * not polled.
   */
  void SetView(vtkSMRenderViewProxy* view);
  void SetDeviceProxy(vtkSMHapticDeviceProxy* device);
  ///@}

  /**
   * Forgets the volumes, before the end of a session whose server may be lost: nothing is sent to
   * it.
   */
  void ForgetVolumes();

  ///@{
  /**
   * Whether the slices of Orthographic Slice Views of the view's session follow the tip when it
   * moves. Default on.
   */
  vtkSetMacro(SlicesFollowTip, bool);
  vtkGetMacro(SlicesFollowTip, bool);
  vtkBooleanMacro(SlicesFollowTip, bool);
  ///@}

  /**
   * Sets a function that returns the pointer's position on the screen, in pixels. It is called
   * while a fine picture is drawn, and the picture is given up if the pointer has moved: for a
   * program whose mouse events wait in a queue that is not VTK's. The dock window passes Qt's
   * position. Null (default): pictures are always completed.
   */
  static void SetPointerQuery(void (*query)(int position[2]));

  /** Sets the property Armed of the device's proxy. */
  void SetArmed(bool on);

  /** Invokes vtkCommand::DisableEvent afterwards if the interactor has released this style. */
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
  void MoveSlices();

  vtkWeakPointer<vtkSMRenderViewProxy> View;
  vtkWeakPointer<vtkSMHapticDeviceProxy> DeviceProxy;
  bool SlicesFollowTip = true;
  std::unique_ptr<VolumeHaptics::HapticSlices> Slices;
  std::unique_ptr<VolumeHaptics::HapticVolumeFrames> Frames;
  bool IsBusy = false; ///< a timer may fire while a view that renders waits for its server
};

#endif

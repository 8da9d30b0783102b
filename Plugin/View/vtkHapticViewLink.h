// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticViewLink
 * @brief   a haptic device in a render view of ParaView
 *
 * Attach() sets a vtkHapticViewStyle in the view's interactor, and shows the hand and the forces in
 * the view's non-composited renderer. The client always draws that renderer itself, so they are
 * visible with both local and remote rendering. Detach() disarms the device, removes the hand and
 * the forces, and restores the previous style.
 *
 * The link disarms the device and ends by itself if the view or the device is closed or
 * unregistered, if the connection closes, or if ParaView sets another style in the view, for
 * example for a 2D view or a selection; that style remains. GetReason() then returns the reason,
 * and vtkCommand::EndEvent is invoked.
 *
 * The device stays open and started.
 *
 * @sa vtkSMHapticViewProxy, vtkSMHapticDeviceProxy
 */
#ifndef vtkHapticViewLink_h
#define vtkHapticViewLink_h

#include "VolumeHapticsViewModule.h" // for export macro
#include "vtkObject.h"

#include <memory> // for std::unique_ptr
#include <string> // for std::string

class vtkInteractorStyleHaptic;
class vtkSMHapticDeviceProxy;
class vtkSMRenderViewProxy;

class VOLUMEHAPTICSVIEW_EXPORT vtkHapticViewLink : public vtkObject
{
public:
  static vtkHapticViewLink* New();
  vtkTypeMacro(vtkHapticViewLink, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Attaches a device to a view. First detaches from any other view. Returns false and reports an
   * error with the cure if the view has no interactor (as in pvbatch), or if it already has a
   * device.
   */
  bool Attach(vtkSMRenderViewProxy* view, vtkSMHapticDeviceProxy* device);
  /** Detaches from the view, if attached. */
  void Detach();
  bool IsAttached() const;

  /**
   * Returns the reason why the link has ended by itself; empty while attached, and after Detach().
   */
  std::string GetReason() const;

  ///@{
  /**
   * A device for the other hand, which is shown as a second hand in the view; nullptr for none. It
   * is removed by Detach(), and when it is deleted. Returns false and reports an error with the
   * cure if nothing is attached, or if it is the first hand's device. A change invokes
   * vtkCommand::ModifiedEvent.
   */
  bool SetSecondDevice(vtkSMHapticDeviceProxy* device);
  vtkSMHapticDeviceProxy* GetSecondDeviceProxy() const;
  ///@}

  ///@{
  /** Return the attached view, device and style; null unless attached. */
  vtkSMRenderViewProxy* GetView() const;
  vtkSMHapticDeviceProxy* GetDeviceProxy() const;
  vtkInteractorStyleHaptic* GetStyle() const;
  ///@}

  ///@{
  /**
   * Whether the mouse moves the tip: see vtkInteractorStyleHaptic::SetTouchMode. The touch begins
   * in front of the first surface at the centre of the view. Default off. A change, for example by
   * a key, invokes vtkCommand::ModifiedEvent.
   */
  void SetTouchMode(bool on);
  bool GetTouchMode() const;
  ///@}

  /**
   * Returns the keys of the view. Each line contains an action, a tab, and the action's keys in the
   * format of vtkInteractorStyleHaptic::GetKey(). Empty unless attached.
   */
  std::string GetKeys() const;

  ///@{
  /**
   * Whether the slices of Orthographic Slice Views follow the tip: see
   * vtkHapticViewStyle::SetSlicesFollowTip. Default on.
   */
  void SetSlicesFollowTip(bool on);
  bool GetSlicesFollowTip() const;
  ///@}

protected:
  vtkHapticViewLink();
  ~vtkHapticViewLink() override;

private:
  vtkHapticViewLink(const vtkHapticViewLink&) = delete;
  void operator=(const vtkHapticViewLink&) = delete;

  /** Shows the notes of the reader of the touched volume's file, if they have changed. */
  void ShowNotes();
  void Watch();
  void OnEvent(vtkObject* caller, unsigned long event, void* data);
  void End(const char* reason);

  bool SlicesFollowTip = true;

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif

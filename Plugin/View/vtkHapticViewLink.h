// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticViewLink
 * @brief   a haptic device in a render view of ParaView
 *
 * Attach() gives the view's interactor a vtkHapticViewStyle, and shows the hand and the forces in
 * the view's non-composited renderer, which the client draws itself: that way they are seen with
 * local and with remote rendering. Detach() disarms the device, takes both away, and puts the very
 * same style back as was there.
 *
 * The link ends by itself, disarmed first, when the view or the device is closed or unregistered,
 * when the connection closes, and when ParaView gives the view another style, as for a 2D view or a
 * selection; that style then stays. GetReason() says why, and vtkCommand::EndEvent is invoked.
 *
 * The device, opened and started, stays so.
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
   * False, with an error that says what to do, if the view has no interactor (as in pvbatch), or
   * has a device already. Detaches from another view first.
   */
  bool Attach(vtkSMRenderViewProxy* view, vtkSMHapticDeviceProxy* device);
  /** Does nothing if nothing is attached. */
  void Detach();
  bool IsAttached() const;

  /** Why the link has ended by itself; empty while attached, and after Detach(). */
  std::string GetReason() const;

  ///@{
  /** While attached, else nullptr. */
  vtkSMRenderViewProxy* GetView() const;
  vtkSMHapticDeviceProxy* GetDeviceProxy() const;
  vtkInteractorStyleHaptic* GetStyle() const;
  ///@}

  ///@{
  /**
   * Whether the mouse leads the tip: see vtkInteractorStyleHaptic::SetTouchMode. On begins in front
   * of what lies in the middle of the view. Default off. vtkCommand::ModifiedEvent follows a
   * change, as by a key.
   */
  void SetTouchMode(bool on);
  bool GetTouchMode() const;
  ///@}

protected:
  vtkHapticViewLink();
  ~vtkHapticViewLink() override;

private:
  vtkHapticViewLink(const vtkHapticViewLink&) = delete;
  void operator=(const vtkHapticViewLink&) = delete;

  void Watch();
  void OnEvent(vtkObject* caller, unsigned long event, void* data);
  void End(const char* reason);

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif

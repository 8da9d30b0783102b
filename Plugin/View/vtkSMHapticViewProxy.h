// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMHapticViewProxy
 * @brief   a vtkHapticViewLink for scripts and for the dock window
 *
 * Exists only in the client. Its properties take effect with UpdateVTKObjects:
 *
 *   View             the render view
 *   Device           a `HapticDevice`
 *   SecondDevice     another device for the other hand, or none
 *   Attached         1: attach the device to the view; 0: detach it. Default 0
 *   TouchMode        1: the mouse moves the tip of a virtual device. Default 0
 *   SlicesFollowTip  1: the slices of Orthographic Slice Views follow the tip. Default 1
 *
 *   link = servermanager.ProxyManager().NewProxy("misc", "HapticView")
 *
 * Attached and TouchMode become 0 if the link ends by itself: see vtkHapticViewLink. Neither a
 * state nor a trace contains them, because a user who loads it may not have a hand on the device.
 */
#ifndef vtkSMHapticViewProxy_h
#define vtkSMHapticViewProxy_h

#include "VolumeHapticsViewModule.h" // for export macro
#include "vtkNew.h"                  // for vtkNew
#include "vtkSMProxy.h"

class vtkHapticViewLink;

class VOLUMEHAPTICSVIEW_EXPORT vtkSMHapticViewProxy : public vtkSMProxy
{
public:
  static vtkSMHapticViewProxy* New();
  vtkTypeMacro(vtkSMHapticViewProxy, vtkSMProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Get the object that the properties control. */
  vtkHapticViewLink* GetLink();

  void UpdateVTKObjects() override;

protected:
  vtkSMHapticViewProxy();
  ~vtkSMHapticViewProxy() override;

private:
  vtkSMHapticViewProxy(const vtkSMHapticViewProxy&) = delete;
  void operator=(const vtkSMHapticViewProxy&) = delete;

  void OnEnd();
  void OnModified();

  vtkNew<vtkHapticViewLink> Link;
};

#endif

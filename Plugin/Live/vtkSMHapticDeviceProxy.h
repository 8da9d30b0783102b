// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMHapticDeviceProxy
 * @brief   a haptic device in ParaView's client, which touches the data of a Volume Haptics filter
 *
 * The servo runs in the client, even if the data are on a server. The proxy owns a vtkHapticDevice
 * and, through the property Touch, a vtkVolumeHapticsFilter with the settings of that filter proxy.
 * The data server has only a small source that shows the client's state, vtkPVHapticStateSource.
 * Data of the same process are touched without a copy. From a server, a region around the tip is
 * fetched and passed to the servo, without a jump of the force. Its half-width h follows from the
 * time t for the round trip and for loading, the largest speed v_max of a hand, the spring's length
 * T_N/k, the reach r of a tick, and the width b of the band in which the force fades:
 *
 *   h = v_max t + T_N/k + r + b
 *
 * If the hand moves faster than the data arrive, the force fades, and returns when they have
 * arrived. This class has no timer: the timer of a user interface calls Poll, or a script calls
 * UpdatePipeline, which calls Poll.
 *
 * Safety: force is exerted only while Running and Armed are 1, and only through the safety stage of
 * vtkHapticDevice. Running, Armed and Recording are neither saved in a state nor traced. They
 * become 0, with zero force, if this proxy, the touched filter or its view is deleted, if the
 * session is closed, and after a fault. If the server is lost, the force fades within 50 ms. The
 * force also fades if Poll is not called for AttentionTime (2 s), because a frozen user interface,
 * for example while a server does not answer, can't be used to stop the hand. Setting Running or
 * Armed to 0 takes effect at once, without a Poll.
 */
#ifndef vtkSMHapticDeviceProxy_h
#define vtkSMHapticDeviceProxy_h

#include "VolumeHapticsLiveModule.h" // for export macro
#include "vtkSMSourceProxy.h"

#include <memory> // for std::unique_ptr

class vtkHapticDevice;
class vtkVolumeHapticsFilter;
class vtkVolumeProperty;

class VOLUMEHAPTICSLIVE_EXPORT vtkSMHapticDeviceProxy : public vtkSMSourceProxy
{
public:
  static vtkSMHapticDeviceProxy* New();
  vtkTypeMacro(vtkSMHapticDeviceProxy, vtkSMSourceProxy);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Get the device. To open, start and arm it, set the properties of this proxy. */
  vtkHapticDevice* GetDevice();

  /** Get the filter in the client; null while there is nothing to touch. */
  vtkVolumeHapticsFilter* GetFilter();

  /**
   * Apply changes of properties, pipeline and opacity, pass them to the servo, and get its latest
   * state. Returns true if the state is new. Does nothing during another call of Poll.
   */
  bool Poll();

  /**
   * The volume property whose visible voxels are felt, instead of the voxels that ParaView shows
   * (FollowOpacity). With nullptr (default), FollowOpacity decides.
   */
  void SetVisibility(vtkVolumeProperty* property);

  /** Remove the force, and release the device until Running is set again. */
  void Shutdown();

  void UpdateVTKObjects() override;
  ///@{
  /** Call Poll, and update the source on the server. */
  void UpdatePipeline() override;
  void UpdatePipeline(double time) override;
  ///@}

  ///@{
  /** Save or load the state except Running, Armed and Recording, which stay unchanged. */
  using Superclass::SaveXMLState;
  vtkPVXMLElement* SaveXMLState(vtkPVXMLElement* root, vtkSMPropertyIterator* properties) override;
  int LoadXMLState(vtkPVXMLElement* element, vtkSMProxyLocator* locator) override;
  ///@}

protected:
  vtkSMHapticDeviceProxy();
  ~vtkSMHapticDeviceProxy() override;

  void UpdatePropertyInformationInternal(vtkSMProperty* property) override;

private:
  vtkSMHapticDeviceProxy(const vtkSMHapticDeviceProxy&) = delete;
  void operator=(const vtkSMHapticDeviceProxy&) = delete;

  bool CanReachServer() const;
  void LoseServer();

  struct vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif

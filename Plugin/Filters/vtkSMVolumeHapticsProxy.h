// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMVolumeHapticsProxy
 * @brief   the client's end of a Volume Haptics filter
 *
 * Adds the command CopyPreset, for the panel's button and for scripts:
 * `filter.InvokeCommand("CopyPreset")`. It copies the chosen preset into the filter's own
 * functions, scales and surface side, as it is fitted to the image, and sets the preset to
 * "Custom", so that the functions can be edited from there. With "Custom" it does nothing.
 */
#ifndef vtkSMVolumeHapticsProxy_h
#define vtkSMVolumeHapticsProxy_h

#include "VolumeHapticsFiltersModule.h" // for export macro
#include "vtkSMSourceProxy.h"

class vtkPiecewiseFunction;

class VOLUMEHAPTICSFILTERS_EXPORT vtkSMVolumeHapticsProxy : public vtkSMSourceProxy
{
public:
  static vtkSMVolumeHapticsProxy* New();
  vtkTypeMacro(vtkSMVolumeHapticsProxy, vtkSMSourceProxy);

protected:
  vtkSMVolumeHapticsProxy();
  ~vtkSMVolumeHapticsProxy() override;

private:
  void OnPropertyUpdated(vtkObject*, unsigned long, void* name);
  void CopyPreset();
  /** @param stretch the factor of the positions of the function's points */
  void CopyFunction(const char* name, vtkPiecewiseFunction* function, double stretch);

  vtkSMVolumeHapticsProxy(const vtkSMVolumeHapticsProxy&) = delete;
  void operator=(const vtkSMVolumeHapticsProxy&) = delete;
};

#endif

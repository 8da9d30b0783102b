// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMVolumeHapticsProxy
 * @brief   the client's end of a Volume Haptics filter
 *
 * Adds the command CopyPreset, which the panel's button gives, and a script with
 * `filter.InvokeCommand("CopyPreset")`: what the chosen preset says is copied into the filter's own
 * functions, scales and surface side, and the preset becomes "Custom", for the functions to be
 * edited from there. With "Custom" it does nothing.
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
  void CopyFunction(const char* name, vtkPiecewiseFunction* function);

  vtkSMVolumeHapticsProxy(const vtkSMVolumeHapticsProxy&) = delete;
  void operator=(const vtkSMVolumeHapticsProxy&) = delete;
};

#endif

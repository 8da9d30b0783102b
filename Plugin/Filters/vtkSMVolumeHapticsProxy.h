// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMVolumeHapticsProxy
 * @brief   the client's proxy of a Volume Haptics filter
 *
 * Adds the command CopyPreset, for the panel's button and for scripts:
 * `filter.InvokeCommand("CopyPreset")`. The command copies the chosen preset, fitted to the image,
 * to the filter's own functions, scales and surface side, and sets the preset to "Custom", so that
 * the user can edit these functions. It does nothing if the preset is already "Custom".
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
  /** @param stretch factor by which the positions of the function's points are multiplied */
  void CopyFunction(const char* name, vtkPiecewiseFunction* function, double stretch);

  vtkSMVolumeHapticsProxy(const vtkSMVolumeHapticsProxy&) = delete;
  void operator=(const vtkSMVolumeHapticsProxy&) = delete;
};

#endif

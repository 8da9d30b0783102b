// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSMHapticFunctionDomain
 * @brief   a domain whose piecewise function over the range of the data is initially constant
 *
 * For a proxy property whose value is an edited function of the data:
 *
 *   <HapticFunctionDomain name="proxy_list" initial="0.5">
 *     <RequiredProperties>...</RequiredProperties>
 *   </HapticFunctionDomain>
 *
 * The function (a PiecewiseFunction of ParaView's) has the value `initial` (0 to 1, default 0)
 * everywhere until the user edits it. With ParaView's own domain, it would initially be a ramp.
 */
#ifndef vtkSMHapticFunctionDomain_h
#define vtkSMHapticFunctionDomain_h

#include "VolumeHapticsFiltersModule.h" // for export macro
#include "vtkSMRangedTransferFunctionDomain.h"

class VOLUMEHAPTICSFILTERS_EXPORT vtkSMHapticFunctionDomain
  : public vtkSMRangedTransferFunctionDomain
{
public:
  static vtkSMHapticFunctionDomain* New();
  vtkTypeMacro(vtkSMHapticFunctionDomain, vtkSMRangedTransferFunctionDomain);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int SetDefaultValues(vtkSMProperty* property, bool useUncheckedValues) override;

protected:
  vtkSMHapticFunctionDomain();
  ~vtkSMHapticFunctionDomain() override;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

private:
  double Initial = 0.0;

  vtkSMHapticFunctionDomain(const vtkSMHapticFunctionDomain&) = delete;
  void operator=(const vtkSMHapticFunctionDomain&) = delete;
};

#endif

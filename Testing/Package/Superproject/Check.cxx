// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <vtkNew.h>
#include <vtkVolumeHapticsFilter.h>

int main()
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->Print(cout);
  return filter->GetKernelRadius() == 2 ? 0 : 1;
}

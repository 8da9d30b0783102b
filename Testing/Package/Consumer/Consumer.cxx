// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include <vtkHapticDevice.h>
#include <vtkMetaImageReader.h>
#include <vtkNamedColors.h>
#include <vtkNew.h>

int main()
{
  vtkNew<vtkNamedColors> colors;
  vtkNew<vtkMetaImageReader> reader;
  vtkNew<vtkHapticDevice> device;
  return colors->ColorExists("ivory") && reader->GetFileName() == nullptr && device->Open("virtual")
    ? 0
    : 1;
}

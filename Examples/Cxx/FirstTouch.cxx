// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// The README's first example: press a stylus against the forehead of the phantom.
#include <vtkHapticProperty.h>
#include <vtkLineSource.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkVolumeHapticsFilter.h>
#include <vtkXMLImageDataReader.h>

#include <iostream>

int main(int, char* argv[])
{
  vtkNew<vtkXMLImageDataReader> head;
  head->SetFileName(argv[1]); // Data/HeadPhantom.vti
  vtkNew<vtkLineSource> path; // one point for each tick: 80 mm in a second
  path->SetPoint1(0.0, -120.0, 60.0);
  path->SetPoint2(0.0, -40.0, 60.0);
  path->SetResolution(1000);
  vtkNew<vtkVolumeHapticsFilter> touch;
  touch->SetInputConnection(head->GetOutputPort());
  touch->SetPathConnection(path->GetOutputPort());
  touch->GetProperty()->ApplyPreset("CT contrast");
  touch->Update();
  std::cout << touch->GetOutput()->GetPointData()->GetArray("Force")->GetMaxNorm() << " N\n";
}

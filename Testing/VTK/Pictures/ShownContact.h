// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Fixture with the representation over a plane that a replayed device presses, in each state of
 * contact.
 */
#ifndef ShownContact_h
#define ShownContact_h

#include "Factories.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkHapticDevice.h>
#include <vtkHapticProperty.h>
#include <vtkHapticRepresentation.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlaneSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRegressionTestImage.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkVolumeHapticsFilter.h>
#include <vtkXMLPolyDataWriter.h>

#include <chrono>
#include <iostream>
#include <string>
#include <thread>

namespace scenetest
{

struct ContactScript
{
  int Contact;   ///< contact of the last tick
  double Depth;  ///< depth of the tip below the plane (mm)
  double Across; ///< length of the drag along x (mm)
  double Friction;
  double Strength; ///< N, surface strength
  bool Markers = false;
  bool Trail = false;
  const double* Orientation = nullptr; ///< orientation of the stylus: w, x, y, z
};

/// Makes an image whose value increases downwards, with a surface at z = 0.
inline vtkSmartPointer<vtkImageData> MakeDepths()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(41, 41, 41);
  image->SetOrigin(-20.0, -20.0, -20.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    image->GetPointData()->GetScalars()->SetTuple1(i, -100.0 * image->GetPoint(i)[2]);
  }
  return image;
}

/// Makes a path down from 6 mm above the surface and then sideways, with 0.1 mm per tick. Finally
/// the tip creeps for twenty seconds, slowly enough that the contact persists while the rendered
/// image does not change.
inline vtkSmartPointer<vtkPolyData> MakePath(const ContactScript& script, vtkIdType& ticks)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (double z = 6.0; z > -script.Depth; z -= 0.1)
  {
    points->InsertNextPoint(-0.5 * script.Across, 0.0, z);
  }
  for (double x = 0.0; x < script.Across; x += 0.1)
  {
    points->InsertNextPoint(x - 0.5 * script.Across, 0.0, -script.Depth);
  }
  ticks = points->GetNumberOfPoints();
  const bool isAcross = script.Across > 0.0;
  for (int i = 1; i <= 20000; ++i)
  {
    const double creep = 1e-5 * i;
    points->InsertNextPoint(0.5 * script.Across + (isAcross ? creep : 0.0), 0.0,
      -script.Depth - (isAcross ? 0.0 : creep));
  }
  auto path = vtkSmartPointer<vtkPolyData>::New();
  path->SetPoints(points);
  if (script.Orientation)
  {
    vtkNew<vtkDoubleArray> orientations;
    orientations->SetName("Orientation");
    orientations->SetNumberOfComponents(4);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      orientations->InsertNextTypedTuple(script.Orientation);
    }
    path->GetPointData()->AddArray(orientations);
  }
  return path;
}

inline int ShowContact(int argc, char* argv[], const ContactScript& script)
{
  vtkNew<vtkVolumeHapticsFilter> filter;
  filter->SetInputData(MakeDepths());
  vtkIdType ticks = 0;
  filter->SetPathData(MakePath(script, ticks));
  filter->GetProperty()->GetFriction()->AddPoint(0.0, script.Friction);
  filter->GetProperty()->GetSurfaceStrength()->AddPoint(199.99, 0.0);
  filter->GetProperty()->GetSurfaceStrength()->AddPoint(200.0, script.Strength);
  filter->Update();

  // A replayed device stays in its last state.
  const std::string file = std::string("ShownContact") + std::to_string(script.Contact) +
    (script.Orientation ? "Turned.vtp" : ".vtp");
  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetFileName(file.c_str());
  writer->SetInputDataObject(filter->GetInputDataObject(1, 0));
  writer->Write();
  vtkNew<vtkHapticDevice> device;
  device->SetVolumeHaptics(filter);
  device->Open(("replay:" + file).c_str());
  device->Start();
  while (device->GetState()->GetTick() < ticks)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    device->UpdateState();
  }
  if (device->GetState()->GetContact() != script.Contact)
  {
    std::cerr << "The contact is " << device->GetState()->GetContact() << ", not " << script.Contact
              << ".\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-14.0, -14.0, 0.0);
  plane->SetPoint1(14.0, -14.0, 0.0);
  plane->SetPoint2(-14.0, 14.0, 0.0);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> skin;
  skin->SetMapper(mapper);
  skin->GetProperty()->SetColor(0.86, 0.62, 0.51);
  vtkNew<vtkHapticRepresentation> hand;
  hand->SetDevice(device);
  hand->SetForceScale(0.2);
  hand->SetMarkerVisibility(script.Markers);
  hand->SetStylusLength(17.0);
  hand->SetTrail(script.Trail ? filter->GetOutput() : nullptr);
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.16, 0.19, 0.24);
  renderer->AddActor(skin);
  renderer->AddViewProp(hand);
  vtkNew<vtkRenderWindow> window;
  window->SetMultiSamples(0);
  window->SetSize(300, 300);
  window->AddRenderer(renderer);
  renderer->GetActiveCamera()->SetPosition(10.0, -60.0, 28.0);
  renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, 1.0);
  renderer->GetActiveCamera()->SetViewUp(0.0, 0.0, 1.0);
  renderer->ResetCameraClippingRange();
  window->Render();
  return vtkRegressionTestImage(window) == vtkTesting::PASSED ? EXIT_SUCCESS : EXIT_FAILURE;
}
} // namespace scenetest

#endif

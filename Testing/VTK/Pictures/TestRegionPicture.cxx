// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders a coarse image that contains all samples of a volume, with a fine box inside. From all
// sides, in perspective and in parallel projection, the result must equal that of the image without
// the box. The volume is a translucent shell around a core, so that a wrong drawing order is
// visible.
#include "Rigs/DrawnPixels.h"
#include "Rigs/Eventually.h"
#include "VTK/Scene/Volumes/RegionPicture.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkHapticDevice.h>
#include <vtkHapticRegionSource.h>
#include <vtkImageData.h>
#include <vtkInteractorStyleHaptic.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeCollection.h>
#include <vtkVolumeHapticsFilter.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

namespace
{
constexpr int PictureSize = 90;
constexpr int Last = 80;

bool FillShell(const int extent[6], void* samples)
{
  auto* sample = static_cast<double*>(samples);
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const double x = i - 40.0;
        const double y = j - 40.0;
        const double z = k - 40.0;
        const double r = std::sqrt(x * x + y * y + z * z);
        const double colour = 100.0 * std::atan2(y, x) + 5.0 * z;
        *sample++ = std::clamp(10.0 * (34.0 - r), 0.0, 1.0) * (1000.0 + colour);
      }
    }
  }
  return true;
}

struct Scene
{
  vtkNew<vtkHapticRegionSource> Source;
  vtkNew<vtkVolumeHapticsFilter> Touch;
  vtkNew<vtkFixedPointVolumeRayCastMapper> Mapper;
  vtkNew<vtkVolumeProperty> Look;
  vtkNew<vtkVolume> Coarse;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  VolumeHaptics::RegionPicture Picture;

  Scene()
  {
    this->Source->SetWholeExtent(0, Last, 0, Last, 0, Last);
    this->Source->SetScalarType(VTK_DOUBLE);
    this->Source->SetMemoryLimit(4194304); // results in a region of 50^3 samples
    this->Source->SetReader(FillShell);
    this->Source->SetOrigin(5.0, -3.0, 2.0);
    this->Source->MakeCoarseImage(100000000);
    this->Touch->SetInputConnection(0, this->Source->GetOutputPort());
    vtkNew<vtkColorTransferFunction> colour;
    colour->AddRGBPoint(500.0, 1.0, 0.0, 0.0);
    colour->AddRGBPoint(1000.0, 0.0, 1.0, 0.0);
    colour->AddRGBPoint(1500.0, 0.0, 0.0, 1.0);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(400.0, 0.0);
    opacity->AddPoint(500.0, 0.08);
    this->Look->SetColor(colour);
    this->Look->SetScalarOpacity(opacity);
    this->Look->SetInterpolationTypeToLinear();
    this->Mapper->SetInputData(this->Source->GetCoarseImage());
    this->Mapper->AutoAdjustSampleDistancesOff();
    this->Mapper->SetSampleDistance(0.4F);
    this->Coarse->SetMapper(this->Mapper);
    this->Coarse->SetProperty(this->Look);
    this->Renderer->AddVolume(this->Coarse);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(PictureSize, PictureSize);
    this->Window->AddRenderer(this->Renderer);
    this->Picture.SetSource(this->Source);
    this->Picture.SetVolume(this->Coarse);
  }
};

std::vector<double> Render(Scene& scene, vtkRenderer* renderer)
{
  scene.Picture.SetRenderer(renderer);
  scene.Window->Render();
  return apitest::ReadPixels(scene.Window, 0, 0, PictureSize - 1, PictureSize - 1);
}
} // namespace

int TestRegionPicture(int, char*[])
{
  Scene scene;
  int wrong = 0;
  const auto expect = [&wrong](bool holds, const char* what)
  {
    if (!holds)
    {
      std::cerr << "Not so: " << what << "\n";
      ++wrong;
    }
  };
  scene.Picture.SetMaximumVoxels(1000000);
  scene.Picture.SetRenderer(scene.Renderer);
  scene.Picture.Update();
  expect(!scene.Picture.IsRefined(), "nothing is refined before there are samples");
  const double tip[3] = { 65.0, 27.0, 62.0 };
  double time = 0.0;
  const bool isRefined = devicetest::Eventually(
    [&]
    {
      time += 0.02;
      scene.Touch->ConfigureSource(scene.Source);
      scene.Source->Follow(tip, time);
      scene.Touch->Update();
      scene.Picture.Update();
      return scene.Picture.IsRefined();
    });
  expect(isRefined, "the box is refined");
  const int* const region = scene.Source->GetOutput()->GetExtent();
  expect(region[0] > 5 && region[5] - region[4] < 60, "the region is a part of the volume");

  vtkCamera* const camera = scene.Renderer->GetActiveCamera();
  scene.Renderer->ResetCamera();
  double focus[3];
  camera->GetFocalPoint(focus);
  const double distance = camera->GetDistance();
  for (int view = 0; view < 12; ++view)
  {
    const double angle = 0.55 * view;
    const double tilt = 1.3 * std::sin(1.7 * view);
    // The last views are so close that the eye is between the planes of the box.
    const double r = view < 9 ? distance : 45.0;
    camera->SetParallelProjection(view % 3 == 2);
    camera->SetPosition(focus[0] + r * std::cos(angle) * std::cos(tilt),
      focus[1] + r * std::sin(angle) * std::cos(tilt), focus[2] + r * std::sin(tilt));
    camera->SetViewUp(0.0, 0.0, 1.0);
    scene.Renderer->ResetCameraClippingRange();
    const std::vector<double> refined = Render(scene, scene.Renderer);
    expect(scene.Picture.IsRefined(), "the box is shown");
    const std::vector<double> plain = Render(scene, nullptr);
    expect(!scene.Picture.IsRefined() && scene.Mapper->GetCropping() == 0, "it is taken out");
    const double difference = apitest::ComputeMeanDifference(refined, plain);
    const double light =
      apitest::ComputeMeanDifference(plain, std::vector<double>(plain.size(), 0.0));
    std::cout << "view " << view << ": difference " << difference << " of " << light << "\n";
    expect(difference < 0.4, "it looks like one volume");
    expect(light > 5.0, "something is seen");
    scene.Picture.SetRenderer(scene.Renderer);
  }
  scene.Picture.SetRenderer(nullptr);
  scene.Picture.SetVolume(nullptr);

  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(scene.Window);
  vtkNew<vtkInteractorStyleHaptic> style;
  interactor->SetInteractorStyle(style);
  vtkNew<vtkHapticDevice> device;
  device->SetVolumeHaptics(scene.Touch);
  style->SetDevice(device);
  style->SetCoarseVolume(scene.Coarse);
  const bool isShown = devicetest::Eventually(
    [&]
    {
      scene.Window->Render();
      return scene.Mapper->GetCropping() != 0;
    });
  expect(isShown, "a style refines its coarse volume");
  expect(scene.Renderer->GetVolumes()->GetNumberOfItems() == 3, "the box, and two parts around it");
  style->SetCoarseVolume(nullptr);
  expect(scene.Mapper->GetCropping() == 0, "the style gives the volume back");
  expect(scene.Renderer->GetVolumes()->GetNumberOfItems() == 1, "as it was");
  return wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

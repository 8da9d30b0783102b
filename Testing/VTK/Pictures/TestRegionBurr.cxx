// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders a large volume with removed tissue, and compares it with a volume whose samples a loop
// has carved: fine in the box around the hand, coarse elsewhere, and on both sides of the box's
// faces.
#include "Rigs/DrawnPixels.h"
#include "Rigs/Eventually.h"
#include "Rigs/RemovalRig.h"
#include "VTK/Scene/Volumes/RegionPicture.h"

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkHapticRegionSource.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkPiecewiseFunction.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkVolume.h>
#include <vtkVolumeHapticsFilter.h>
#include <vtkVolumeProperty.h>

#include <cmath>
#include <iostream>

namespace
{
using removaltest::Hole;

constexpr int BurrPictureSize = 90;
constexpr int LastSample = 79; // index of the last sample, for an even number of samples
constexpr double AirOfScene = 0.0;
constexpr double SolidValue = 1000.0;
/// The hole at the hand's first position.
const Hole NearHole{ { 52.0, 14.0, 50.0 }, 12.0 };

/// Fills a block with tissue surrounded by air, and carves the hole if there is one.
bool FillBlock(const int extent[6], void* samples, const Hole* hole)
{
  auto* sample = static_cast<float*>(samples);
  for (int k = extent[4]; k <= extent[5]; ++k)
  {
    for (int j = extent[2]; j <= extent[3]; ++j)
    {
      for (int i = extent[0]; i <= extent[1]; ++i)
      {
        const bool isTissue = std::min({ i, j, k }) > 11 && std::max({ i, j, k }) < 68;
        const double value = isTissue ? SolidValue : AirOfScene;
        *sample++ = static_cast<float>(
          hole ? removaltest::LeftOf(value, hole->GetFraction(i, j, k), AirOfScene) : value);
      }
    }
  }
  return true;
}

struct BurrScene
{
  vtkNew<vtkHapticRegionSource> Source;
  vtkNew<vtkVolumeHapticsFilter> Touch;
  vtkSmartPointer<vtkVolumeMapper> Mapper;
  vtkNew<vtkVolumeProperty> Look;
  vtkNew<vtkVolume> Coarse;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  VolumeHaptics::RegionPicture Picture;
  double Time = 0.0;

  BurrScene(vtkVolumeMapper* mapper, vtkIdType coarseVoxels, const Hole* hole)
    : Mapper(mapper)
  {
    this->Source->SetWholeExtent(0, LastSample, 0, LastSample, 0, LastSample);
    this->Source->SetScalarType(VTK_FLOAT);
    this->Source->SetMemoryLimit(2097152); // results in regions of about 50^3 samples
    this->Source->SetMaximumSpeed(0.0);    // makes regions independent of the reading time
    this->Source->SetReader(
      [hole](const int extent[6], void* samples) { return FillBlock(extent, samples, hole); });
    this->Source->SetOrigin(5.0, -3.0, 2.0);
    this->Source->MakeCoarseImage(coarseVoxels);
    this->Touch->SetInputConnection(0, this->Source->GetOutputPort());
    vtkNew<vtkColorTransferFunction> colour;
    colour->AddRGBPoint(AirOfScene, 1.0, 0.2, 0.1);
    colour->AddRGBPoint(SolidValue, 0.9, 1.0, 0.8);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(0.4 * SolidValue, 0.0);
    opacity->AddPoint(0.6 * SolidValue, 0.4);
    this->Look->SetColor(colour);
    this->Look->SetScalarOpacity(opacity);
    this->Look->SetInterpolationTypeToLinear();
    this->Look->ShadeOn();
    this->Mapper->SetInputDataObject(this->Source->GetCoarseImage());
    if (auto* const cpu = vtkFixedPointVolumeRayCastMapper::SafeDownCast(this->Mapper))
    {
      cpu->AutoAdjustSampleDistancesOff();
      cpu->SetSampleDistance(0.5F);
    }
    if (auto* const gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(this->Mapper))
    {
      gpu->AutoAdjustSampleDistancesOff();
      gpu->SetSampleDistance(0.5F);
    }
    this->Coarse->SetMapper(this->Mapper);
    this->Coarse->SetProperty(this->Look);
    this->Renderer->AddVolume(this->Coarse);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(BurrPictureSize, BurrPictureSize);
    this->Window->AddRenderer(this->Renderer);
    this->Picture.SetMaximumVoxels(1000000);
    this->Picture.SetSource(this->Source);
    this->Picture.SetVolume(this->Coarse);
    this->Picture.SetVolumeHaptics(this->Touch);
    this->Picture.SetRenderer(this->Renderer);
    vtkCamera* const camera = this->Renderer->GetActiveCamera();
    camera->SetFocalPoint(55.0, 33.0, 50.0);
    camera->SetPosition(105.0, -117.0, 120.0);
    camera->SetViewUp(0.0, 0.0, 1.0);
  }
  /// Moves the tip to a position, and waits until the fine box surrounds it. Returns false if this
  /// never happens.
  bool Refine(double x, double y, double z)
  {
    const double tip[3] = { x, y, z };
    return devicetest::Eventually(
      [&]
      {
        this->Time += 0.02;
        this->Touch->ConfigureSource(this->Source);
        this->Source->Follow(tip, this->Time);
        this->Touch->Update();
        this->Picture.Update();
        const double* const box = this->Picture.GetFineVolume()->GetBounds();
        return this->Picture.IsRefined() && box && std::abs(x - 0.5 * (box[0] + box[1])) < 15.0 &&
          std::abs(y - 0.5 * (box[2] + box[3])) < 25.0;
      });
  }
  std::vector<double> Draw()
  {
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
    return apitest::ReadPixels(this->Window, 0, 0, BurrPictureSize - 1, BurrPictureSize - 1);
  }
};

int CheckMapper(
  const char* name, vtkVolumeMapper* mapper, vtkVolumeMapper* reference, vtkIdType coarseVoxels)
{
  int wrong = 0;
  const auto expect = [&](bool holds, const char* what)
  {
    if (!holds)
    {
      std::cerr << name << ", not so: " << what << "\n";
      ++wrong;
    }
  };
  BurrScene scene(mapper, coarseVoxels, nullptr);
  BurrScene carved(reference, coarseVoxels, &NearHole);
  vtkImageData* const coarse = scene.Source->GetCoarseImage();
  const int step = (LastSample + 1) / coarse->GetDimensions()[0];
  carved.Mapper->SetInputDataObject(removaltest::MakeLeft(coarse, 0, NearHole, AirOfScene, step));
  vtkNew<vtkImageData> volume;
  volume->SetExtent(0, LastSample, 0, LastSample, 0, LastSample);
  volume->SetOrigin(scene.Source->GetOrigin());
  const auto compare = [&](const char* what, double most)
  {
    const double difference = apitest::ComputeMeanDifference(scene.Draw(), carved.Draw());
    std::cout << name << ", " << what << ": difference " << difference << "\n";
    expect(difference <= most, what);
  };
  const std::vector<double> wholeCoarse = scene.Draw();
  expect(removaltest::LoadHole(scene.Touch->GetRemoval(), volume, NearHole, AirOfScene),
    "shares are read");
  std::cout << name << ": the hole makes "
            << apitest::ComputeMeanDifference(wholeCoarse, carved.Draw()) << "\n";
  expect(apitest::ComputeMeanDifference(wholeCoarse, carved.Draw()) > 2.0, "the hole is seen");
  compare("before there is a box", 0.0);
  expect(scene.Refine(57.0, 11.0, 52.0) && carved.Refine(57.0, 11.0, 52.0), "the box is shown");
  compare("the box in the hole", 0.0);
  expect(scene.Refine(25.0, 57.0, 22.0) && carved.Refine(25.0, 57.0, 22.0), "it has moved");
  compare("the box far from the hole", 0.0);
  // Reset() must restore all tissue.
  scene.Touch->GetRemoval()->Reset();
  const std::vector<double> wholeAgain = scene.Draw();
  scene.Picture.SetVolumeHaptics(nullptr);
  expect(apitest::ComputeMeanDifference(wholeAgain, scene.Draw()) == 0.0,
    "nothing is left of what is undone");
  expect(scene.Mapper->GetDataObjectInput() == coarse, "the mapper has its own image");
  scene.Picture.SetRenderer(nullptr);
  expect(apitest::ComputeMeanDifference(wholeCoarse, scene.Draw()) == 0.0, "as it was");
  carved.Picture.SetRenderer(nullptr);
  return wrong;
}
} // namespace

int TestRegionBurr(int, char*[])
{
  const int wrong = CheckMapper("as fine as the volume", vtkNew<vtkFixedPointVolumeRayCastMapper>(),
                      vtkNew<vtkFixedPointVolumeRayCastMapper>(), 1000000) +
    CheckMapper("half as fine", vtkNew<vtkFixedPointVolumeRayCastMapper>(),
      vtkNew<vtkFixedPointVolumeRayCastMapper>(), 64000) +
    CheckMapper("by texture", vtkNew<vtkOpenGLGPUVolumeRayCastMapper>(),
      vtkNew<vtkOpenGLGPUVolumeRayCastMapper>(), 64000);
  return wrong == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

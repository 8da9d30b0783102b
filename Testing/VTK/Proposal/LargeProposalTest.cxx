// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Of a large volume, ProposeFromImage looks at rows only. It finds the same: balls whose edges are
 * known in closed form (ProposalRig.h), and the tissues of the head phantom, beside each other in
 * mirror images (the numbers of Data/phantom.py).
 */

#include "ProposalRig.h"

#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkXMLImageDataReader.h>

using namespace proposaltest;

namespace
{
constexpr int LargeSize = 408; // 68 million voxels; 2^26 are not large
constexpr double LargeMiddle = 0.5 * (LargeSize - 1);
constexpr double OuterRadius = 173.0;
constexpr double InnerRadius = 92.0;
constexpr double Range = 250.0;

class LargeProposal : public testing::Test
{
protected:
  /// Three materials, 0, 100 and 250, with noise of 2 %; `bias` is the share of the value that is
  /// added at the last voxel of the first axis and taken away at the first.
  vtkSmartPointer<vtkImageData> MakeBalls(double outer, double inner, double bias)
  {
    // Values against the radius, and noise, from tables: there are many voxels.
    constexpr int perVoxel = 64;
    std::vector<float> values;
    for (int i = 0; i <= 2 * LargeSize * perVoxel; ++i)
    {
      const double r = static_cast<double>(i) / perVoxel;
      values.push_back(static_cast<float>(
        100.0 * Phi((OuterRadius - r) / outer) + 150.0 * Phi((InnerRadius - r) / inner)));
    }
    constexpr std::size_t noises = 1000003; // prime, so that rows differ
    Noise noise(0.02 * Range);
    std::vector<float> noiseTable;
    for (std::size_t i = 0; i < noises; ++i)
    {
      noiseTable.push_back(static_cast<float>(noise()));
    }
    vtkNew<vtkFloatArray> scalars;
    scalars->SetName("Density");
    scalars->SetNumberOfValues(vtkIdType{ LargeSize } * LargeSize * LargeSize);
    float* next = scalars->GetPointer(0);
    std::size_t number = 0;
    for (int k = 0; k < LargeSize; ++k)
    {
      for (int j = 0; j < LargeSize; ++j)
      {
        const double aside =
          (j - LargeMiddle) * (j - LargeMiddle) + (k - LargeMiddle) * (k - LargeMiddle);
        for (int i = 0; i < LargeSize; ++i)
        {
          const double x = i - LargeMiddle;
          const auto place = static_cast<std::size_t>(perVoxel * std::sqrt(x * x + aside) + 0.5);
          *next++ =
            static_cast<float>(1.0 + bias * x / LargeMiddle) * values[place] + noiseTable[number];
          number = number + 1 == noises ? 0 : number + 1;
        }
      }
    }
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(LargeSize, LargeSize, LargeSize);
    image->GetPointData()->SetScalars(scalars);
    return image;
  }

  void ExpectMaterials(double outer, double inner)
  {
    const std::vector<Found> found = Boundaries(this->Property);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].Low, 0.0, 0.02 * Range);
    EXPECT_NEAR(found[0].High, 100.0, 0.02 * Range);
    EXPECT_NEAR(found[1].Low, 100.0, 0.02 * Range);
    EXPECT_NEAR(found[1].High, 250.0, 0.02 * Range);
    EXPECT_NEAR(found[0].Width, outer, 0.05 * outer);
    EXPECT_NEAR(found[1].Width, inner, 0.05 * inner);
    // The areas of the balls: 512 rows meet the larger ball some 290 times, the smaller one 80.
    const double ratio = OuterRadius * OuterRadius / (InnerRadius * InnerRadius);
    EXPECT_NEAR(found[0].Share / found[1].Share, ratio, 0.25 * ratio);
  }

  /// As in ProposalTest.cxx: above what noise reaches, and below every edge.
  void ExpectDistinctness(double leastStep, double width)
  {
    const double pi = std::acos(-1.0);
    const double t = 0.5 * this->Property->GetProposedKernelRadius();
    const double noise = 0.02 * Range / (4.0 * std::pow(pi, 0.75) * std::pow(t, 2.5));
    const double arc = leastStep / (std::sqrt(2.0 * pi) * std::hypot(width, t));
    vtkPiecewiseFunction* const distinctness = this->Property->GetDistinctness();
    ASSERT_EQ(distinctness->GetSize(), 2);
    EXPECT_GE(NodeOf(distinctness, 0)[0], 0.95 * std::max(3.4 * noise, 0.2 * arc));
    EXPECT_LT(NodeOf(distinctness, 0)[0], NodeOf(distinctness, 1)[0]);
    EXPECT_LE(NodeOf(distinctness, 1)[0], 0.55 * arc);
    EXPECT_GE(NodeOf(distinctness, 1)[0], 0.4 * arc);
  }

  vtkNew<vtkHapticProperty> Property;
};
} // namespace

TEST_F(LargeProposal, ValuesAndWidthsAreFoundInNoise)
{
  ASSERT_TRUE(this->Property->ProposeFromImage(this->MakeBalls(2.0, 1.0, 0.0)));
  this->ExpectMaterials(2.0, 1.0);
  this->ExpectDistinctness(100.0, 2.0);
}

TEST_F(LargeProposal, AMultiplicativeBiasDoesLittle)
{
  ASSERT_TRUE(this->Property->ProposeFromImage(this->MakeBalls(1.0, 1.5, 0.3)));
  this->ExpectMaterials(1.0, 1.5);
  this->ExpectDistinctness(85.0, 1.0);
}

TEST_F(LargeProposal, TheHeadPhantomsTissuesAreFound)
{
  vtkNew<vtkXMLImageDataReader> head;
  head->SetFileName(HEAD_PHANTOM);
  head->Update();
  auto* const samples =
    vtkShortArray::SafeDownCast(head->GetOutput()->GetPointData()->GetScalars());
  ASSERT_NE(samples, nullptr);
  constexpr int n = 64;
  constexpr int times = 7; // 90 million voxels
  constexpr int size = times * n;
  ASSERT_EQ(samples->GetNumberOfTuples(), n * n * n);
  const auto mirror = [](int i) { return i / n % 2 == 0 ? i % n : n - 1 - i % n; };
  vtkNew<vtkShortArray> mirrored;
  mirrored->SetNumberOfValues(vtkIdType{ size } * size * size);
  short* next = mirrored->GetPointer(0);
  for (int k = 0; k < size; ++k)
  {
    for (int j = 0; j < size; ++j)
    {
      const short* const row = samples->GetPointer(n * (mirror(j) + n * mirror(k)));
      for (int i = 0; i < size; ++i)
      {
        *next++ = row[mirror(i)];
      }
    }
  }
  vtkNew<vtkImageData> heads;
  heads->SetDimensions(size, size, size);
  heads->SetSpacing(head->GetOutput()->GetSpacing());
  heads->GetPointData()->SetScalars(mirrored);
  ASSERT_TRUE(this->Property->ProposeFromImage(heads));
  vtkPiecewiseFunction* const strength = this->Property->GetSurfaceStrength();
  EXPECT_EQ(strength->GetValue(-1000.0), 0.0); // air
  EXPECT_GT(strength->GetValue(40.0), 0.5);    // scalp, brain
  EXPECT_LT(strength->GetValue(40.0), 3.5);
  EXPECT_EQ(strength->GetValue(1200.0), 12.0); // skull
  EXPECT_EQ(this->Property->GetSurfaceSide(), vtkHapticProperty::HIGHER);
}

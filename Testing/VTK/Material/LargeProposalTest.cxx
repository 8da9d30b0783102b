// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that ProposeFromImage(), which reads only some rows of a large volume, has the same results
 * as for a small volume: for balls whose edges are known in closed form (ProposalRig.h), and for
 * the tissues of the head phantom, in adjacent mirror images (the numbers of Data/phantom.py).
 */

#include "ProposalRig.h"

#include <vtkFloatArray.h>
#include <vtkPointData.h>
#include <vtkShortArray.h>
#include <vtkXMLImageDataReader.h>

using namespace proposaltest;

namespace
{
constexpr int LargeSize = 408; // 68 million voxels; a volume counts as large above 2^26
constexpr double LargeMiddle = 0.5 * (LargeSize - 1);
constexpr double OuterRadius = 173.0;
constexpr double InnerRadius = 92.0;
// Ratio of the balls' areas. Of 512 rows, about 290 cross the larger ball, and about 80 the smaller
// ball.
constexpr double Areas = OuterRadius * OuterRadius / (InnerRadius * InnerRadius);

class LargeProposal : public Proposal
{
protected:
  /// Makes two balls in air: three materials with the values 0, 100 and 250, and noise of 2 %.
  /// Along the first axis, a bias of the values increases from -`bias` to `bias` (as fractions).
  vtkSmartPointer<vtkImageData> MakeBalls(double outer, double inner, double bias)
  {
    // Look up the values by radius and the noise in tables, which saves time with so many voxels.
    constexpr int perVoxel = 64;
    std::vector<float> values;
    for (int i = 0; i <= 2 * LargeSize * perVoxel; ++i)
    {
      const double r = static_cast<double>(i) / perVoxel;
      values.push_back(static_cast<float>(
        100.0 * Phi((OuterRadius - r) / outer) + 150.0 * Phi((InnerRadius - r) / inner)));
    }
    constexpr std::size_t noises = 1000003; // prime, so that rows have different noise
    Noise noise(Sigma);
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
};
} // namespace

TEST_F(LargeProposal, ValuesAndWidthsAreFoundInNoise)
{
  ASSERT_TRUE(this->Property->ProposeFromImage(this->MakeBalls(2.0, 1.0, 0.0)));
  this->ExpectMaterials(2.0, 1.0, Areas, 0.25 * Areas);
  this->ExpectDistinctness(100.0, 2.0);
}

TEST_F(LargeProposal, AMultiplicativeBiasDoesLittle)
{
  ASSERT_TRUE(this->Property->ProposeFromImage(this->MakeBalls(1.0, 1.5, 0.3)));
  this->ExpectMaterials(1.0, 1.5, Areas, 0.25 * Areas);
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
  constexpr int times = 7; // results in 90 million voxels
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
  this->ExpectTissues();
}

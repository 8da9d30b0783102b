// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the noise of a volume in pieces is bitwise equal to the noise of the whole, and is
 * estimated once. Unmeasured samples must be detected in all pieces.
 */

#include "RegionRig.h"

#include "Core/Field/NoiseSamples.h"

#include <vtkFieldData.h>
#include <vtkObjectFactory.h>
#include <vtkTrivialProducer.h>

using namespace apitest;

namespace
{
/// A filter that collects samples from several slabs across an axis, as if each slab were in a
/// separate process.
class SlabFilter : public vtkHapticRegionFilter
{
public:
  static SlabFilter* New();
  vtkTypeMacro(SlabFilter, vtkHapticRegionFilter);

  int Slabs = 1;
  int Axis = 2;
  int Gathered = 0;

protected:
  void GatherSamples(SamplesOfComponents& samples) override
  {
    ++this->Gathered;
    auto* const image = vtkImageData::SafeDownCast(this->GetInputDataObject(0, 0));
    int whole[6];
    image->GetExtent(whole);
    samples.clear();
    // Start with the last slab, because the order of the pieces must not matter.
    for (int i = this->Slabs - 1; i >= 0; --i)
    {
      int part[6];
      std::copy(whole, whole + 6, part);
      const int count = whole[2 * this->Axis + 1] - whole[2 * this->Axis] + 1;
      part[2 * this->Axis] = whole[2 * this->Axis] + i * count / this->Slabs;
      part[2 * this->Axis + 1] = whole[2 * this->Axis] + (i + 1) * count / this->Slabs - 1;
      vtkNew<vtkImageData> slab;
      slab->SetExtent(part);
      slab->AllocateScalars(image->GetScalarType(), image->GetNumberOfScalarComponents());
      vtkDataArray* const scalars = slab->GetPointData()->GetScalars();
      CopySamples(image->GetPointData()->GetScalars(), whole, scalars, part);
      const SamplesOfComponents more = CollectSamples(scalars, part, whole);
      samples.resize(more.size());
      for (std::size_t c = 0; c < more.size(); ++c)
      {
        std::copy(more[c].Dimensions, more[c].Dimensions + 3, samples[c].Dimensions);
        samples[c].Merge(more[c]);
      }
    }
  }
};
vtkStandardNewMacro(SlabFilter);

/// A filter without a piece that gathers the samples of all pieces, as one of a server's processes
/// does.
class FilterWithoutPiece : public vtkHapticRegionFilter
{
public:
  static FilterWithoutPiece* New();
  vtkTypeMacro(FilterWithoutPiece, vtkHapticRegionFilter);

  void SetOthers(vtkImageData* image)
  {
    this->Others = image;
    vtkNew<vtkTrivialProducer> producer;
    producer->SetOutput(vtkNew<vtkImageData>());
    int whole[6];
    image->GetExtent(whole);
    producer->SetWholeExtent(whole[0], whole[1], whole[2], whole[3], whole[4], whole[5]);
    this->SetInputConnection(producer->GetOutputPort());
  }

protected:
  void GatherSamples(SamplesOfComponents& samples) override
  {
    ASSERT_TRUE(samples.empty());
    const int* const whole = this->Others->GetExtent();
    samples = CollectSamples(this->Others->GetPointData()->GetScalars(), whole, whole);
  }
  bool GatherRegion(vtkImageData*, vtkDataArray* array, const int region[6], vtkImageData* output,
    std::string& error) override
  {
    EXPECT_EQ(array, nullptr);
    vtkDataArray* const scalars = this->Others->GetPointData()->GetScalars();
    return this->Superclass::GatherRegion(this->Others, scalars, region, output, error);
  }

private:
  vtkSmartPointer<vtkImageData> Others;
};
vtkStandardNewMacro(FilterWithoutPiece);

class RegionNoise : public testing::Test
{
protected:
  double Number(vtkHapticRegionFilter* filter, const char* name, int i = 0)
  {
    filter->Update();
    vtkDataArray* const numbers = filter->GetOutput()->GetFieldData()->GetArray(name);
    const int components = numbers ? numbers->GetNumberOfComponents() : 1;
    return numbers ? numbers->GetComponent(i / components, i % components) : NAN;
  }
};
} // namespace

TEST_F(RegionNoise, OfPiecesIsThatOfTheWhole)
{
  for (const int type : { VTK_SHORT, VTK_FLOAT, VTK_UNSIGNED_CHAR })
  {
    const auto image = MakeBall(type);
    vtkDataArray* const scalars = image->GetPointData()->GetScalars();
    double range[2];
    scalars->GetRange(range, 0);
    for (vtkIdType i = 0; i < 40000; ++i)
    {
      scalars->SetComponent(i, 0, range[0]); // makes padding that contains the first corner
    }
    vtkNew<vtkHapticRegionFilter> one;
    one->SetInputData(image);
    const double noise = this->Number(one, "HapticNoise");
    EXPECT_GT(noise, 1.0);
    EXPECT_LT(this->Number(one, "HapticSolid"), this->Number(one, "HapticSolid", 1));
    for (const int slabs : { 1, 2, 3, 8 })
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        vtkNew<SlabFilter> pieces;
        pieces->SetInputData(image);
        pieces->Slabs = slabs;
        pieces->Axis = axis;
        EXPECT_EQ(this->Number(pieces, "HapticNoise"), noise) << slabs << " along " << axis;
        EXPECT_EQ(this->Number(pieces, "HapticBorderValue"), range[0]);
        for (int i = 0; i < 4; ++i)
        {
          EXPECT_EQ(this->Number(pieces, "HapticSolid", i), this->Number(one, "HapticSolid", i));
        }
      }
    }
  }
}

TEST_F(RegionNoise, IsCollectedOnceUntilTheImageChanges)
{
  const auto image = MakeBall();
  vtkNew<SlabFilter> pieces;
  pieces->SetInputData(image);
  const double noise = this->Number(pieces, "HapticNoise");
  const double time = this->Number(pieces, "HapticWholeTime");
  for (int i = 0; i < 5; ++i)
  {
    pieces->SetRegion(0, 10 + i, 10, 30, 20, 40);
    EXPECT_EQ(this->Number(pieces, "HapticNoise"), noise);
    EXPECT_EQ(this->Number(pieces, "HapticWholeTime"), time);
  }
  EXPECT_EQ(pieces->Gathered, 1);
  image->GetPointData()->GetScalars()->Fill(3.0);
  image->Modified();
  EXPECT_EQ(this->Number(pieces, "HapticNoise"), 0.0);
  EXPECT_NE(this->Number(pieces, "HapticWholeTime"), time);
  EXPECT_EQ(pieces->Gathered, 2);
}

TEST_F(RegionNoise, OutsideIsFoundInPiecesOfOtherProcesses)
{
  const auto image = MakeBall(VTK_FLOAT);
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const double value = scalars->GetComponent(i, 0);
    scalars->SetComponent(i, 0, value < 500.0 ? -9999.0 : value);
  }
  int middle[3];
  for (int a = 0; a < 3; ++a)
  {
    middle[a] = (image->GetExtent()[2 * a] + image->GetExtent()[2 * a + 1]) / 2;
  }
  image->SetScalarComponentFromDouble(middle[0], middle[1], middle[2], 0, 400.0);
  vtkNew<FilterWithoutPiece> first;
  first->SetOthers(image);
  EXPECT_EQ(this->Number(first, "HapticOutside", 0), 0.0);
  EXPECT_EQ(this->Number(first, "HapticOutside", 1), -9999.0);
  EXPECT_EQ(this->Number(first, "HapticOutside", 2), 400.0);
  EXPECT_EQ(this->Number(first, "HapticBorderValue"), 400.0);
  EXPECT_EQ(first->GetOutput()->GetPointData()->GetScalars()->GetComponent(0, 0), -9999.0);
}

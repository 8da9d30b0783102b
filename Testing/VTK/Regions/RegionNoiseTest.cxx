// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The noise of a volume in pieces is that of the whole, to the bit, and is collected once.
 */

#include "RegionRig.h"

#include "Core/Field/NoiseSamples.h"

#include <vtkFieldData.h>
#include <vtkObjectFactory.h>

using namespace apitest;

namespace
{
/// Collects the samples from so many slabs across an axis, as processes that hold one each would.
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
    // The last first: the order of the pieces must not matter.
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

class RegionNoise : public testing::Test
{
protected:
  double Number(vtkHapticRegionFilter* filter, const char* name, int component = 0)
  {
    filter->Update();
    return filter->GetOutput()->GetFieldData()->GetArray(name)->GetComponent(component, 0);
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
      scalars->SetComponent(i, 0, range[0]); // padding, with the first corner in it
    }
    vtkNew<vtkHapticRegionFilter> one;
    one->SetInputData(image);
    const double noise = this->Number(one, "HapticNoise");
    EXPECT_GT(noise, 1.0);
    const double solid = this->Number(one, "HapticSolid");
    EXPECT_LT(solid, this->Number(one, "HapticSolid", 1));
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
        EXPECT_EQ(this->Number(pieces, "HapticSolid"), solid);
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

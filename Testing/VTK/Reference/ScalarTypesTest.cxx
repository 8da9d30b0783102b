// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the same numbers result in the same forces in every scalar type, component and memory
 * layout.
 */

#include "CompareTraces.h"
#include "RandomScene.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkSOADataArrayTemplate.h>
#include <vtkSetGet.h>

#include <algorithm>

using namespace reference;

namespace
{
enum class Layout
{
  OfStructures,
  OfArrays
};

vtkSmartPointer<vtkDataArray> MakeArray(int scalarType, Layout layout)
{
  if (layout == Layout::OfArrays)
  {
    switch (scalarType)
    {
      vtkTemplateMacro(return vtkSmartPointer<vtkSOADataArrayTemplate<VTK_TT>>::New());
    }
  }
  return vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(scalarType));
}

// Sets integers around `middle` in the last component, and a walk through them.
void Begin(Scene& scene, Estimator estimator, vtkDataArray* array, int components, double middle)
{
  Random random(77);
  scene.estimator = estimator;
  scene.component = components - 1;
  Geometry geometry = Cube(10.0, 1.0);
  geometry.extent[4] += 3;
  const Field smooth = RandomField(random, geometry);
  scene.image = MakeImage(geometry);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(scene.image->GetNumberOfPoints());
  for (int component = 0; component < components; ++component)
  {
    Fill(array, component, geometry,
      [&](const Vec3& x)
      { return component == scene.component ? std::round(middle + 60.0 * smooth(x)) : 99.0; });
  }
  scene.image->GetPointData()->SetScalars(array);
  SetMaterial(scene, 500.0, 0.3, 0.2, 1.5);
  RandomWalk(scene, random, geometry, 200);
}

void ExpectSameAsDouble(int scalarType, Layout layout, double middle)
{
  SCOPED_TRACE("layout " + std::to_string(int(layout)) + ", around " + std::to_string(middle));
  for (Estimator estimator : AllEstimators)
  {
    Scene expected;
    Begin(expected, estimator, MakeArray(VTK_DOUBLE, Layout::OfStructures), 1, middle);
    const Trace expectedTrace = RunFilter(expected);
    EXPECT_GT(ForceScale(expectedTrace), 0.5);
    for (int components : { 1, 3 })
    {
      Scene scene;
      Begin(scene, estimator, MakeArray(scalarType, layout), components, middle);
      const Difference difference = CompareTraces(expectedTrace, RunFilter(scene));
      EXPECT_LE(difference.worst, 1e-12) << difference.text;
    }
  }
}
} // namespace

class ScalarTypes : public testing::TestWithParam<int>
{
};

TEST_P(ScalarTypes, FeelTheSame)
{
  const int type = this->GetParam();
  const auto limits = MakeArray(type, Layout::OfStructures);
  for (Layout layout : { Layout::OfStructures, Layout::OfArrays })
  {
    ExpectSameAsDouble(type, layout, 62.0);
    if (limits->GetDataTypeMin() < 0.0)
    {
      ExpectSameAsDouble(type, layout, -20.0);
    }
  }
}

// The filter must report values at the ends of a type's range, as far as a double can represent
// them.
TEST_P(ScalarTypes, ReachTheirLimits)
{
  const auto array = MakeArray(this->GetParam(), Layout::OfStructures);
  const bool real = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
  // A double can't represent the largest 64-bit number, so the limits are smaller.
  const double low = std::max(array->GetDataTypeMin(), real ? -1e30 : -0x1p62);
  const double high = std::min(array->GetDataTypeMax(), real ? 1e30 : 0x1p62);
  Scene scene;
  scene.image = Sample(
    Cube(9.0, 1.0), [&](const Vec3& x) { return x[0] < 0.0 ? low : high; }, array->GetDataType());
  scene.method = Method::ForceField;
  scene.path = { { { -5.5, 0.3, 0.4 } }, { { 5.5, 0.3, 0.4 } } };
  const Trace trace = RunFilter(scene);
  EXPECT_NEAR(trace[0].value, low, 1e-6 * high);
  EXPECT_NEAR(trace[1].value, high, 1e-6 * high);
}

INSTANTIATE_TEST_SUITE_P(All, ScalarTypes,
  testing::Values(VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
    VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG,
    VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE),
  [](const testing::TestParamInfo<int>& type)
  {
    std::string name = vtkImageScalarTypeNameMacro(type.param);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
  });

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that voxels that a volume property's opacities hide are not felt: surface strength and
 * viscosity must be zero exactly there, even for a proxy at a hidden value.
 */

#include "Rigs/ApiRig.h"
#include "Rigs/RandomFunctions.h"

#include <vtkVolumeProperty.h>

#include <cmath>

using namespace apitest;

namespace
{
class Visibility : public ApiTest
{
protected:
  Visibility()
  {
    // V = 4 z^2 on voxels of 1 x 2 x 3 mm, so that the gradient's magnitude varies. The mean
    // spacing is 2 mm.
    this->Image = MakeImage(16, VTK_DOUBLE, [](const Point& x) { return 36.0 * x[2] * x[2]; });
    this->Image->SetSpacing(1.0, 2.0, 3.0);
    this->Filter->SetInputDataObject(0, this->Image);
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> uniform(2.0, 13.0);
    std::vector<Point> points;
    for (int i = 0; i < 2000; ++i)
    {
      points.push_back({ uniform(engine), 2.0 * uniform(engine), 3.0 * uniform(engine) });
    }
    this->Filter->SetPathData(MakePath(points));
    SetConstant(this->Property->GetViscosity(), 0.5);
    this->Property->SetVisibilityFrom(this->Volume);
  }

  /// Returns 1 if a value is visible, 0 if it is hidden, and -1 if the result depends on rounding,
  /// or on the table's error near a steep curve. An empty function hides nothing.
  static int Look(vtkPiecewiseFunction* opacity, double x)
  {
    if (opacity->GetSize() == 0)
    {
      return 1;
    }
    const auto [low, high] = ValuesAround(opacity, x);
    if (high <= 0.0)
    {
      return 0;
    }
    return low > AllowedError(opacity, x) ? 1 : -1;
  }

  /// Returns the visibility of the value at a proxy's height, as Look() does. The proxy may have
  /// moved by 2e-3 voxels since the filter read the visibility.
  static int LookAround(vtkPiecewiseFunction* opacity, double z)
  {
    constexpr double near = 2e-3;
    const auto lookAt = [opacity](double index)
    {
      const double below = std::floor(index);
      const double value =
        // The image is linear between its samples.
        36.0 * (below * below + (index - below) * (2.0 * below + 1.0));
      return Look(opacity, value);
    };
    const int look = lookAt(z / 3.0);
    return look == lookAt(z / 3.0 - near) && look == lookAt(z / 3.0 + near) ? look : -1;
  }

  void ExpectHiddenExactly(vtkPiecewiseFunction* scalar, vtkPiecewiseFunction* gradient)
  {
    // With the alignment EDGE, a visible surface has no strength in front of the middle of its
    // edge.
    for (const int alignment :
      { vtkVolumeHapticsFilter::EDGE, vtkVolumeHapticsFilter::DISTINCTNESS })
    {
      this->Filter->SetContactAlignment(alignment);
      const bool isWhole = alignment == vtkVolumeHapticsFilter::DISTINCTNESS;
      vtkPolyData* const output = this->Run(2000);
      int wrong[2] = {};
      for (vtkIdType tick = 0; tick < 2000; ++tick)
      {
        const int byGradient = Look(gradient, 2.0 * Get(output, "GradientMagnitude", tick));
        const int surface = Look(scalar, Get(output, "SurfaceValue", tick)) * byGradient;
        const int medium = Look(scalar, Get(output, "MediumValue", tick)) * byGradient;
        const int here = LookAround(scalar, output->GetPoint(tick)[2]);
        const double strength = Get(output, "SurfaceStrength", tick);
        const double viscosity = Get(output, "Viscosity", tick);
        wrong[0] += (surface == 0 || here == 0) && strength != 0.0;
        wrong[0] += surface == 1 && here == 1 && isWhole && strength != 2.0;
        wrong[1] += (medium == 0 || here == 0) && viscosity != 0.0;
        wrong[1] += medium == 1 && here == 1 && viscosity != 0.5;
        this->Hidden += surface == 0;
        this->Seen += surface == 1;
        this->Held += surface == 1 && strength > 0.0;
      }
      EXPECT_EQ(wrong[0], 0) << "surface strength, alignment " << alignment;
      EXPECT_EQ(wrong[1], 0) << "viscosity, alignment " << alignment;
    }
  }

  /// Makes a function in which about half of the nodes are zero. It has plateaus, spikes, and
  /// points that touch zero.
  static vtkSmartPointer<vtkPiecewiseFunction> RandomOpacity(int seed, double width)
  {
    std::mt19937_64 engine(seed);
    const Shape shape{ seed % 3 == 0 ? 1.0 : 0.0, seed % 2 == 0, seed % 5 != 0, false };
    const auto function = RandomFunction(engine, shape, 0.0, width, 1.0);
    for (int i = 0; i < function->GetSize(); ++i)
    {
      double node[4];
      function->GetNodeValue(i, node);
      node[1] = engine() % 2 ? 0.0 : node[1];
      function->SetNodeValue(i, node);
    }
    return function;
  }

  vtkNew<vtkVolumeProperty> Volume;
  vtkNew<vtkPiecewiseFunction> Everything;
  int Hidden = 0;
  int Seen = 0;
  int Held = 0;
};
} // namespace

TEST_F(Visibility, ScalarOpacityHides)
{
  for (int seed = 0; seed < 12; ++seed)
  {
    SCOPED_TRACE(seed);
    const auto opacity = RandomOpacity(seed, 900.0);
    this->Volume->SetScalarOpacity(opacity);
    this->ExpectHiddenExactly(opacity, this->Everything);
  }
  EXPECT_GT(this->Hidden, 4000);
  EXPECT_GT(this->Seen, 4000);
  EXPECT_GT(this->Held, 4000);
}

TEST_F(Visibility, GradientOpacityHidesToo)
{
  this->Volume->SetScalarOpacity(this->Everything);
  for (int seed = 0; seed < 12; ++seed)
  {
    SCOPED_TRACE(seed);
    const auto opacity = RandomOpacity(seed, 400.0);
    this->Volume->SetGradientOpacity(opacity);
    this->ExpectHiddenExactly(this->Everything, opacity);
  }
  EXPECT_GT(this->Hidden, 4000);
  EXPECT_GT(this->Seen, 4000);
  EXPECT_GT(this->Held, 4000);
  this->Volume->DisableGradientOpacityOn();
  this->ExpectHiddenExactly(this->Everything, this->Everything);
}

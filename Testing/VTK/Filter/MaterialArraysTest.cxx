// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the materials in a trace equal the functions at the values in the trace.
 */

#include "Rigs/ApiRig.h"
#include "Rigs/RandomFunctions.h"

using namespace apitest;

namespace
{
class MaterialArrays : public ApiTest
{
protected:
  MaterialArrays()
  {
    // V = 4 z^2 has values from 0 to 900, and gradient magnitudes from 0 to 120.
    this->Image = MakeImage(16, VTK_DOUBLE, [](const Point& x) { return 4.0 * x[2] * x[2]; });
    this->Filter->SetInputDataObject(0, this->Image);
    // PAPER's stiffness depends only on the present tick. PRECISE's spring may have slack, so its
    // stiffness also depends on earlier ticks.
    this->Filter->SetSolverToPaper();
    std::vector<Point> zigzag;
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> uniform(2.0, 13.0);
    for (int i = 0; i < 3000; ++i)
    {
      zigzag.push_back({ uniform(engine), uniform(engine), uniform(engine) });
    }
    this->Filter->SetPathData(MakePath(zigzag));
  }

  /// Expects that an array of the trace is the function of another array, `argument`.
  void Compare(const char* array, const char* argument, vtkPiecewiseFunction* function)
  {
    int outside = 0;
    vtkPolyData* const output = this->Filter->GetOutput();
    for (vtkIdType tick = 0; tick < output->GetNumberOfPoints(); ++tick)
    {
      const double x = Get(output, argument, tick);
      const double actual = Get(output, array, tick);
      const auto [low, high] = ValuesAround(function, x);
      const double allowed = AllowedError(function, x);
      outside += !(low - allowed <= actual && actual <= high + allowed);
    }
    EXPECT_EQ(outside, 0) << array << " is not the function of " << argument;
  }
};
} // namespace

TEST_F(MaterialArrays, AreTheFunctionsAtTheReportedValues)
{
  for (int seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937_64 engine(seed);
    const Shape shape{ -1.0, true, true, false };
    const auto stiffness = RandomFunction(engine, shape, 0.0, 900.0, 800.0);
    const auto friction = RandomFunction(engine, shape, 0.0, 900.0, 1.0);
    const auto viscosity = RandomFunction(engine, shape, 0.0, 900.0, 0.5);
    this->Property->SetStiffness(stiffness);
    this->Property->SetFriction(friction);
    this->Property->SetViscosity(viscosity);
    this->Run(3000);
    this->Compare("Stiffness", "SurfaceValue", stiffness);
    this->Compare("Friction", "SurfaceValue", friction);
    this->Compare("Viscosity", "MediumValue", viscosity);
  }
}

TEST_F(MaterialArrays, SurfaceStrengthIsStrengthTimesDistinctness)
{
  for (int seed = 0; seed < 20; ++seed)
  {
    SCOPED_TRACE(seed);
    std::mt19937_64 engine(100 + seed);
    const Shape shape{ -1.0, true, seed % 2 == 0, false };
    // Test each function alone, while the other function is constant.
    const auto strength = RandomFunction(engine, shape, 0.0, 900.0, 3.0);
    this->Property->SetSurfaceStrength(strength);
    SetConstant(this->Property->GetDistinctness(), 1.0);
    this->Run(3000);
    this->Compare("SurfaceStrength", "SurfaceValue", strength);

    const auto distinctness = RandomFunction(engine, shape, 0.0, 120.0, 1.0);
    this->Property->SetDistinctness(distinctness);
    this->Property->SetSurfaceStrength(nullptr);
    SetConstant(this->Property->GetSurfaceStrength(), 1.0);
    this->Run(3000);
    this->Compare("SurfaceStrength", "GradientMagnitude", distinctness);
    this->Property->SetDistinctness(nullptr);
  }
}

TEST_F(MaterialArrays, DefaultsWhereNothingIsSet)
{
  vtkPolyData* const output = this->Run(3000);
  for (const vtkIdType tick : { 0, 1, 1500, 2999 })
  {
    EXPECT_EQ(Get(output, "Stiffness", tick), 500.0);
    EXPECT_EQ(Get(output, "Friction", tick), 0.0);
    EXPECT_EQ(Get(output, "Viscosity", tick), 0.0);
    EXPECT_EQ(Get(output, "SurfaceStrength", tick), 2.0);
  }
}

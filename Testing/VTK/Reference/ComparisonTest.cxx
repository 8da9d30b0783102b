// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Compares the module with the reference on random volumes, materials, settings and walks. This
 * test is independent of the module's implementation.
 */

#include "CompareTraces.h"
#include "RandomScene.h"

#include <gtest/gtest.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <algorithm>
#include <iostream>
#include <memory>

using namespace reference;

namespace
{
constexpr int Scenes = 300;
constexpr int Ticks = 150;

std::unique_ptr<Scene> MakeScene(int seed, Curves curves)
{
  auto scene = std::make_unique<Scene>();
  Random random(seed);
  RandomScene(*scene, random, curves, Ticks);
  return scene;
}

std::string Describe(int seed, const Scene& scene)
{
  return "seed " + std::to_string(seed) + ", estimator " + std::to_string(int(scene.estimator)) +
    ", radius " + std::to_string(scene.kernelRadius) + ", side " + std::to_string(int(scene.side)) +
    ", scalars " + scene.image->GetPointData()->GetArray(0)->GetDataTypeAsString();
}
} // namespace

// Piecewise linear functions are baked without loss, so each array must agree within 1e-9 in each
// tick.
TEST(ReferenceComparison, EveryTickAgrees)
{
  double worst = 0.0;
  for (int seed = 0; seed < Scenes; ++seed)
  {
    const auto scene = MakeScene(seed, Curves::Linear);
    const Trace actual = RunFilter(*scene);
    const Difference difference = CompareTraces(RunReference(*scene, &actual, true), actual);
    EXPECT_LE(difference.worst, 1e-9) << Describe(seed, *scene) << ": " << difference.text;
    worst = std::max(worst, difference.worst);
  }
  std::cout << "worst relative difference of a tick: " << worst << std::endl;
}

// Traces must also agree over whole walks, in which differences could accumulate. The material is
// gentle, because the paper's tick can amplify a difference by its drag where the stiffness falls
// steeply.
TEST(ReferenceComparison, EveryWalkAgrees)
{
  double worst = 0.0;
  for (int seed = 0; seed < Scenes; ++seed)
  {
    const auto scene = MakeScene(seed, Curves::Linear);
    double range[2];
    FeltScalars(*scene)->GetRange(range, scene->component);
    GentleMaterial(*scene, range[0], range[1]);
    const Trace actual = RunFilter(*scene);
    const Difference difference = CompareTraces(RunReference(*scene, &actual), actual);
    EXPECT_LE(difference.worst, 1e-9) << Describe(seed, *scene) << ": " << difference.text;
    worst = std::max(worst, difference.worst);
  }
  std::cout << "worst relative difference of a walk: " << worst << std::endl;
}

// Curved functions are tabulated, so the force may differ by 0.1 % of the trace's largest force.
TEST(ReferenceComparison, CurvedMaterialsStayWithinATenthOfAPercent)
{
  double worst = 0.0;
  for (int seed = 1000; seed < 1000 + Scenes; ++seed)
  {
    const auto scene = MakeScene(seed, Curves::Curved);
    const Trace actual = RunFilter(*scene);
    const Difference difference = CompareForces(RunReference(*scene, &actual, true), actual);
    EXPECT_LE(difference.worst, 1e-3) << Describe(seed, *scene) << ": " << difference.text;
    worst = std::max(worst, difference.worst);
  }
  std::cout << "worst relative difference of a force, curved: " << worst << std::endl;
}

TEST(ReferenceComparison, ForceFieldsAgree)
{
  double worst = 0.0;
  for (int seed = 2000; seed < 2000 + Scenes / 2; ++seed)
  {
    const auto scene = MakeScene(seed, Curves::Linear);
    Random random(seed);
    scene->method = Method::ForceField;
    scene->forceFieldGain = random.Uniform(1e-4, 1e-2);
    scene->forceFieldDamping = random.Uniform(0.0, 3.0);
    const Difference difference = CompareForceFields(RunReference(*scene), RunFilter(*scene));
    EXPECT_LE(difference.worst, 1e-9) << Describe(seed, *scene) << ": " << difference.text;
    worst = std::max(worst, difference.worst);
  }
  std::cout << "worst relative difference of a force field: " << worst << std::endl;
}

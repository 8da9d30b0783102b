// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Methods/Methods.h"

#include "Core/Model/HapticModel.h"
#include "Core/Solvers/ForceField/ForceField.h"
#include "Core/Solvers/LocalSurface/LocalSurfaceSolver.h"
#include "Core/Solvers/Paper/PaperSolver.h"
#include "Core/Solvers/Precise/PreciseSolver.h"
#include "Core/Solvers/Primitives/PrimitivesMethod.h"
#include "Core/Solvers/SurfaceProxy/SurfaceProxy.h"

#include <cstddef>

namespace VolumeHaptics
{
namespace
{

constexpr Method PaperRow = { &StepPaper, &FindPaperReach };

/**
 * The methods in the order of HapticMethod. The row of Proxy is for its default solver, Precise.
 */
constexpr Method Rows[] = {
  { &StepPrecise, &FindPreciseReach, &IncludePrecise },
  { &StepForceField, &FindFieldReach, nullptr, &FindFieldDrag, false },
  { [](const HapticModel& model, ServoState& state, TickRecord& record,
      const MethodInput& input) noexcept
    { (model.Baked->Mesh ? StepSurfaceProxy : StepPaper)(model, state, record, input); },
    &FindSurfaceProxyReach },
  { &StepLocalSurface, &FindLocalSurfaceReach, &IncludeLocalSurface },
  { &StepPrimitives, &FindPrimitivesReach },
};

} // namespace

const Method& GetMethod(const HapticSettings& settings) noexcept
{
  return settings.Method == HapticMethod::Proxy && settings.Solver == HapticSolver::Paper
    ? PaperRow
    : Rows[static_cast<std::size_t>(settings.Method)];
}

} // namespace VolumeHaptics

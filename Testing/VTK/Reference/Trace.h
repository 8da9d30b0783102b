// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A servo tick as the filter's output reports it, and the names of its point arrays.
 */
#ifndef Trace_h
#define Trace_h

#include "Vec3.h"

#include <vector>

namespace reference
{
struct TickRecord
{
  Vec3 proxy; // output point (world units)
  Vec3 tip;   // world units
  Vec3 force; // force on the hand (N)
  Vec3 normal;
  double time = 0.0;              // s since the start of the path
  double normalForce = 0.0;       // normal force before the drag step (N)
  double frictionForce = 0.0;     // friction force before the drag step (N)
  double dragForce = 0.0;         // N, force of the drag step
  double value = 0.0;             // value at the proxy at the end of the tick
  double gradientMagnitude = 0.0; // magnitude of the gradient (scalar units per world unit)
  double surfaceValue = 0.0;
  double mediumValue = 0.0;
  double stiffness = 0.0; // N/m
  double friction = 0.0;
  double viscosity = 0.0;       // N
  double surfaceStrength = 0.0; // N
  int contact = 0;
  // Set only by the reference: force (N) by which the tick's closest decision was made. If the
  // rounding error exceeds this force, the tick may decide either way.
  double margin = 0.0;
};

using Trace = std::vector<TickRecord>;

struct ScalarArray
{
  const char* name;
  double TickRecord::*member;
};

inline const ScalarArray ScalarArrays[] = {
  { "Time", &TickRecord::time },
  { "NormalForce", &TickRecord::normalForce },
  { "FrictionForce", &TickRecord::frictionForce },
  { "DragForce", &TickRecord::dragForce },
  { "Value", &TickRecord::value },
  { "GradientMagnitude", &TickRecord::gradientMagnitude },
  { "SurfaceValue", &TickRecord::surfaceValue },
  { "MediumValue", &TickRecord::mediumValue },
  { "Stiffness", &TickRecord::stiffness },
  { "Friction", &TickRecord::friction },
  { "Viscosity", &TickRecord::viscosity },
  { "SurfaceStrength", &TickRecord::surfaceStrength },
};

struct VectorArray
{
  const char* name;
  Vec3 TickRecord::*member;
};

inline const VectorArray VectorArrays[] = {
  { "Tip", &TickRecord::tip },
  { "Force", &TickRecord::force },
  { "Normal", &TickRecord::normal },
};
} // namespace reference

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Measures the error of the force's direction.
 */
#ifndef Evaluation_Angle_h
#define Evaluation_Angle_h

#include "Figure.h"

namespace evaluation
{

/**
 * Returns the angles (degrees) between the frictionless force and the normal of an 8-bit sphere, at
 * positions that cover one half of the sphere.
 */
std::vector<double> MeasureAngles(const Candidate& candidate);

} // namespace evaluation

#endif

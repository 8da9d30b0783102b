// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Measures a real scan, whose correct forces are unknown.
 */
#ifndef Evaluation_RealVolume_h
#define Evaluation_RealVolume_h

#include "Figure.h"

class vtkImageData;

namespace evaluation
{

/**
 * Makes random presses on a CT, each a closed cycle: from the air towards the middle, across, and
 * out again, with the preset "CT contrast". Returns no figures, with VTK's error, if the image
 * can't be touched.
 */
Figures MeasureRealVolume(
  vtkImageData* image, VolumeHaptics::HapticSolver solver, const Effort& effort);

} // namespace evaluation

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Measures a real scan, for which only bounds of the forces are known.
 */
#ifndef Evaluation_RealVolume_h
#define Evaluation_RealVolume_h

#include "Figure.h"

class vtkImageData;

namespace evaluation
{

/**
 * Makes random presses on a CT, each a closed cycle: from the air towards the middle, across, and
 * out again, with the preset "CT contrast". If the image can't be touched, returns no figures, and
 * VTK reports the error.
 */
Figures MeasureRealVolume(
  vtkImageData* image, VolumeHaptics::HapticSolver solver, const Effort& effort);

} // namespace evaluation

#endif

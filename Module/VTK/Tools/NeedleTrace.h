// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes the track of a needle as vtkPolyData, from a trace or from the needle in the hand.
 */
#ifndef NeedleTrace_h
#define NeedleTrace_h

#include "Core/Math/Vector3.h"

#include <string>

class vtkPolyData;

namespace VolumeHaptics
{

class HapticModel;
struct NeedleState;

/**
 * Makes the track of a needle from a trace: see vtkHapticNeedle::MakeTrack. Returns the fault, with
 * its cure; empty on success.
 */
std::string MakeNeedleTrack(vtkPolyData* trace, vtkPolyData* track);

/**
 * Writes the track from the entry to the tip along the needle's present axis: see
 * vtkHapticState::GetNeedleTrack. The proxy is in metres. The track is empty if the needle is not
 * inserted.
 */
void WriteNeedleTrack(
  const HapticModel& model, const NeedleState& needle, const Vector3& proxy, vtkPolyData* track);

} // namespace VolumeHaptics

#endif

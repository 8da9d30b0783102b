// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeLook_h
#define Explore_VolumeLook_h

#include "Applications/Explorer/Analysis/VolumeAnalysis.h"

class vtkHapticLabelTable;
class vtkVolumeProperty;

namespace Explore
{
/// Colours and opacities: the outer surface, which a hand meets first, is visible: half of the
/// opacity along a ray of a CT is within about a voxel of it. A field, which has no surface that
/// holds, is like glass with opaque parts, equally clear at every scale. The gradient opacity, for
/// a cut, is disabled here.
void SetVolumeLook(const Analysis& analysis, vtkVolumeProperty* property);

/// Whether there is something to see and to feel inside: not in labels, each of which can be
/// hidden, or in fields.
bool HasInside(const Analysis& analysis);

/// Shows only the dense parts instead. vtkHapticProperty::SetVisibilityFrom makes the same parts
/// felt.
void SetInsideLook(const Analysis& analysis, vtkVolumeProperty* property);

/// The colours of labels, each over half a number below and above its own.
void SetLabelLook(vtkHapticLabelTable* table, vtkVolumeProperty* property);
} // namespace Explore

#endif

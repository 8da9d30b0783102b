// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeLook_h
#define Explore_VolumeLook_h

#include "Applications/Explorer/Analysis/VolumeAnalysis.h"

class vtkHapticLabelTable;
class vtkVolumeProperty;

namespace Explore
{
/// Sets colours and opacities. The outer surface, which a hand meets first, is visible: half of the
/// opacity along a ray through a CT is within about a voxel of it. A field, which has no surface
/// that holds, is like glass with opaque parts, equally clear at every scale. The gradient opacity,
/// for a cut, is disabled here.
void SetVolumeLook(const Analysis& analysis, vtkVolumeProperty* property);

/// Whether the inside has something to see and to feel. Returns false for labels, each of which can
/// be hidden, and for fields.
bool HasInside(const Analysis& analysis);

/// Shows only the dense parts of the volume. vtkHapticProperty::SetVisibilityFrom makes the same
/// parts felt.
void SetInsideLook(const Analysis& analysis, vtkVolumeProperty* property);

/// Sets the colours of labels, each from half a number below its own to half a number above.
void SetLabelLook(vtkHapticLabelTable* table, vtkVolumeProperty* property);
} // namespace Explore

#endif

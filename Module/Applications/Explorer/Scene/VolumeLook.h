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
/// opacity along a ray through a CT is within about a voxel of it. A field has no solid surface, so
/// it looks like glass with opaque parts, equally clear at every scale. The gradient opacity is
/// only for cuts, and is disabled here.
void SetVolumeLook(const Analysis& analysis, vtkVolumeProperty* property);

/// Returns whether the inside has parts to show and to feel. Returns false for labels, which can be
/// hidden individually, and for fields.
bool HasInside(const Analysis& analysis);

/// Shows only the dense parts of the volume. With vtkHapticProperty::SetVisibilityFrom, only these
/// parts are felt, too.
void SetInsideLook(const Analysis& analysis, vtkVolumeProperty* property);

/// Sets the colour of each label for values within half a number of the label.
void SetLabelLook(vtkHapticLabelTable* table, vtkVolumeProperty* property);
} // namespace Explore

#endif

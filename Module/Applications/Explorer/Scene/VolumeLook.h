// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeLook_h
#define Explore_VolumeLook_h

#include "Applications/Explorer/Analysis/VolumeAnalysis.h"

class vtkHapticLabelTable;
class vtkVolumeProperty;

namespace Explore
{
/// Colours and opacities: the outer surface, which a hand meets first, is what is seen: half of the
/// opacity along a ray of a CT is within about a voxel of it. A field, which has no surface that
/// holds, is like glass with opaque parts, equally clear at every scale. The gradient opacity, for
/// a cut, is disabled here.
void SetVolumeLook(const Analysis& analysis, vtkVolumeProperty* property);

/// Whether there is something to see and to feel inside: not in labels, each of which can be
/// hidden, or fields.
bool HasInside(const Analysis& analysis);

/// Instead, the dense parts alone. vtkHapticProperty::SetVisibilityFrom makes that what is felt.
void SetInsideLook(const Analysis& analysis, vtkVolumeProperty* property);

/// The colours of labels, each from half a number below its own to half a number above.
void SetLabelLook(vtkHapticLabelTable* table, vtkVolumeProperty* property);
} // namespace Explore

#endif

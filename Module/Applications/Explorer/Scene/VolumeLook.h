// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeLook_h
#define Explore_VolumeLook_h

#include "Applications/Explorer/Analysis/VolumeAnalysis.h"

class vtkHapticLabelTable;
class vtkVolumeProperty;

namespace Explore
{
/// Colours and opacities: the outer tissue like glass, the dense parts inside it opaque and shaded,
/// so that a trail is visible on the outer surface as well as under it. The glass is equally clear
/// at every scale.
void SetVolumeLook(const Analysis& analysis, vtkVolumeProperty* property);

/// The colours of labels, each from half a number below its own to half a number above.
void SetLabelLook(vtkHapticLabelTable* table, vtkVolumeProperty* property);
} // namespace Explore

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LabelMap_h
#define Explore_LabelMap_h

#include "vtkImageData.h"

namespace Explore
{
/// Whether the values of a volume look like label numbers: they are few whole numbers of 0 or more,
/// most voxels equal their neighbours, and the other steps are of any size. In a scan, noise makes
/// neighbours differ, and blurred edges make most steps small.
bool LooksLikeLabels(vtkImageData* image);
} // namespace Explore

#endif

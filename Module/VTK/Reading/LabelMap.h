// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_LabelMap_h
#define Explore_LabelMap_h

#include "vtkImageData.h"

namespace Explore
{
/// Whether the values of a volume look like numbers of labels: few whole numbers of 0 or more, most
/// voxels like their neighbours, and steps of any size between the others. In a scan noise makes
/// neighbours differ, and a blurred edge makes most steps small.
bool LooksLikeLabels(vtkImageData* image);
} // namespace Explore

#endif

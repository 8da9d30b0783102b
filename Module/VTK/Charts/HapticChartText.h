// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The text style of charts.
 */
#ifndef HapticChartText_h
#define HapticChartText_h

#include "vtkTextProperty.h"

namespace VolumeHaptics
{

/** Upright letters of a size (points) and a colour (RGB, 0 to 1). */
inline void SetChartText(vtkTextProperty* text, int size, const double (&colour)[3])
{
  text->SetFontSize(size);
  text->SetColor(colour[0], colour[1], colour[2]);
  text->BoldOff();
  text->ItalicOff();
}

} // namespace VolumeHaptics

#endif

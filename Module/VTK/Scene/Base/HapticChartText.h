// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Sets the style of charts: text and background panel.
 */
#ifndef HapticChartText_h
#define HapticChartText_h

#include "vtkBlockItem.h"
#include "vtkBrush.h"
#include "vtkPen.h"
#include "vtkTextProperty.h"

#include <string>

namespace VolumeHaptics
{

/** Sets the size (points) and colour (RGB, 0 to 1) of a chart's text, neither bold nor italic. */
inline void SetChartText(vtkTextProperty* text, int size, const double (&colour)[3])
{
  text->SetFontSize(size);
  text->SetColor(colour[0], colour[1], colour[2]);
  text->BoldOff();
  text->ItalicOff();
}

/** Makes a panel slightly transparent, so that the scene behind it stays visible. */
inline void MakePanel(vtkBlockItem* panel)
{
  panel->GetBrush()->SetColor(250, 250, 252, 225);
  panel->GetPen()->SetColor(150, 155, 165, 255);
  panel->GetMouseOverBrush()->SetColor(250, 250, 252, 225);
  panel->SetInteractive(false);
}

/**
 * Returns ", 40 % counted" for the fraction 0.4 and the word "counted"; empty for the fraction 1.
 */
inline std::string DescribeFraction(double fraction, const char* done)
{
  constexpr double percent = 100.0;
  return fraction < 1.0 ? ", " + std::to_string(static_cast<int>(percent * fraction)) + " % " + done
                        : std::string();
}

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The style of charts: their text, and the panel behind them.
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

/**
 * Sets the size (points) and the colour (RGB, 0 to 1) of a chart's text, without bold and italics.
 */
inline void SetChartText(vtkTextProperty* text, int size, const double (&colour)[3])
{
  text->SetFontSize(size);
  text->SetColor(colour[0], colour[1], colour[2]);
  text->BoldOff();
  text->ItalicOff();
}

/** Makes a panel that lets the scene behind it shine through a little. */
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

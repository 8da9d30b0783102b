// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_SliderLook_h
#define Explore_SliderLook_h

#include "vtkProperty2D.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSliderRepresentation2D.h"
#include "vtkSliderWidget.h"
#include "vtkTextProperty.h"

namespace Explore
{
/// Places a slider for the time along the lower edge of a window, and enables it.
inline void ShowTimeSlider(vtkSliderWidget* widget, vtkSliderRepresentation2D* slider,
  vtkRenderWindowInteractor* interactor, vtkRenderer* overlay)
{
  constexpr float priority = 1.0f; // receives events before the scene
  slider->GetPoint1Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  slider->GetPoint1Coordinate()->SetValue(0.34, 0.07);
  slider->GetPoint2Coordinate()->SetCoordinateSystemToNormalizedDisplay();
  slider->GetPoint2Coordinate()->SetValue(0.66, 0.07);
  slider->SetTubeWidth(0.006);
  slider->SetSliderLength(0.012);
  slider->SetSliderWidth(0.022);
  slider->SetEndCapLength(0.004);
  slider->SetTitleHeight(0.022);
  slider->SetLabelHeight(0.022);
  slider->GetTubeProperty()->SetColor(0.45, 0.52, 0.62);
  slider->GetSliderProperty()->SetColor(0.93, 0.95, 0.98);
  slider->GetSelectedProperty()->SetColor(1.0, 0.75, 0.25);
  widget->SetInteractor(interactor);
  widget->SetRepresentation(slider);
  widget->SetCurrentRenderer(overlay);
  widget->SetDefaultRenderer(overlay);
  widget->SetPriority(priority);
  widget->KeyPressActivationOff();
  widget->SetAnimationModeToJump();
  widget->EnabledOn();
}
} // namespace Explore

#endif

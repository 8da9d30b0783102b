// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_TimeSlider_h
#define Explore_TimeSlider_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSliderRepresentation2D.h"
#include "vtkSliderWidget.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace Explore
{
/// A slider for the time of a moving volume: it shows which time step is felt, and the user can
/// drag it to another time step.
class TimeSlider
{
public:
  TimeSlider(
    TouchScene& touch, const Exploration& exploration, vtkRenderWindowInteractor* interactor);
  ~TimeSlider();
  TimeSlider(const TimeSlider&) = delete;
  TimeSlider& operator=(const TimeSlider&) = delete;

private:
  void GoTo();
  void Update();

  TouchScene& Touch;
  const vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  std::vector<double> Times; // times of the time steps, ascending, in the units of the source
  double UnitsPerSecond = 1.0;
  bool IsDragged = false;
  vtkNew<vtkSliderRepresentation2D> Slider;
  vtkNew<vtkSliderWidget> Widget;
  vtkNew<vtkCallbackCommand> Observer;
};
} // namespace Explore

#endif

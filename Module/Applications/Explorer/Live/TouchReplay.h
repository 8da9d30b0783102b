// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_TouchReplay_h
#define Explore_TouchReplay_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkActor.h"
#include "vtkArrowSource.h"
#include "vtkCallbackCommand.h"
#include "vtkLineSource.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSliderRepresentation2D.h"
#include "vtkSliderWidget.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <chrono>
#include <string>

namespace Explore
{
/// Shows a recording of a touch in the window: the path of the proxy, and the tip, the proxy and
/// the force at the time that a slider sets. F5 plays and pauses it in real time, F6 and F7 step
/// back and forward. A replay exerts no force; the user can touch with a device at the same time.
class TouchReplay
{
public:
  /// Throws InputError if the file is neither a recording nor a trace.
  TouchReplay(TouchScene& touch, vtkRenderWindowInteractor* interactor, const std::string& file);
  ~TouchReplay();
  TouchReplay(const TouchReplay&) = delete;
  TouchReplay& operator=(const TouchReplay&) = delete;

  /// Reads a recording. Throws InputError if the file is neither a recording nor a trace.
  static vtkSmartPointer<vtkPolyData> ReadFile(const std::string& file);

private:
  void BuildActors();
  void BuildSlider(const std::string& file);
  void AddCommands();
  void Update();
  /// Shows the state at a time of the recording (s).
  void Show(double time);

  TouchScene& Touch;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  vtkSmartPointer<vtkPolyData> Trace;
  double Begin = 0.0, End = 0.0; ///< first and last time of the recording (s)
  double Now = 0.0;              ///< shown time (s)
  bool IsPlaying = false;
  std::chrono::steady_clock::time_point
    Played; ///< when Now was last updated, on the computer's clock

  vtkNew<vtkActor> Way;
  vtkNew<vtkSphereSource> Proxy;
  vtkNew<vtkActor> ProxyActor;
  vtkNew<vtkLineSource> Spring; ///< line from the proxy to the tip
  vtkNew<vtkActor> SpringActor;
  vtkNew<vtkArrowSource> Force;
  vtkNew<vtkActor> ForceActor;
  vtkNew<vtkSliderRepresentation2D> Slider;
  vtkNew<vtkSliderWidget> Widget;
  vtkNew<vtkCallbackCommand> Observer;
};
} // namespace Explore

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects a demonstration's mouse to be at the script's position, regardless of the real pointer.
#include "Applications/Explorer/Record/DemoScript.h"
#include "Expectations.h"
#include "HeadExploration.h"

#include "vtkCallbackCommand.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <array>
#include <vector>

int TestExploreScript(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "ExploreScript");
  const std::string file =
    WriteText("demo.txt", "0 move 0.25 0.75\n0 key t\n0 wheel 1\n0 press left\n");
  vtkNew<vtkRenderWindow> window;
  window->SetSize(401, 201);
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);

  using Place = std::array<int, 2>;
  std::vector<Place> places;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&places);
  observer->SetCallback(
    [](vtkObject* caller, unsigned long, void* to, void*)
    {
      auto* const at = static_cast<vtkRenderWindowInteractor*>(caller);
      const int* const place = at->GetEventPosition();
      static_cast<std::vector<Place>*>(to)->push_back({ place[0], place[1] });
      // Change the position, as X11 does when the real pointer enters the window.
      at->SetEventInformation(3, 5);
    });
  for (const unsigned long event : { vtkCommand::MouseMoveEvent, vtkCommand::KeyPressEvent,
         vtkCommand::MouseWheelForwardEvent, vtkCommand::LeftButtonPressEvent })
  {
    interactor->AddObserver(event, observer);
  }
  {
    const Explore::DemoScript script(Explore::ReadDemoScript(file), interactor);
    interactor->InvokeEvent(vtkCommand::TimerEvent);
  }
  Expect(places == std::vector<Place>(4, Place{ 100, 150 }), "each event is where the mouse is");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

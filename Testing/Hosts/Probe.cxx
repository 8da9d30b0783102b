// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reports the haptic state to drive.py from a program that runs no foreign code: VTK loads this
 * library into the program. In the folder HOST_PROBE, it writes state.json as program.py does.
 */
#include "Applications/Autoload/InteractorFactory.h"

#include "vtkCallbackCommand.h"
#include "vtkHapticDevice.h"
#include "vtkHapticRepresentation.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>

namespace
{

std::string Text(const double* vector)
{
  return "[" + std::to_string(vector[0]) + ", " + std::to_string(vector[1]) + ", " +
    std::to_string(vector[2]) + "]";
}

/** Returns the window's id, and a position in the window in pixels from the top left, as JSON. */
std::string PlaceOn(vtkRenderWindow* window, double x, double y)
{
  return "[" + std::to_string(reinterpret_cast<std::uintptr_t>(window->GetGenericWindowId())) +
    ", " + std::to_string(static_cast<int>(x)) + ", " +
    std::to_string(window->GetSize()[1] - static_cast<int>(y)) + "]";
}

class HostProbe : public VolumeHaptics::InteractorFactory
{
public:
  static HostProbe* New();
  vtkTypeMacro(HostProbe, VolumeHaptics::InteractorFactory);
  const char* GetDescription() override { return "What a test sees of a program"; }

protected:
  void Attach(vtkRenderWindowInteractor* made) override
  {
    this->Interactor = made; // lives as long as the program
    this->Eye->SetClientData(this);
    this->Eye->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<HostProbe*>(self)->Look(); });
    vtkNew<vtkCallbackCommand> start;
    start->SetClientData(this);
    start->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<HostProbe*>(self)->Start(); });
    made->AddObserver(vtkCommand::RenderEvent, start);
    made->AddObserver(vtkCommand::MouseMoveEvent, start, 2.0f);
    vtkNew<vtkCallbackCommand> hear;
    hear->SetClientData(this);
    hear->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<HostProbe*>(self)->Hear(); });
    made->AddObserver(vtkCommand::KeyPressEvent, hear, -1.0f);
  }

private:
  void Start()
  {
    if (!std::exchange(this->HasTimer, true))
    {
      this->Interactor->CreateRepeatingTimer(50); // ms
    }
    if (!this->Interactor->HasObserver(vtkCommand::TimerEvent, this->Eye)) // f3d removed it
    {
      this->Interactor->AddObserver(vtkCommand::TimerEvent, this->Eye, 2.0f);
    }
  }
  void Hear()
  {
    const char* const key = this->Interactor->GetKeySym();
    this->Keys += std::string(this->Keys.empty() ? "" : ", ") + "\"" + (key ? key : "") + "\"";
  }
  void Look()
  {
    vtkRenderWindow* const window = this->Interactor->GetRenderWindow();
    vtkRenderer* const renderer = window ? window->GetRenderers()->GetFirstRenderer() : nullptr;
    vtkHapticDevice* device = nullptr;
    vtkCollectionSimpleIterator it;
    if (renderer)
    {
      renderer->GetViewProps()->InitTraversal(it);
    }
    while (vtkProp* const prop = renderer ? renderer->GetViewProps()->GetNextProp(it) : nullptr)
    {
      auto* const hand = vtkHapticRepresentation::SafeDownCast(prop);
      device = hand ? hand->GetDevice() : device;
    }
    auto* const volume = renderer && renderer->GetVolumes()->GetNumberOfItems() > 0
      ? vtkVolume::SafeDownCast(renderer->GetVolumes()->GetItemAsObject(0))
      : nullptr;
    if (!device || !volume)
    {
      return;
    }
    const double* const center = volume->GetCenter();
    renderer->SetWorldPoint(center[0], center[1], center[2], 1.0);
    renderer->WorldToDisplay();
    const double* const at = renderer->GetDisplayPoint();
    const int* const pointer = this->Interactor->GetEventPosition();
    const bool touches = device->GetStatus() == vtkHapticDevice::ARMED ||
      device->GetStatus() == vtkHapticDevice::ACTIVE;
    std::string status = device->GetStatusText();
    std::replace(status.begin(), status.end(), '"', '\'');
    const std::string file = std::string(std::getenv("HOST_PROBE")) + "/state.json";
    std::ofstream(file + ".new") << "{\"touch\": " << (touches ? "true" : "false")
                                 << ", \"force\": " << Text(device->GetState()->GetForce())
                                 << ", \"tip\": " << Text(device->GetState()->GetTipPosition())
                                 << ", \"proxy\": " << Text(device->GetState()->GetProxyPosition())
                                 << ", \"center\": " << Text(center) << ", \"keys\": ["
                                 << this->Keys << "], \"status\": \"" << status
                                 << "\", \"looks\": " << ++this->Looks
                                 << ", \"middle\": " << PlaceOn(window, at[0], at[1])
                                 << ", \"pointer\": " << PlaceOn(window, pointer[0], pointer[1])
                                 << ", \"again\": false, \"lets_go\": \"Escape\"}\n";
    std::rename((file + ".new").c_str(), file.c_str());
  }

  vtkRenderWindowInteractor* Interactor = nullptr;
  vtkNew<vtkCallbackCommand> Eye;
  std::string Keys;
  int Looks = 0;
  bool HasTimer = false;
};

vtkStandardNewMacro(HostProbe);

} // namespace

VTK_FACTORY_INTERFACE_IMPLEMENT(HostProbe)

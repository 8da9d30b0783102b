// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture with a window that contains a volume. Tests choose the duration of its frames. */
#ifndef QualityRig_h
#define QualityRig_h

#include "VTK/Scene/Interaction/StyleRig.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <chrono>
#include <thread>

#include <dlfcn.h>

namespace scenetest
{
constexpr double InMotion = 15.0;
constexpr double AtRest = 0.001;

/// Waits until the X server has handled all requests. Their events are then in X11's queue.
inline void AwaitServer(vtkRenderWindow* window)
{
  using Sync = int (*)(void* display, int);
  static const auto sync = reinterpret_cast<Sync>(dlsym(dlopen("libX11.so.6", RTLD_LAZY), "XSync"));
  sync(window->GetGenericDisplayId(), 0);
}

/// Sends a mouse motion to the window with XSendEvent(), because the pointer may be over another
/// test's window. X11's header is not included, because its macros would conflict with other tests.
inline void SendMotion(vtkRenderWindow* window)
{
  using Send = int (*)(void* display, unsigned long window, int, long, void* event);
  static const auto send =
    reinterpret_cast<Send>(dlsym(dlopen("libX11.so.6", RTLD_LAZY), "XSendEvent"));
  constexpr int motionNotify = 6;
  struct // the used members of XMotionEvent, padded to the size of an XEvent
  {
    int Type;
    unsigned long Serial;
    int IsSent;
    void* Display;
    unsigned long Window;
    long Rest[24];
  } event = {};
  event.Type = motionNotify;
  event.Window = reinterpret_cast<unsigned long>(window->GetGenericWindowId());
  send(window->GetGenericDisplayId(), event.Window, 0, 0, &event);
  AwaitServer(window);
}

/// Removes one event of this type for the window from X11's queue. Returns false if there is none.
inline bool DrainEvent(vtkRenderWindow* window, int type)
{
  using Take = int (*)(void* display, unsigned long window, int, void* event);
  static const auto take =
    reinterpret_cast<Take>(dlsym(dlopen("libX11.so.6", RTLD_LAZY), "XCheckTypedWindowEvent"));
  long event[24];
  return take(window->GetGenericDisplayId(),
           reinterpret_cast<unsigned long>(window->GetGenericWindowId()), type, event) != 0;
}

/// Makes a mapper slow by sleeping in each progress report. One thread sends a report every eight
/// rows.
class SlowRows
{
public:
  SlowRows(vtkFixedPointVolumeRayCastMapper* mapper, int slowness)
    : Slowness(slowness)
  {
    this->Wait->SetClientData(this);
    this->Wait->SetCallback(
      [](vtkObject* mapper, unsigned long, void* self, void*)
      {
        auto& rows = *static_cast<SlowRows*>(self);
        if (++rows.Count == rows.Move)
        {
          SendMotion(static_cast<vtkFixedPointVolumeRayCastMapper*>(mapper)->GetRenderWindow());
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(rows.Slowness));
      });
    mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, this->Wait, 1.0f);
  }

  int Slowness; ///< sleep (ms) in each report
  int Move = 0; ///< number of the report during which the mouse moves; 0: none
  int Count = 0;

private:
  vtkNew<vtkCallbackCommand> Wait;
};

class StyleQualityTest : public StyleTest
{
protected:
  StyleQualityTest()
  {
    this->Window->SetOffScreenRendering(0);
    this->Window->SetSize(120, 120);
    this->Volume->GetProperty()->GetScalarOpacity()->AddPoint(-1.0, 0.0);
    this->Volume->GetProperty()->GetScalarOpacity()->AddPoint(1.0, 1.0);
    this->Renderer->AddVolume(this->Volume);
    vtkNew<vtkCallbackCommand> wait;
    wait->SetClientData(this);
    wait->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*)
      {
        std::this_thread::sleep_for(
          std::chrono::milliseconds(static_cast<StyleQualityTest*>(self)->Slowness));
      });
    // runs before the observer of the interactor style
    this->Window->AddObserver(vtkCommand::EndEvent, wait, 1.0f);
  }
  ~StyleQualityTest() override { this->Interactor->SetInteractorStyle(nullptr); }

  template <typename Mapper>
  void Show(Mapper* mapper)
  {
    mapper->SetInputData(this->Ball);
    this->Volume->SetMapper(mapper);
    this->Interactor->Initialize();
    this->Style->UpdateHaptics();
  }
  void Draw(double rate, int times)
  {
    this->Window->SetDesiredUpdateRate(rate);
    for (int i = 0; i < times; ++i)
    {
      this->Window->Render();
    }
  }
  void Arm()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    ASSERT_TRUE(this->Device->Start());
    this->Device->Arm();
    ASSERT_TRUE(Eventually(
      [this]
      {
        this->Style->UpdateHaptics();
        return this->Device->GetStatus() == vtkHapticDevice::ARMED;
      }));
  }

  vtkNew<vtkVolume> Volume;
  int Slowness = 0; ///< sleep (ms) in each frame
};
} // namespace scenetest

#endif

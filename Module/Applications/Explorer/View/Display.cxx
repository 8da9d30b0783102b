// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/View/Display.h"

#include "Core/Math/NumberText.h"
#include "VTK/Scene/Base/HapticPixels.h"

#include "vtkNew.h"
#include "vtkRenderWindow.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <string>

#if defined(__linux__)
#include <dlfcn.h>
#endif

namespace
{
/// Returns the dots per inch of an X11 screen; 0 if unknown. VTK 9.1 reads them only on other
/// systems.
double ReadDots([[maybe_unused]] vtkRenderWindow* window)
{
  double dots = 0.0;
#if defined(__linux__)
  // Look for the library that VTK has loaded, if any. X11's header is not included, because it
  // defines macros with common names.
  void* const library = window->IsA("vtkXOpenGLRenderWindow")
    ? dlopen("libX11.so.6", RTLD_LAZY | RTLD_NOLOAD)
    : nullptr;
  if (!library)
  {
    return dots;
  }
  using Text = char* (*)(void* display, const char* program, const char* option);
  using Number = int (*)(void* display, int screen);
  const auto getDefault = reinterpret_cast<Text>(dlsym(library, "XGetDefault"));
  const auto getHeight = reinterpret_cast<Number>(dlsym(library, "XDisplayHeight"));
  const auto getMillimetres = reinterpret_cast<Number>(dlsym(library, "XDisplayHeightMM"));
  window->GetScreenSize(); // opens the display as a side effect
  void* const display = window->GetGenericDisplayId();
  if (display && getDefault && getHeight && getMillimetres)
  {
    constexpr double inch = 25.4; // mm
    const char* const chosen = getDefault(display, "Xft", "dpi");
    const int millimetres = getMillimetres(display, 0);
    const double reported = millimetres > 0 ? inch * getHeight(display, 0) / millimetres : 0.0;
    dots = VolumeHaptics::ParseNumber(chosen ? chosen : "").value_or(reported);
  }
  dlclose(library);
#endif
  return dots;
}
} // namespace

namespace Explore
{
bool HasDisplay()
{
  vtkNew<vtkRenderWindow> window;
  const bool needsX = std::string(window->GetClassName()) == "vtkXOpenGLRenderWindow";
  std::string display;
  return !needsX || (vtksys::SystemTools::GetEnv("DISPLAY", display) && !display.empty());
}

void ApplyScreen(vtkRenderWindow* window)
{
  using VolumeHaptics::OwnDotsPerInch;
  constexpr double usual = 96.0;
  constexpr double least = 105.0;
  constexpr double most = 300.0;
  const double dots = window->DetectDPI() ? window->GetDPI() : ReadDots(window);
  window->SetDPI(dots > least
      ? static_cast<int>(std::lround(OwnDotsPerInch * std::min(dots, most) / usual))
      : OwnDotsPerInch);
}
} // namespace Explore

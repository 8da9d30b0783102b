// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/View/StereoModes.h"

#include "VTK/Reading/InputError.h"

#include "vtkRenderWindow.h"

namespace Explore
{
int FindStereoMode(const std::string& name)
{
  static const std::pair<const char*, int> modes[] = { { "anaglyph", VTK_STEREO_ANAGLYPH },
    { "crystal-eyes", VTK_STEREO_CRYSTAL_EYES }, { "red-blue", VTK_STEREO_RED_BLUE },
    { "interlaced", VTK_STEREO_INTERLACED }, { "checkerboard", VTK_STEREO_CHECKERBOARD },
    { "split-viewport", VTK_STEREO_SPLITVIEWPORT_HORIZONTAL }, { "dresden", VTK_STEREO_DRESDEN },
    { "left", VTK_STEREO_LEFT }, { "right", VTK_STEREO_RIGHT }, { "fake", VTK_STEREO_FAKE },
    { "emulate", VTK_STEREO_EMULATE } };
  std::string names;
  for (const auto& [known, mode] : modes)
  {
    if (name == known)
    {
      return mode;
    }
    names += (names.empty() ? "" : ", ") + std::string(known);
  }
  throw InputError("--stereo " + name, "is not a stereo mode of VTK", "use one of " + names);
}

void SetStereo(vtkRenderWindow* window, const std::string& name)
{
  if (name.empty())
  {
    // VTK's default, red and blue, would lose all colours.
    window->SetStereoType(VTK_STEREO_ANAGLYPH);
    return;
  }
  const int mode = FindStereoMode(name);
  if (mode == VTK_STEREO_CRYSTAL_EYES)
  {
    window->StereoCapableWindowOn();
  }
  window->SetStereoType(mode);
  window->StereoRenderOn();
}
} // namespace Explore

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The volumes that a window shows.
 */
#ifndef WindowVolumes_h
#define WindowVolumes_h

#include "vtkCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"

namespace VolumeHaptics
{

/** Visits each visible volume with a mapper, and the renderer that draws it. */
template <typename Visit>
void ForEachVolume(vtkRenderWindow* window, Visit&& visit)
{
  vtkRendererCollection* const renderers = window->GetRenderers();
  vtkCollectionSimpleIterator at;
  renderers->InitTraversal(at);
  while (vtkRenderer* const renderer = renderers->GetNextRenderer(at))
  {
    vtkVolumeCollection* const volumes = renderer->GetVolumes();
    for (int i = 0; i < volumes->GetNumberOfItems(); ++i)
    {
      auto* const volume = vtkVolume::SafeDownCast(volumes->GetItemAsObject(i));
      if (volume && volume->GetVisibility() && volume->GetMapper())
      {
        visit(renderer, volume);
      }
    }
  }
}

} // namespace VolumeHaptics

#endif

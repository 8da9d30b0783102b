// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes text over a scene legible on dark and on light backgrounds.
 */
#ifndef HapticTextLook_h
#define HapticTextLook_h

#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTextProperty.h"
#include "vtkViewport.h"

#include <algorithm>

namespace VolumeHaptics
{

/**
 * Returns whether the background behind a viewport is light. The viewport may be in an upper layer.
 */
inline bool IsOnLight(vtkViewport* viewport)
{
  vtkViewport* ground = viewport;
  auto* const renderer = vtkRenderer::SafeDownCast(viewport);
  vtkRenderWindow* const window = renderer ? renderer->GetRenderWindow() : nullptr;
  if (window && renderer->GetLayer() > 0)
  {
    // If several renderers of layer 0 are side by side, use the one behind the centre of this
    // viewport.
    double mine[4]; // left, bottom, right, top
    renderer->GetViewport(mine);
    const double middle[2] = { 0.5 * (mine[0] + mine[2]), 0.5 * (mine[1] + mine[3]) };
    vtkCollectionSimpleIterator at;
    window->GetRenderers()->InitTraversal(at);
    while (vtkRenderer* const other = window->GetRenderers()->GetNextRenderer(at))
    {
      double theirs[4];
      other->GetViewport(theirs);
      const bool isBelow = other->GetLayer() == 0 && middle[0] >= theirs[0] &&
        middle[0] <= theirs[2] && middle[1] >= theirs[1] && middle[1] <= theirs[3];
      ground = isBelow ? other : ground;
    }
  }
  const auto lightness = [](const double* c) { return 0.3 * c[0] + 0.6 * c[1] + 0.1 * c[2]; };
  const double low = lightness(ground->GetBackground());
  const double high = ground->GetGradientBackground() ? lightness(ground->GetBackground2()) : low;
  constexpr double middle = 0.55;
  return 0.5 * (low + high) > middle;
}

/**
 * Sets a text colour that fits the background. On a dark background, the text has a shadow. On a
 * light one, it has no shadow and a darker colour, with greys inverted.
 */
inline void SetLook(
  vtkTextProperty* text, double red, double green, double blue, vtkViewport* viewport)
{
  constexpr double darker = 0.6;
  const bool isLight = IsOnLight(viewport);
  const bool isGrey = std::max({ red, green, blue }) - std::min({ red, green, blue }) < 0.1;
  const auto fit = [&](double part) {
    return !isLight ? part : isGrey ? 1.0 - part : darker * part;
  };
  text->SetColor(fit(red), fit(green), fit(blue));
  text->SetShadow(isLight ? 0 : 1);
}

} // namespace VolumeHaptics

#endif

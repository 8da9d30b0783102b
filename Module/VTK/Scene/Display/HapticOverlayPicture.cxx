// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/HapticOverlayPicture.h"

#include "VTK/Base/vtkVolumeHapticsCompat.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkTextureObject.h"
#include "vtkViewport.h"

#include VOLUME_HAPTICS_OPENGL_HEADER

#include <algorithm>

namespace VolumeHaptics
{

HapticOverlayPicture::HapticOverlayPicture() = default;
HapticOverlayPicture::~HapticOverlayPicture() = default;

int HapticOverlayPicture::Render(
  vtkViewport* viewport, vtkProp* prop, const int extent[2], bool isStale)
{
  auto* const window = vtkOpenGLRenderWindow::SafeDownCast(viewport->GetVTKWindow());
  if (!window || window->GetTileScale()[0] > 1 || window->GetTileScale()[1] > 1)
  {
    return prop->RenderOverlay(viewport);
  }
  vtkOpenGLState* const state = window->GetState();
  int origin[2] = { 0, 0 };
  int size[2] = { 0, 0 };
  viewport->GetTiledSizeAndOrigin(size, size + 1, origin, origin + 1);
  if (size[0] < 1 || size[1] < 1)
  {
    return 0;
  }
  // Place the viewport in the picture as in the window: charts clip their curves by its place
  // there.
  const int width = origin[0] + size[0];
  const int height = origin[1] + size[1];
  if (this->Window && this->Window != window)
  {
    this->ReleaseGraphicsResources(this->Window);
  }
  if (width != this->Size[0] || height != this->Size[1])
  {
    this->ReleaseGraphicsResources(window);
    this->Picture->SetContext(window);
    this->Picture->Allocate2D(width, height, 4, VTK_UNSIGNED_CHAR);
    this->Target->SetContext(window);
    this->Window = window;
    this->Size[0] = width;
    this->Size[1] = height;
    isStale = true;
  }
  if (origin[0] != this->Origin[0] || origin[1] != this->Origin[1])
  {
    std::copy(origin, origin + 2, this->Origin);
    isStale = true;
  }
  int drawn = 1;
  vtkOpenGLState::ScopedglViewport keepViewport(state);
  vtkOpenGLState::ScopedglScissor keepScissor(state);
  vtkOpenGLState::ScopedglBlendFuncSeparate keepBlending(state);
  vtkOpenGLState::ScopedglEnableDisable keepDepthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable keepBlend(state, GL_BLEND);
  if (isStale)
  {
    vtkOpenGLState::ScopedglClearColor keepColor(state);
    vtkOpenGLState::ScopedglColorMask keepMask(state);
    state->PushFramebufferBindings();
    this->Target->Bind();
    this->Target->AddColorAttachment(0, this->Picture);
    this->Target->ActivateDrawBuffer(0);
    state->vtkglViewport(origin[0], origin[1], size[0], size[1]);
    state->vtkglScissor(0, 0, width, height);
    state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    state->vtkglClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    drawn = prop->RenderOverlay(viewport);
    state->PopFramebufferBindings();
  }
  // Drawing over an empty background has already multiplied the colours by their opacity.
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  const int end[2] = { origin[0] + std::min(extent[0], size[0]) - 1,
    origin[1] + std::min(extent[1], size[1]) - 1 };
  this->Picture->Activate();
  this->Picture->CopyToFrameBuffer(origin[0], origin[1], end[0], end[1], origin[0], origin[1],
    end[0], end[1], window->GetSize()[0], window->GetSize()[1], nullptr, nullptr);
  this->Picture->Deactivate();
  return drawn;
}

void HapticOverlayPicture::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Target->ReleaseGraphicsResources(window);
  this->Picture->ReleaseGraphicsResources(window);
  this->Window = nullptr;
  this->Size[0] = 0;
  this->Size[1] = 0;
}

} // namespace VolumeHaptics

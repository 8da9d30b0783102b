// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws a prop of the overlay into a texture, and shows the texture in every frame. A chart has
 * dozens of small pieces; its picture is one.
 */
#ifndef HapticOverlayPicture_h
#define HapticOverlayPicture_h

#include "vtkNew.h"

class vtkOpenGLFramebufferObject;
class vtkProp;
class vtkTextureObject;
class vtkViewport;
class vtkWindow;

namespace VolumeHaptics
{

class HapticOverlayPicture
{
public:
  HapticOverlayPicture();
  ~HapticOverlayPicture();

  /**
   * Shows the prop. Redraws its picture if it is stale, if the viewport has changed, or if there is
   * none yet. Shows the lower left corner of the picture, up to an extent (pixels). If the window
   * does not use OpenGL, or is drawn in tiles, the prop itself is drawn. Returns the result of
   * vtkProp::RenderOverlay.
   */
  int Render(vtkViewport* viewport, vtkProp* prop, const int extent[2], bool isStale);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkOpenGLFramebufferObject> Target;
  vtkNew<vtkTextureObject> Picture;
  vtkWindow* Window = nullptr; ///< the owner of the resources
  int Size[2] = { 0, 0 };      ///< pixels
  int Origin[2] = { 0, 0 };    ///< origin of the viewport, pixels
};

} // namespace VolumeHaptics

#endif

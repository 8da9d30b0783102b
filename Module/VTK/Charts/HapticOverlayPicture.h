// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A prop of the overlay, drawn into a texture now and then and shown from there in every frame: a
 * chart is made of dozens of small pieces, a picture of it is one.
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
   * Show the prop, after drawing it anew if it is stale, if the viewport's size has changed or if
   * there is no picture yet. Of its picture, the lower left corner is shown, up to an extent
   * (pixels). Where the window isn't OpenGL's, or is drawn in tiles, the prop is just drawn.
   * Returns what vtkProp::RenderOverlay does.
   */
  int Render(vtkViewport* viewport, vtkProp* prop, const int extent[2], bool isStale);
  void ReleaseGraphicsResources(vtkWindow* window);

private:
  vtkNew<vtkOpenGLFramebufferObject> Target;
  vtkNew<vtkTextureObject> Picture;
  vtkWindow* Window = nullptr; ///< whose resources these are
  int Size[2] = { 0, 0 };      ///< pixels
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One slice of an image in a renderer of its own, with a crosshair and texts.
 */
#ifndef SlicePanel_h
#define SlicePanel_h

#include "VTK/Scene/Slices/SliceAxes.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkTextActor.h"

#include <array>
#include <string>

class vtkImageProperty;

namespace VolumeHaptics
{

class SlicePanel
{
public:
  SlicePanel();

  vtkRenderer* GetRenderer() const { return this->Renderer; }
  const SliceAxes& GetAxes() const { return this->Axes; }

  /** Sets an image without direction: see SliceImage::GetPlain. */
  void SetImage(vtkImageData* plain, const SliceAxes& axes, vtkImageProperty* look);
  void Hide();
  /** Sets another image with the shown slice: see SliceImage::GetLayer. */
  void SetLayer(vtkImageData* layer);

  /**
   * Shows the slice of a continuous index, with the crosshair there. The lines have the colours of
   * the panels whose slices they are, in the order of the index axes.
   */
  void Show(
    const std::array<double, 3>& index, const std::array<std::array<unsigned char, 3>, 3>& colors);
  /** Sets the texts: the upper left one begins with the panel's name, in its colour. */
  void SetTexts(const std::string& title, const std::string& facts, const std::string& below);
  void SetColor(const std::array<unsigned char, 3>& color);

  /**
   * Fits the whole slice into the middle of the viewport, whatever its size. Cheap if nothing
   * changed.
   */
  void Fit();

  /**
   * The continuous index at a position in the window (pixels), in the shown slice; it may be
   * outside the image.
   */
  std::array<double, 3> FindIndex(int x, int y) const;
  bool Contains(int x, int y) const;

private:
  void PlaceCrosshair();
  void PlaceTexts(const int size[2]);

  SliceAxes Axes;
  std::array<double, 3> Index{};
  std::array<double, 3> Spacing{ { 1.0, 1.0, 1.0 } };
  std::array<std::array<unsigned char, 3>, 3> Colors{};
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkImageSlice> Slice;
  vtkNew<vtkImageSliceMapper> Mapper;
  vtkNew<vtkPolyData> Cross;
  vtkNew<vtkActor> CrossActor;
  vtkNew<vtkActor2D> Frame;
  vtkNew<vtkTextActor> Title;
  vtkNew<vtkTextActor> Facts;
  vtkNew<vtkTextActor> Below;
  std::array<vtkNew<vtkTextActor>, 4> Sides; ///< left, right, bottom, top
  std::array<int, 2> FittedSize{};
  bool IsFitted = false;
};

} // namespace VolumeHaptics

#endif

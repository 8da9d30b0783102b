// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws one slice of an image in a renderer of its own, with a crosshair and texts.
 */
#ifndef SlicePanel_h
#define SlicePanel_h

#include "VTK/Scene/Volumes/CarvedImage.h"

#include "vtkActor.h"
#include "vtkActor2D.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkTextActor.h"
#include "vtkType.h"

#include <array>
#include <string>

class vtkHapticDevice;
class vtkImageProperty;

namespace VolumeHaptics
{

/** An index axis of an image, forwards (1) or backwards (-1). */
struct SignedAxis
{
  int Axis = 0;
  int Sign = 1;
};

/** The layout of one slice on the screen. */
struct SliceAxes
{
  SignedAxis Through; ///< direction in which a step of the wheel moves the slice
  SignedAxis Right;   ///< direction that points to the right on the screen
  SignedAxis Up;
  const char* Name = "";                              ///< "Axial", or the name of an index, "k"
  std::array<const char*, 4> Sides{ "", "", "", "" }; ///< texts at the left, right, bottom and top
};

/**
 * Returns the slices along the index axes k, j and i of an image. If `anatomical`, the world's axes
 * point to a patient's left, back and head, and the result is the axial, coronal and sagittal slice
 * as radiologists look at them, each along the index axis nearest to the world's axis.
 */
std::array<SliceAxes, 3> ComputeSliceAxes(vtkImageData* image, bool anatomical);

/**
 * The image whose slices are shown. It is the data that a device feels now, unless the application
 * has chosen an image.
 */
class SliceImage
{
public:
  /**
   * Updates the image: the application's choice, or if it is null, the image of the device's
   * filter. If that is a moving volume, the image is the time step at the data time; if it is
   * larger than memory, the coarse level. Returns whether the samples or their geometry have
   * changed. Does not copy samples.
   */
  bool Update(vtkHapticDevice* device, vtkImageData* chosen);

  /**
   * Checks which tissue a tool of the device's filter has removed from the shown image. Returns
   * whether the removed tissue has changed.
   */
  bool PollRemoval(vtkHapticDevice* device);

  /** Returns whether there is an image to show. */
  bool HasSamples() const { return this->Samples != nullptr; }

  /**
   * Returns the image along its own axes: its index (0, 0, 0) is at the origin, and it has no
   * direction, because VTK 9.1's mappers of slices ignore directions. So each slice is a rectangle.
   */
  vtkImageData* GetPlain() const { return this->Plain; }

  /**
   * Returns an image that contains slice `number` perpendicular to an axis. It is the plain image,
   * or if tissue was removed, an image of that slice alone, with the remaining tissue.
   */
  vtkImageData* GetLayer(int axis, int number);

  /** See ComputeSliceAxes. */
  std::array<SliceAxes, 3> ComputeAxes(bool anatomical) const
  {
    return ComputeSliceAxes(this->Image, anatomical);
  }

  ///@{
  /**
   * Convert between positions in the world and continuous indices. Indices from ComputeIndex() and
   * Clamp() lie within the image.
   */
  std::array<double, 3> ComputeIndex(const double world[3]) const;
  void ComputeWorld(const std::array<double, 3>& index, double world[3]) const;
  ///@}
  std::array<double, 3> Clamp(std::array<double, 3> index) const;
  std::array<double, 3> GetCentre() const;

  /**
   * Returns the value of the nearest sample, after the removal of tissue. It is the chosen
   * component, or the magnitude of all components if UsesMagnitude() is true.
   */
  double GetValue(const std::array<double, 3>& index) const;
  /**
   * Returns the text in front of a value, "magnitude " or "component 1 of 3: "; empty for plain
   * scalars.
   */
  std::string DescribeComponents() const;
  bool UsesMagnitude() const { return this->IsMagnitude; }
  int GetComponent() const { return this->Component; }

  /**
   * Returns two values: 1 % of some samples lie below the first, 0.5 % above the second. Removed
   * tissue counts as if it was there.
   */
  std::array<double, 2> EstimateUsualValues() const;

private:
  /** A slice of the remaining tissue. */
  struct Layer
  {
    vtkSmartPointer<vtkImageData> Image;
    int Number = 0;
  };

  bool IsCarved() const { return this->Removed.Removal != nullptr; }
  void CopyLeftPart(const int part[6], vtkDataArray* left) const;
  double GetValueOf(vtkDataArray* samples, vtkIdType id) const;

  vtkSmartPointer<vtkImageData> Image; ///< the image, placed in the world
  vtkSmartPointer<vtkDataArray> Samples;
  vtkNew<vtkImageData> Plain;
  RemovedTissue Removed;
  CarvedCover Cover = CarvedCover::Nearest;
  std::array<Layer, 3> Layers; ///< one slice for each axis
  vtkMTimeType Time = 0;       ///< modification time of image and samples when they were fetched
  int Component = 0;
  bool IsMagnitude = false;
};

class SlicePanel
{
public:
  SlicePanel();

  vtkRenderer* GetRenderer() const { return this->Renderer; }
  const SliceAxes& GetAxes() const { return this->Axes; }

  /** Sets an image without direction: see SliceImage::GetPlain. */
  void SetImage(vtkImageData* plain, const SliceAxes& axes, vtkImageProperty* look);
  void Hide();
  /**
   * Replaces the shown image by one that contains the shown slice, such as SliceImage::GetLayer().
   */
  void SetLayer(vtkImageData* layer);

  /**
   * Shows the slice at a continuous index, with a crosshair there. Each line of the crosshair is
   * another panel's slice, and has that panel's colour. `colors` are in the order of the index
   * axes.
   */
  void Show(
    const std::array<double, 3>& index, const std::array<std::array<unsigned char, 3>, 3>& colors);
  /** Sets the texts. The upper left text begins with the panel's name, in the panel's colour. */
  void SetTexts(const std::string& title, const std::string& facts, const std::string& below);
  void SetColor(const std::array<unsigned char, 3>& color);

  /** Fits the whole slice into the middle of the viewport. Takes no time if nothing has changed. */
  void Fit();

  /**
   * Computes the continuous index at a position in the window (pixels), in the shown slice. The
   * index may be outside the image.
   */
  std::array<double, 3> ComputeIndex(int x, int y) const;
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

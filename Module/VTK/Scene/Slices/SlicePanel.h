// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws one slice of an image in its own renderer, with a crosshair and texts.
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

/** An index axis of an image, in ascending (1) or descending (-1) direction. */
struct SignedAxis
{
  int Axis = 0;
  int Sign = 1;
};

/** Layout of a slice on the screen. */
struct SliceAxes
{
  SignedAxis Through; ///< direction in which a wheel step moves the slice
  SignedAxis Right;   ///< direction that is to the right on the screen
  SignedAxis Up;
  const char* Name = "";                              ///< name of the slice, "Axial", or of its
                                                      ///< index, "k"
  std::array<const char*, 4> Sides{ "", "", "", "" }; ///< labels at the left, right, bottom and top
};

/**
 * Returns the layouts of the slices along an image's index axes k, j and i. If `anatomical`, the
 * world's axes point to a patient's left, back and head; the result is then the axial, coronal and
 * sagittal slice as radiologists view them, each along the index axis nearest to the world's axis.
 */
std::array<SliceAxes, 3> ComputeSliceAxes(vtkImageData* image, bool anatomical);

/**
 * The image whose slices are shown: the data that a device feels now, unless the application has
 * chosen an image.
 */
class SliceImage
{
public:
  /**
   * Updates the image: the application's choice, or, if that is null, the image of the device's
   * filter. For a moving volume, this is the time step at the data time; for a volume larger than
   * memory, the coarse level. Returns whether the samples or their geometry have changed. Does not
   * copy samples.
   */
  bool Update(vtkHapticDevice* device, vtkImageData* chosen);

  /**
   * Determines which tissue a tool of the device's filter has removed from the shown image. Returns
   * whether it has changed.
   */
  bool PollRemoval(vtkHapticDevice* device);

  /** Returns whether an image can be shown. */
  bool HasSamples() const { return this->Samples != nullptr; }

  /**
   * Returns the image without its placement: index (0, 0, 0) is at the origin, and there is no
   * direction matrix, because VTK 9.1's slice mappers ignore it. Each slice is thus a rectangle
   * along the axes.
   */
  vtkImageData* GetPlain() const { return this->Plain; }

  /**
   * Returns an image that contains slice `number` perpendicular to an axis: the plain image, or, if
   * tissue was removed, an image of this slice alone with the remaining tissue.
   */
  vtkImageData* GetLayer(int axis, int number);

  /** See the function ComputeSliceAxes(). */
  std::array<SliceAxes, 3> ComputeAxes(bool anatomical) const
  {
    return ComputeSliceAxes(this->Image, anatomical);
  }

  ///@{
  /**
   * Convert between positions in the world and continuous indices. ComputeIndex() and Clamp()
   * return indices within the image.
   */
  std::array<double, 3> ComputeIndex(const double world[3]) const;
  void ComputeWorld(const std::array<double, 3>& index, double world[3]) const;
  ///@}
  std::array<double, 3> Clamp(std::array<double, 3> index) const;
  std::array<double, 3> GetCentre() const;

  /**
   * Returns the value of the nearest sample, after removed tissue: of the chosen component, or the
   * magnitude of all components if UsesMagnitude().
   */
  double GetValue(const std::array<double, 3>& index) const;
  /**
   * Returns the prefix of a value, such as "magnitude " or "component 1 of 3: "; empty for a single
   * component.
   */
  std::string DescribeComponents() const;
  bool UsesMagnitude() const { return this->IsMagnitude; }
  int GetComponent() const { return this->Component; }

  /**
   * Returns a usual range: among a subset of the samples, 1 % are below the first value and 0.5 %
   * above the second. Includes removed tissue.
   */
  std::array<double, 2> EstimateUsualValues() const;

private:
  /** Image of one slice of the remaining tissue. */
  struct Layer
  {
    vtkSmartPointer<vtkImageData> Image;
    int Number = 0;
  };

  bool IsCarved() const { return this->Removed.Removal != nullptr; }
  void CopyLeftPart(const int part[6], vtkDataArray* left) const;
  double GetValueOf(vtkDataArray* samples, vtkIdType id) const;

  vtkSmartPointer<vtkImageData> Image; ///< image with its position in the world
  vtkSmartPointer<vtkDataArray> Samples;
  vtkNew<vtkImageData> Plain;
  RemovedTissue Removed;
  CarvedCover Cover = CarvedCover::Nearest;
  std::array<Layer, 3> Layers; ///< one per axis
  vtkMTimeType Time = 0;       ///< modification time of image and samples at the last update
  int Component = 0;
  bool IsMagnitude = false;
};

class SlicePanel
{
public:
  SlicePanel();

  vtkRenderer* GetRenderer() const { return this->Renderer; }
  const SliceAxes& GetAxes() const { return this->Axes; }

  /** Sets an image without direction matrix: see SliceImage::GetPlain. */
  void SetImage(vtkImageData* plain, const SliceAxes& axes, vtkImageProperty* look);
  void Hide();
  /**
   * Replaces the image with another one that contains the shown slice, such as
   * SliceImage::GetLayer().
   */
  void SetLayer(vtkImageData* layer);

  /**
   * Shows the slice at a continuous index, with a crosshair there. Each line of the crosshair marks
   * another panel's slice in that panel's colour. `colors` are in the order of the index axes.
   */
  void Show(
    const std::array<double, 3>& index, const std::array<std::array<unsigned char, 3>, 3>& colors);
  /** Sets the texts. The upper left text starts with the panel's name, in the panel's colour. */
  void SetTexts(const std::string& title, const std::string& facts, const std::string& below);
  void SetColor(const std::array<unsigned char, 3>& color);

  /** Fits the whole slice into the centre of the viewport. Fast if nothing has changed. */
  void Fit();

  /**
   * Computes the continuous index in the shown slice at a position in the window (pixels). The
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

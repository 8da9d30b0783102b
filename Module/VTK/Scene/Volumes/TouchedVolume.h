// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes a filter feel what a vtkVolume shows.
 */
#ifndef TouchedVolume_h
#define TouchedVolume_h

#include "VTK/Scene/Base/WindowVolumes.h"
#include "VTK/Scene/Volumes/CarvedPicture.h"
#include "VTK/Scene/Volumes/HapticShownTimeSteps.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkVolume.h"
#include "vtkWeakPointer.h"

#include <vector>

class vtkAbstractVolumeMapper;
class vtkAlgorithmOutput;
class vtkDataArray;
class vtkDataObject;
class vtkMatrix4x4;
class vtkUnsignedCharArray;
class vtkVolumeHapticsFilter;
class vtkVolumeMapper;
class vtkVolumeProperty;

namespace VolumeHaptics
{

/** An image, and the objects that determine how it is drawn. */
struct DrawnImage
{
  vtkAbstractVolumeMapper* Mapper;
  vtkVolumeProperty* Property;
  vtkImageData* Image;
  vtkDataArray* Array; ///< drawn array; null if there is none
  bool AreCells;       ///< whether the drawn array is a cell array
  int Component;
  bool IsIsosurface; ///< whether an isosurface is felt, which needs no flags
};

/**
 * Ghost flags of an image's points or cells with which mappers on the graphics card hide them. Any
 * flag hides: the shader of vtkOpenGLGPUVolumeRayCastMapper tests whether the flags are above 0.
 */
class MapperFlags
{
public:
  /**
   * Returns an array with the flag `hidden` wherever the image's own flags are not 0. Returns null
   * if nothing is hidden, or if the own flags are used (`isRead`) and already have `hidden` there.
   * The array stays the same until the own flags change.
   */
  vtkUnsignedCharArray* Get(vtkUnsignedCharArray* own, unsigned char hidden, bool isRead);

private:
  const void* Own = nullptr;
  vtkMTimeType Time = 0;
  vtkSmartPointer<vtkUnsignedCharArray> Flags;
};

class DrawnVoxels
{
public:
  /**
   * Returns flags for the image's points, or for its cells if a cell array is drawn. Hidden points
   * or cells have the flag vtkDataSetAttributes::HIDDENPOINT. Returns null if the image's own flags
   * are sufficient. The array stays the same until anything changes.
   */
  vtkUnsignedCharArray* Get(const DrawnImage& drawn);
  /**
   * Returns flags for the image's cells if points are drawn. Hidden cells have the flag
   * vtkDataSetAttributes::HIDDENCELL. Returns null if the image's own flags are sufficient.
   */
  vtkUnsignedCharArray* GetCells(const DrawnImage& drawn);
  /**
   * Returns whether the flags alone decide what is felt, so that the property's scalar opacity is
   * not needed.
   */
  bool ReplacesOpacity() const { return this->HasOpacity; }

private:
  struct Source
  {
    const void* Mask = nullptr;
    const void* Array = nullptr;
    const void* Own = nullptr;
    vtkMTimeType Time = 0;
    int Kind = 0;
    int Component = 0;
    bool operator==(const Source& other) const;
  };
  void Fill(const DrawnImage& drawn, vtkImageData* mask, vtkUnsignedCharArray* own);

  Source From;
  bool HasOpacity = false;
  vtkSmartPointer<vtkUnsignedCharArray> Flags;
  MapperFlags Points;
  MapperFlags Cells;
};

/** Returns the mask with which a mapper hides voxels; null if it has none. */
vtkImageData* GetBinaryMask(vtkAbstractVolumeMapper* mapper);

/** Returns the mask whose labels have their own opacities; null if there is none. */
vtkImageData* GetOpacityMask(vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property);

/** Returns whether a mask has as many voxels along each axis as an image, wherever it is. */
bool IsMaskOf(vtkImageData* mask, vtkImageData* image);

/**
 * Returns whether a mapper hides points and cells with ghost flags. Since VTK 9.2, a mapper that
 * draws cell data hides only cells.
 */
bool HidesBlanked(vtkAbstractVolumeMapper* mapper, bool areCells);

class TouchedVolume
{
public:
  TouchedVolume();
  ~TouchedVolume();

  /** Sets the volume to follow; null follows none and leaves the filter unchanged. */
  void Set(vtkVolume* volume) { this->Volume = volume; }
  vtkVolume* Get() const { return this->Volume; }

  /**
   * Looks for this volume among the drawn volumes, to find its position and mapper. Returns false
   * if it is not among them; its own matrix then determines its position.
   */
  bool FindPlace(const std::vector<DrawnVolume>& drawn);
  /** Returns whether FindPlace() has found a mapper with data. */
  bool HasData() const { return this->Drawn.GetData() != nullptr; }

  /**
   * Passes changes of the volume to the filter: its data with their position; the drawn array and
   * component; opacity, cropping and clipping planes; and hidden voxels. Ignores the time steps of
   * a moving volume that the mapper shows instead of its own input. Uses the original image instead
   * of a copy with the remaining tissue. Data other than images keep their position.
   */
  void Update(vtkVolumeHapticsFilter* filter, const HapticShownTimeSteps& pictures,
    const CarvedPictures& carved);

private:
  /** Returns the drawing mapper's input, as the application set it; null if there is none. */
  vtkAlgorithmOutput* GetGivenInput(const CarvedPictures& carved) const;
  void Place(vtkAlgorithmOutput* input, vtkImageData* shown, vtkVolumeHapticsFilter* filter);
  /** Selects the array that the mapper draws, and a component that is drawn, in the filter. */
  void ChooseArray(vtkDataObject* data, vtkVolumeHapticsFilter* filter);
  int ChooseComponent(vtkDataArray* array, vtkVolumeHapticsFilter* filter) const;
  /**
   * Copies the image for the filter. `flags` replaces the ghost flags of its points, and `cells`
   * those of its cells; either may be null. If `areCells`, the copy has a point at each cell's
   * centre, with the cell arrays as point arrays.
   */
  void CopyImage(
    vtkImageData* shown, bool areCells, vtkUnsignedCharArray* flags, vtkUnsignedCharArray* cells);
  void Crop(vtkImageData* shown, vtkVolumeHapticsFilter* filter);

  vtkSmartPointer<vtkVolume> Volume;
  DrawnVolume Drawn;
  vtkNew<vtkImageData> Placed; ///< the image, placed as the volume's matrix requires
  vtkMTimeType PlacedTime = 0; ///< modification time of the image when it was placed
  bool ArePlacedCells = false;
  vtkSmartPointer<vtkUnsignedCharArray> PlacedFlags;
  vtkSmartPointer<vtkUnsignedCharArray> PlacedCells;
  DrawnVoxels Voxels;
};

/**
 * Computes the placement of an image by a matrix: origin, spacing and direction of `placed`.
 * Returns false if the matrix shears the voxels, so that they are no longer boxes.
 */
bool PlaceImage(vtkMatrix4x4* matrix, vtkImageData* image, vtkImageData* placed);

/**
 * Returns the array that a mapper draws of its data; null if there is none. For composite data,
 * this is the array of the first block. Sets `areCells` to whether it is a cell array.
 */
vtkDataArray* GetDrawnArray(vtkAbstractVolumeMapper* mapper, vtkDataObject* data, bool& areCells);

/** Returns whether a filter touches an isosurface, the one at its IsoValue. */
bool TouchesIsosurface(vtkVolumeHapticsFilter* filter);

/**
 * Returns whether a filter feels this array, or the array that this one was copied from for
 * display.
 */
bool FeelsArray(vtkVolumeHapticsFilter* filter, vtkDataArray* array);

/** Returns whether a component of an array has any opacity at any value. */
bool IsComponentDrawn(vtkVolumeProperty* property, vtkDataArray* array, int component);

/** Returns a component of an array that a mapper draws with opacity, preferably the wanted one. */
int ChooseDrawnComponent(
  vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property, vtkDataArray* array, int wanted);

/**
 * Converts a mapper's cropping planes to the axes of another image of the same shape, or of the
 * image of its cells' centres.
 */
void MapCropping(
  vtkVolumeMapper* mapper, vtkImageData* shown, vtkImageData* felt, double planes[6]);

} // namespace VolumeHaptics

#endif

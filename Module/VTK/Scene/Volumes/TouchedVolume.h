// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lets a filter feel what a vtkVolume shows.
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

/** An image, and the objects that decide what it shows. */
struct DrawnImage
{
  vtkAbstractVolumeMapper* Mapper;
  vtkVolumeProperty* Property;
  vtkImageData* Image;
  vtkDataArray* Array; ///< the drawn array; null if there is none
  bool AreCells;       ///< whether the drawn array belongs to the cells
  int Component;
  bool IsIsosurface; ///< whether an isosurface is felt, so that it needs no flags
};

class DrawnVoxels
{
public:
  /**
   * Returns flags of the image's points, or of its cells if these are drawn. Hidden points or cells
   * have the flag vtkDataSetAttributes::HIDDENPOINT. Null if the image's own flags are enough. The
   * array stays the same until something changes.
   */
  vtkUnsignedCharArray* Get(const DrawnImage& drawn);
  /** Whether the flags decide alone, without the property's scalar opacity. */
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
  /** Computes the flags of the image's cells. */
  vtkUnsignedCharArray* ComputeCells(const DrawnImage& drawn);
  void Fill(const DrawnImage& drawn, vtkImageData* mask, vtkUnsignedCharArray* own);

  Source From;
  bool HasOpacity = false;
  vtkSmartPointer<vtkUnsignedCharArray> Flags;
};

/** Returns the mask by which a mapper hides voxels; null if it has none. */
vtkImageData* GetBinaryMask(vtkAbstractVolumeMapper* mapper);

/** Returns the mask whose labels have opacities of their own; null if there is none. */
vtkImageData* GetOpacityMask(vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property);

/**
 * Whether a mask fits an image: it has one voxel for each voxel of the image, wherever it is
 * placed.
 */
bool IsMaskOf(vtkImageData* mask, vtkImageData* image);

/**
 * Whether a mapper hides blanked points and cells. Since VTK 9.2, a mapper that draws cell data
 * hides only blanked cells.
 */
bool HidesBlanked(vtkAbstractVolumeMapper* mapper, bool areCells);

class TouchedVolume
{
public:
  TouchedVolume();
  ~TouchedVolume();

  /** Follows a volume from now on; null follows none, and leaves the filter unchanged. */
  void Set(vtkVolume* volume) { this->Volume = volume; }
  vtkVolume* Get() const { return this->Volume; }

  /**
   * Searches the drawn volumes for this volume: they tell its place and its mapper. False if it is
   * not among them; its own matrix then gives its place.
   */
  bool FindPlace(const std::vector<DrawnVolume>& drawn);
  /** Whether FindPlace() has found data that a mapper shows. */
  bool HasData() const { return this->Drawn.GetData() != nullptr; }

  /**
   * Passes to the filter what has changed of: the volume's data at their place; the array and the
   * component that are drawn; opacity, cropping and clipping planes; and the hidden voxels. Images
   * of a moving volume, which the mapper shows instead of its own input, are ignored. A copy that
   * shows what a tool has left of the image stands for the image. Data that are no image keep their
   * place.
   */
  void Update(vtkVolumeHapticsFilter* filter, const HapticShownTimeSteps& pictures,
    const CarvedPictures& carved);

private:
  /** Returns the drawing mapper's input, as the application set it; null if there is none. */
  vtkAlgorithmOutput* GetGivenInput(const CarvedPictures& carved) const;
  void Place(vtkAlgorithmOutput* input, vtkImageData* shown, vtkVolumeHapticsFilter* filter);
  /**
   * Makes the filter touch the array that the mapper draws, and the drawn one of its components.
   */
  void ChooseArray(vtkDataObject* data, vtkVolumeHapticsFilter* filter);
  int ChooseComponent(vtkDataArray* array, vtkVolumeHapticsFilter* filter) const;
  /**
   * Copies the image. If `flags` are given, they replace those of its points. If `areCells`, the
   * copy is an image of the cells' centres, with the cell arrays as point arrays.
   */
  void CopyImage(vtkImageData* shown, bool areCells, vtkUnsignedCharArray* flags);
  void Crop(vtkImageData* shown, vtkVolumeHapticsFilter* filter);

  vtkSmartPointer<vtkVolume> Volume;
  DrawnVolume Drawn;
  vtkNew<vtkImageData> Placed; ///< the image where the volume's matrix puts it
  vtkMTimeType PlacedTime = 0; ///< the image's change time when it was placed
  bool ArePlacedCells = false;
  vtkSmartPointer<vtkUnsignedCharArray> PlacedFlags;
  DrawnVoxels Voxels;
};

/**
 * Writes the place of an image under a matrix to another image: origin, spacing and direction.
 * False if the matrix shears the voxels, so that they are no boxes.
 */
bool PlaceImage(vtkMatrix4x4* matrix, vtkImageData* image, vtkImageData* placed);

/**
 * Returns the array of its data that a mapper shows (of composite data, the array of the first
 * block); null if there is none.
 */
vtkDataArray* GetDrawnArray(vtkAbstractVolumeMapper* mapper, vtkDataObject* data, bool& areCells);

/** Whether a filter touches an isosurface, at its IsoValue. */
bool TouchesIsosurface(vtkVolumeHapticsFilter* filter);

/** Whether a filter feels an array of its image, or one that the array stands for. */
bool FeelsArray(vtkVolumeHapticsFilter* filter, vtkDataArray* array);

/** Whether a component of an array has opacity somewhere. */
bool IsComponentDrawn(vtkVolumeProperty* property, vtkDataArray* array, int component);

/**
 * Returns the component of an array that a mapper draws with opacity; if there are several, the
 * wanted one if it is among them.
 */
int ChooseDrawnComponent(
  vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property, vtkDataArray* array, int wanted);

/**
 * Copies the planes of a mapper's regions to the axes of another image of the same shape, or of the
 * image of its cells' centres.
 */
void MapCropping(
  vtkVolumeMapper* mapper, vtkImageData* shown, vtkImageData* felt, double planes[6]);

} // namespace VolumeHaptics

#endif

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
  bool AreCells;       ///< whether it is an array of cells
  int Component;
  bool IsIsosurface; ///< whether an isosurface is felt, so that it needs no flags
};

class DrawnVoxels
{
public:
  /**
   * Flags of the image's points, or of its cells if these are drawn. Hidden ones have the flag
   * vtkDataSetAttributes::HIDDENPOINT. Null if the image's own flags are enough. The array stays
   * the same until something changes.
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
  /** Flags of the image's cells, likewise. */
  vtkUnsignedCharArray* ComputeCells(const DrawnImage& drawn);
  void Fill(const DrawnImage& drawn, vtkImageData* mask, vtkUnsignedCharArray* own);

  Source From;
  bool HasOpacity = false;
  vtkSmartPointer<vtkUnsignedCharArray> Flags;
};

/** The mask by which a mapper hides voxels; null if it has none. */
vtkImageData* GetBinaryMask(vtkAbstractVolumeMapper* mapper);

/** The mask whose labels have opacities of their own; null if there is none. */
vtkImageData* GetOpacityMask(vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property);

/** Whether a mask fits an image: it has a voxel for each of the image's, whatever its own place. */
bool IsMaskOf(vtkImageData* mask, vtkImageData* image);

/**
 * Whether a mapper hides blanked points and cells. If it draws cell data, it hides only blanked
 * cells, since VTK 9.2.
 */
bool HidesBlanked(vtkAbstractVolumeMapper* mapper, bool areCells);

class TouchedVolume
{
public:
  TouchedVolume();
  ~TouchedVolume();

  /** The volume that is followed from now on; null for none, which leaves the filter as it is. */
  void Set(vtkVolume* volume) { this->Volume = volume; }
  vtkVolume* Get() const { return this->Volume; }

  /**
   * Looks for the volume among those that are drawn, which say where it is and what shows it; false
   * if it is none of them. Then it is where its own matrix puts it.
   */
  bool FindPlace(const std::vector<DrawnVolume>& drawn);
  /** Whether FindPlace() has found data that a mapper shows. */
  bool HasData() const { return this->Drawn.GetData() != nullptr; }

  /**
   * Gives the filter the volume's data at their place, the array and the component that are drawn,
   * its opacity, its cropping, its clipping planes and the voxels that are hidden, as far as they
   * have changed. Images of a moving volume, which the mapper shows in the place of its own input,
   * are left alone. A copy that shows what a tool has left of the image stands for the image. Data
   * that are no image stay where they are.
   */
  void Update(vtkVolumeHapticsFilter* filter, const HapticShownTimeSteps& pictures,
    const CarvedPictures& carved);

private:
  /** Returns the drawing mapper's input, as the application set it; null if there is none. */
  vtkAlgorithmOutput* GetGivenInput(const CarvedPictures& carved) const;
  void Place(vtkAlgorithmOutput* input, vtkImageData* shown, vtkVolumeHapticsFilter* filter);
  /** Touches the array, and of its components the one, that the mapper draws. */
  void ChooseArray(vtkDataObject* data, vtkVolumeHapticsFilter* filter);
  int ChooseComponent(vtkDataArray* array, vtkVolumeHapticsFilter* filter) const;
  /**
   * The image, with these flags of its points instead of its own, if there are any; or with its
   * cell arrays as point arrays of an image of the cells' centres.
   */
  void CopyImage(vtkImageData* shown, bool areCells, vtkUnsignedCharArray* flags);
  void Crop(vtkImageData* shown, vtkVolumeHapticsFilter* filter);

  vtkSmartPointer<vtkVolume> Volume;
  DrawnVolume Drawn;
  vtkNew<vtkImageData> Placed; ///< the image where the volume's matrix puts it
  vtkMTimeType PlacedTime = 0; ///< of the image, when that was placed
  bool ArePlacedCells = false;
  vtkSmartPointer<vtkUnsignedCharArray> PlacedFlags;
  DrawnVoxels Voxels;
};

/**
 * The world position of an image under a matrix, written to another image: origin, spacing and
 * direction. False if voxels are no boxes there, because the matrix shears them.
 */
bool PlaceImage(vtkMatrix4x4* matrix, vtkImageData* image, vtkImageData* placed);

/**
 * The array that a mapper shows of its data, of composite ones that of the first block; null if
 * there is none.
 */
vtkDataArray* GetDrawnArray(vtkAbstractVolumeMapper* mapper, vtkDataObject* data, bool& areCells);

/** Whether what a filter touches is an isosurface at its IsoValue. */
bool TouchesIsosurface(vtkVolumeHapticsFilter* filter);

/** Whether a filter feels an array of its image, or one that the array stands for. */
bool FeelsArray(vtkVolumeHapticsFilter* filter, vtkDataArray* array);

/** Whether a component of an array has opacity somewhere. */
bool IsComponentDrawn(vtkVolumeProperty* property, vtkDataArray* array, int component);

/**
 * The component of an array that a mapper draws, where it has opacity: the wanted one, if it is
 * among them.
 */
int ChooseDrawnComponent(
  vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property, vtkDataArray* array, int wanted);

/**
 * The planes of a mapper's regions, along the axes of the data of another image of its shape, or of
 * the centres of its cells.
 */
void MapCropping(
  vtkVolumeMapper* mapper, vtkImageData* shown, vtkImageData* felt, double planes[6]);

} // namespace VolumeHaptics

#endif

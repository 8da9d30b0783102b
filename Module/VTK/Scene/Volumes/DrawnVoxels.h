// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The voxels of an image that a volume mapper hides one by one: by a mask, by an opacity for each
 * label of a mask, by isosurfaces, or because they are blanked.
 */
#ifndef DrawnVoxels_h
#define DrawnVoxels_h

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

class vtkAbstractVolumeMapper;
class vtkDataArray;
class vtkImageData;
class vtkUnsignedCharArray;
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
  vtkUnsignedCharArray* Find(const DrawnImage& drawn);
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
  vtkUnsignedCharArray* FindCells(const DrawnImage& drawn);
  void Fill(const DrawnImage& drawn, vtkImageData* mask, vtkUnsignedCharArray* own);

  Source From;
  bool HasOpacity = false;
  vtkSmartPointer<vtkUnsignedCharArray> Flags;
};

/** The mask by which a mapper hides voxels; null if it has none. */
vtkImageData* FindBinaryMask(vtkAbstractVolumeMapper* mapper);

/** The mask whose labels have opacities of their own; null if there is none. */
vtkImageData* FindOpacityMask(vtkAbstractVolumeMapper* mapper, vtkVolumeProperty* property);

/** Whether a mask fits an image: it has a voxel for each of the image's, whatever its own place. */
bool IsMaskOf(vtkImageData* mask, vtkImageData* image);

/**
 * Whether a mapper hides blanked points and cells. If it draws cell data, it hides only blanked
 * cells, since VTK 9.2.
 */
bool HidesBlanked(vtkAbstractVolumeMapper* mapper, bool areCells);

} // namespace VolumeHaptics

#endif

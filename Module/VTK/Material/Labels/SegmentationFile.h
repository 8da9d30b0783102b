// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a segmentation of 3D Slicer or VolView (.seg.nrrd), overlapping segments included, or any
 * other label map in a NRRD file.
 */
#ifndef SegmentationFile_h
#define SegmentationFile_h

#include "vtkVolumeHapticsModule.h" // for export macro

#include <string>

class vtkHapticLabelTable;
class vtkImageData;

namespace VolumeHaptics
{

/**
 * Reads one label (int) a voxel into an image, and the names and colours of the labels into a
 * table, whose other contents stay. Overlapping segments are in layers, which vtkNrrdReader does
 * not read: where segments overlap, the last of them in the file counts, as in 3D Slicer. Labels
 * are the values of the file; if two segments of different layers share a value, segment N has the
 * label N + 1 (see vtkHapticLabelTable::ReadFile). Origin, spacing and direction are those of the
 * file, converted to left-posterior-superior.
 *
 * If `segment` is not 0, only the segment with this number is read, from 1 on in the order of the
 * labels: the image has no other label, and all voxels of this one. The table has all segments.
 *
 * Returns an error that names the file and the cure, with an empty image; empty on success.
 */
VTKVOLUMEHAPTICS_EXPORT std::string ReadSegmentation(
  const std::string& fileName, vtkImageData* image, vtkHapticLabelTable* table, int segment = 0);

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a segmentation of 3D Slicer or VolView (.seg.nrrd), including overlapping segments, or any
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
 * Reads one label (int) per voxel into an image, and adds the names and colours of the labels to a
 * table. Overlapping segments are stored in layers, which vtkNrrdReader does not support: where
 * segments overlap, the last one in the file counts, as in 3D Slicer. The labels are the values in
 * the file. If two segments of different layers share a value, segment N has the label N + 1
 * instead (see vtkHapticLabelTable::ReadFile). Origin, spacing and direction are those of the file,
 * converted to left-posterior-superior.
 *
 * If `segment` is not 0, reads only the segment with this number, counted from 1 in the order of
 * the labels: the image then has this label in all voxels of the segment, and no other label. The
 * table gets all segments.
 *
 * Returns an error that names the file and the cure, with an empty image; an empty text on success.
 */
VTKVOLUMEHAPTICS_EXPORT std::string ReadSegmentation(
  const std::string& fileName, vtkImageData* image, vtkHapticLabelTable* table, int segment = 0);

} // namespace VolumeHaptics

#endif

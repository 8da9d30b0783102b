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
 * table, which keeps what else it has. Overlapping segments are in layers, which vtkNrrdReader
 * does not read: where segments overlap, the last of them in the file counts, as in 3D Slicer.
 * Labels are the values of the file; if two segments of different layers share a value, segment N
 * has the label N + 1 (see vtkHapticLabelTable::ReadFile). Origin, spacing and direction are those
 * of the file, converted to left-posterior-superior.
 *
 * Returns an error that names the file and the cure, with an empty image; empty on success.
 */
VTKVOLUMEHAPTICS_EXPORT std::string ReadSegmentation(
  const std::string& fileName, vtkImageData* image, vtkHapticLabelTable* table);

} // namespace VolumeHaptics

#endif

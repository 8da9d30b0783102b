// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_VolumeLoader_h
#define Explore_VolumeLoader_h

#include "VTK/Reading/VolumeOrientation.h"

#include "vtkHapticLabelTable.h"
#include "vtkHapticRegionSource.h"
#include "vtkHapticTimeStepSource.h"
#include "vtkImageData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <string>
#include <vector>

namespace Explore
{
/// A volume ready to be touched: one finite scalar component, at least two voxels along every axis,
/// lengths in millimetres if the file states a unit of length, and index axes within 45 degrees of
/// the world's. Its vectors and tensors are further point arrays. World axes of medical formats
/// follow DICOM: +x to the patient's left, +y to the back, +z to the head.
struct Volume
{
  vtkSmartPointer<vtkImageData> Image;
  std::string Name;               // last part of the path, for the window's title and messages
  std::string Format;             // such as "NIfTI"
  std::vector<std::string> Notes; // assumptions and changes made while reading
  // A segmentation with the geometry of its own file; null if there is none.
  vtkSmartPointer<vtkImageData> Labels;
  vtkSmartPointer<vtkHapticLabelTable> LabelTable;
  // For a moving volume: all time steps, with times in seconds; Image is the first one.
  vtkSmartPointer<vtkHapticTimeStepSource> TimeSteps = nullptr;
  // Name of the array with the displacement to the next time step; empty if there is none.
  std::string Displacements = {};
  // Source of a volume that is read region by region; Image is then a coarse level.
  vtkSmartPointer<vtkHapticRegionSource> Large = nullptr;
  WorldAxes Axes = WorldAxes::Unknown;
  double MetersPerUnit = 0.001; // for lengths in the unit of Image
  // Later phases of a moving DICOM series, with their times (s): see LoadVolumes.
  struct Phase
  {
    double Time;
    vtkSmartPointer<vtkImageData> Image;
  };
  std::vector<Phase> Phases = {};
  double Shift = 0.0;        // number added to the values to convert them to Hounsfield units
  std::string Modality = {}; // DICOM modality, such as "CT"; empty if unknown
  bool HasPlace = true;      // whether the file states the position of the volume
  bool IsGrid = false;       // whether the volume was resampled from a grid
  bool IsField = false; // whether values come from a grid or are the magnitude of a field, so that
                        // they stand for no tissue
  vtkSmartPointer<vtkPolyData> Outline = nullptr; // lines along the edges of a grid; null for other
                                                  // volumes
  // Choices in the file, each with its number from 1: the series of a DICOM folder, such as `1
  // "Thorax", CT, 133 slices of 512 x 512`, the segments of a segmentation, or the volumes of a
  // file with more than three axes. SeriesNumber is the choice that was read.
  std::vector<std::string> Series = {};
  int SeriesNumber = 0;
  bool MayBeLabels = false; // whether the values look like labels
  bool AreLabels = false;   // whether the values are used as labels
  std::string Flow = {};    // vector array that the hand follows by default; empty if there is none
  std::string Padding = {}; // describes which values count as outside; empty if none do
};

/// Reads a file or folder like LoadVolume, but keeps the positions and values of the voxels, with
/// axes in any direction. 64-bit integers that fit into 32 bits are stored in a smaller type. If
/// timesAreComponents, the times of a NIfTI file become components; otherwise the first time is
/// read. For `series`, see vtkHapticVolumeReader::SetSeries().
Volume ReadVolume(const std::string& path, bool timesAreComponents = false, int series = 0);

/// Number and spacing of the volumes along the fourth axis of a NIfTI file.
struct NiftiTimes
{
  int Count = 1;
  double Spacing = 0.0; // s; 0 for a single volume
};

/// Reads the number and the spacing of the volumes from a file's header. `unknown` is returned as
/// the spacing if the header does not state it. A file of any other format has one volume.
NiftiTimes ReadNiftiTimes(const std::string& path, double unknown);

/// Aligns the image with the axes of the world, after straightening it if its axes are sheared,
/// with a note.
void AlignVolume(Volume& volume);

/// Reads a volume from a file or folder of any format that vtkHapticVolumeReader supports. If an
/// array is named, its values or the magnitude of its vectors are shown and felt. If the volume
/// can't be read or touched, throws InputError, with the fault and the cure.
Volume LoadVolume(const std::string& path, int series = 0, const std::string& array = "");

/// Reads all samples of a volume that can be read in boxes. Returns null on failure, with the
/// reason in `error`.
vtkSmartPointer<vtkImageData> ReadWhole(vtkHapticRegionSource* source, std::string& error);

/// Adds the notes on assumptions that the source made when it opened its file, and the list of
/// choices in the file.
void AddFileNotes(vtkHapticRegionSource* source, Volume& volume);

/// Reads a NRRD file of labels, which may have segments in layers. If it has segments, `series`
/// chooses one of them.
Volume ReadNrrdSegmentation(const std::string& path, int series = 0);

/// Lists the segments in a segmentation's table for the user to choose from. `chosen` is the number
/// of the segment that was read; 0 means all.
void ListSegments(Volume& volume, int chosen);
} // namespace Explore

#endif

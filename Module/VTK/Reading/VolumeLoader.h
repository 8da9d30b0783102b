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
/// lengths in millimetres if the file has a unit of length, and index axes within 45 degrees of the
/// world's. Its vectors and tensors are further point arrays. World axes of medical formats are the
/// DICOM ones: +x to the patient's left, +y to the back, +z to the head.
struct Volume
{
  vtkSmartPointer<vtkImageData> Image;
  std::string Name;               // last part of the path
  std::string Format;             // such as "NIfTI"
  std::vector<std::string> Notes; // assumptions and changes while loading
  // A segmentation, if there is one, with the geometry of its file.
  vtkSmartPointer<vtkImageData> Labels;
  vtkSmartPointer<vtkHapticLabelTable> LabelTable;
  // If the volume moves: all time steps, with times in seconds; Image is the first one.
  vtkSmartPointer<vtkHapticTimeStepSource> TimeSteps = nullptr;
  // name of the array with the motion of each time step's material; empty if there is none
  std::string Displacements = {};
  // If the volume is read only around the hand: its source. Image is a coarse level of it.
  vtkSmartPointer<vtkHapticRegionSource> Large = nullptr;
  WorldAxes Axes = WorldAxes::Unknown;
  double MetersPerUnit = 0.001; // for lengths in the world of the file
  // The later phases of a DICOM series that moves, with their times (s): see LoadVolumes.
  struct Phase
  {
    double Time;
    vtkSmartPointer<vtkImageData> Image;
  };
  std::vector<Phase> Phases = {};
  double Shift = 0.0;        // was added to the values, so that they are Hounsfield units
  std::string Modality = {}; // DICOM's modality, such as "CT"; empty if not known
  bool HasPlace = true;      // whether the file defines the position of the volume
  bool IsGrid = false;       // whether the volume was resampled from cells
  bool IsField = false; // values come from a grid or are the magnitude of a field, of no tissue
  vtkSmartPointer<vtkPolyData> Outline = nullptr; // where the cells of a grid are
  // The choices in the file: the series of a DICOM folder, as
  // `1 "Thorax", CT, 133 slices of 512 x 512`, the segments of a segmentation, or the volumes of a
  // file with more than three axes. Each begins with its number, from 1 on. SeriesNumber is the
  // number of the choice that was read.
  std::vector<std::string> Series = {};
  int SeriesNumber = 0;
  bool MayBeLabels = false; // whether the values look like label numbers
  bool AreLabels = false;   // whether its values are used as labels
  std::string Flow = {};    // name of the vectors of a grid, which the hand follows by default
  std::string Padding = {}; // describes the values that count as outside; empty if none does
};

/// Reads a file or a folder like LoadVolume, but keeps the positions and values of the voxels: axes
/// may have any direction. 64-bit integers that fit into 32 bits are stored in a smaller type. If
/// timesAreComponents, the times of a NIfTI file become components; otherwise the first time is
/// read. For `series`, see vtkHapticVolumeReader::SetSeries().
Volume ReadVolume(const std::string& path, bool timesAreComponents = false, int series = 0);

/// The volumes along the fourth axis of a NIfTI file.
struct NiftiTimes
{
  int Count = 1;
  double Spacing = 0.0; // s; 0 if there is one volume
};

/// Reads the number and the spacing of the volumes from a file's header. `unknown` is the spacing
/// if the header does not define it. A file of any other format has one volume.
NiftiTimes ReadNiftiTimes(const std::string& path, double unknown);

/// Aligns the image with the axes of the world. Straightens it first if its axes are sheared, with
/// a note.
void AlignVolume(Volume& volume);

/// Reads a volume from a file or a folder of any format that vtkHapticVolumeReader reads. If an
/// array is named, its values, or the magnitude of its vectors, are shown and felt. If the volume
/// can't be read or touched, throws InputError, with the fault and the cure.
Volume LoadVolume(const std::string& path, int series = 0, const std::string& array = "");

/// Reads all samples of a volume that can be read in boxes. Returns null, with the reason in
/// `error`, on failure.
vtkSmartPointer<vtkImageData> ReadWhole(vtkHapticRegionSource* source, std::string& error);

/// Adds notes on the assumptions that the source made when it opened its file, and the list of
/// choices in the file.
void AddFileNotes(vtkHapticRegionSource* source, Volume& volume);

/// Reads a NRRD file of labels, which may have segments in layers. If it has segments, they can be
/// chosen from.
Volume ReadNrrdSegmentation(const std::string& path, int series = 0);

/// Lists the segments of a segmentation, whose table has their names, for the user to choose from.
/// `chosen` is the number of the segment that was read alone; 0 means all.
void ListSegments(Volume& volume, int chosen);
} // namespace Explore

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_Options_h
#define Explore_Options_h

#include "Applications/Explorer/Exploration/Exploration.h"
#include "Applications/Explorer/Live/TouchScene.h"
#include "Applications/Explorer/Scene/ExplorerScene.h"

#include <string>
#include <vector>

namespace Explore
{
struct Options
{
  bool Help = false;
  bool CheckDisplay = false; // only test the display
  bool Live = false;         // also tick in real time, with the servo loop
  bool Inspect = false;      // only describe what the file contains
  bool Json = false;         // write this description as JSON, for programs
  bool Large = false;        // always read the volume only around the hand, whatever its size
  std::string VolumePath;
  int Series = 0;                     // see vtkHapticVolumeReader::SetSeries()
  std::string Array;                  // name of the array to show and feel
  std::vector<std::string> MorePaths; // further time steps of a moving volume
  std::string Displacements;          // name of the array with the displacements of its material
  bool AsLabels = false;              // whether the values of the volume are labels
  std::string Notice;                 // notice of the window at the beginning
  bool BringBack = false;             // whether to restore the unsaved work of the last window
  std::string Labels;                 // file of a label image
  std::vector<std::string> Materials; // files of label tables
  std::string Folder = "explore-pictures";
  bool Pictures = false;       // write pictures even if there is a display
  DeviceChoice Device;         // devices of the window
  bool HasDevice = false;      // whether a device was named
  std::string Setup;           // file of the window's functions, settings and camera
  std::string Measurements;    // file of the window's measurements
  std::string Script;          // file of the window's demonstration script
  std::string Movie;           // file of the window's movie, which lasts until the window closes
  std::string Replay;          // file of a recording to show in the window
  std::string Stereo;          // stereo mode of the window
  bool Slices = false;         // show slices in the window
  CutKind Cut = CutKind::None; // cut of the volume in the window
  bool Sound = false;          // play sound in the window
  std::string Tool;            // tool in the window: "needle", "burr", a file, or empty for a point
  std::string SoundFile;       // file for the sound along the path; empty: none
  std::string WrittenVolume;   // file for the volume; if it is given, the volume is only converted
  Settings How;
  MapperChoice Mapper = MapperChoice::Auto;
  int Width = 900;
  WindowPlace Place; // place of the last volume's window; a new window has Width
};

/// Throws InputError for an unknown option or a wrong value.
Options ParseOptions(int argc, char* argv[]);

/// Replaces the settings of vtkHapticVolumeReader that a text names, such as "Series = 2", by the
/// options of this program.
std::string NameOptions(const std::string& text);
} // namespace Explore

#endif

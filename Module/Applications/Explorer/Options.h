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
  bool CheckDisplay = false; // whether to test only the display
  bool Live = false;         // whether to run the path in real time, too, with the servo loop
  bool Inspect = false;      // whether to describe only the file's contents
  bool Json = false;         // whether to write this description as JSON, for programs
  bool Large = false;        // whether to read the volume only around the hand, whatever its size
  std::string VolumePath;
  int Series = 0;                     // see vtkHapticVolumeReader::SetSeries()
  std::string Array;                  // name of the array that is shown and felt
  std::vector<std::string> MorePaths; // files of further time steps of a moving volume
  std::string Displacements;          // name of the array with the displacements of the material
  bool AsLabels = false;              // whether the values of the volume are labels
  std::string Notice;                 // notice shown when the window opens
  bool BringBack = false;             // whether to restore the unsaved work of the last window
  std::string Labels;                 // file of a label image
  std::vector<std::string> Materials; // files of label tables
  std::string Folder = "explore-pictures";
  bool Pictures = false;       // whether to write pictures even if there is a display
  DeviceChoice Device;         // devices of the window
  bool HasDevice = false;      // whether the user named a device
  std::string Setup;           // file of the window's functions, settings and camera
  std::string Measurements;    // file of the window's measurements
  std::string Script;          // file of the window's demonstration script
  std::string Movie;           // file of the window's movie, which runs until the window closes
  std::string Replay;          // file of a recording to show in the window
  std::string Stereo;          // stereo mode of the window
  bool Slices = false;         // whether to show slices in the window
  CutKind Cut = CutKind::None; // cut of the volume in the window
  bool Sound = false;          // whether to play sound in the window
  std::string Tool;            // tool in the window: "needle", "burr", a file, or empty for a point
  std::string SoundFile;       // file for the sound along the path; empty: none
  std::string WrittenVolume;   // file for the volume; if set, the program only converts the volume
  Settings How;
  MapperChoice Mapper = MapperChoice::Auto;
  int Width = 900;
  WindowPlace Place; // place of the last volume's window; a new window uses Width
};

/// Throws InputError for an unknown option or a wrong value.
Options ParseOptions(int argc, char* argv[]);

/// Rewrites settings of vtkHapticVolumeReader in a text, such as "Series = 2", as options of this
/// program.
std::string NameOptions(const std::string& text);
} // namespace Explore

#endif

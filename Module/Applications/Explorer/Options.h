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
  bool CheckDisplay = false; // test the display and do nothing else
  bool Live = false;         // also tick in real time, through the servo loop
  bool Inspect = false;      // say what the file holds, and do nothing else
  bool Json = false;         // write what Inspect says as JSON, for programs
  bool Large = false;        // read the volume around the hand only, whatever its size
  std::string VolumePath;
  int Series = 0;                     // number of the series in a DICOM folder; 0: the largest
  std::string Array;                  // the array to show and feel
  std::vector<std::string> MorePaths; // further time steps of a volume that moves
  std::string Displacements;          // array with the motion of its material
  bool AsLabels = false;              // whether the values of the volume are labels
  std::string Notice;                 // notice of the window at the beginning
  bool BringBack = false;             // restore work that was not saved in the last window
  std::string Labels;                 // file of a segmentation
  std::vector<std::string> Materials; // files of tables for the labels
  std::string Folder = "explore-pictures";
  bool Pictures = false;       // write pictures even if there is a display
  DeviceChoice Device;         // device of the window
  std::string Setup;           // file of the window's functions, settings and camera
  std::string Measurements;    // file of what is measured in the window
  std::string Script;          // file of the window's demonstration
  std::string Movie;           // movie of the window, from its beginning to its end
  std::string Replay;          // a recording to show in the window
  std::string Stereo;          // stereo mode of the window
  bool Slices = false;         // show slices in the window
  CutKind Cut = CutKind::None; // cut of the volume in the window
  bool Sound = false;          // play sound in the window
  std::string Tool;            // tool in the window: "needle", "burr", a file, or empty for a point
  std::string SoundFile;       // file for the sound along the path; empty: none
  std::string WrittenVolume;   // file for the volume alone, if it is only converted
  Settings How;
  MapperChoice Mapper = MapperChoice::Auto;
  int Width = 900;
};

/// Throws InputError for an unknown option or a wrong value.
Options ParseOptions(int argc, char* argv[]);
} // namespace Explore

#endif

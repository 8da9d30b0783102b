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
  bool Live = false;         // in real time through the servo loop, too
  bool Large = false;        // read it where the hand is, whatever its size
  std::string VolumePath;
  int Series = 0;                     // of a DICOM folder; 0: the largest
  std::string Array;                  // that is shown and felt
  std::vector<std::string> MorePaths; // further frames of a volume that moves
  std::string Displacements;          // array that tells where its material goes
  bool AsLabels = false;              // its values are labels
  std::string Notice;                 // of the window, at its beginning
  bool BringBack = false;             // what was not saved when the window closed last
  std::string Labels;                 // file of a segmentation
  std::vector<std::string> Materials; // files of tables for it
  std::string Folder = "explore-pictures";
  bool Pictures = false;       // even if there is a display
  DeviceChoice Device;         // of the window
  std::string Setup;           // file of the window's functions, settings and camera
  std::string Measurements;    // file of what is measured in the window
  std::string Script;          // of the window: a demonstration
  std::string Movie;           // of the window, from its beginning to its end
  std::string Replay;          // of the window: a recording that is shown
  std::string Stereo;          // of the window
  bool Slices = false;         // of the window
  CutKind Cut = CutKind::None; // of the window
  bool Sound = false;          // of the window
  std::string Tool;            // of the window: "needle", "burr", a file, or empty for a point
  std::string SoundFile;       // for the sound along the path
  std::string WrittenVolume;   // file for the volume alone, if it is only read and written
  Settings How;
  MapperChoice Mapper = MapperChoice::Auto;
  int Width = 900;
};

/// Throws InputError for an option that is not known or has no proper value.
Options ParseOptions(int argc, char* argv[]);
} // namespace Explore

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HeadExploration_h
#define HeadExploration_h

#include "Applications/Explorer/Exploration/Exploration.h"
#include "VTK/Reading/VolumeLoader.h"

#include <vtksys/SystemTools.hxx>

#include <cstring>
#include <string>

/// Returns the command-line argument after an option, such as `--volume`.
inline std::string Argument(int argc, char* argv[], const char* option)
{
  for (int i = 1; i + 1 < argc; ++i)
  {
    if (std::strcmp(argv[i], option) == 0)
    {
      return argv[i + 1];
    }
  }
  return {};
}

inline vtkSmartPointer<vtkImageData> LoadHead(int argc, char* argv[])
{
  return Explore::LoadVolume(Argument(argc, argv, "--volume")).Image;
}

/// Creates the folder for this test's files and returns its path.
inline std::string MakeTestFolder(int argc, char* argv[], const char* name)
{
  const std::string folder = Argument(argc, argv, "-T") + "/" + name;
  vtksys::SystemTools::MakeDirectory(folder);
  return folder;
}

/// Runs the standard exploration of the head phantom.
inline Explore::Exploration ExploreHead(
  int argc, char* argv[], const Explore::Settings& settings = Explore::Settings())
{
  return Explore::ExploreVolume(Explore::LoadVolume(Argument(argc, argv, "--volume")), settings);
}

#endif

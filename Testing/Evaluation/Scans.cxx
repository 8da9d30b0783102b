// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Scans.h"

#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeLoader.h"

#include "vtkImageData.h"

#include <cstdio>
#include <fstream>
#include <sstream>

namespace evaluation
{
namespace
{
/** Reads lines of the form "group,number,structure,label" after a heading. */
LabelNames ReadNames(const std::string& file)
{
  LabelNames names;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line))
  {
    std::istringstream cells(line);
    std::string group;
    std::string number;
    std::string structure;
    int label = 0;
    if (std::getline(cells, group, ',') && std::getline(cells, number, ',') &&
      std::getline(cells, structure, ',') && cells >> label)
    {
      names[label] = structure;
    }
  }
  return names;
}
} // namespace

vtkSmartPointer<vtkImageData> ReadScan(const std::string& file)
{
  try
  {
    return Explore::LoadVolume(file).Image;
  }
  catch (const Explore::InputError& error)
  {
    std::fprintf(stderr, "%s\n", error.what());
    return nullptr;
  }
}

bool ReadChest(const std::string& folder, Scans& scans)
{
  scans.Chest = ReadScan(folder + "/cxr.nii.gz");
  scans.ChestLabels = ReadScan(folder + "/mask.nii.gz");
  scans.Names = ReadNames(folder + "/structures.csv");
  if (scans.Names.empty())
  {
    std::fprintf(stderr, "%s/structures.csv has no names of labels.\n", folder.c_str());
  }
  return scans.Chest && scans.ChestLabels && !scans.Names.empty();
}

} // namespace evaluation

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/KeptWork.h"

#include "Applications/Explorer/Live/FreeFile.h"
#include "VTK/Reading/MessageCapture.h"

#include "vtkColorTransferFunction.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRemoval.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>

namespace
{
using Files = vtksys::SystemTools;

// Names of files in a folder of unsaved work.
constexpr const char* MEASUREMENTS = "/measurements.mrk.json";
constexpr const char* SETUP = "/setup.json";
constexpr const char* REMOVAL = "/removal.vti";
constexpr const char* SUMMARY = "/summary.txt";

/// Returns the folder for the work on a file, without the number at its end; empty if the user has
/// no state folder.
std::string FindFolder(const Explore::FileChoice& shown)
{
  const std::string state = Explore::FindStateFolder();
  if (state.empty())
  {
    return {};
  }
  const std::string path = Files::CollapseFullPath(shown.Path);
  std::ostringstream key;
  key << path << "\n" << shown.Series << "\n" << shown.AsLabels;
  std::ostringstream folder;
  folder << state << "/volumehaptics/" << Files::GetFilenameName(path) << "-" << std::hex
         << std::hash<std::string>()(key.str());
  return folder.str();
}

/// Returns the folder with the highest number; empty if there is none.
std::string FindLast(const std::string& folder)
{
  std::string last;
  const std::string next = folder.empty() ? folder : Explore::FindFreeFile(folder, "");
  for (int number = 1; !next.empty(); ++number)
  {
    const std::string one = Explore::NumberFile(folder, number, "");
    if (one == next)
    {
      break;
    }
    last = one;
  }
  return last;
}

bool MakePrivateFolder(const std::string& folder)
{
  const mode_t mode = 0700;
  return static_cast<bool>(Files::MakeDirectory(folder, &mode));
}

/// Returns whether two lists of nodes differ by more than the rounding of products.
bool Differ(const std::vector<double>& a, const std::vector<double>& b)
{
  return a.size() != b.size() ||
    !std::equal(a.begin(), a.end(), b.begin(),
      [](double x, double y) { return std::abs(x - y) <= 1e-12 * std::max(1.0, std::abs(x)); });
}

template <typename Function, int Size>
void Append(Function* function, std::vector<double>& values)
{
  for (int i = 0; function && i < function->GetSize(); ++i)
  {
    double node[Size];
    function->GetNodeValue(i, node);
    values.insert(values.end(), node, node + Size);
  }
}
} // namespace

namespace Explore
{
KeptWork::KeptWork(TouchScene& touch, vtkVolumeHapticsFilter* filter,
  SavedMeasurements& measurements, HandTool& tool, LookSwitch& look, const FileChoice& shown)
  : Touch(touch)
  , Filter(filter)
  , Measurements(measurements)
  , Tool(tool)
  , Look(look)
  , Folder(FindFolder(shown))
  , Offered(FindLast(this->Folder))
  , Functions(this->ListFunctions())
{
  touch.Commands.Add(this,
    { "File", "bring back unsaved work", "F11", [this] { this->BringBack(); }, nullptr,
      [this] { return !this->Offered.empty(); } });
}

KeptWork::~KeptWork()
{
  this->Touch.Commands.Remove(this);
}

std::string KeptWork::GetOffer() const
{
  std::string words;
  std::ifstream in(this->Offered + SUMMARY);
  return !this->Offered.empty() && std::getline(in, words)
    ? "Not saved last time: " + words + ". F11 brings it back"
    : std::string();
}

void KeptWork::BringBack()
{
  if (this->Offered.empty())
  {
    return;
  }
  this->Look.ShowOutside();
  std::string error;
  {
    const MessageCapture capture;
    const auto has = [&](const char* file)
    { return Files::FileExists(this->Offered + file, true); };
    const auto name = [&](const char* file) { return this->Offered + file; };
    // Keep the current measurements, which are newer: reading the file would replace them.
    const bool isFree = this->Touch.Measurements->GetNumberOfMeasurements() == 0;
    const bool isDone = (!has(SETUP) || this->Touch.Setup->Load(name(SETUP).c_str())) &&
      (!has(REMOVAL) || this->Filter->GetRemoval()->ReadFile(name(REMOVAL))) &&
      (!has(MEASUREMENTS) ||
        (isFree && this->Touch.Measurements->ReadFile(name(MEASUREMENTS).c_str())));
    error = isDone ? ""
      : isFree
      ? capture.FirstError()
      : "Save (Ctrl+S) and remove (Delete) the measurements of this window first, then F11";
  }
  if (error.empty())
  {
    this->Brought = this->Offered;
    this->Offered.clear();
  }
  this->Touch.Display->SetNotice(error.empty() ? "Unsaved work restored" : error.c_str());
}

void KeptWork::KeepAtEnd(bool isSetUp)
{
  this->Look.ShowOutside();
  const bool hasMeasurements =
    !this->Measurements.IsSaved() && this->Touch.Measurements->GetNumberOfMeasurements() > 0;
  const bool hasFunctions = !isSetUp && Differ(this->ListFunctions(), this->Functions);
  const bool hasRemoval = this->Tool.HasUnwrittenRemoval();
  const std::string words = this->Describe(hasMeasurements, hasFunctions, hasRemoval);
  bool isKept = words.empty();
  if (!isKept && !this->Folder.empty())
  {
    const std::string folder = FindFreeFile(this->Folder, "");
    {
      const MessageCapture capture;
      isKept = MakePrivateFolder(folder) &&
        (!hasMeasurements ||
          this->Touch.Measurements->WriteFile((folder + MEASUREMENTS).c_str())) &&
        (!hasFunctions || this->Touch.Setup->Save((folder + SETUP).c_str())) &&
        (!hasRemoval || this->Filter->GetRemoval()->WriteFile(folder + REMOVAL));
      std::ofstream out(folder + SUMMARY);
      isKept = isKept && out << words << std::endl;
    }
    if (isKept)
    {
      std::cout << "Not saved: " << words << ". Kept in " << folder
                << "; the next window on this volume offers it (F11)." << std::endl;
    }
  }
  if (!isKept)
  {
    std::cerr << "Not saved, and lost: " << words << ". "
              << (this->Folder.empty() ? std::string("There is no home folder to keep it in")
                                       : this->Folder + " can't be written")
              << "." << std::endl;
  }
  else if (!this->Brought.empty())
  {
    Files::RemoveADirectory(this->Brought);
  }
}

std::vector<double> KeptWork::ListFunctions() const
{
  vtkHapticProperty* const feel = this->Filter->GetProperty();
  // Changing the look's transparency does not count as an edit.
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->DeepCopy(this->Touch.Scene.Look->GetScalarOpacity());
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    double node[4];
    opacity->GetNodeValue(i, node);
    node[1] /= this->Look.GetOpacityFactor();
    opacity->SetNodeValue(i, node);
  }
  std::vector<double> values;
  for (vtkPiecewiseFunction* const function : { feel->GetStiffness(), feel->GetFriction(),
         feel->GetViscosity(), feel->GetSurfaceStrength(), feel->GetDistinctness(), opacity.Get() })
  {
    Append<vtkPiecewiseFunction, 4>(function, values);
    values.push_back(-1.0); // marks the end of a function's nodes
  }
  Append<vtkColorTransferFunction, 6>(this->Touch.Scene.Look->GetRGBTransferFunction(), values);
  return values;
}

std::string KeptWork::Describe(bool hasMeasurements, bool hasFunctions, bool hasRemoval) const
{
  std::ostringstream words;
  if (hasMeasurements)
  {
    const vtkIdType count = this->Touch.Measurements->GetNumberOfMeasurements();
    words << count << (count == 1 ? " measurement" : " measurements");
  }
  const auto add = [&](const std::string& more)
  { words << (words.tellp() > 0 ? ", " : "") << more; };
  if (hasFunctions)
  {
    add("edited functions");
  }
  if (hasRemoval)
  {
    std::ostringstream volume;
    volume.precision(3);
    volume << this->Filter->GetRemoval()->GetRemovedVolume() << " mm^3 that the burr removed";
    add(volume.str());
  }
  return words.str();
}
} // namespace Explore

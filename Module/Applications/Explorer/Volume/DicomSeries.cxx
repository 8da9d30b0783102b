// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Volume/DicomSeries.h"

#include "vtkMath.h"

#include <vtksys/Directory.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

namespace
{
using Explore::DicomHeader;
using Explore::DicomSeries;
using Files = vtksys::SystemTools;

constexpr int DEEPEST_FOLDER = 8;        // patient, study and series need fewer
constexpr double SAME_DIRECTION = 0.999; // cosine
constexpr double SAME_PLACE = 1e-3;      // mm

bool IsAlike(const DicomHeader& a, const DicomHeader& b)
{
  return a.Series == b.Series && a.Width == b.Width && a.Height == b.Height && a.Bits == b.Bits &&
    a.Samples == b.Samples && vtkMath::Dot(a.Normal, b.Normal) > SAME_DIRECTION;
}

void AddFolder(const std::string& folder, int depth, std::set<std::string>& visited,
  std::vector<DicomSeries>& all, bool& hasFolders)
{
  vtksys::Directory directory;
  directory.Load(folder);
  std::vector<std::string> names;
  for (unsigned long i = 0; i < directory.GetNumberOfFiles(); ++i)
  {
    names.emplace_back(directory.GetFile(i));
  }
  std::sort(names.begin(), names.end());
  for (const std::string& name : names)
  {
    const std::string path = folder + "/" + name;
    if (name == "." || name == "..")
    {
      continue;
    }
    if (Files::FileIsDirectory(path))
    {
      hasFolders = true;
      // A link may lead back to its own folder, or to another one of these.
      if (depth < DEEPEST_FOLDER && visited.insert(Files::GetRealPath(path)).second)
      {
        AddFolder(path, depth + 1, visited, all, hasFolders);
      }
    }
    else
    {
      for (const DicomHeader& slice : Explore::ReadDicomSlices(path))
      {
        const auto found = std::find_if(all.begin(), all.end(),
          [&](const DicomSeries& series) { return IsAlike(series.Slices.front(), slice); });
        auto& slices = found != all.end() ? found->Slices : all.emplace_back().Slices;
        slices.push_back(slice);
      }
    }
  }
}

/// Counts the pixels of what can be a volume before all others: a localizer, or a capture of the
/// screen, may have more pixels than a scan.
double CountPixels(const DicomSeries& series)
{
  const DicomHeader& first = series.Slices.front();
  constexpr std::size_t fewest = 5; // slices
  const double weight = series.Slices.size() < fewest ? 1e-9 : 1.0;
  return weight * static_cast<double>(series.Slices.size()) * first.Width * first.Height;
}
} // namespace

namespace Explore
{
std::string DicomSeries::Describe(std::size_t number) const
{
  const DicomHeader& first = this->Slices.front();
  std::ostringstream text;
  text << number << " \"" << (first.Description.empty() ? "without a name" : first.Description)
       << "\", " << (first.Modality.empty() ? "" : first.Modality + ", ") << this->Slices.size()
       << (this->Slices.size() == 1 ? " slice of " : " slices of ") << first.Width << " x "
       << first.Height;
  return text.str();
}

std::vector<DicomSeries> ListDicomSeries(const std::string& folder, bool& hasFolders)
{
  hasFolders = false;
  std::vector<DicomSeries> all;
  std::set<std::string> visited{ Files::GetRealPath(folder) };
  AddFolder(folder, 0, visited, all, hasFolders);
  for (DicomSeries& series : all)
  {
    std::stable_sort(series.Slices.begin(), series.Slices.end(),
      [](const DicomHeader& a, const DicomHeader& b) { return a.Along < b.Along; });
  }
  std::stable_sort(all.begin(), all.end(),
    [](const DicomSeries& a, const DicomSeries& b)
    { return a.Slices.front().SeriesNumber < b.Slices.front().SeriesNumber; });
  return all;
}

std::size_t FindLargest(const std::vector<DicomSeries>& series)
{
  const auto largest = std::max_element(series.begin(), series.end(),
    [](const DicomSeries& a, const DicomSeries& b) { return CountPixels(a) < CountPixels(b); });
  return static_cast<std::size_t>(largest - series.begin());
}

bool ArePhases(const std::vector<std::string>& folders)
{
  std::vector<DicomHeader> slices;
  for (const std::string& folder : folders)
  {
    bool hasFolders = false;
    const std::vector<DicomSeries> found = ListDicomSeries(folder, hasFolders);
    if (found.size() != 1 || hasFolders)
    {
      return false;
    }
    const std::vector<DicomHeader>& others = found.front().Slices;
    slices = slices.empty() ? others : slices;
    const auto isSame = [](const DicomHeader& a, const DicomHeader& b)
    {
      return a.Width == b.Width && a.Height == b.Height &&
        vtkMath::Dot(a.Normal, b.Normal) > SAME_DIRECTION &&
        std::sqrt(vtkMath::Distance2BetweenPoints(a.Position, b.Position)) < SAME_PLACE;
    };
    if (others.size() != slices.size() ||
      !std::equal(slices.begin(), slices.end(), others.begin(), isSame))
    {
      return false;
    }
  }
  return !slices.empty();
}
} // namespace Explore

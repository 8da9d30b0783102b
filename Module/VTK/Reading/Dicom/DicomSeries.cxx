// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/Dicom/DicomSeries.h"

#include "VTK/Reading/WholeFile.h"

#include "vtkMath.h"

#include <vtksys/Directory.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <sstream>
#include <utility>

namespace
{
using Explore::DicomHeader;
using Explore::DicomSeries;
using Files = vtksys::SystemTools;

// Largest depth of nested folders; patient, study and series need fewer.
constexpr int DEEPEST_FOLDER = 8;
constexpr double SAME_DIRECTION = 0.999; // cosine
constexpr double SAME_PLACE = 1e-3;      // mm

bool HaveSameSpacing(const DicomHeader& a, const DicomHeader& b)
{
  constexpr double rounding = 1e-2;
  return std::abs(a.Spacing[0] - b.Spacing[0]) <= rounding * a.Spacing[0] &&
    std::abs(a.Spacing[1] - b.Spacing[1]) <= rounding * a.Spacing[1];
}

bool IsAlike(const DicomHeader& a, const DicomHeader& b)
{
  return a.Series == b.Series && a.Patient == b.Patient && a.Width == b.Width &&
    a.Height == b.Height && a.Samples == b.Samples && (a.Frames > 1) == (b.Frames > 1) &&
    HaveSameSpacing(a, b) && vtkMath::Dot(a.Normal, b.Normal) > SAME_DIRECTION &&
    vtkMath::Dot(a.Row, b.Row) > SAME_DIRECTION && (!a.IsSegmentation() || a.File == b.File);
}

bool IsSamePlace(const DicomHeader& a, const DicomHeader& b)
{
  return std::sqrt(vtkMath::Distance2BetweenPoints(a.Position, b.Position)) < SAME_PLACE;
}

/// Removes duplicates of slices, with the same identifier, position and facts. Returns how many it
/// removed. For `named`, see SortDicomSlices().
std::size_t RemoveCopies(std::vector<DicomHeader>& slices, const std::string& named)
{
  const auto rank = [&](const DicomHeader& slice) {
    return slice.File == named ? 0 : slice.IsWhole ? 1 : 2;
  };
  std::stable_sort(slices.begin(), slices.end(),
    [&](const DicomHeader& a, const DicomHeader& b) { return rank(a) < rank(b); });
  std::map<std::pair<std::string, int>, const DicomHeader*> known;
  std::vector<DicomHeader> left;
  left.reserve(slices.size()); // avoids a reallocation, so that addresses stay valid
  for (const DicomHeader& slice : slices)
  {
    const auto [found, isNew] = known.insert({ { slice.Instance, slice.Frame }, nullptr });
    const bool isCopy = !isNew && !slice.Instance.empty() && found->second->File != slice.File &&
      IsSamePlace(*found->second, slice) && found->second->Facts == slice.Facts;
    if (!isCopy)
    {
      left.push_back(slice);
      found->second = &left.back();
    }
  }
  const std::size_t copies = slices.size() - left.size();
  slices = left;
  return copies;
}

void SortByPlace(std::vector<DicomHeader>& slices)
{
  std::stable_sort(slices.begin(), slices.end(),
    [](const DicomHeader& a, const DicomHeader& b) { return a.Along < b.Along; });
}

/// Sets missing slice positions from SliceLocation, if that distinguishes the slices. Returns
/// whether it does.
bool PlaceByLocation(std::vector<DicomHeader>& slices)
{
  std::set<double> places;
  for (const DicomHeader& slice : slices)
  {
    if (slice.HasPosition || !slice.Location || slice.Frames > 1)
    {
      return false;
    }
    places.insert(*slice.Location);
  }
  if (places.size() < 2)
  {
    return false;
  }
  for (DicomHeader& slice : slices)
  {
    slice.Along = *slice.Location;
    for (int axis = 0; axis < 3; ++axis)
    {
      slice.Position[axis] = slice.Along * slice.Normal[axis];
    }
  }
  return true;
}

/// Returns the number of slices at each position; 0 if it differs from position to position.
std::size_t CountAtPlace(const std::vector<DicomHeader>& slices)
{
  std::size_t count = 0, here = 0;
  for (std::size_t i = 0; i < slices.size(); ++i)
  {
    ++here;
    if (i + 1 == slices.size() || !IsSamePlace(slices[i], slices[i + 1]))
    {
      if (count > 0 && here != count)
      {
        return 0;
      }
      count = here;
      here = 0;
    }
  }
  return count;
}

/// Splits a series by a fact that is unrelated to time, such as the echo. Returns one series per
/// value; none if all slices have the same value.
template <typename Fact>
std::vector<DicomSeries> SplitBy(const DicomSeries& series, const std::string& name, Fact&& fact)
{
  std::map<std::string, std::vector<DicomHeader>> parts;
  for (const DicomHeader& slice : series.Slices)
  {
    parts[fact(slice)].push_back(slice);
  }
  std::vector<DicomSeries> all;
  for (const auto& [value, slices] : parts)
  {
    DicomSeries part = series;
    part.Slices = slices;
    part.Kind += (part.Kind.empty() ? "" : ", ") + name + " " + value;
    all.push_back(part);
    if (CountAtPlace(slices) == 0 || slices.size() != all.front().Slices.size() ||
      !IsSamePlace(slices.front(), all.front().Slices.front()) || value.empty())
    {
      return {};
    }
  }
  return parts.size() > 1 ? all : std::vector<DicomSeries>();
}

/// Splits the slices into `count` phases by a fact that must increase at each position, such as the
/// trigger time. Returns false if it does not, or if a slice lacks it.
bool PartPhases(DicomSeries& series, std::size_t count, const Explore::DicomFact& fact)
{
  std::vector<std::vector<DicomHeader>> phases(count);
  for (std::size_t first = 0; first < series.Slices.size(); first += count)
  {
    const auto begin = series.Slices.begin() + static_cast<std::ptrdiff_t>(first);
    std::vector<DicomHeader> here(begin, begin + static_cast<std::ptrdiff_t>(count));
    if (std::any_of(here.begin(), here.end(),
          [&](const DicomHeader& slice) { return slice.Facts.count(fact.Tag) == 0; }))
    {
      return false;
    }
    const auto valueOf = [&](const DicomHeader& slice) { return slice.Facts.at(fact.Tag); };
    std::sort(here.begin(), here.end(),
      [&](const DicomHeader& a, const DicomHeader& b) { return valueOf(a) < valueOf(b); });
    for (std::size_t i = 0; i < count; ++i)
    {
      if (i > 0 && !(valueOf(here[i]) > valueOf(here[i - 1])))
      {
        return false;
      }
      phases[i].push_back(here[i]);
    }
  }
  series.PhasesBy = fact.Name;
  series.HaveTimes = fact.Seconds > 0.0;
  for (std::size_t i = 0; i < count; ++i)
  {
    const double since =
      phases[i].front().Facts.at(fact.Tag) - phases[0].front().Facts.at(fact.Tag);
    series.Times.push_back(series.HaveTimes ? since * fact.Seconds : static_cast<double>(i));
  }
  series.Slices = phases.front();
  series.MorePhases.assign(phases.begin() + 1, phases.end());
  return true;
}

/// Splits a series that contains several volumes: different kinds of images, or the phases of a
/// moving volume. Returns an unsplittable series unchanged.
std::vector<DicomSeries> Part(const DicomSeries& series)
{
  const std::size_t count = CountAtPlace(series.Slices);
  const DicomHeader& first = series.Slices.front();
  const bool isPlaced = first.HasPosition || first.Frames > 1 || series.IsPlacedByLocation;
  if (count < 2 || !isPlaced || first.IsSegmentation())
  {
    return { series };
  }
  std::vector<DicomSeries> parts =
    SplitBy(series, "ImageType", [](const DicomHeader& slice) { return slice.ImageType; });
  for (const Explore::DicomFact& fact : Explore::DICOM_FACTS)
  {
    if (parts.empty() && fact.Seconds < 0.0)
    {
      parts = SplitBy(series, fact.Name,
        [&](const DicomHeader& slice)
        {
          std::ostringstream text;
          const auto found = slice.Facts.find(fact.Tag);
          found != slice.Facts.end() ? text << found->second : text;
          return text.str();
        });
    }
  }
  std::vector<DicomSeries> all;
  for (const DicomSeries& part : parts)
  {
    const std::vector<DicomSeries> further = Part(part);
    all.insert(all.end(), further.begin(), further.end());
  }
  if (!parts.empty())
  {
    return all;
  }
  DicomSeries phases = series;
  for (const Explore::DicomFact& fact : Explore::DICOM_FACTS)
  {
    if (fact.Seconds >= 0.0 && PartPhases(phases, count, fact))
    {
      break;
    }
  }
  return { phases };
}

void AddFolder(const std::string& folder, int depth, std::set<std::string>& visited,
  std::vector<DicomHeader>& all, Explore::DicomFolderFacts& facts)
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
      facts.HasFolders = true;
      // Skip visited folders: a link may lead back to its own folder or to another visited one.
      if (depth < DEEPEST_FOLDER && visited.insert(Files::GetRealPath(path)).second)
      {
        AddFolder(path, depth + 1, visited, all, facts);
      }
    }
    else if (const std::string fault = Explore::DetectDevice(path); !fault.empty())
    {
      facts.Device = facts.Device.empty() ? fault : facts.Device;
    }
    else
    {
      const std::vector<DicomHeader> slices = Explore::ReadDicomSlices(path);
      all.insert(all.end(), slices.begin(), slices.end());
    }
  }
}

/// Ranks a series by its number of pixels. A series that can't be a volume ranks lower, because a
/// localizer, a screen capture, or images derived from a scan may have more pixels than the scan.
double CountPixels(const DicomSeries& series)
{
  const DicomHeader& first = series.Slices.front();
  constexpr std::size_t fewest = 5; // smallest number of slices that count as a volume
  const bool isMade = first.IsSegmentation() || first.Modality == "RTDOSE";
  const double weight = series.Slices.size() < fewest ? 1e-18 : isMade ? 1e-9 : 1.0;
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
  if (!this->MorePhases.empty())
  {
    text << ", " << this->MorePhases.size() + 1 << " phases";
  }
  text << (this->Kind.empty() ? "" : ", ") << this->Kind;
  return text.str();
}

bool DicomSeries::Holds(const std::string& file) const
{
  const auto holds = [&](const std::vector<DicomHeader>& slices)
  {
    return std::any_of(
      slices.begin(), slices.end(), [&](const DicomHeader& slice) { return slice.File == file; });
  };
  return holds(this->Slices) ||
    std::any_of(this->MorePhases.begin(), this->MorePhases.end(), holds);
}

std::vector<DicomSeries> SortDicomSlices(
  const std::vector<DicomHeader>& slices, const std::string& named)
{
  std::vector<DicomSeries> found;
  for (const DicomHeader& slice : slices)
  {
    const auto alike = std::find_if(found.begin(), found.end(),
      [&](const DicomSeries& series) { return IsAlike(series.Slices.front(), slice); });
    (alike != found.end() ? *alike : found.emplace_back()).Slices.push_back(slice);
  }
  std::vector<DicomSeries> all;
  for (DicomSeries& series : found)
  {
    series.IsPlacedByLocation = PlaceByLocation(series.Slices);
    series.Copies = RemoveCopies(series.Slices, named);
    SortByPlace(series.Slices);
    const std::vector<DicomSeries> parts = Part(series);
    all.insert(all.end(), parts.begin(), parts.end());
  }
  std::stable_sort(all.begin(), all.end(),
    [](const DicomSeries& a, const DicomSeries& b)
    { return a.Slices.front().SeriesNumber < b.Slices.front().SeriesNumber; });
  return all;
}

std::vector<DicomSeries> ListDicomSeries(
  const std::string& folder, DicomFolderFacts& facts, const std::string& named)
{
  std::vector<DicomHeader> all;
  std::set<std::string> visited{ Files::GetRealPath(folder) };
  AddFolder(folder, 0, visited, all, facts);
  return SortDicomSlices(all, named);
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
    DicomFolderFacts facts;
    const std::vector<DicomSeries> found = ListDicomSeries(folder, facts);
    if (found.size() != 1 || facts.HasFolders || !found.front().MorePhases.empty())
    {
      return false;
    }
    const std::vector<DicomHeader>& others = found.front().Slices;
    slices = slices.empty() ? others : slices;
    const auto isSame = [](const DicomHeader& a, const DicomHeader& b)
    {
      return a.Patient == b.Patient && a.Modality == b.Modality && a.Width == b.Width &&
        a.Height == b.Height && vtkMath::Dot(a.Normal, b.Normal) > SAME_DIRECTION &&
        IsSamePlace(a, b);
    };
    const auto isCopy = [](const DicomHeader& a, const DicomHeader& b)
    { return a.Instance == b.Instance && a.Series == b.Series && a.File != b.File; };
    if (others.size() != slices.size() ||
      !std::equal(slices.begin(), slices.end(), others.begin(), isSame) ||
      (!slices.front().Instance.empty() && isCopy(slices.front(), others.front())))
    {
      return false;
    }
  }
  return !slices.empty();
}
} // namespace Explore

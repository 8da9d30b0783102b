// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Options.h"

#include "Applications/Explorer/Exploration/GuideFile.h"
#include "Applications/Explorer/Exploration/ModeChoice.h"
#include "Applications/Explorer/HelpText.h"
#include "Applications/Explorer/Live/ToolFile.h"
#include "Applications/Explorer/Live/TouchReplay.h"
#include "Applications/Explorer/Record/DemoScript.h"
#include "Applications/Explorer/Record/MovieFile.h"
#include "Applications/Explorer/Sound/SoundOutput.h"
#include "Applications/Explorer/View/StereoModes.h"
#include "VTK/Reading/InputError.h"

#include "Core/Math/NumberText.h"

#include "vtkStringArray.h"
#include "vtkVolumeHapticsFilter.h"

#include <vtksys/SystemTools.hxx>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <regex>

namespace
{
using Explore::CutKind;
using Explore::Estimator;
using Explore::InputError;
using Explore::MapperChoice;
using Explore::Options;

constexpr int SMALLEST_WIDTH = 100;
constexpr int LARGEST_WIDTH = 8000;
constexpr double MOST_NEWTONS = 100.0;

const std::map<std::string, Estimator> ESTIMATORS = { { "central", Estimator::CentralDifference },
  { "gaussian", Estimator::Gaussian }, { "bspline", Estimator::CubicBSpline } };

const std::map<std::string, MapperChoice> MAPPERS = { { "auto", MapperChoice::Auto },
  { "gpu", MapperChoice::GPU }, { "cpu", MapperChoice::CPU } };

const std::map<std::string, CutKind> CUTS = { { "plane", CutKind::Plane },
  { "box", CutKind::Box } };

template <typename Value>
Value Choose(
  const std::map<std::string, Value>& choices, const std::string& option, const std::string& text)
{
  const auto choice = choices.find(text);
  if (choice != choices.end())
  {
    return choice->second;
  }
  std::string list;
  for (const auto& known : choices)
  {
    list += (list.empty() ? "" : ", ") + known.first;
  }
  throw InputError(option + " '" + text + "'", "is not known", "use one of: " + list);
}

/// Returns a map of all methods' names to themselves.
std::map<std::string, std::string> Methods()
{
  std::map<std::string, std::string> methods;
  vtkStringArray* const names = vtkVolumeHapticsFilter::GetMethodNames();
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    methods[names->GetValue(i)] = names->GetValue(i);
  }
  return methods;
}

double ParseNumber(const std::string& text)
{
  return VolumeHaptics::ParseNumber(text).value_or(std::nan(""));
}

/// Parses the forces at full scale along a stick's axes: "2.5" for both axes, or "2.5,0".
std::array<double, 2> ParseNewtons(const std::string& text)
{
  const std::size_t comma = text.find(',');
  const double first = ParseNumber(text.substr(0, comma));
  const double second = comma == std::string::npos ? first : ParseNumber(text.substr(comma + 1));
  if (!(std::abs(first) <= MOST_NEWTONS) || !(std::abs(second) <= MOST_NEWTONS))
  {
    throw InputError("--newtons '" + text + "'", "is not a force in newtons",
      "use -100 to 100, or two such numbers, as in 2.5,0 for a wheel");
  }
  return { first, second };
}

int ParseWidth(const std::string& text)
{
  char* end = nullptr;
  const long width = std::strtol(text.c_str(), &end, 10);
  if (text.empty() || *end != '\0' || width < SMALLEST_WIDTH || width > LARGEST_WIDTH)
  {
    throw InputError(
      "--size '" + text + "'", "is not a width in pixels", "use a whole number from 100 to 8000");
  }
  return static_cast<int>(width);
}

int ParseSeries(const std::string& text)
{
  const double number = ParseNumber(text);
  constexpr double most = 1e6;
  if (!(number >= 1.0) || number > most || number != std::floor(number))
  {
    throw InputError("--series '" + text + "'", "is not the number of a series",
      "use 1 or more; without --series, the largest is used and all are listed");
  }
  return static_cast<int>(number);
}

bool IsSoundFile(const std::string& name)
{
  return vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name)) ==
    ".wav";
}

void CheckMeasurementsFile(const std::string& name)
{
  const std::string ending =
    vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name));
  if (ending != ".csv" && ending != ".vtp" && ending != ".json")
  {
    throw InputError("--measurements " + name, "has an unknown extension",
      "use one that ends in .csv, .vtp or .mrk.json");
  }
}

void CheckMovieFile(const std::string& name)
{
  if (vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name)) != ".ogv")
  {
    throw InputError("--movie " + name, "has an unknown extension", "use one that ends in .ogv");
  }
  if (!Explore::MovieFile::IsAvailable())
  {
    throw InputError("--movie", "this program's VTK can't write movies",
      "build it with a VTK that has the module IOOggTheora, as Debian's has");
  }
}

/// Makes the sound go to a file or, if the name is empty, to the loudspeakers.
void SetSound(Options& options, const std::string& file)
{
  if (!file.empty())
  {
    if (!IsSoundFile(file))
    {
      throw InputError(
        "--sound " + file, "is not the name of a sound file", "use one that ends in .wav");
    }
    options.SoundFile = file;
    return;
  }
  if (!Explore::SoundOutput::IsAvailable())
  {
    throw InputError("--sound", "this program was built without PulseAudio's library",
      "build it from its sources with the package libpulse-dev, as Examples/explore.sh does, or "
      "give a file, as in --sound touch.wav");
  }
  options.Sound = true;
}

/// Sets the first device or, if it is already set, the device of the second hand.
void SetDevice(Options& options, const std::string& id)
{
  if (options.HasDevice && !options.Device.SecondId.empty())
  {
    throw InputError(
      "--device " + id, "is a third device", "give two devices at most, one for each hand");
  }
  if (options.HasDevice && (id == "virtual" || id.compare(0, 7, "replay:") == 0))
  {
    throw InputError("--device " + id, "can't be the second device, which a person has to move",
      "give it before the real device");
  }
  (options.HasDevice ? options.Device.SecondId : options.Device.Id) = id;
  options.HasDevice = true;
}

void SetOption(Options& options, const std::string& name, const std::string& value)
{
  if (name == "--pictures")
  {
    options.Folder = value;
    options.Pictures = true;
  }
  else if (name == "--labels")
  {
    options.Labels = value;
  }
  else if (name == "--series")
  {
    options.Series = ParseSeries(value);
  }
  else if (name == "--array")
  {
    options.Array = value;
  }
  else if (name == "--displacements")
  {
    options.Displacements = value;
  }
  else if (name == "--materials")
  {
    options.Materials.push_back(value);
  }
  else if (name == "--preset")
  {
    options.How.Preset = value;
  }
  else if (name == "--estimator")
  {
    options.How.Gradient = Choose(ESTIMATORS, name, value);
  }
  else if (name == "--method")
  {
    options.How.Method = Choose(Methods(), name, value);
  }
  else if (name == "--mode")
  {
    Explore::CheckMode(value);
    options.How.Modes.push_back(value);
  }
  else if (name == "--guide")
  {
    Explore::CheckGuideFile(value);
    options.How.Guide = value;
  }
  else if (name == "--tool")
  {
    if (value != "needle" && value != "burr" && value != "point" && !Explore::IsToolFile(value))
    {
      throw InputError("--tool '" + value + "'", "is not known",
        "use needle, burr, or point, or a surface that ends in .stl, .ply, .obj or .vtp");
    }
    if (Explore::IsToolFile(value))
    {
      // only checks the file: throws InputError before any computation
      Explore::ReadToolFile(value);
    }
    options.Tool = value == "point" ? std::string() : value;
  }
  else if (name == "--mapper")
  {
    options.Mapper = Choose(MAPPERS, name, value);
  }
  else if (name == "--cut")
  {
    options.Cut = Choose(CUTS, name, value);
  }
  else if (name == "--device")
  {
    SetDevice(options, value);
  }
  else if (name == "--firmware")
  {
    options.Device.Firmware = value;
  }
  else if (name == "--newtons")
  {
    options.Device.Newtons = ParseNewtons(value);
  }
  else if (name == "--setup")
  {
    options.Setup = value;
  }
  else if (name == "--measurements")
  {
    CheckMeasurementsFile(value);
    options.Measurements = value;
  }
  else if (name == "--script")
  {
    // only checks the file: throws InputError before any computation
    Explore::ReadDemoScript(value);
    options.Script = value;
  }
  else if (name == "--movie")
  {
    CheckMovieFile(value);
    options.Movie = value;
  }
  else if (name == "--write-volume")
  {
    if (vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(value)) !=
      ".vti")
    {
      throw InputError(
        "--write-volume " + value, "has an unknown extension", "use one that ends in .vti");
    }
    options.WrittenVolume = value;
  }
  else if (name == "--replay")
  {
    // only checks the file: throws InputError before any computation
    Explore::TouchReplay::ReadFile(value);
    options.Replay = value;
  }
  else if (name == "--stereo")
  {
    // only checks the name: throws InputError before any computation
    Explore::FindStereoMode(value);
    options.Stereo = value;
  }
  else if (name == "--sound")
  {
    SetSound(options, value);
  }
  else if (name == "--size")
  {
    options.Width = ParseWidth(value);
  }
  else if (name == "--front")
  {
    options.How.Front = value;
  }
  else if (name == "--up")
  {
    options.How.Up = value;
  }
  else
  {
    throw InputError(name, "is not an option", "--help lists the options");
  }
}
} // namespace

namespace Explore
{
Options ParseOptions(int argc, char* argv[])
{
  Options options;
  for (int i = 1; i < argc; ++i)
  {
    std::string word = argv[i];
    if (word == "--help" || word == "-h")
    {
      options.Help = true;
    }
    else if (word == "--check-display")
    {
      options.CheckDisplay = true;
    }
    else if (word == "--live")
    {
      options.Live = true;
    }
    else if (word == "--inspect")
    {
      options.Inspect = true;
    }
    else if (word == "--json")
    {
      options.Json = true;
    }
    else if (word == "--large")
    {
      options.Large = true;
    }
    else if (word == "--as-labels")
    {
      options.AsLabels = true;
    }
    else if (word == "--slices")
    {
      options.Slices = true;
    }
    else if (word == "--sound" && (i + 1 >= argc || !IsSoundFile(argv[i + 1])))
    {
      SetSound(options, "");
    }
    else if (word.size() > 1 && word[0] == '-')
    {
      const std::size_t equals = word.find('=');
      const std::string name = word.substr(0, equals);
      if (equals == std::string::npos && i + 1 >= argc)
      {
        // Every option has a line in the help, so the help decides whether the option is known.
        const bool isKnown = Explore::HelpText().find("\n  " + name + " ") != std::string::npos;
        throw InputError(
          word, isKnown ? "needs a value" : "is not an option", "--help lists the options");
      }
      SetOption(options, name, equals == std::string::npos ? argv[++i] : word.substr(equals + 1));
    }
    else if (options.VolumePath.empty())
    {
      options.VolumePath = word;
    }
    else
    {
      options.MorePaths.push_back(word);
    }
  }
  if (options.VolumePath.empty() && !options.Help && !options.CheckDisplay)
  {
    throw InputError("volumehaptics-explore", "no volume was given",
      "give a volume file or a DICOM folder; Examples/explore.sh finds a head CT by itself");
  }
  if (!options.How.Modes.empty() || !options.How.Guide.empty())
  {
    options.How.Method = "primitives";
  }
  if (!options.Replay.empty() && !options.Device.SecondId.empty())
  {
    throw InputError("--replay " + options.Replay, "shows the touch of one hand",
      "give one device, or leave out --replay");
  }
  if (options.Json && !options.Inspect)
  {
    throw InputError("--json", "is a format of what --inspect finds", "add --inspect");
  }
  if (options.AsLabels && !options.Labels.empty())
  {
    throw InputError("--as-labels", "is for a volume that is a label map itself",
      "leave out this option, or --labels");
  }
  if (!options.Materials.empty() && options.Labels.empty() && !options.AsLabels)
  {
    throw InputError("--materials " + options.Materials.front(), "has no labels to describe",
      "give the segmentation, as in --labels Liver.seg.nrrd");
  }
  return options;
}

std::string NameOptions(const std::string& text)
{
  static const std::pair<std::regex, const char*> words[] = {
    { std::regex("\\bSeries = "), "--series " },
    { std::regex("eave Series out"), "eave out --series" },
    { std::regex("\\bArrayName = "), "--array " },
  };
  std::string named = text;
  for (const auto& [setting, option] : words)
  {
    named = std::regex_replace(named, setting, option);
  }
  return named;
}
} // namespace Explore

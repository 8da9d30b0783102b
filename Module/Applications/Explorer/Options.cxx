// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Options.h"

#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Exploration/GuideFile.h"
#include "Applications/Explorer/Exploration/ModeChoice.h"
#include "Applications/Explorer/Live/ToolFile.h"
#include "Applications/Explorer/Record/DemoScript.h"
#include "Applications/Explorer/Record/MovieFile.h"
#include "Applications/Explorer/Sound/SoundOutput.h"
#include "Applications/Explorer/View/StereoModes.h"

#include "vtkHapticProperty.h"
#include "vtkStringArray.h"

#include <vtksys/SystemTools.hxx>

#include <array>
#include <cmath>
#include <cstdlib>
#include <map>

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
  throw InputError(option + " '" + text + "'", "is not known", "take one of: " + list);
}

/// All methods, each mapped to itself.
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

/// ", first, second" of names, each in quotes or not.
std::string List(vtkStringArray* names, const std::string& quote)
{
  std::string list;
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    list += ", " + quote + names->GetValue(i) + quote;
  }
  return list;
}

double ParseNumber(const std::string& text)
{
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  return text.empty() || *end != '\0' ? std::nan("") : number;
}

/// Along a stick's axes: "2.5" of both, or "2.5,0".
std::array<double, 2> ParseNewtons(const std::string& text)
{
  const std::size_t comma = text.find(',');
  const double first = ParseNumber(text.substr(0, comma));
  const double second = comma == std::string::npos ? first : ParseNumber(text.substr(comma + 1));
  if (!(std::abs(first) <= MOST_NEWTONS) || !(std::abs(second) <= MOST_NEWTONS))
  {
    throw InputError("--newtons '" + text + "'", "is no force of a stick",
      "take -100 to 100, or two such numbers, as in 2.5,0 for a wheel");
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
      "--size '" + text + "'", "is not a width in pixels", "take a whole number from 100 to 8000");
  }
  return static_cast<int>(width);
}

int ParseSeries(const std::string& text)
{
  const double number = ParseNumber(text);
  constexpr double most = 1e6;
  if (!(number >= 1.0) || number > most || number != std::floor(number))
  {
    throw InputError("--series '" + text + "'", "is not a number of the list of series",
      "take 1 or more; without --series, the largest is taken and all are listed");
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
    throw InputError("--measurements " + name, "has an unknown ending",
      "take one that ends in .csv, .vtp or .mrk.json");
  }
}

void CheckMovieFile(const std::string& name)
{
  if (vtksys::SystemTools::LowerCase(vtksys::SystemTools::GetFilenameLastExtension(name)) != ".ogv")
  {
    throw InputError("--movie " + name, "has an unknown ending", "take one that ends in .ogv");
  }
  if (!Explore::MovieFile::IsAvailable())
  {
    throw InputError("--movie", "this program was built with a VTK that writes no movies",
      "build it with a VTK that has the module IOOggTheora, as Debian's has");
  }
}

/// Into a file, or with an empty name on the loudspeakers.
void SetSound(Options& options, const std::string& file)
{
  if (!file.empty())
  {
    if (!IsSoundFile(file))
    {
      throw InputError(
        "--sound " + file, "is no name of a sound file", "take one that ends in .wav");
    }
    options.SoundFile = file;
    return;
  }
  if (!Explore::SoundOutput::IsAvailable())
  {
    throw InputError("--sound", "this program was built without PulseAudio's library",
      "build it from its sources with the package libpulse-dev, as Examples/explore.sh does, or "
      "name a file, as in --sound touch.wav");
  }
  options.Sound = true;
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
        "take needle, burr, or point, or a surface that ends in .stl, .ply, .obj or .vtp");
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
    options.Device.Id = value;
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
    Explore::ReadDemoScript(value); // throws, if it has to, before anything is computed
    options.Script = value;
  }
  else if (name == "--movie")
  {
    CheckMovieFile(value);
    options.Movie = value;
  }
  else if (name == "--replay")
  {
    options.Replay = value;
  }
  else if (name == "--stereo")
  {
    Explore::FindStereoMode(value); // throws, if it has to, before anything is computed
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
      if (equals == std::string::npos && i + 1 >= argc)
      {
        throw InputError(word, "needs a value", "--help lists the options");
      }
      const std::string value = equals == std::string::npos ? argv[++i] : word.substr(equals + 1);
      SetOption(options, word.substr(0, equals), value);
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
    throw InputError("volumehaptics-explore", "no volume was named",
      "name a volume file or a DICOM folder; Examples/explore.sh gets a head CT by itself");
  }
  if (!options.How.Modes.empty() || !options.How.Guide.empty())
  {
    options.How.Method = "primitives";
  }
  if (options.AsLabels && !options.Labels.empty())
  {
    throw InputError(
      "--as-labels", "is for a volume that is a label map itself", "leave it out, or --labels");
  }
  if (!options.Materials.empty() && options.Labels.empty() && !options.AsLabels)
  {
    throw InputError("--materials " + options.Materials.front(), "has no labels that it is for",
      "name the segmentation, as in --labels Liver.seg.nrrd");
  }
  return options;
}

std::string HelpText()
{
  const std::string presets = List(vtkHapticProperty::GetPresetNames(), "\"");
  const std::string methods = List(vtkVolumeHapticsFilter::GetMethodNames(), "").substr(2);
  return R"(Usage: volumehaptics-explore VOLUME [options]

Feels its way over a volume: presses a tip into the outer surface, drags it, presses through to what is
dense inside, drags it there, and says what a hand would feel. Then, if there is a display, opens a
window in which the mouse, or a device, touches the volume. Without a display, or with --pictures, writes
pictures, the trace and a summary.

VOLUME   .vti .mhd .mha .nii .nii.gz .nrrd .nhdr; a DICOM slice, for its series; a folder of DICOM slices or of
         folders of them, or its DICOMDIR; or one that may be larger than memory:
         .vtkhdf, a folder .zarr (of a Zarr array or an OME-Zarr image), or raw samples behind .mhd .mha .nrrd
         .nhdr. These are felt from the file, and the window shows a coarse level. A volume that moves is several of these
         files, in this order; a folder of them, or of folders of slices, in the order of the numbers in their
         names; a .pvd file with times (s); or a NIfTI file with several times. The window plays it: space holds,
         arrows go from frame to frame, comma and period change the speed. Files without times are 1/10 s apart.
         Grids, .vtu .vtr .vts .vtm .vtmb .vtk, OpenFOAM's .foam and EnSight's .case, are resampled; if they
         have vectors, the flow is followed

  --pictures DIR    no window, and where the results go (default explore-pictures):
                    explore.png force.png trace.vtp trace.csv summary.txt
  --device ID       of the window: virtual (default, the mouse), replay:FILE, or a real one, such as
                    falcon: see volumehaptics-device list
  --firmware FILE   the image for a Novint Falcon that has none
  --newtons X[,Y]   a stick's force at full scale along its axes, N (100): measure it, most have much
                    less; Y is 0 if only the first axis has a motor, as that of a wheel
  --setup FILE      of the window: loaded if it is there, saved when the window is closed
  --measurements FILE
                    of the window: points, distances, angles, paths and areas that you measure by touch (keys P,
                    D, A, L, B; S saves). Loaded if the file is there, saved when the window is closed: .csv,
                    .vtp, or .mrk.json for 3D Slicer
  --movie FILE.ogv  of the window: a movie from its beginning to its end, 20 pictures a second. In the window, key F9
                    begins and ends one, F10 a recording of the touch, and F12 takes a picture
  --replay FILE.vtp of the window: shows a recording of key F10 with a slider for its time. F5 plays and holds it,
                    F6 and F7 go back and on
  --script FILE     of the window: a demonstration, lines with a time (s) and an event, such as
                    "1.0 key t", "1.5 wheel 3", "2.0 stroke 0.7 0.5 1.5", "9 key q": see
                    Documentation/recording.md
  --stereo MODE     of the window: anaglyph, crystal-eyes, red-blue, interlaced, checkerboard,
                    split-viewport, dresden, left, right, fake, emulate
  --slices          of the window: three slices through the tip beside the volume (key s). A click goes
                    there and touches, the wheel moves across them, the right button sets window and level
  --cut NAME        of the window: cut open at first by a plane or a box (default: not cut). The mouse drags the
                    handles; keys: x plane, box, none; X swaps the kept and the hidden part; z feels the
                    cut faces
  --tool NAME       of the window: what the hand holds: point (default); needle, which punctures surfaces, and
                    rubs and is held in tissue; burr, which removes tissue while the left button, or the
                    device's, is pressed. Keys: N the next one; T saves the track of a needle, or what was
                    removed; U undoes a stroke of the burr, J does it again
  --tool FILE.stl   the closed surface of a tool, also .ply, .obj or .vtp, in the volume's units: its shape is
                    felt where it meets the outer surface. Alt + mouse turns it; key N: the next one
  --sound           of the window: what is touched can be heard, a click where a surface is touched or
                    pierced, and noise while the tip slides; the harder, the brighter
  --sound FILE.wav  the sound along the path, in a file
  --preset NAME     materials: auto (default: "CT contrast" for Hounsfield units, else propose), propose
                    (what the volume's own edges suggest), histogram)" +
    presets + R"(,
                    or a file .json that the key F8 of the window saved
  --array NAME      of several point arrays, the one that is shown and felt: its values, or the magnitude of
                    its vectors (default: the active scalars, or else the first array)
  --displacements NAME
                    of a volume that moves: the point array of vectors that tells where the material of a frame
                    is in the next one. Surfaces then go from frame to frame however far that is, and take
                    along a hand that sticks to them
  --series N        which series of a DICOM folder with several (default: that with most pixels; the
                    summary lists them, and key F3 of the window). Key F2, or a file that is dropped on
                    the window, opens another volume
  --labels FILE     a segmentation of the volume, .seg.nrrd .nrrd .nii .nii.gz .mhd .mha .vti: its labels
                    have names in the window, and materials of their own
  --as-labels       the volume is a label map: its values are numbers of labels, which have colours, and
                    the names that the file has for them. The window asks if it looks like one (key F4)
  --materials FILE  a table of what the labels feel like, such as a CSV with the columns label, name,
                    stiffness, friction, viscosity, strength; several of these options add up
  --method NAME     of the path, and the first of the window: )" +
    methods + R"(
                    (default proxy, or primitives for the vectors of a grid; the others for comparison; primitives feels the modes)
  --mode NAME[:ARRAY]
                    a mode of the method primitives, which this chooses, too: )" +
    ListModes() + R"(;
                    ARRAY has its vectors or tensors (default: the first that fits). Several of these options
                    add up; without any, the vectors are followed, else the tensors. NAME may also say what
                    you want: )" +
    ListModePresets() + R"(
  --guide FILE      leads the hand along the lines of a file, or on its surface, as a mode of primitives, with
                    2 N: .vtp .vtk .stl .ply .obj, in the volume's coordinates; or along the paths that you
                    measured (--measurements: .csv .mrk.json .vtp), or a trace. The modes of --mode are felt,
                    too; without any, the window offers them (key M)
  --estimator NAME  gradient: central, gaussian (default), bspline
  --size PX         width of the picture (default 900)
  --mapper NAME     volume rendering: auto (default), gpu, cpu; auto takes the
                    processor in a window if OpenGL runs there, too
  --front AXIS      where a face looks: -y (default), +y, +x, -x, +z, -z
  --up AXIS         where the top is: +z (default), ...
  --live            run the same path through the servo loop, too, at 1 kHz in real time; what was felt
                    there is recorded in live.vtp and shown in the pictures
  --large           read .mhd .mha .nrrd .nhdr where the hand is (default: if they take more than half of the
                    free memory)
  --check-display   do nothing but test whether the display can draw pictures: exit status 0 if it can;
                    if not, VTK may crash
  --help            this text

Exit status: 0 done, 1 the computation failed, 2 the input or an option is wrong, 3 no display.
)";
}
} // namespace Explore

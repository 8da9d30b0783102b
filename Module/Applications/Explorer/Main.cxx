// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/// The main program: explores a volume by touch from the command line, with or without a device.
#include "Applications/Explorer/Exploration/Inspection.h"
#include "Applications/Explorer/Exploration/ModeChoice.h"
#include "Applications/Explorer/Exploration/TissueTable.h"
#include "Applications/Explorer/HelpText.h"
#include "Applications/Explorer/Live/LiveRun.h"
#include "Applications/Explorer/Live/TouchScene.h"
#include "Applications/Explorer/Options.h"
#include "Applications/Explorer/Report/ForcePicture.h"
#include "Applications/Explorer/Report/ReportFiles.h"
#include "Applications/Explorer/Report/TraceSound.h"
#include "Applications/Explorer/Report/TraceSummary.h"
#include "Applications/Explorer/Scene/ExplorerScene.h"
#include "Applications/Explorer/View/Display.h"
#include "Applications/Explorer/View/LoadingScreen.h"
#include "Applications/Explorer/View/StereoModes.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/LabelLoader.h"
#include "VTK/Reading/VolumeChecks.h"
#include "VTK/Reading/VolumeSeries.h"

#include <vtkRenderer.h>
#include <vtkRendererCollection.h>
#include <vtksys/SystemTools.hxx>

#include <exception>
#include <iostream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

namespace
{
constexpr const char* LABELS_OFFERED =
  "it looks like a label map: F4, or --as-labels, treats it as one";

enum ExitCode
{
  DONE = 0,
  FAILED = 1,
  BAD_INPUT = 2,
  NO_DISPLAY = 3
};

/// Tests whether a window can be opened and drawn. VTK would otherwise crash, for example on an X
/// server without GLX.
int CheckDisplay()
{
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  if (!Explore::HasDisplay())
  {
    return NO_DISPLAY;
  }
  window->Render();
  return window->SupportsOpenGL() ? DONE : NO_DISPLAY;
}

std::string Caption(const Explore::Exploration& exploration)
{
  const int* size = exploration.Input.Image->GetDimensions();
  std::ostringstream text;
  text << exploration.Input.Name << ", " << size[0] << " x " << size[1] << " x " << size[2]
       << " voxels\nTrail of the proxy, coloured by the force on the hand\nMethod: "
       << exploration.Method << "\nMaterials: " << exploration.Materials;
  return text.str();
}

int HeightOf(int width)
{
  return width * 7 / 9;
}

Explore::SceneOptions MakeLook(
  const Explore::Exploration& exploration, const Explore::Options& options)
{
  Explore::SceneOptions look;
  vtkRenderWindow* const window = options.Place.Window;
  look.Width = window ? window->GetSize()[0] : options.Width;
  look.Height = window ? window->GetSize()[1] : HeightOf(options.Width);
  look.Mapper = options.Mapper;
  look.Caption = Caption(exploration);
  // If the file does not define its axes, decide by the kind of the values.
  const Explore::VolumeKind kind = exploration.Values.Kind;
  // Label maps have the axes that their numbers suggest when they are read as values.
  const double* const range = exploration.Values.Range;
  const bool isMedical = kind == Explore::VolumeKind::CT || kind == Explore::VolumeKind::EightBit ||
    (kind == Explore::VolumeKind::Labels && range[0] >= 0.0 && range[1] <= 255.0);
  const Explore::WorldAxes axes = exploration.Input.Axes;
  look.Anatomical =
    axes == Explore::WorldAxes::Patient || (axes == Explore::WorldAxes::Unknown && isMedical);
  return look;
}

void WriteSound(const Explore::Exploration& exploration, const Explore::Options& options)
{
  if (!options.SoundFile.empty())
  {
    Explore::WriteSound(exploration, options.SoundFile);
    std::cout << "Written: " << options.SoundFile << std::endl;
  }
}

/// Opens a window that shows the progress until the scene is ready. Returns null if the options
/// request no scene.
vtkSmartPointer<vtkRenderWindow> OpenWindow(const Explore::Options& options)
{
  if (options.Pictures || options.Live || !Explore::HasDisplay())
  {
    return nullptr;
  }
  if (vtkRenderWindow* const before = options.Place.Window)
  {
    while (vtkRenderer* const renderer = before->GetRenderers()->GetFirstRenderer())
    {
      before->RemoveRenderer(renderer);
    }
    return before;
  }
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  Explore::SetStereo(window, options.Stereo);
  window->SetMultiSamples(0);
  window->SetSize(options.Width, HeightOf(options.Width));
  window->SetWindowName("VTK Volume Haptics");
  Explore::ApplyScreen(window);
  return window;
}

/// Shows the touch window. Returns the file to open next; its path is empty if there is none.
Explore::FileChoice Touch(vtkRenderWindow* window, const Explore::Exploration& exploration,
  const Explore::Options& options, const Explore::OpenDevices& devices)
{
  Explore::SceneOptions look = MakeLook(exploration, options);
  look.OffScreen = false;
  look.Interactive = true;
  look.Cut = options.Cut;
  look.SliceShare = options.Slices ? Explore::SLICE_SHARE : 0.0;
  look.Caption.clear(); // no caption, because the head-up display occupies its place
  const Explore::FileChoice now{ options.VolumePath, exploration.Input.SeriesNumber,
    options.AsLabels, {}, !options.MorePaths.empty() };
  return Explore::RunTouchWindow(window, exploration, look, options.Device,
    { options.Setup, options.Measurements, options.Script, options.Movie, options.Sound,
      options.Tool, options.Replay, now, options.Notice, options.BringBack, devices,
      options.Place.View });
}

void WritePictures(Explore::Exploration& exploration, const Explore::Options& options)
{
  const Explore::SceneOptions look = MakeLook(exploration, options);
  Explore::ExplorerScene scene;
  Explore::BuildScene(scene, exploration, look);
  scene.Window->Render();
  Explore::WritePicture(scene.Window, options.Folder + "/explore.png");
  std::cout << "explore.png (" << scene.MapperName << ")\n";

  Explore::ForcePictureOptions paper;
  paper.Width = options.Width;
  paper.Height = options.Width * 3 / 5;
  paper.Title = "Force on the hand: " + exploration.Input.Name + ", " + exploration.Method;
  paper.Modes = Explore::NameModes(exploration.Filter);
  Explore::ForcePicture chart;
  Explore::BuildForcePicture(chart, exploration.Trace, exploration.Tip.Phases, paper);
  chart.Window->Render();
  Explore::WritePicture(chart.Window, options.Folder + "/force.png");
  std::cout << "force.png\n";
}

std::vector<std::string> PathsOf(const Explore::Options& options)
{
  std::vector<std::string> paths{ options.VolumePath };
  paths.insert(paths.end(), options.MorePaths.begin(), options.MorePaths.end());
  return paths;
}

void NameOptions(Explore::Volume& volume)
{
  for (std::string& note : volume.Notes)
  {
    note = Explore::NameOptions(note);
  }
}

Explore::Volume Load(const Explore::Options& options)
{
  Explore::Volume volume =
    Explore::LoadVolumes(PathsOf(options), options.Large, options.Series, options.Array);
  NameOptions(volume);
  return volume;
}

int WriteVolume(const Explore::Options& options)
{
  Explore::Volume volume = Explore::LoadIntoMemory(PathsOf(options), options.Series, options.Array);
  NameOptions(volume);
  if (volume.LabelTable)
  {
    volume.LabelTable->WriteFieldData(volume.Image->GetFieldData());
  }
  Explore::WriteImage(volume.Image, options.WrittenVolume);
  for (const std::string& note : volume.Notes)
  {
    std::cout << note << "\n";
  }
  std::cout << "Written: " << options.WrittenVolume << std::endl;
  return DONE;
}

int Inspect(const Explore::Options& options)
{
  // send progress to stderr, so that stdout contains only the result
  std::streambuf* const out = std::cout.rdbuf(std::cerr.rdbuf());
  Explore::Volume volume = Load(options);
  std::cout.rdbuf(out);
  if (options.AsLabels || (volume.LabelTable && options.Labels.empty()))
  {
    Explore::UseAsLabels(volume, options.VolumePath, options.Materials);
  }
  else if (volume.MayBeLabels)
  {
    volume.Notes.emplace(volume.Notes.begin(), LABELS_OFFERED);
  }
  Explore::Analysis values = Explore::AnalyseVolume(
    volume.Image, volume.IsField, volume.AreLabels, Explore::MayBeHounsfield(volume.Modality));
  vtkNew<vtkVolumeHapticsFilter> filter;
  const std::string materials =
    Explore::ApplyMaterials(options.How.Preset, values, volume.Image, filter);
  const Explore::Inspection inspection(volume, values, materials, filter);
  std::cout << (options.Json ? inspection.ToJson() : inspection.Describe());
  return DONE;
}

int Run(const Explore::Options& options, Explore::FileChoice& next)
{
  const vtkSmartPointer<vtkRenderWindow> window = OpenWindow(options);
  auto loading = window ? std::make_unique<Explore::LoadingScreen>(window) : nullptr;
  const auto tell = [&](const std::string& step, double fraction)
  {
    if (loading)
    {
      loading->Report(step, fraction);
    }
  };
  // Open the devices first, so that a faulty device is reported before the long reading.
  const Explore::OpenDevices devices =
    window ? Explore::OpenDevicesOf(options.Device) : Explore::OpenDevices();
  std::cout << "Reading " << options.VolumePath << std::endl;
  tell("Reading " + vtksys::SystemTools::GetFilenameName(options.VolumePath), 0.0);
  Explore::Volume volume = Load(options);
  if (volume.Large && options.Live)
  {
    throw Explore::InputError(options.VolumePath,
      "is read around the hand, and only volumes in memory can be recorded", "leave out --live");
  }
  if (!options.Displacements.empty())
  {
    Explore::UseDisplacements(volume, options.Displacements);
  }
  if (!options.Labels.empty())
  {
    Explore::LoadLabels(volume, options.Labels, options.Materials);
  }
  if (options.AsLabels || (volume.LabelTable && options.Labels.empty()))
  {
    Explore::UseAsLabels(volume, options.VolumePath, options.Materials);
  }
  else if (volume.MayBeLabels)
  {
    volume.Notes.emplace(volume.Notes.begin(), LABELS_OFFERED);
  }
  Explore::Exploration exploration = Explore::ExploreVolume(volume, options.How, tell);
  const std::string summary = Explore::Summarise(exploration);
  std::cout << "\n" << summary << std::endl;

  if (window)
  {
    WriteSound(exploration, options);
    tell("Drawing", 0.9);
    loading.reset();
    next = Touch(window, exploration, options, devices);
    next.Place.Window = window;
    return DONE;
  }
  if (options.Sound)
  {
    std::cerr << "--sound: there is no window. Cure: give a file, as in --sound touch.wav."
              << std::endl;
  }
  Explore::MakeFolder(options.Folder);
  bool isReproduced = true;
  if (options.Live)
  {
    const Explore::LiveRun live = Explore::RunLive(exploration, options.Folder + "/live.vtp");
    std::cout << live.Report << std::endl;
    isReproduced = live.IsReproduced;
    // Show the live trace in the pictures.
    exploration.Trace = live.Trace;
  }
  WriteSound(exploration, options);
  Explore::WriteText(summary, options.Folder + "/summary.txt");
  Explore::WriteTrace(exploration.Trace, options.Folder + "/trace.vtp");
  Explore::WriteTable(exploration.Trace, options.Folder + "/trace.csv");
  std::cout << "Written to " << vtksys::SystemTools::CollapseFullPath(options.Folder)
            << ":\nsummary.txt\ntrace.vtp\ntrace.csv" << std::endl;
  if (!Explore::HasDisplay())
  {
    std::cerr << "There is no X display for the pictures.\n"
                 "  Cure: run the program as 'xvfb-run -a volumehaptics-explore ...'.\n";
    return NO_DISPLAY;
  }
  WritePictures(exploration, options);
  return isReproduced ? DONE : FAILED;
}
/// Runs the volume of the options, then each volume that is opened in the window. If a file can't
/// be opened, the window reports this, and shows the previous volume again. Returns the exit code
/// of the last run.
int RunAll(Explore::Options options)
{
  Explore::FileChoice next;
  int code = Run(options, next);
  while (!next.Path.empty())
  {
    // These options apply only to the first window.
    options.Notice.clear();
    options.BringBack = false;
    options.Script.clear();
    options.Movie.clear();
    options.Replay.clear();
    const Explore::Options before = options;
    options.Measurements.clear();
    // Options of one volume don't apply to another volume.
    const bool isSame = next.Path == options.VolumePath;
    const Explore::WindowPlace place = next.Place;
    options.Place = place;
    if (!isSame || next.Series != options.Series)
    {
      options.Place.View = nullptr;
    }
    options.VolumePath = next.Path;
    options.Series = next.Series;
    options.AsLabels = next.AsLabels;
    if (!isSame)
    {
      options.MorePaths.clear();
      options.Array.clear();
      options.Setup.clear();
      options.Labels.clear();
      options.Materials.clear();
      options.Displacements.clear();
      options.How.Method = "auto";
      options.How.Modes.clear();
      options.How.Guide.clear();
    }
    try
    {
      next = {};
      code = Run(options, next);
    }
    catch (const Explore::InputError& error)
    {
      const std::string what = Explore::NameOptions(error.what());
      std::cerr << what << std::endl;
      options = before;
      options.Place = place;
      options.Notice = what;
      options.BringBack = true;
      next = {};
      code = Run(options, next);
    }
  }
  return code;
}
} // namespace

int main(int argc, char* argv[])
{
  try
  {
    const Explore::Options options = Explore::ParseOptions(argc, argv);
    if (options.Help)
    {
      std::cout << Explore::HelpText();
      return DONE;
    }
    if (options.CheckDisplay)
    {
      return CheckDisplay();
    }
    if (!options.WrittenVolume.empty())
    {
      return WriteVolume(options);
    }
    return options.Inspect ? Inspect(options) : RunAll(options);
  }
  catch (const Explore::InputError& error)
  {
    std::cerr << Explore::NameOptions(error.what()) << std::endl;
    return BAD_INPUT;
  }
  catch (const std::exception& error)
  {
    std::cerr << "volumehaptics-explore: " << error.what() << std::endl;
    return FAILED;
  }
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tests the sound on the head phantom: skin over fat, a temple (muscle) and the skull (bone), at
// the places that the phantom's description (Data/README.md) gives; and silence without a contact.
#include "Applications/Explorer/Exploration/HeardTicks.h"
#include "Applications/Explorer/Options.h"
#include "Applications/Explorer/Report/TraceSound.h"
#include "Applications/Explorer/Sound/ContactSound.h"
#include "Applications/Explorer/Sound/SoundOutput.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "Sound/Spectrum.h"
#include "VTK/Reading/InputError.h"

#include "vtkDoubleArray.h"
#include "vtkHapticLabelTable.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
using Explore::Exploration;
using soundtest::PI;

constexpr vtkIdType SLIDE = 600; // ticks of a slide

double At(vtkPolyData* trace, const char* array, vtkIdType tick)
{
  return trace->GetPointData()->GetArray(array)->GetComponent(tick, 0);
}

void Feel(Exploration& exploration, vtkPoints* points)
{
  vtkNew<vtkPolyData> path;
  path->SetPoints(points);
  exploration.Filter->SetPathData(path);
  exploration.Filter->Update();
  exploration.Trace = vtkSmartPointer<vtkPolyData>::New();
  exploration.Trace->DeepCopy(exploration.Filter->GetOutput());
}

/// Presses from outside towards the head's axis at a height (mm) and an angle, to `depth` (mm)
/// below the first contact, and slides upwards by 15 mm. Returns the tick at which the slide
/// begins.
vtkIdType Stroke(Exploration& exploration, double height, double degrees, double depth)
{
  const double x = std::cos(degrees * PI / 180.0), y = std::sin(degrees * PI / 180.0);
  constexpr double outside = 118.0, inside = 30.0, step = 0.1; // mm
  vtkNew<vtkPoints> ray;
  ray->SetDataTypeToDouble();
  for (double r = outside; r > inside; r -= step)
  {
    ray->InsertNextPoint(r * x, r * y, height);
  }
  Feel(exploration, ray);
  vtkIdType contact = 0;
  while (contact < ray->GetNumberOfPoints() && At(exploration.Trace, "NormalForce", contact) < 0.2)
  {
    ++contact;
  }
  const double deepest = outside - step * static_cast<double>(contact) - depth;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (double r = outside; r > deepest; r -= step)
  {
    points->InsertNextPoint(r * x, r * y, height);
  }
  const vtkIdType begin = points->GetNumberOfPoints();
  for (vtkIdType i = 0; i < SLIDE; ++i)
  {
    points->InsertNextPoint(deepest * x, deepest * y, height + 0.025 * static_cast<double>(i));
  }
  Feel(exploration, points);
  return begin;
}

std::vector<float> Cut(const std::vector<float>& sound, vtkIdType from, vtkIdType to)
{
  constexpr vtkIdType samples = Explore::SAMPLES_PER_SECOND / 1000; // samples per tick
  return { sound.begin() + from * samples, sound.begin() + to * samples };
}

/// Returns the mean frequency (Hz) of the sound of a range of ticks. Expects that most of these
/// ticks slide on values from `low` to `high` (HU).
double Hear(const Exploration& exploration, vtkIdType from, vtkIdType to, double low, double high,
  const std::string& tissue)
{
  vtkIdType slides = 0;
  for (vtkIdType i = from; i < to; ++i)
  {
    const double value = At(exploration.Trace, "SurfaceValue", i);
    slides += At(exploration.Trace, "Contact", i) == 2.0 && value >= low && value <= high ? 1 : 0;
  }
  Expect(10 * slides > 8 * (to - from), "the tip slides on " + tissue);
  const double centroid = soundtest::Centroid(Cut(Explore::MakeSound(exploration), from, to), 4096);
  std::cout << tissue << ": " << centroid << " Hz\n";
  return centroid;
}

void CheckTissues(int argc, char* argv[])
{
  Explore::Settings settings;
  settings.Preset = "CT contrast";
  Exploration exploration = ExploreHead(argc, argv, settings);
  // Skin and fat are thinner than a voxel, so only the kernel placement assigns their values to
  // them.
  exploration.Filter->SetMaterialPlacementToKernel();
  exploration.Filter->SetContactAlignmentToDistinctness();
  constexpr vtkIdType start = 100; // ticks after the slide's beginning
  vtkIdType begin = Stroke(exploration, -110.0, 30.0, 6.0);
  const double skin =
    Hear(exploration, begin + start, begin + SLIDE, -150.0, -80.0, "skin over fat (neck)");
  // Press 10 mm deep, where the muscle under the fat resists. A deeper hand breaks through the
  // muscle.
  begin = Stroke(exploration, 40.0, 0.0, 10.0);
  const double muscle =
    Hear(exploration, begin + start, begin + SLIDE, 35.0, 80.0, "muscle (temple)");
  exploration.Filter->SetPathData(exploration.Tip.Path);
  exploration.Filter->Update();
  exploration.Trace->DeepCopy(exploration.Filter->GetOutput());
  const auto inside = std::find_if(exploration.Tip.Phases.begin(), exploration.Tip.Phases.end(),
    [](const Explore::Phase& phase) { return phase.Name == "slide inside"; });
  const vtkIdType middle = (inside->First + inside->Last) / 2;
  const double bone = Hear(exploration, middle - 250, middle + 250, 350.0, 3000.0, "bone (skull)");
  const double third = std::cbrt(2.0); // a third of an octave
  Expect(muscle > third * skin, "muscle is brighter than skin by a third of an octave");
  Expect(bone > third * muscle, "bone is brighter than muscle by a third of an octave");
}

void CheckPath(int argc, char* argv[])
{
  Exploration exploration = ExploreHead(argc, argv);
  vtkPolyData* const trace = exploration.Trace;
  vtkIdType contact = 0;
  while (At(trace, "Contact", contact) == 0.0)
  {
    ++contact;
  }
  const std::vector<float> sound = Explore::MakeSound(exploration);
  const auto isSilent = [](const std::vector<float>& y)
  { return std::all_of(y.begin(), y.end(), [](float x) { return x == 0.0f; }); };
  Expect(isSilent(Cut(sound, 0, contact)), "silent before the first contact");
  Expect(!isSilent(Cut(sound, contact, contact + 100)), "heard after it");
  const auto ends = static_cast<vtkIdType>(sound.size()) * 1000 / Explore::SAMPLES_PER_SECOND;
  Expect(isSilent(Cut(sound, ends - 100, ends)), "silent at the end");

  const std::string file = MakeTestFolder(argc, argv, "ExploreSound") + "/touch.wav";
  Explore::WriteSound(exploration, file);
  Expect(vtksys::SystemTools::FileLength(file) == 44 + 2 * sound.size(), "a head and samples");

  // A device renders only part of the force: half during the ramp, and none when disarmed.
  vtkDataArray* const force = trace->GetPointData()->GetArray("Force");
  vtkNew<vtkDoubleArray> command;
  command->SetName("Command");
  command->SetNumberOfComponents(3);
  command->SetNumberOfTuples(trace->GetNumberOfPoints());
  for (const double share : { 1.0, 0.5, 0.0 })
  {
    for (vtkIdType i = 0; i < trace->GetNumberOfPoints(); ++i)
    {
      const double* const f = force->GetTuple3(i);
      command->SetTuple3(i, share * f[0], share * f[1], share * f[2]);
    }
    trace->GetPointData()->AddArray(command);
    const std::vector<float> heard = Explore::MakeSound(exploration);
    double energy = 0.0;
    double full = 0.0;
    for (std::size_t i = 0; i < heard.size(); ++i)
    {
      energy += static_cast<double>(heard[i]) * heard[i];
      full += static_cast<double>(sound[i]) * sound[i];
    }
    const bool isRight = share == 1.0 ? energy > 0.99 * full
      : share == 0.5                  ? energy > 0.3 * full && energy < 0.8 * full
                                      : isSilent(heard);
    Expect(isRight, "as loud as the force that is sent");
  }
}

void CheckLabels(int argc, char* argv[])
{
  Exploration exploration = ExploreHead(argc, argv);
  vtkPolyData* const trace = exploration.Trace;
  vtkNew<vtkHapticLabelTable> table;
  table->SetStiffness(7, 25.0);
  table->SetSurfaceStrength(7, 9.0);
  table->SetFriction(8, 0.1);
  exploration.Filter->SetLabelTable(table);
  vtkNew<vtkDoubleArray> labels;
  labels->SetName("Label");
  labels->SetNumberOfTuples(trace->GetNumberOfPoints());
  vtkIdType contact = 0;
  while (At(trace, "Contact", contact) == 0.0)
  {
    ++contact;
  }
  const Explore::SoundTick plain =
    Explore::HeardTicks(exploration.Filter).Read(trace)[static_cast<std::size_t>(contact)];
  for (const int label : { 7, 8 })
  {
    labels->Fill(label);
    trace->GetPointData()->AddArray(labels);
    const Explore::SoundTick tick =
      Explore::HeardTicks(exploration.Filter).Read(trace)[static_cast<std::size_t>(contact)];
    Expect(tick.Stiffness == (label == 7 ? 25.0 : plain.Stiffness) &&
        tick.Strength == (label == 7 ? 9.0 : plain.Strength),
      "the material of a label, or of the functions if it has none");
  }
}

Explore::Options Parse(std::vector<std::string> words)
{
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(&word[0]);
  }
  return Explore::ParseOptions(static_cast<int>(arguments.size()), arguments.data());
}

void ExpectError(const std::vector<std::string>& words, const std::string& text)
{
  std::string message;
  try
  {
    Parse(words);
  }
  catch (const Explore::InputError& error)
  {
    message = error.what();
  }
  Expect(message.find(text) != std::string::npos, words.back() + " says " + text);
}

void CheckOptions()
{
  Explore::Options options = Parse({ "program", "--sound", "touch.WAV", "head.vti" });
  Expect(options.SoundFile == "touch.WAV" && !options.Sound && options.VolumePath == "head.vti",
    "a sound file");
  options = Parse({ "program", "--sound=here/touch.wav", "head.vti" });
  Expect(options.SoundFile == "here/touch.wav" && !options.Sound, "a sound file");
  ExpectError({ "program", "head.vti", "--sound=touch.mp3" }, "ends in .wav");
  if (!Explore::SoundOutput::IsAvailable())
  {
    ExpectError({ "program", "head.vti", "--sound" }, "libpulse-dev");
    return;
  }
  options = Parse({ "program", "--sound", "head.vti" });
  Expect(options.Sound && options.SoundFile.empty() && options.VolumePath == "head.vti",
    "sound in the window");
  options = Parse({ "program", "head.vti", "--sound", "--sound", "touch.wav", "--sound" });
  Expect(options.Sound && options.SoundFile == "touch.wav", "both");
}
} // namespace

int TestExploreSound(int argc, char* argv[])
{
  CheckTissues(argc, argv);
  CheckPath(argc, argv);
  CheckLabels(argc, argv);
  CheckOptions();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects that every method has acceptable forces on the same path over the same head, and that the
// output contains the method's name.
#include "Applications/Explorer/HelpText.h"
#include "Applications/Explorer/Options.h"
#include "Applications/Explorer/Report/TraceSummary.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeOrientation.h"

#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkHapticMode.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"
#include "vtkXMLImageDataWriter.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace
{
Explore::Options Parse(std::vector<std::string> words)
{
  std::vector<char*> arguments;
  for (std::string& word : words)
  {
    arguments.push_back(&word[0]);
  }
  return Explore::ParseOptions(static_cast<int>(arguments.size()), arguments.data());
}

/// Returns the largest magnitude of an array of the trace during a phase.
double Largest(const Explore::Exploration& e, const char* array, const std::string& phase)
{
  vtkDataArray* const values = e.Trace->GetPointData()->GetArray(array);
  double largest = 0.0;
  for (const Explore::Phase& p : e.Tip.Phases)
  {
    for (vtkIdType i = p.First; p.Name == phase && i < p.Last; ++i)
    {
      double sum = 0.0;
      for (int c = 0; c < values->GetNumberOfComponents(); ++c)
      {
        sum += std::pow(values->GetComponent(i, c), 2);
      }
      largest = std::max(largest, std::sqrt(sum));
    }
  }
  return largest;
}
/// Explores a file whose only array is a flow around z, and expects errors for modes that need
/// other arrays.
void ExpectModesOfAFlow(const std::string& head)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(24, 24, 24);
  image->SetOrigin(-11.5, -11.5, -11.5);
  vtkNew<vtkFloatArray> flow;
  flow->SetName("flow");
  flow->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* const x = image->GetPoint(i);
    const double fall = std::exp(-0.02 * (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]));
    flow->InsertNextTuple3(-x[1] * fall, x[0] * fall, 0.0);
  }
  image->GetPointData()->AddArray(flow);
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName("ExploreFlow.vti");
  writer->SetInputData(image);
  writer->Write();
  const Explore::Volume volume = Explore::LoadVolume("ExploreFlow.vti");
  vtkDataArray* const kept = volume.Image->GetPointData()->GetArray("flow");
  Expect(kept && kept->GetComponent(100, 1) == flow->GetComponent(100, 1), "vectors are kept");
  Expect(volume.Image->GetPointData()->GetScalars()->GetNumberOfComponents() == 1,
    "their magnitude is seen");
  const Explore::Options options =
    Parse({ "explore", "ExploreFlow.vti", "--mode", "vortex", "--mode=vector-follow:flow" });
  Expect(options.How.Method == "primitives", "a mode chooses its method");
  const Explore::Exploration e = Explore::ExploreVolume(volume, options.How);
  Expect(e.Filter->GetNumberOfModes() == 2, "both modes are there");
  Expect(
    Largest(e, "ModeForce_0", "slide outside") + Largest(e, "ModeForce_1", "slide outside") > 0.0,
    "the flow is felt");
  const Explore::Options wanted =
    Parse({ "explore", "ExploreFlow.vti", "--mode", "Find a vortex" });
  Expect(wanted.How.Method == "primitives", "a preset chooses its method");
  const Explore::Exploration found = Explore::ExploreVolume(volume, wanted.How);
  Expect(found.Filter->GetMode(0)->GetKind() == vtkHapticMode::VORTEX, "a preset makes its mode");
  for (const std::string mode :
    { "vector-follow", "tensor-follow", "spin", "ridge:flow", "Slide along fibres" })
  {
    std::string said;
    try
    {
      const Explore::Options wrong = Parse({ "explore", head, "--mode", mode });
      Explore::ExploreVolume(Explore::LoadVolume(head), wrong.How);
    }
    catch (const Explore::InputError& error)
    {
      said = error.what();
    }
    Expect(said.find("--mode") != std::string::npos && said.find(mode) != std::string::npos,
      "an error names " + mode);
  }
}
} // namespace

int TestExploreMethods(int argc, char* argv[])
{
  const std::string volume = Argument(argc, argv, "--volume");
  const Explore::Exploration proxy = ExploreHead(argc, argv);
  vtkStringArray* const names = vtkVolumeHapticsFilter::GetMethodNames();
  const std::string help = Explore::HelpText();
  for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
  {
    const std::string name = names->GetValue(i);
    const Explore::Options options = Parse({ "explore", volume, "--method", name });
    Expect(options.How.Method == name && help.find(name) != std::string::npos, name + " is known");
    const Explore::Exploration e = ExploreHead(argc, argv, options.How);
    Expect(e.Filter->GetMethodName() == name, name + " is used");
    Expect(Explore::Summarise(e).find("method \"" + e.Filter->GetMethodText()) != std::string::npos,
      "the summary names " + name);
    vtkDataArray* const tips = e.Trace->GetPointData()->GetArray("Tip");
    vtkDataArray* const same = proxy.Trace->GetPointData()->GetArray("Tip");
    bool isSame = tips->GetNumberOfTuples() == same->GetNumberOfTuples();
    for (vtkIdType k = 0; isSame && k < 3 * tips->GetNumberOfTuples(); ++k)
    {
      isSame = tips->GetVariantValue(k) == same->GetVariantValue(k);
    }
    Expect(isSame, name + " feels the same path");
    const double skin = Largest(e, "Force", "slide outside");
    std::cout << name << ": " << skin << " N on the skin\n";
    Expect(skin > 0.1 && skin < 5.0, name + " is felt on the skin, and bearable");
    if (e.Filter->GetMethod() == vtkVolumeHapticsFilter::FORCE_FIELD)
    {
      const double gain = e.Filter->GetForceFieldGain();
      const double gradient = Largest(e, "GradientMagnitude", "slide outside");
      Expect(std::abs(skin - gain * gradient) < 1e-9, "the force is the gain times the gradient");
      Expect(skin > 0.5 && skin < 1.5, "the sharpest skin pushes with 1 N or so");
    }
  }
  Expect(proxy.Filter->GetIsoValue() == proxy.Values.OuterThreshold, "the surface is the skin");
  Explore::Volume large = Explore::LoadVolume(volume);
  Explore::ScaleLengths(large.Image, 1.5);
  const double gain = Explore::ExploreVolume(large, {}).Filter->GetForceFieldGain();
  Expect(std::abs(gain / proxy.Filter->GetForceFieldGain() - 1.5) < 0.01,
    "a larger head, less sharp, pushes as much");
  std::string message;
  try
  {
    Parse({ "explore", volume, "--method=spring" });
  }
  catch (const Explore::InputError& error)
  {
    message = error.what();
  }
  Expect(message.find("force-field") != std::string::npos, "another name lists the known ones");
  ExpectModesOfAFlow(volume);
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

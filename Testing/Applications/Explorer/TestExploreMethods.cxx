// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Every method feels the same path over the same head, with forces that a hand can bear, and the
// output says which it was.
#include "Applications/Explorer/Errors/InputError.h"
#include "Applications/Explorer/Options.h"
#include "Applications/Explorer/Report/TraceSummary.h"
#include "Applications/Explorer/Volume/VolumeOrientation.h"
#include "Expectations.h"
#include "HeadExploration.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

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

/// The largest norm of an array of the trace in a phase.
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
    if (name == "primitives")
    {
      continue; // it feels modes, of which the explorer has none
    }
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
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

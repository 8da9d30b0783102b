// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * volumehaptics-evaluation [--quick] [--volume FILE.mhd] [--output FOLDER]
 *
 * Measures the figures of Documentation/evaluation.md for PAPER and PRECISE, compares them with
 * other methods, prints the tables, and writes a report with plots to FOLDER (default: evaluation).
 * The exit status is the number of figures (times aside) that PRECISE does not reach with the
 * default estimator or the B-spline, and of false alarms about honest devices. --quick takes
 * seconds instead of minutes.
 */
#include "RealVolume.h"
#include "Report.h"
#include "TransferPicture.h"

#include "vtkImageData.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cstdio>
#include <cstring>

using namespace evaluation;
using namespace VolumeHaptics;

namespace
{
constexpr std::pair<const char*, GradientEstimator> Estimators[] = {
  { "Gaussian", GradientEstimator::Gaussian },
  { "Cubic B-spline", GradientEstimator::CubicBSpline },
};

Figures MeasureAll(const Candidate& candidate, const Effort& effort)
{
  Figures all;
  for (const auto& measure : { MeasureClosedForms, MeasureTracking, MeasureFallThrough,
         MeasureRipple, MeasureEnergy, MeasureAngle, MeasureAlignment, MeasureSpeed })
  {
    const Figures figures = measure(candidate, effort);
    all.insert(all.end(), figures.begin(), figures.end());
  }
  return all;
}
} // namespace

int main(int argc, char* argv[])
{
  Effort effort{ true };
  std::string volume;
  std::string folder = "evaluation";
  for (int i = 1; i < argc; ++i)
  {
    const bool hasValue = i + 1 < argc;
    if (std::strcmp(argv[i], "--quick") == 0)
    {
      effort.IsFull = false;
    }
    else if (std::strcmp(argv[i], "--volume") == 0 && hasValue)
    {
      volume = argv[++i];
    }
    else if (std::strcmp(argv[i], "--output") == 0 && hasValue)
    {
      folder = argv[++i];
    }
    else
    {
      std::fprintf(stderr, "usage: %s [--quick] [--volume FILE.mhd] [--output FOLDER]\n", argv[0]);
      return 255;
    }
  }
  if (!vtksys::SystemTools::MakeDirectory(folder))
  {
    std::fprintf(
      stderr, "The folder %s can't be made. Name another with --output.\n", folder.c_str());
    return 255;
  }
  vtkSmartPointer<vtkImageData> image;
  if (!volume.empty() && !(image = ReadRealVolume(volume)))
  {
    return 255;
  }
  std::vector<Section> sections;
  for (const auto& [name, estimator] : Estimators)
  {
    sections.push_back({ name, MeasureAll({ HapticSolver::Paper, estimator }, effort),
      MeasureAll({ HapticSolver::Precise, estimator }, effort) });
  }
  if (image)
  {
    sections.push_back({ "A real CT", MeasureRealVolume(image, HapticSolver::Paper, effort),
      MeasureRealVolume(image, HapticSolver::Precise, effort) });
  }
  int missed = PrintSections(sections);
  const Report report{ sections, MakePlots(effort), CompareMethods(image, effort),
    DrawTransferPicture(volume, effort, folder),
    MeasurePortSafety(effort.Pick(50, 1000), effort.Pick(2, 20)) };
  PrintComparison(report.Methods);
  PrintSafety(report.Safety);
  missed += report.Safety.Alarms;
  for (const std::vector<Plot>& plots : { report.Plots, report.Methods.Plots })
  {
    for (const Plot& plot : plots)
    {
      DrawPlot(plot, folder);
    }
  }
  if (!WriteReport(report, folder))
  {
    std::fprintf(stderr, "%s/report.md can't be written.\n", folder.c_str());
    return 255;
  }
  std::printf("\n%d figures not reached. Report: %s/report.md\n", missed, folder.c_str());
  return std::min(missed, 254);
}

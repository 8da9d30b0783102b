// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * volumehaptics-evaluation [--quick] [--volume FILE] [--chest FOLDER] [--mri FILE] [--feel]
 *   [--output FOLDER]
 *
 * Measures the figures of Documentation/evaluation.md for PAPER and PRECISE, compares them with
 * other methods, prints the tables, and writes a report with plots to FOLDER (default: evaluation).
 * The exit status is the number of figures (times aside) that PRECISE does not reach with the
 * default estimator or the B-spline, and of false alarms about honest devices. --quick takes
 * seconds instead of minutes. --volume is a CT of a head, --chest a folder with cxr.nii.gz,
 * mask.nii.gz and structures.csv, --mri a T1-weighted MRI of a head: scans to be felt. --feel
 * measures only how these feel.
 */
#include "BumpyBall.h"
#include "Feel.h"
#include "Palpation.h"
#include "Proposals.h"
#include "RealVolume.h"
#include "Report.h"
#include "Scans.h"
#include "TickRatio.h"
#include "TransferPicture.h"

#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
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
         MeasureRipple, MeasureEnergy, MeasureAngle, MeasureAlignment, MeasureBumps, MeasureSpeed })
  {
    const Figures figures = measure(candidate, effort);
    all.insert(all.end(), figures.begin(), figures.end());
  }
  return all;
}

/**
 * How many of the four tissues of the head CT an ideal hand told apart, under constant force and at
 * constant depth, before materials were looked for behind an edge: 2.94 and 2.95.
 */
constexpr double CorrectBefore[] = { 2.93, 2.94 };

/** How much longer a tick takes by what is not the paper's: at most a quarter. */
Figures MeasureTickRatios(const std::vector<FeltSurface>& surfaces, const Scans& scans)
{
  Figures figures;
  for (const FeltSurface& surface : surfaces)
  {
    const std::string on = " over that without, " + surface.Scan + ", " + surface.Name;
    const auto without = [](vtkVolumeHapticsFilter* filter)
    {
      filter->SetMaterialPlacementToKernel();
      filter->SetContactAlignmentToDistinctness();
    };
    if (surface.Scan == "head CT")
    {
      const auto byDefault = [](vtkVolumeHapticsFilter*) {};
      figures.push_back({ "tick, median, with far side and Edge" + on, "times",
        MeasureTickRatio(surface, byDefault, without), 1.25, true });
    }
    else if (surface.Scan == "chest CT")
    {
      const auto labels = [&](vtkVolumeHapticsFilter* filter)
      {
        without(filter);
        filter->SetLabelData(scans.ChestLabels);
        filter->SetLabelTable(MakeLabelTable(scans.Names, filter->GetProperty()));
      };
      figures.push_back({ "tick, median, with labels" + on, "times",
        MeasureTickRatio(surface, labels, without), 1.25, true });
    }
  }
  return figures;
}

/** Surfaces of all scans, the ideal hand, and the bumpy ball. */
Feel MeasureScans(const Scans& scans, const Effort& effort)
{
  std::vector<FeltSurface> surfaces;
  const auto add = [&](const std::vector<FeltSurface>& more)
  { surfaces.insert(surfaces.end(), more.begin(), more.end()); };
  if (scans.Head)
  {
    add(FindHeadSurfaces(scans.Head, effort));
  }
  if (scans.Chest)
  {
    const NeedleLabels sorted = SortLabels(scans.Names);
    const int liver = sorted.Liver.empty() ? 0 : *sorted.Liver.begin();
    add(FindChestSurfaces(scans.Chest, scans.ChestLabels, liver, effort));
  }
  if (scans.Mri)
  {
    add(FindMriSurfaces(scans.Mri, effort));
  }
  Feel feel = MeasureFeel(surfaces);
  for (const Figure& figure : MeasureTickRatios(surfaces, scans))
  {
    feel.Required.push_back(figure);
  }
  if (scans.Chest)
  {
    RunNeedleProtocol(
      scans.Chest, scans.ChestLabels, scans.Names, effort.Pick(20, 2000), feel.Found);
  }
  Table proposals = MakeProposalTable();
  for (const auto& [name, image] : { std::pair<const char*, vtkImageData*>{ "head CT", scans.Head },
         { "chest CT", scans.Chest }, { "MRI", scans.Mri } })
  {
    if (image)
    {
      AddProposal(name, image, proposals);
    }
  }
  if (!proposals.Rows.empty())
  {
    feel.Found.Tables.push_back(proposals);
  }
  if (scans.Head)
  {
    feel.Required.push_back(CountMissingBoundaries(scans.Head));
  }
  feel.Found.Tables.push_back(CompareOnBumpyBall(effort));
  feel.Found.Tables.push_back(IdentifyOnSlabs("CT contrast").Confusions);
  if (scans.Head)
  {
    const Identification found = IdentifyOnHead(surfaces, "CT contrast", effort);
    feel.Found.Tables.push_back(found.Confusions);
    for (std::size_t i = 0; effort.IsFull && i < found.Correct.size(); ++i)
    {
      feel.Required.push_back({ std::string("tissues that the ideal hand mistakes, of 4, ") +
          NameOf(i == 0 ? HandStrategy::ConstantForce : HandStrategy::ConstantDepth),
        "", static_cast<double>(found.Tissues) - found.Correct[i],
        static_cast<double>(found.Tissues) - CorrectBefore[i] });
    }
  }
  return feel;
}
} // namespace

int main(int argc, char* argv[])
{
  Effort effort{ true };
  std::string volume;
  std::string chest;
  std::string mri;
  std::string folder = "evaluation";
  bool isFeelAlone = false;
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
    else if (std::strcmp(argv[i], "--chest") == 0 && hasValue)
    {
      chest = argv[++i];
    }
    else if (std::strcmp(argv[i], "--mri") == 0 && hasValue)
    {
      mri = argv[++i];
    }
    else if (std::strcmp(argv[i], "--feel") == 0)
    {
      isFeelAlone = true;
    }
    else if (std::strcmp(argv[i], "--output") == 0 && hasValue)
    {
      folder = argv[++i];
    }
    else
    {
      std::fprintf(stderr,
        "usage: %s [--quick] [--volume FILE] [--chest FOLDER] [--mri FILE] [--feel]\n"
        "  [--output FOLDER]\n",
        argv[0]);
      return 255;
    }
  }
  if (!vtksys::SystemTools::MakeDirectory(folder))
  {
    std::fprintf(
      stderr, "The folder %s can't be made. Name another with --output.\n", folder.c_str());
    return 255;
  }
  Scans scans;
  if ((!volume.empty() && !(scans.Head = ReadScan(volume))) ||
    (!chest.empty() && !ReadChest(chest, scans)) || (!mri.empty() && !(scans.Mri = ReadScan(mri))))
  {
    return 255;
  }
  Report report;
  report.Scans = MeasureScans(scans, effort);
  if (!isFeelAlone)
  {
    for (const auto& [name, estimator] : Estimators)
    {
      report.Sections.push_back({ name, MeasureAll({ HapticSolver::Paper, estimator }, effort),
        MeasureAll({ HapticSolver::Precise, estimator }, effort) });
    }
    if (scans.Head)
    {
      report.Sections.push_back(
        { "A real CT", MeasureRealVolume(scans.Head, HapticSolver::Paper, effort),
          MeasureRealVolume(scans.Head, HapticSolver::Precise, effort) });
    }
    report.Plots = MakePlots(effort);
    report.Methods = CompareMethods(scans.Head, effort);
    report.Transfer = DrawTransferPicture(volume, effort, folder);
    report.Safety = MeasurePortSafety(effort.Pick(50, 1000), effort.Pick(2, 20));
  }
  report.Sections.push_back({ "Felt where it is seen", {}, MeasureBumpyBall(effort) });
  if (!report.Scans.Required.empty())
  {
    report.Sections.push_back({ "The feel of real scans", {}, report.Scans.Required });
  }
  int missed = PrintSections(report.Sections);
  PrintFeel(report.Scans);
  PrintComparison(report.Methods);
  PrintSafety(report.Safety);
  missed += report.Safety.Alarms;
  for (const std::vector<Plot>& plots :
    { report.Plots, report.Scans.Found.Plots, report.Methods.Plots })
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

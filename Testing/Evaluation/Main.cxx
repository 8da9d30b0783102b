// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * volumehaptics-evaluation [--quick] [--volume FILE] [--chest FOLDER] [--mri FILE]
 *   [--scans FOLDER] [--feel] [--table] [--only TEXT] [--output FOLDER]
 *
 * Measures the figures of Documentation/evaluation.md for PAPER and PRECISE, compares them with
 * other methods, prints the tables, and writes a report with plots to FOLDER (default: evaluation).
 * The exit status is the number of figures, without times, that PRECISE does not reach with the
 * default estimator or the B-spline, plus the number of false alarms about honest devices. --quick
 * takes seconds instead of minutes. Scans to be felt: --volume is a CT of a head, --chest a folder
 * with cxr.nii.gz, mask.nii.gz and structures.csv, --mri a T1-weighted MRI of a head; --scans is
 * the folder of all other volumes (see get_real_volumes in Data/scans.sh). --feel measures only how
 * the scans feel, --table only the table of all real volumes, --only the lines that have TEXT in
 * "volume, preset". Tables are printed as soon as they are measured. Without a display there are no
 * plots.
 */
#include "BumpyBall.h"
#include "Feel.h"
#include "InsideTissues.h"
#include "Palpation.h"
#include "Parts.h"
#include "Proposals.h"
#include "RealVolume.h"
#include "RealVolumes.h"
#include "Report.h"
#include "Scans.h"
#include "TickRatio.h"
#include "TransferPicture.h"

#include "Applications/Explorer/View/Display.h"

#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkImageData.h"
#include "vtksys/SystemTools.hxx"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <iterator>

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
  for (const auto& measure :
    { MeasureClosedForms, MeasureTracking, MeasureFallThrough, MeasureRipple, MeasureEnergy,
      MeasureAngle, MeasureAlignment, MeasureBumps, MeasureMovingWall, MeasureSpeed })
  {
    const Figures figures = measure(candidate, effort);
    all.insert(all.end(), figures.begin(), figures.end());
  }
  return all;
}

/**
 * Number of tissues, of the head CT's four, that an ideal hand must identify correctly under
 * constant force and at constant depth. Before materials were read behind an edge, the numbers were
 * 2.94 and 2.95.
 */
constexpr double CorrectBefore[] = { 2.93, 2.94 };

/**
 * Measures the cost of a tick with the features that the paper lacks, relative to a tick without
 * them. The bound is a factor of 1.25.
 */
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

/** Adds a table to the results, and prints it. */
void Tell(const Table& table, Comparison& found)
{
  PrintTable(table);
  found.Tables.push_back(table);
}

/**
 * Adds a section to the report, and prints it. Returns the number of figures that miss their
 * bounds.
 */
int Tell(const Section& section, Report& report)
{
  report.Sections.push_back(section);
  return PrintSection(section);
}

/**
 * Measures the surfaces of all scans, the ideal hand, and the bumpy ball. Prints each table as soon
 * as it is complete.
 */
Feel MeasureScans(const Scans& scans, const Effort& effort)
{
  PrintFeelTitle();
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
    add(FindLabelSurfaces(scans.ChestLabels, liver, effort));
  }
  if (scans.Mri)
  {
    add(FindMriSurfaces(scans.Mri, effort));
  }
  const std::vector<FeltSurface> parts = MakePartSurfaces(effort);
  add(parts);
  Feel feel = MeasureFeel(surfaces);
  std::for_each(feel.Found.Tables.begin(), feel.Found.Tables.end(), PrintTable);
  Tell(ComparePresets(surfaces), feel.Found);
  Tell(ComparePartsWithFormulas(parts), feel.Found);
  for (const Figure& figure : MeasureTickRatios(surfaces, scans))
  {
    feel.Required.push_back(figure);
  }
  if (scans.Chest)
  {
    Comparison needles;
    RunNeedleProtocol(scans.Chest, scans.ChestLabels, scans.Names, effort.Pick(20, 2000), needles);
    for (const Table& table : needles.Tables)
    {
      Tell(table, feel.Found);
    }
    std::copy(needles.Plots.begin(), needles.Plots.end(), std::back_inserter(feel.Found.Plots));
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
    Tell(proposals, feel.Found);
  }
  if (scans.Head)
  {
    feel.Required.push_back(CountMissingBoundaries(scans.Head));
  }
  if (scans.Head || scans.Chest)
  {
    Tell(MeasureInsideTissues(scans, effort), feel.Found);
  }
  Tell(CompareOnBumpyBall(effort), feel.Found);
  Tell(IdentifyOnSlabs("CT contrast").Confusions, feel.Found);
  if (scans.Head)
  {
    const Identification found = IdentifyOnHead(surfaces, "CT contrast", effort);
    Tell(found.Confusions, feel.Found);
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

void DrawAll(const Report& report, const std::string& folder)
{
  for (const std::vector<Plot>* plots :
    { &report.Plots, &report.Scans.Found.Plots, &report.Methods.Plots })
  {
    for (const Plot& plot : *plots)
    {
      DrawPlot(plot, folder);
    }
  }
}
} // namespace

int main(int argc, char* argv[])
{
  Effort effort{ true };
  std::string volume;
  std::string chest;
  std::string mri;
  std::string folder = "evaluation";
  std::string others;
  std::string only;
  bool isFeelAlone = false;
  bool isTableAlone = false;
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
    else if (std::strcmp(argv[i], "--scans") == 0 && hasValue)
    {
      others = argv[++i];
    }
    else if (std::strcmp(argv[i], "--only") == 0 && hasValue)
    {
      only = argv[++i];
    }
    else if (std::strcmp(argv[i], "--table") == 0)
    {
      isTableAlone = true;
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
        "usage: %s [--quick] [--volume FILE] [--chest FOLDER] [--mri FILE] [--scans FOLDER]\n"
        "  [--feel] [--table] [--only TEXT] [--output FOLDER]\n",
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
  const VolumePlaces places{ volume, chest, others, only };
  if (isTableAlone)
  {
    PrintTable(MeasureRealVolumes(places, effort));
    return 0;
  }
  Scans scans;
  if ((!volume.empty() && !(scans.Head = ReadScan(volume))) ||
    (!chest.empty() && !ReadChest(chest, scans)) || (!mri.empty() && !(scans.Mri = ReadScan(mri))))
  {
    return 255;
  }
  Report report;
  report.Scans = MeasureScans(scans, effort);
  if (!volume.empty() || !chest.empty() || !others.empty())
  {
    Tell(MeasureRealVolumes(places, effort), report.Scans.Found);
  }
  int missed = Tell({ "Felt where it is seen", {}, MeasureBumpyBall(effort) }, report);
  if (!report.Scans.Required.empty())
  {
    missed += Tell({ "The feel of real scans", {}, report.Scans.Required }, report);
  }
  if (!isFeelAlone)
  {
    for (const auto& [name, estimator] : Estimators)
    {
      missed += Tell({ name, MeasureAll({ HapticSolver::Paper, estimator }, effort),
                       MeasureAll({ HapticSolver::Precise, estimator }, effort) },
        report);
    }
    if (scans.Head)
    {
      missed += Tell({ "A real CT", MeasureRealVolume(scans.Head, HapticSolver::Paper, effort),
                       MeasureRealVolume(scans.Head, HapticSolver::Precise, effort) },
        report);
    }
    report.Plots = MakePlots(effort);
    report.Methods = CompareMethods(scans.Head, effort);
    PrintComparison(report.Methods);
    report.Safety = MeasurePortSafety(effort.Pick(50, 1000), effort.Pick(2, 20));
    PrintSafety(report.Safety);
    missed += report.Safety.Alarms;
  }
  if (Explore::HasDisplay())
  {
    DrawAll(report, folder);
    if (!isFeelAlone)
    {
      report.Transfer = DrawTransferPicture(volume, effort, folder);
    }
  }
  else
  {
    std::fprintf(stderr,
      "There is no X display for the plots: the report has its tables alone. Cure: run the program "
      "as 'xvfb-run -a volumehaptics-evaluation ...'.\n");
    report.Plots.clear();
    report.Scans.Found.Plots.clear();
    report.Methods.Plots.clear();
  }
  if (!WriteReport(report, folder))
  {
    std::fprintf(stderr, "%s/report.md can't be written.\n", folder.c_str());
    return 255;
  }
  std::printf("\n%d figures not reached. Report: %s/report.md\n", missed, folder.c_str());
  return std::min(missed, 254);
}

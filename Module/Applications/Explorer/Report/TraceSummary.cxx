// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Report/TraceSummary.h"

#include "Applications/Explorer/Exploration/TissueTable.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace
{
using Explore::Exploration;

constexpr double LEAST_FELT = 0.01; // N
constexpr const char* CONTACTS[] = { "free", "sticking", "sliding", "penetrating" };

/// The columns of the trace.
struct Columns
{
  explicit Columns(vtkPolyData* trace)
    : Count(trace->GetNumberOfPoints())
    , Time(trace->GetPointData()->GetArray("Time"))
    , Tip(trace->GetPointData()->GetArray("Tip"))
    , Force(trace->GetPointData()->GetArray("Force"))
    , Contact(trace->GetPointData()->GetArray("Contact"))
    , SurfaceValue(trace->GetPointData()->GetArray("SurfaceValue"))
  {
  }

  double Newtons(vtkIdType i) const
  {
    double force[3];
    this->Force->GetTuple(i, force);
    return vtkMath::Norm(force);
  }

  int State(vtkIdType i) const
  {
    return std::clamp(static_cast<int>(this->Contact->GetComponent(i, 0)), 0, 3);
  }

  vtkIdType Count;
  vtkDataArray *Time, *Tip, *Force, *Contact, *SurfaceValue;
};

struct Share
{
  vtkIdType Ticks = 0;
  double Sum = 0.0;
  double Largest = 0.0;

  void Add(double newtons)
  {
    this->Ticks += 1;
    this->Sum += newtons;
    this->Largest = std::max(this->Largest, newtons);
  }
};

/// Returns whether the trace has values at surfaces, which the method PRIMITIVES does not write.
bool HasSurfaces(const Exploration& e)
{
  return e.Filter->GetMethod() != vtkVolumeHapticsFilter::PRIMITIVES;
}

/// Returns the tissues that can be distinguished by the values at surfaces.
std::vector<Explore::Tissue> CollectTissues(const Exploration& e)
{
  return HasSurfaces(e) ? Explore::MakeTissueTable(e.Values) : std::vector<Explore::Tissue>();
}

double PathLength(vtkDataArray* positions)
{
  double length = 0.0;
  for (vtkIdType i = 1; i < positions->GetNumberOfTuples(); ++i)
  {
    double a[3], b[3];
    positions->GetTuple(i - 1, a);
    positions->GetTuple(i, b);
    length += std::sqrt(vtkMath::Distance2BetweenPoints(a, b));
  }
  return length;
}

void WriteRow(
  std::ostream& out, const std::string& name, const Share& share, double dt, vtkIdType all)
{
  out << "  " << std::left << std::setw(28) << name << std::right << std::fixed
      << std::setprecision(2) << std::setw(8) << share.Ticks * dt << " s" << std::setprecision(1)
      << std::setw(8) << 100.0 * share.Ticks / std::max<vtkIdType>(1, all) << " %"
      << std::setprecision(2) << std::setw(10) << (share.Ticks ? share.Sum / share.Ticks : 0.0)
      << " N" << std::setw(10) << share.Largest << " N\n";
}

void WriteHeader(std::ostream& out, const std::string& title)
{
  out << "\n"
      << std::left << std::setw(30) << title << std::right << std::setw(10) << "time"
      << std::setw(10) << "share" << std::setw(12) << "mean force" << std::setw(12) << "largest"
      << "\n";
}

void WriteVolume(std::ostream& out, const Exploration& e)
{
  const int* size = e.Input.Image->GetDimensions();
  const double* spacing = e.Input.Image->GetSpacing();
  out << "Volume\n  " << e.Input.Name << " (" << e.Input.Format << "), " << size[0] << " x "
      << size[1] << " x " << size[2] << " voxels of " << spacing[0] << " x " << spacing[1] << " x "
      << spacing[2] << (e.Values.MetersPerWorldUnit == 0.001 ? " mm, " : " world units, ")
      << e.Input.Image->GetScalarTypeAsString() << "\n  " << e.Values.KindReason
      << "\n  outer surface above " << e.Values.OuterThreshold << ", dense structure above "
      << e.Values.DeepThreshold << "\n";
  for (const std::string& note : e.Input.Notes)
  {
    out << "  " << note << "\n";
  }
}

void WriteSettings(std::ostream& out, const Exploration& e, const Columns& columns)
{
  const double scale = e.Values.MetersPerWorldUnit;
  out << "\nHaptics\n  method \"" << e.Method << "\", materials \"" << e.Materials
      << "\", gradient by " << e.Estimator << ", kernel radius " << e.KernelRadius << " voxels\n  "
      << scale * 1000.0 << " mm of hand movement per world unit"
      << (scale == 0.001 ? " (life-size)" : "") << ", servo rate " << e.ServoRate << " Hz\n  "
      << columns.Count << " ticks: " << columns.Count / e.ServoRate << " s, tip moved "
      << std::fixed << std::setprecision(0) << 1000.0 * scale * PathLength(columns.Tip)
      << " mm, proxy " << 1000.0 * scale * PathLength(e.Trace->GetPoints()->GetData()) << " mm\n"
      << std::defaultfloat << std::setprecision(6);
}

void WritePhases(std::ostream& out, const Exploration& e, const Columns& columns)
{
  WriteHeader(out, "What the hand did");
  double outside = 0.0;
  for (const Explore::Phase& phase : e.Tip.Phases)
  {
    Share share;
    for (vtkIdType i = phase.First; i < std::min(phase.Last, columns.Count); ++i)
    {
      share.Add(columns.Newtons(i));
    }
    WriteRow(out, phase.Name, share, 1.0 / e.ServoRate, columns.Count);
    outside = phase.Name == "press" || phase.Name == "slide outside"
      ? std::max(outside, share.Largest)
      : outside;
  }
  if (outside < LEAST_FELT)
  {
    out << "  Nothing is felt on the outer surface, where values reach " << std::defaultfloat
        << e.Values.OuterThreshold
        << ": it has no edge there, or no strength.\n  Cure: use another --preset, or press e in "
           "the window and set the functions.\n";
  }
}

void WriteContacts(std::ostream& out, const Exploration& e, const Columns& columns)
{
  const std::vector<Explore::Tissue> tissues = CollectTissues(e);
  std::vector<Share> states(4), touched(tissues.size());
  vtkIdType contact = 0;
  for (vtkIdType i = 0; i < columns.Count; ++i)
  {
    const int state = columns.State(i);
    states[state].Add(columns.Newtons(i));
    contact += state > 0 ? 1 : 0;
    if (state > 0 && !tissues.empty())
    {
      const double value = columns.SurfaceValue->GetComponent(i, 0);
      touched[Explore::FindTissue(tissues, value)].Add(columns.Newtons(i));
    }
  }
  WriteHeader(out, "Contact state");
  for (int state = 0; state < 4; ++state)
  {
    WriteRow(out, CONTACTS[state], states[state], 1.0 / e.ServoRate, columns.Count);
  }
  if (tissues.empty())
  {
    return;
  }
  WriteHeader(out, "Contact by tissue");
  for (std::size_t i = 0; i < tissues.size(); ++i)
  {
    if (touched[i].Ticks > 0)
    {
      WriteRow(out, tissues[i].Name, touched[i], 1.0 / e.ServoRate, contact);
    }
  }
}

void WriteLargest(std::ostream& out, const Exploration& e, const Columns& columns)
{
  vtkIdType where = 0;
  for (vtkIdType i = 1; i < columns.Count; ++i)
  {
    where = columns.Newtons(i) > columns.Newtons(where) ? i : where;
  }
  std::string doing;
  for (const Explore::Phase& phase : e.Tip.Phases)
  {
    doing = where >= phase.First && where < phase.Last ? phase.Name : doing;
  }
  const std::vector<Explore::Tissue> tissues = CollectTissues(e);
  const double value = columns.SurfaceValue->GetComponent(where, 0);
  double proxy[3];
  e.Trace->GetPoint(where, proxy);
  out << "\nLargest force\n  " << std::fixed << std::setprecision(2) << columns.Newtons(where)
      << " N at " << columns.Time->GetComponent(where, 0) << " s (" << doing << "), proxy at ("
      << std::setprecision(1) << proxy[0] << ", " << proxy[1] << ", " << proxy[2] << ")";
  if (!tissues.empty())
  {
    out << ", on " << tissues[Explore::FindTissue(tissues, value)].Name << " (value "
        << std::setprecision(0) << value << ")";
  }
  else if (HasSurfaces(e))
  {
    out << ", value " << std::defaultfloat << std::setprecision(4) << value;
  }
  out << "\n";
}
} // namespace

namespace Explore
{
std::string Summarise(const Exploration& e)
{
  const Columns columns(e.Trace);
  std::ostringstream out;
  WriteVolume(out, e);
  WriteSettings(out, e, columns);
  WritePhases(out, e, columns);
  WriteContacts(out, e, columns);
  WriteLargest(out, e, columns);
  const double rate = columns.Count / std::max(e.FilterSeconds, 1e-9);
  out << "\nSpeed\n  " << std::fixed << std::setprecision(0) << rate << " ticks per second, "
      << std::setprecision(1) << rate / e.ServoRate
      << " times the servo rate (computed offline, including set-up)\n";
  return out.str();
}
} // namespace Explore

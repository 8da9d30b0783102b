// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Relief.h"

#include "Shapes.h"

#include "vtkImageData.h"
#include "vtkMath.h"

using namespace VolumeHaptics;

namespace evaluation
{
namespace
{
constexpr double Stiffness = 500.0; // N/m
constexpr double Height = 1000.0;
constexpr double Blur = 1.5;    // mm, scale of the relief's edge
constexpr double Depth = 0.5;   // mm: less than the smallest radius of curvature
constexpr double Step = 0.05;   // mm per tick
constexpr double RunIn = 4.0;   // mm before the measured slide
constexpr double Extent = 40.0; // mm, of the slide

/**
 * Depth (mm) at which FORCE_FIELD's force increases most: one blur, including the kernel's, in
 * front of the middle.
 */
const double Flank = std::hypot(Blur, 2.0 * GradientKernel::ScalePerRadius);

/** Height (mm) of a relief above a plane, as a function of the position along OddAside. */
using Wave = std::function<double(double)>;

vtkSmartPointer<vtkImageData> MakeRelief(const Wave& wave)
{
  return SampleImage(
    [&](const Vector3& x)
    {
      const Vector3 from = x - OddCentre;
      return BlurredStep(Dot(from, OddNormal) + wave(Dot(from, OddAside)), Blur, Height);
    },
    28.0);
}

/**
 * Returns a stroke that slides over the relief and back. On the first pass, the edge yields
 * slightly where the hand presses most, so only the way back follows a single level.
 */
Stroke SlideAcross(const Wave& wave, double depth, double extent)
{
  const double first = -0.5 * extent - RunIn;
  const Vector3 under = OddCentre + first * OddAside;
  const Vector3 start = under - wave(first) * OddNormal;
  Stroke stroke{ start, -1.0 * OddNormal, { start }, 0 };
  const Vector3 deep = under + depth * OddNormal;
  MoveTo(stroke.Tips, deep, 0.02);
  MoveTo(stroke.Tips, deep + (RunIn + extent) * OddAside, Step);
  stroke.Pressed = stroke.Tips.size();
  MoveTo(stroke.Tips, deep + RunIn * OddAside, Step);
  return stroke;
}

/**
 * Returns the gain with which the force on a plane has the slope k at the flank, so that methods
 * are comparable.
 */
double CalibrateGain(const Method& method)
{
  Scene plane(MakeRelief([](double) { return 0.0; }), 0.5 * Height);
  plane.SetForceFieldGain(1.0);
  const auto model = plane.Bake(method);
  const auto force = [&](double z) {
    return Norm(Play(*model, { OddCentre + z * OddNormal, OddCentre + z * OddNormal })[1].Force);
  };
  constexpr double small = 0.01; // mm, for the difference quotient
  return 0.001 * Stiffness / ((force(small - Flank) - force(-small - Flank)) / (2.0 * small));
}
} // namespace

double AmplitudeOf(const std::vector<double>& signal, double frequency)
{
  constexpr int count = 4;
  double rows[count][count] = {};
  double right[count] = {};
  for (std::size_t i = 0; i < signal.size(); ++i)
  {
    const double t = static_cast<double>(i);
    const double basis[count] = { std::sin(frequency * t), std::cos(frequency * t), 1.0,
      t / static_cast<double>(signal.size()) };
    for (int a = 0; a < count; ++a)
    {
      right[a] += basis[a] * signal[i];
      for (int b = 0; b < count; ++b)
      {
        rows[a][b] += basis[a] * basis[b];
      }
    }
  }
  double* matrix[count] = { rows[0], rows[1], rows[2], rows[3] };
  const bool isSolved = signal.size() > count && vtkMath::SolveLinearSystem(matrix, right, count);
  return isSolved ? std::hypot(right[0], right[1]) : 0.0;
}

double MeasureRelief(const Method& method, double wavelength)
{
  const double extent = wavelength * std::floor(Extent / wavelength);
  const Wave wave = [&](double x) { return ReliefAmplitude * std::sin(TwoPi / wavelength * x); };
  Scene scene(MakeRelief(wave), 0.5 * Height);
  scene.SetMaterial(Stiffness, 0.0);
  if (!method.HasSurface())
  {
    scene.SetForceFieldGain(CalibrateGain(method));
  }
  const Stroke stroke = SlideAcross(wave, method.HasSurface() ? Depth : -Flank, extent);
  const Trace trace = scene.Feel(method, stroke);
  std::vector<double> forces;
  for (std::size_t i = stroke.Pressed; i < trace.size(); ++i)
  {
    forces.push_back(Dot(trace[i].Force, OddNormal));
  }
  const double step = extent / static_cast<double>(forces.size());
  return AmplitudeOf(forces, TwoPi * step / wavelength) / (0.001 * Stiffness * ReliefAmplitude);
}

double CutOff(const std::vector<double>& wavelengths, const std::vector<double>& responses)
{
  const double level = std::sqrt(0.5);
  for (std::size_t i = wavelengths.size() - 1; i > 0; --i)
  {
    const double low = responses[i - 1];
    const double high = responses[i];
    if (low < level && high >= level)
    {
      const double fraction = (level - low) / (high - low);
      return wavelengths[i - 1] * std::pow(wavelengths[i] / wavelengths[i - 1], fraction);
    }
  }
  return 0.0;
}

Table CompareRelief(const Effort& effort, std::vector<Plot>& plots)
{
  Table table{ "Fine detail: the response to sinusoidal relief",
    "The paper: the ability \"to follow and reconstruct fine details seems to be similar to "
    "that of general haptics\", that is, of FORCE_FIELD. Here: waves of 0.05 mm on a plane "
    "(an edge blurred by 1.5 voxels that lies askew in the grid) under a tip at constant "
    "depth, without friction; entries are the force's amplitude beside k times the relief's "
    "(1: all of it is felt). -3 dB: the wavelength from which on 0.707 is felt. FORCE_FIELD "
    "has the gain that makes it as stiff as the others at the contact.",
    { "method" }, {} };
  std::vector<double> wavelengths = { 2.0, 4.0, 8.0, 20.0 };
  if (effort.IsFull)
  {
    wavelengths = { 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0, 13.0, 16.0, 20.0, 28.0, 40.0 };
  }
  Plot plot{ "relief", "Relief of 0.05 mm: what of it is felt", "wavelength (voxels)",
    "force's amplitude / (k A)", {} };
  for (const double wavelength : wavelengths)
  {
    table.Columns.push_back(Number(wavelength));
    plot.XTicks.emplace_back(std::log10(wavelength), Number(wavelength));
  }
  table.Columns.push_back("-3 dB (voxels)");
  // Draw the first curves wider, so that they stay visible where methods agree.
  float width = 2.0f + 2.5f * static_cast<float>(AllMethods().size() - 1);
  for (const Method& method : AllMethods())
  {
    Curve curve{ method.Name, {}, {}, method.Colour, false, width };
    width -= 2.5f;
    std::vector<double> responses;
    std::vector<std::string> row{ method.Name };
    for (const double wavelength : wavelengths)
    {
      responses.push_back(MeasureRelief(method, wavelength));
      curve.X.push_back(std::log10(wavelength));
      row.push_back(Number(responses.back()));
    }
    curve.Y = responses;
    const double cutOff = CutOff(wavelengths, responses);
    const bool isLow = responses.back() < std::sqrt(0.5);
    row.push_back(cutOff > 0.0 ? Number(cutOff)
        : isLow                ? "above " + Number(wavelengths.back())
                               : "below " + Number(wavelengths.front()));
    table.Rows.push_back(row);
    plot.Curves.push_back(std::move(curve));
  }
  plots.push_back(std::move(plot));
  return table;
}

} // namespace evaluation

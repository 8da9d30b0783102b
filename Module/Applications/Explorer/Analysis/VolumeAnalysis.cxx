// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Analysis/VolumeAnalysis.h"

#include "vtkBoundingBox.h"
#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{
constexpr int BINS = 256;
constexpr double AIR_AND_SKIN_HU = -300.0; // between air (-1000) and the fattest tissue (-150)
constexpr double BONE_HU = 300.0;
constexpr vtkIdType ENOUGH_SAMPLES = 4000000;

using Histogram = std::array<double, BINS>;

/// Returns the finite values among every n-th value. n is odd, so that the samples are not all from
/// one column.
std::vector<float> SampleValues(vtkDataArray* scalars)
{
  const vtkIdType count = scalars->GetNumberOfTuples();
  const vtkIdType step = count > ENOUGH_SAMPLES ? (count / ENOUGH_SAMPLES) | 1 : 1;
  std::vector<float> values;
  values.reserve(count / step + 1);
  for (vtkIdType i = 0; i < count; i += step)
  {
    const double value = scalars->GetComponent(i, 0);
    if (std::isfinite(value))
    {
      values.push_back(static_cast<float>(value));
    }
  }
  return values;
}

double Percentile(std::vector<float>& values, double fraction)
{
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(fraction * (values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Returns the two thresholds of Otsu's method for three classes, which maximise the variance
/// between the classes.
std::array<int, 2> OtsuCuts(const Histogram& histogram)
{
  Histogram weight{}, moment{};
  double w = 0.0, m = 0.0;
  for (int i = 0; i < BINS; ++i)
  {
    weight[i] = w += histogram[i];
    moment[i] = m += histogram[i] * i;
  }
  const auto term = [&](int from, int to) { // bins from + 1 to `to`
    const double mass = weight[to] - (from < 0 ? 0.0 : weight[from]);
    const double sum = moment[to] - (from < 0 ? 0.0 : moment[from]);
    return mass > 0.0 ? sum * sum / mass : 0.0;
  };
  std::array<int, 2> best{ BINS / 3, 2 * BINS / 3 };
  double bestValue = -1.0;
  for (int a = 0; a < BINS - 2; ++a)
  {
    for (int b = a + 1; b < BINS - 1; ++b)
    {
      const double value = term(-1, a) + term(a, b) + term(b, BINS - 1);
      if (value > bestValue)
      {
        bestValue = value;
        best = { a, b };
      }
    }
  }
  return best;
}

void SetThresholds(Explore::Analysis& analysis, const std::vector<float>& values)
{
  if (analysis.Kind == Explore::VolumeKind::CT)
  {
    analysis.OuterThreshold = AIR_AND_SKIN_HU;
    analysis.DeepThreshold = BONE_HU;
    return;
  }
  if (analysis.Kind == Explore::VolumeKind::Labels)
  {
    analysis.OuterThreshold = 0.5; // between 0, the background, and the first label
    analysis.DeepThreshold = std::max(1.5, 0.5 * analysis.Range[1]);
    return;
  }
  Histogram histogram{};
  const double width = (analysis.High - analysis.Low) / BINS;
  for (const float value : values)
  {
    const double bin = std::floor((value - analysis.Low) / width);
    histogram[static_cast<int>(std::clamp(bin, 0.0, BINS - 1.0))] += 1.0;
  }
  const std::array<int, 2> cuts = OtsuCuts(histogram);
  analysis.OuterThreshold = analysis.Low + (cuts[0] + 1) * width;
  analysis.DeepThreshold = analysis.Low + (cuts[1] + 1) * width;
}

void SetKind(
  Explore::Analysis& analysis, int scalarType, bool isField, bool areLabels, bool mayBeHounsfield)
{
  std::ostringstream reason;
  reason << "values " << analysis.Range[0] << " to " << analysis.Range[1];
  const bool whole = scalarType != VTK_FLOAT && scalarType != VTK_DOUBLE;
  if (areLabels)
  {
    analysis.Kind = Explore::VolumeKind::Labels;
    reason << " are label numbers";
  }
  else if (isField)
  {
    analysis.Kind = Explore::VolumeKind::Field;
    reason << " of a field: thresholds from the histogram";
  }
  else if (mayBeHounsfield && analysis.Range[0] <= -500.0 && analysis.Range[0] >= -4096.0 &&
    analysis.Range[1] >= 300.0 && analysis.Range[1] <= 40000.0)
  {
    analysis.Kind = Explore::VolumeKind::CT;
    reason << " look like Hounsfield units: treated as CT";
  }
  else if (whole && analysis.Range[0] >= 0.0 && analysis.Range[1] <= 255.0)
  {
    analysis.Kind = Explore::VolumeKind::EightBit;
    reason << " fit into 8 bits: thresholds from the histogram";
  }
  else
  {
    reason << " are neither Hounsfield units nor 8-bit: thresholds from the histogram";
  }
  analysis.KindReason = reason.str();
}

void SetScale(Explore::Analysis& analysis, vtkImageData* image)
{
  // Use life-size if the bounds, in millimetres, are those of an object that fits in a hand;
  // otherwise scale to 20 cm.
  double largest = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    largest = std::max(largest, image->GetSpacing()[axis] * (image->GetDimensions()[axis] - 1));
  }
  analysis.Voxel = *std::min_element(image->GetSpacing(), image->GetSpacing() + 3);
  analysis.MetersPerWorldUnit = largest > 50.0 && largest < 1000.0 ? 0.001 : 0.2 / largest;
}
} // namespace

namespace Explore
{
Analysis AnalyseVolume(vtkImageData* image, bool isField, bool areLabels, bool mayBeHounsfield)
{
  Analysis analysis;
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  scalars->GetFiniteRange(analysis.Range, 0);
  SetKind(analysis, scalars->GetDataType(), isField, areLabels, mayBeHounsfield);
  std::vector<float> values = SampleValues(scalars);
  analysis.Low = Percentile(values, 0.005);
  analysis.High = Percentile(values, 0.995);
  if (!(analysis.Low < analysis.High))
  {
    analysis.Low = analysis.Range[0];
    analysis.High = analysis.Range[1];
  }
  SetThresholds(analysis, values);
  SetScale(analysis, image);
  return analysis;
}

void MeasureBody(Analysis& analysis, vtkImageData* image)
{
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  const int* size = image->GetDimensions();
  const int step = std::max(1, std::max({ size[0], size[1], size[2] }) / 96);
  const int* extent = image->GetExtent();
  double sum[3] = { 0, 0, 0 }, count = 0;
  vtkBoundingBox body;
  for (int k = extent[4]; k <= extent[5]; k += step)
  {
    for (int j = extent[2]; j <= extent[3]; j += step)
    {
      for (int i = extent[0]; i <= extent[1]; i += step)
      {
        int index[3] = { i, j, k };
        if (scalars->GetComponent(image->ComputePointId(index), 0) > analysis.OuterThreshold)
        {
          double position[3];
          image->TransformIndexToPhysicalPoint(index, position);
          body.AddPoint(position);
          vtkMath::Add(sum, position, sum);
          count += 1;
        }
      }
    }
  }
  if (count == 0)
  {
    image->GetBounds(analysis.BodyBounds);
    body.SetBounds(analysis.BodyBounds);
    body.GetCenter(analysis.Centre);
    return;
  }
  body.GetBounds(analysis.BodyBounds);
  for (int axis = 0; axis < 3; ++axis)
  {
    analysis.Centre[axis] = sum[axis] / count;
  }
}
} // namespace Explore

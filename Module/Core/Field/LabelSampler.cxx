// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Field/LabelSampler.h"

#include <array>

namespace VolumeHaptics
{

LabelFunctions SelectBaselineLabelFunctions(ScalarType);
#ifdef VOLUME_HAPTICS_HAS_AVX2
LabelFunctions SelectAVX2LabelFunctions(ScalarType);
#endif

namespace
{

/** The weights and slopes of a kernel at the fraction i / Intervals of a voxel. */
struct WeightsAt
{
  WeightsAt(const GradientKernel& kernel, int i)
  {
    constexpr int last = GradientKernel::Intervals - 1;
    static_assert(LabelField::Intervals == GradientKernel::Intervals);
    const int count = 2 * kernel.Taps;
    const double* const c = &kernel.Table[static_cast<std::size_t>(std::min(i, last)) *
      GradientKernel::Coefficients * static_cast<std::size_t>(count)];
    for (int tap = 0; tap < kernel.Taps; ++tap)
    {
      this->Value[tap] = c[tap];
      this->Slope[tap] = c[kernel.Taps + tap];
      // At the end of the last interval, the value of a polynomial is the sum of its coefficients.
      for (int power = 1; power < GradientKernel::Coefficients && i > last; ++power)
      {
        this->Value[tap] += c[power * count + tap];
        this->Slope[tap] += c[power * count + kernel.Taps + tap];
      }
    }
  }

  double Value[LabelBlock::Taps];
  double Slope[LabelBlock::Taps];
};

std::vector<double> MakeTable(const GradientKernel& kernel)
{
  if (kernel.Taps != LabelBlock::Taps || kernel.Table.empty())
  {
    return {};
  }
  constexpr double h = 1.0 / LabelField::Intervals;
  std::vector<double> table;
  table.reserve(std::size_t{ LabelField::Intervals } * LabelField::Coefficients * LabelBlock::Taps);
  for (int i = 0; i < LabelField::Intervals; ++i)
  {
    const WeightsAt a(kernel, i);
    const WeightsAt b(kernel, i + 1);
    for (int power = 0; power < LabelField::Coefficients; ++power)
    {
      for (int tap = 0; tap < LabelBlock::Taps; ++tap)
      {
        const double rise = b.Value[tap] - a.Value[tap];
        const double from = h * a.Slope[tap];
        const double to = h * b.Slope[tap];
        const double c[LabelField::Coefficients] = { a.Value[tap], from,
          3.0 * rise - 2.0 * from - to, from + to - 2.0 * rise };
        table.push_back(c[power]);
      }
    }
  }
  return table;
}

constexpr int Patterns = 256;
constexpr std::uint16_t NoStep = 0xFFFF;

/** Returns, for each pattern of a row's bits, the position of its sums in StepWeights::Sums. */
constexpr std::array<std::uint16_t, Patterns> MakePlaces() noexcept
{
  std::array<std::uint16_t, Patterns> places{};
  for (std::uint16_t& place : places)
  {
    place = NoStep;
  }
  constexpr int bytes = sizeof(StepWeights::Sums) / (2 * StepWeights::Ends);
  for (int count = LabelBlock::Taps; count >= 0; --count)
  {
    const int first = (1 << count) - 1;
    const int last = (first << (LabelBlock::Taps - count)) % Patterns;
    places[last] = static_cast<std::uint16_t>(bytes * (StepWeights::Ends + count));
    places[first] = static_cast<std::uint16_t>(bytes * count);
  }
  return places;
}

constexpr std::array<std::uint16_t, Patterns> Places = MakePlaces();

} // namespace

bool LabelSteps::Set(const std::uint64_t* planes) noexcept
{
  bool areSteps = true;
  for (int k = 0; k < LabelBlock::Taps; ++k)
  {
    for (int j = 0; j < LabelBlock::Taps; ++j)
    {
      const std::uint16_t place = Places[(planes[k] >> (LabelBlock::Taps * j)) % Patterns];
      this->Place[k][j] = place;
      areSteps = areSteps && place != NoStep;
    }
  }
  return areSteps;
}

LabelSampler::LabelSampler(
  const VolumeView& view, const GradientKernel& kernel, InstructionSet instructions)
  : Table(MakeTable(kernel))
  , View{ view, this->Table.data() }
{
#ifdef VOLUME_HAPTICS_HAS_AVX2
  if (instructions == InstructionSet::AVX2)
  {
    this->Functions = SelectAVX2LabelFunctions(view.Type);
    return;
  }
#else
  static_cast<void>(instructions);
#endif
  this->Functions = SelectBaselineLabelFunctions(view.Type);
}

} // namespace VolumeHaptics

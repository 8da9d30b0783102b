// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "IdealHand.h"

#include <cmath>
#include <limits>
#include <random>
#include <utility>

namespace evaluation
{
namespace
{
constexpr int Draws = 100000;

/** The ideal hand's knowledge of a tissue: mean and variance of each perceived cue. */
struct Template
{
  std::vector<double> Mean;
  std::vector<double> Variance;
};

double LogLikelihood(const Template& tissue, const std::vector<double>& percept)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < percept.size(); ++i)
  {
    const double off = percept[i] - tissue.Mean[i];
    sum -= 0.5 * off * off / tissue.Variance[i] + 0.5 * std::log(tissue.Variance[i]);
  }
  return sum;
}
} // namespace

IdealHand::IdealHand(double weberFraction, std::vector<double> floors)
  : WeberFraction(weberFraction)
  , Floors(std::move(floors))
{
}

double IdealHand::Perceive(double cue, std::size_t index) const
{
  return std::log1p(cue / this->Floors[index]) / std::log1p(this->WeberFraction);
}

std::vector<double> IdealHand::MeanOf(const FeltTissue& tissue) const
{
  std::vector<double> mean(this->Floors.size(), 0.0);
  for (const std::vector<double>& place : tissue.Places)
  {
    for (std::size_t i = 0; i < mean.size(); ++i)
    {
      mean[i] += this->Perceive(place[i], i) / static_cast<double>(tissue.Places.size());
    }
  }
  return mean;
}

double IdealHand::Distance(const FeltTissue& one, const FeltTissue& other) const
{
  const std::vector<double> a = this->MeanOf(one);
  const std::vector<double> b = this->MeanOf(other);
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(sum);
}

std::vector<std::vector<double>> IdealHand::ComputeConfusion(
  const std::vector<FeltTissue>& tissues) const
{
  std::vector<Template> known;
  for (const FeltTissue& tissue : tissues)
  {
    Template one{ this->MeanOf(tissue), std::vector<double>(this->Floors.size(), 1.0) };
    for (const std::vector<double>& place : tissue.Places)
    {
      for (std::size_t i = 0; i < one.Mean.size(); ++i)
      {
        const double off = this->Perceive(place[i], i) - one.Mean[i];
        one.Variance[i] += off * off / static_cast<double>(tissue.Places.size());
      }
    }
    known.push_back(std::move(one));
  }
  std::vector<std::vector<double>> confusion(
    tissues.size(), std::vector<double>(tissues.size(), 0.0));
  std::mt19937 random(11);
  std::normal_distribution<double> noise;
  for (std::size_t t = 0; t < tissues.size(); ++t)
  {
    const auto& places = tissues[t].Places;
    for (int draw = 0; draw < Draws && !places.empty(); ++draw)
    {
      const std::vector<double>& place = places[draw % places.size()];
      std::vector<double> percept(place.size());
      for (std::size_t i = 0; i < place.size(); ++i)
      {
        percept[i] = this->Perceive(place[i], i) + noise(random);
      }
      std::size_t named = 0;
      double best = -std::numeric_limits<double>::max();
      for (std::size_t other = 0; other < known.size(); ++other)
      {
        const double likelihood = LogLikelihood(known[other], percept);
        if (likelihood > best)
        {
          best = likelihood;
          named = other;
        }
      }
      confusion[t][named] += 1.0 / Draws;
    }
  }
  return confusion;
}

double CountCorrect(const std::vector<std::vector<double>>& confusion)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < confusion.size(); ++i)
  {
    sum += confusion[i][i];
  }
  return sum;
}

void AddConfusion(const std::string& heading, const std::vector<FeltTissue>& tissues,
  const std::vector<std::vector<double>>& confusion, Table& table)
{
  for (std::size_t i = 0; i < tissues.size(); ++i)
  {
    std::vector<std::string> row = { heading, tissues[i].Name };
    for (const double fraction : confusion[i])
    {
      row.push_back(Number(100.0 * fraction));
    }
    table.Rows.push_back(std::move(row));
  }
}

} // namespace evaluation

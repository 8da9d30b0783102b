// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "TouchHfab.h"

#include "Dealer.h"
#include "Devices/Hfab/HfabModel.h"
#include "Devices/Hfab/HfabProtocol.h"

#include <cmath>
#include <string>
#include <vector>

using namespace VolumeHaptics;

namespace
{
constexpr int MostPieces = 60;

/** Draws raw bytes, characters of answers in any order, or an answer that may be damaged. */
std::string DealText(Dealer& dealer)
{
  std::string text;
  for (int piece = 0; piece < MostPieces && dealer.HasMore(); ++piece)
  {
    const int kind = dealer.Choose(4);
    if (kind == 0)
    {
      text += static_cast<char>(dealer.Byte());
      continue;
    }
    if (kind == 1)
    {
      const std::string letters = "[],-0123456789\n";
      for (int count = dealer.Choose(12); count > 0; --count)
      {
        text += letters[static_cast<std::size_t>(dealer.Choose(static_cast<int>(letters.size())))];
      }
      continue;
    }
    std::string answer = "[" + std::to_string(dealer.Choose(5));
    for (int count = 0; count < 7; ++count)
    {
      const double most = dealer.Choose(8) == 0 ? 2e10 : 12000.0;
      answer += "," + std::to_string(static_cast<long long>(dealer.Between(-most, most)));
    }
    answer += "]\n";
    if (kind == 3)
    {
      answer[static_cast<std::size_t>(dealer.Choose(static_cast<int>(answer.size())))] =
        static_cast<char>(dealer.Byte());
    }
    text += answer;
  }
  return text;
}

/** Returns whether a word is a number of one to nine digits, optionally with a minus sign. */
bool IsNumber(const std::string& word)
{
  const std::string digits = word.substr(!word.empty() && word[0] == '-' ? 1 : 0);
  return !digits.empty() && digits.size() < 10 &&
    digits.find_first_not_of("0123456789") == std::string::npos;
}

/** Searches the whole text for answers, as a slow reference implementation. */
std::vector<std::vector<long>> Search(const std::string& text)
{
  std::vector<std::vector<long>> answers;
  for (std::size_t end = text.find(']'); end != std::string::npos; end = text.find(']', end + 1))
  {
    const std::size_t begin = text.rfind('[', end);
    if (begin == std::string::npos)
    {
      continue;
    }
    std::vector<long> numbers;
    bool isAnswer = true;
    std::string rest = text.substr(begin + 1, end - begin - 1) + ",";
    while (isAnswer && !rest.empty())
    {
      const std::string word = rest.substr(0, rest.find(','));
      isAnswer = IsNumber(word);
      numbers.push_back(isAnswer ? std::stol(word) : 0);
      rest.erase(0, word.size() + 1);
    }
    if (isAnswer && numbers.size() == 8)
    {
      answers.push_back(numbers);
    }
  }
  return answers;
}

void CheckArm(const HfabAnswer& answer, const Vector3& force)
{
  const HfabGeometry* const geometry = HfabModel::Find(answer.Model);
  if (!geometry)
  {
    return;
  }
  const HfabModel::Angles angles = HfabModel::ComputeAngles(*geometry, answer.Counts);
  Vector3 tip;
  const bool exists = HfabModel::ComputeTip(*geometry, angles, tip);
  Check(!exists || IsFinite(tip), "tips are finite");
  for (const int current : HfabModel::ComputeCurrents(*geometry, angles, force))
  {
    Check(std::abs(current) <= geometry->MaximumCurrent, "the cap holds");
    Check((exists && IsFinite(force)) || current == 0, "what is no number is no force");
  }
}
} // namespace

void TouchHfab(const std::uint8_t* bytes, std::size_t size)
{
  Dealer dealer(bytes, size);
  constexpr double sizes[] = { 1.0, 1e6, 1e308, HUGE_VAL };
  const double most = sizes[dealer.Choose(4)];
  const Vector3 force{ most * dealer.Between(-1.0, 1.0), dealer.Between(-1.0, 1.0),
    dealer.Choose(16) == 0 ? std::nan("") : dealer.Between(-1.0, 1.0) };
  const std::string text = DealText(dealer);
  const std::vector<std::vector<long>> expected = Search(text);
  HfabReader reader;
  std::size_t found = 0;
  for (const char byte : text)
  {
    if (!reader.Receive(byte))
    {
      continue;
    }
    Check(found < expected.size(), "no answer is made up");
    const std::vector<long>& numbers = expected[found++];
    const HfabAnswer& answer = reader.Get();
    Check(answer.Model == numbers[0] && answer.Error == numbers[7], "model and error are read");
    for (std::size_t e = 0; e < answer.Counts.size(); ++e)
    {
      Check(answer.Counts[e] == numbers[e + 1], "counts are read");
    }
    CheckArm(answer, force);
  }
  Check(found == expected.size(), "no answer is left out");
}

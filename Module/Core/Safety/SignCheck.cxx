// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Safety/SignCheck.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Time (s) over which a push rises, and time (s) after which it ends. */
constexpr double PushRiseTime = 0.15;
constexpr double PushTime = 0.2;
/**
 * Number of force levels, the lowest level as a fraction of the highest one, and a limit (N) of the
 * lowest level.
 */
constexpr int Levels = 4;
constexpr double FirstShare = 0.125;
constexpr double FirstForce = 0.1;
/** Limits of speed (m/s), spread (m) and surprise (m) of a hand at rest (DriftLine.h). */
constexpr double RestSpeed = 0.02;
constexpr double RestSpread = 0.25e-3;
constexpr double RestSurprise = 0.35e-3;
/** The tip has turned back when it is this distance (m) from its farthest position. */
constexpr double TurnedBack = 0.1e-3;
/** A return ends at this distance (m) at the latest. A free mass turns back earlier. */
constexpr double MostDistance = 3.5e-3;
/** Time (s) for which the check waits until the hand rests. */
constexpr double Patience = 8.0;
/**
 * A vote counts if its distance is at least this length (m), and at least this multiple of the
 * spread, because it is then clear of the noise.
 */
constexpr double ClearDistance = 0.4e-3;
constexpr double ClearSpread = 4.0;
/**
 * Number of votes that an axis needs in each direction, and the number by which its votes must
 * exceed three times the opposite votes.
 */
constexpr int VotesEachWay = 2;
constexpr int VotesAhead = 4;
constexpr int MostTrials = 20;
/**
 * After this number of trials at the highest level without a vote, an axis counts as not moving.
 */
constexpr int MostUnclear = 6;

double Get(const Vector3& v, int axis) noexcept
{
  return axis == 0 ? v.X : axis == 1 ? v.Y : v.Z;
}

Vector3 Along(int axis, double value) noexcept
{
  return { axis == 0 ? value : 0.0, axis == 1 ? value : 0.0, axis == 2 ? value : 0.0 };
}

bool AreAhead(const int votes[2], const int others[2]) noexcept
{
  return votes[0] >= VotesEachWay && votes[1] >= VotesEachWay &&
    votes[0] + votes[1] - 3 * (others[0] + others[1]) >= VotesAhead;
}

} // namespace

void SignCheck::Begin(unsigned axes, double force) noexcept
{
  *this = SignCheck();
  this->Axes = axes & 7u;
  this->Most = std::min(MostShare * force, MostForce);
  if (this->Axes == 0 || !(this->Most > 0.0))
  {
    this->Verdict.Result = SignResult::Confirmed; // no axis can push
    return;
  }
  while ((this->Axes >> this->Axis & 1u) == 0)
  {
    ++this->Axis;
  }
}

void SignCheck::Finish(SignResult result) noexcept
{
  this->Verdict = { result, this->Axis };
}

void SignCheck::BeginRest() noexcept
{
  this->Now = Phase::Rest;
  this->Start = this->Time;
  this->Drift.Reset();
}

void SignCheck::Interrupt() noexcept
{
  this->BeginRest();
}

double SignCheck::GetDirection() const noexcept
{
  // The directions follow the Thue-Morse sequence, which is the parity of the bits of the trial's
  // number.
  int parity = 0;
  for (int bits = this->Tally[this->Axis].Trials; bits != 0; bits >>= 1)
  {
    parity ^= bits & 1;
  }
  return parity == 0 ? 1.0 : -1.0;
}

/** Returns the magnitude (N) of the push at a time (s) after its beginning. */
double SignCheck::GetForce(double time) const noexcept
{
  const double first = std::min(FirstShare * this->Most, FirstForce);
  const double rise = static_cast<double>(this->Tally[this->Axis].Level) / (Levels - 1);
  const double level = first * std::pow(this->Most / first, rise);
  return this->GetDirection() * level * std::clamp(time / PushRiseTime, 0.0, 1.0);
}

void SignCheck::Rest() noexcept
{
  if (this->Drift.IsFull())
  {
    const double surprise = Get(this->Drift.ComputeSurprise(), this->Axis);
    this->Drift.Fit();
    const double spread = Get(this->Drift.GetSpread(), this->Axis);
    if (Norm(this->Drift.GetVelocity()) <= RestSpeed && spread <= RestSpread &&
      surprise <= RestSurprise)
    {
      this->Clear = std::max(ClearDistance, ClearSpread * spread);
      this->Now = Phase::Push;
      this->Start = this->Time;
      return;
    }
  }
  if (this->Time - this->Start > Patience)
  {
    this->Finish(SignResult::Restless);
  }
}

/**
 * Continues a push. `distance` (m) is the distance of the measured tip from the line, along the
 * push.
 */
void SignCheck::Push(double distance) noexcept
{
  const double time = this->Time - this->Start;
  if (time >= PushTime || std::abs(distance) >= std::max(StopDistance, this->Clear))
  {
    this->Count(distance);
    this->Duration = time;
    this->Farthest = distance;
    this->Now = Phase::Return;
    this->Start = this->Time;
  }
}

void SignCheck::Return(double distance) noexcept
{
  const double way = this->Farthest < 0.0 ? -1.0 : 1.0;
  // If the push has not moved the tip, no return is needed.
  if (way * (this->Farthest - distance) >= TurnedBack || std::abs(this->Farthest) < TurnedBack ||
    std::abs(distance) > MostDistance)
  {
    this->Judge();
  }
  else if (way * (distance - this->Farthest) > 0.0)
  {
    this->Farthest = distance;
  }
}

/** Counts a vote. `distance` (m) is measured along the push. */
void SignCheck::Count(double distance) noexcept
{
  Votes& votes = this->Tally[this->Axis];
  const int way = this->GetDirection() > 0.0 ? 0 : 1;
  if (std::abs(distance) >= this->Clear)
  {
    ++(distance > 0.0 ? votes.With : votes.Against)[way];
  }
  else if (votes.Level == Levels - 1)
  {
    ++votes.Unclear;
  }
  const int with = votes.With[0] + votes.With[1];
  const int against = votes.Against[0] + votes.Against[1];
  this->MustPushHarder = std::abs(distance) < this->Clear || (with > 0 && against > 0);
}

/** Ends a trial. Unless there is a verdict, begins the next trial on the next axis. */
void SignCheck::Judge() noexcept
{
  Votes& votes = this->Tally[this->Axis];
  ++votes.Trials;
  if (this->MustPushHarder)
  {
    votes.Level = std::min(votes.Level + 1, Levels - 1);
  }
  votes.IsDone = AreAhead(votes.With, votes.Against);
  if (AreAhead(votes.Against, votes.With))
  {
    this->Finish(SignResult::Wrong);
    return;
  }
  if (!votes.IsDone && (votes.Unclear >= MostUnclear || votes.Trials >= MostTrials))
  {
    const int clear = votes.With[0] + votes.With[1] + votes.Against[0] + votes.Against[1];
    this->Finish(clear > votes.Unclear ? SignResult::Restless : SignResult::NoMotion);
    return;
  }
  for (int i = 0; i < 3; ++i)
  {
    this->Axis = (this->Axis + 1) % 3;
    if ((this->Axes >> this->Axis & 1u) != 0 && !this->Tally[this->Axis].IsDone)
    {
      this->BeginRest();
      return;
    }
  }
  this->Finish(SignResult::Confirmed);
}

Vector3 SignCheck::Step(const Vector3& tip, bool isFresh, double elapsed) noexcept
{
  this->Time += elapsed;
  if (this->Verdict.Result != SignResult::Pending || !IsFinite(tip))
  {
    return {};
  }
  const double distance =
    Get(tip - this->Drift.GetPlace(this->Time), this->Axis) * this->GetDirection();
  const double phase = this->Time - this->Start;
  if (this->Now == Phase::Rest && isFresh)
  {
    this->Drift.Add(tip, this->Time);
    this->Rest();
  }
  else if (this->Now == Phase::Push && isFresh)
  {
    this->Push(distance);
  }
  else if (this->Now == Phase::Push && phase > 2.0 * PushTime)
  {
    this->Interrupt(); // a push without measured tips is not a trial
  }
  else if (this->Now == Phase::Return && phase >= this->Duration)
  {
    this->Judge();
  }
  else if (this->Now == Phase::Return && isFresh)
  {
    this->Return(distance);
  }
  const double time = this->Time - this->Start;
  switch (this->Verdict.Result == SignResult::Pending ? this->Now : Phase::Rest)
  {
    case Phase::Push:
      return Along(this->Axis, this->GetForce(time));
    case Phase::Return:
      return Along(this->Axis, -this->GetForce(this->Duration - time));
    case Phase::Rest:
      break;
  }
  return {};
}

} // namespace VolumeHaptics

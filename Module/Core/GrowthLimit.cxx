// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "GrowthLimit.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/**
 * Paid / Work is never taken for less. A tick is a finite step along the curve of (2) and can overshoot its end;
 * from zero the force could not come back.
 */
constexpr double LeastPaid = 1.0 / 64.0;

} // namespace

void GrowthLimit::BeginContact() noexcept
{
  this->LeastShare = this->MostShare = 1.0;
  this->Work = 0.0;
  this->Unpaid = 0.0;
}

void GrowthLimit::Reset() noexcept
{
  this->BeginContact();
  this->Wanted = {};
  this->Sent = {};
  this->HasTip = false;
}

void GrowthLimit::Override(const Vector3& force) noexcept
{
  this->Reset();
  this->Sent = force;
}

void GrowthLimit::Account(const Vector3& wanted, const Vector3& tip, double recoverable) noexcept
{
  const bool turned = Dot(wanted, this->Wanted) <= 0.0;
  const bool touched = Dot(this->Wanted, this->Wanted) > 0.0;
  if (turned && touched)
  {
    this->BeginContact();
  }
  else if (this->HasTip)
  {
    // The mean of both ends is exact for springs.
    const double work = -0.5 * Dot(this->Wanted + wanted, tip - this->Tip);
    this->Work += work;
    this->Unpaid += (1.0 - (work > 0.0 ? this->LeastShare : this->MostShare)) * work;
    if (recoverable >= 0.0 && this->Work > recoverable)
    {
      this->Unpaid *= recoverable / this->Work;
      this->Work = recoverable;
    }
    if (!(this->Work > 0.0))
    {
      // The hand has got back all that it could put in: what else comes is the wanted force's own.
      this->Work = 0.0;
      this->Unpaid = 0.0;
    }
    this->Unpaid = std::min(std::max(this->Unpaid, 0.0), (1.0 - LeastPaid) * this->Work);
  }
}

Vector3 GrowthLimit::Apply(
  const Vector3& wanted, const Vector3& tip, double growth, double recoverable) noexcept
{
  const double norm = Norm(wanted);
  if (norm > 0.0)
  {
    this->Account(wanted, tip, recoverable);
    const double paid = this->Work - this->Unpaid;
    const double share = this->Unpaid > 0.0 ? 2.0 * paid / (this->Work + paid) : 1.0;
    const double before = std::max(0.0, Dot(this->Sent, wanted) / norm);
    const double most = std::min(share * norm, before + growth);
    const double sent = most < norm ? most / norm : 1.0;
    const bool moved = !this->HasTip || !IsIdentical(tip, this->Tip);
    this->LeastShare = moved ? sent : std::min(this->LeastShare, sent);
    this->MostShare = moved ? sent : std::max(this->MostShare, sent);
    this->Sent = sent < 1.0 ? sent * wanted : wanted;
  }
  else
  {
    this->BeginContact();
    this->Sent = {};
  }
  this->Wanted = wanted;
  this->Tip = tip;
  this->HasTip = true;
  return this->Sent;
}

} // namespace VolumeHaptics

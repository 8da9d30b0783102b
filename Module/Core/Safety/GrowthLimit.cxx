// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Safety/GrowthLimit.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

/** Least value of Paid / Work in (2). With zero, the force could never return. */
constexpr double LeastPaid = 1.0 / 64.0;

} // namespace

void GrowthLimit::BeginContact() noexcept
{
  this->LeastShare = this->MostShare = this->LastShare = 1.0;
  this->Work = 0.0;
  this->Unpaid = 0.0;
  this->Return = 0.0;
}

void GrowthLimit::Reset() noexcept
{
  this->BeginContact();
  this->Source = {};
  this->Sent = {};
  this->HasTip = false;
}

void GrowthLimit::Lower(const Vector3& force) noexcept
{
  const double wanted = Norm(this->Source);
  const double share = wanted > 0.0 ? std::min(1.0, Norm(force) / wanted) : 0.0;
  this->LeastShare = std::min(this->LeastShare, share);
  this->LastShare = share;
  this->Sent = force;
}

void GrowthLimit::Account(const Vector3& source, const Vector3& tip, double recoverable) noexcept
{
  const bool turned = Dot(source, this->Source) <= 0.0;
  const bool touched = Dot(this->Source, this->Source) > 0.0;
  if (turned && touched)
  {
    this->BeginContact();
  }
  else if (this->HasTip)
  {
    // The work is computed with the mean of both forces, which is exact for springs.
    const double work = -0.5 * Dot(this->Source + source, tip - this->Tip);
    this->Return = IsIdentical(tip, this->Tip) ? this->Return : std::max(0.0, -work);
    this->Work += work;
    this->Unpaid += (1.0 - (work > 0.0 ? this->LeastShare : this->MostShare)) * work;
    if (recoverable >= 0.0 && this->Work > recoverable)
    {
      this->Unpaid *= recoverable / this->Work;
      this->Work = recoverable;
    }
    if (!(this->Work > 0.0))
    {
      // The hand has got back all that it put in. Further work would come from the wanted force
      // itself.
      this->Work = 0.0;
      this->Unpaid = 0.0;
    }
    this->Unpaid = std::max(this->Unpaid, 0.0);
  }
}

double GrowthLimit::ComputeMostShare() const noexcept
{
  if (!(this->Unpaid > 0.0))
  {
    return 1.0;
  }
  const double paid = this->Work - this->Unpaid;
  const double taken = std::max(paid, LeastPaid * this->Work);
  const double share = 2.0 * taken / (this->Work + taken);
  // A tick is a finite step along the curve, and the next tick may return as much work as this one.
  // The account therefore limits the share.
  const bool isTooMuch = this->Return > 0.0 && share * this->Return > paid;
  return isTooMuch ? std::max(0.0, paid) / this->Return : share;
}

Vector3 GrowthLimit::Apply(const GrowthInput& input) noexcept
{
  const Vector3& wanted = input.Wanted;
  const double norm = Norm(wanted);
  const Vector3 source = wanted - input.Drag;
  if (norm > 0.0)
  {
    this->Account(source, input.Tip, input.Recoverable);
    const double before = std::max(0.0, Dot(this->Sent, wanted) / norm);
    const double share = std::min(input.Share, this->ComputeMostShare());
    const double sent = std::min(share, (before + input.Growth) / norm);
    const bool isKnown = input.IsMeasured || !this->HasTip;
    // A device may output a force one tick late, so the share of the last tick may still act on the
    // hand.
    this->LeastShare = std::min(isKnown ? this->LastShare : this->LeastShare, sent);
    this->MostShare = std::max(isKnown ? this->LastShare : this->MostShare, sent);
    this->LastShare = sent;
    this->Sent = sent < 1.0 ? sent * wanted : wanted;
  }
  else
  {
    this->BeginContact();
    this->Sent = {};
  }
  this->Source = source;
  this->Tip = input.Tip;
  this->HasTip = true;
  return this->Sent;
}

} // namespace VolumeHaptics

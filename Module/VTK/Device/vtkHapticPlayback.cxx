// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHapticPlayback.h"

#include "VTK/Device/DeviceParts.h"

#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkHapticPlayback);

using namespace VolumeHaptics;

//------------------------------------------------------------------------------
DeviceParts* vtkHapticPlayback::GetParts()
{
  if (!this->Parts)
  {
    vtkErrorMacro("This playback has no device: take it from vtkHapticDevice::GetPlayback(), and "
                  "keep the device as long as it is used.");
  }
  return this->Parts;
}

//------------------------------------------------------------------------------
void vtkHapticPlayback::Play()
{
  if (DeviceParts* const parts = this->GetParts())
  {
    parts->Models.GetPlayback().SetPlays(true);
  }
}

//------------------------------------------------------------------------------
void vtkHapticPlayback::Hold()
{
  if (DeviceParts* const parts = this->GetParts())
  {
    parts->Models.GetPlayback().SetPlays(false);
  }
}

//------------------------------------------------------------------------------
bool vtkHapticPlayback::IsPlaying()
{
  return this->Parts && this->Parts->Models.GetPlayback().IsPlaying();
}

//------------------------------------------------------------------------------
void vtkHapticPlayback::SetMode(int mode)
{
  const int clamped = std::clamp<int>(mode, ONCE, PING_PONG);
  DeviceParts* const parts = this->GetParts();
  if (parts && clamped != this->GetMode())
  {
    parts->Models.GetPlayback().SetMode(static_cast<Playback>(clamped));
    this->Modified();
  }
}

//------------------------------------------------------------------------------
int vtkHapticPlayback::GetMode()
{
  return this->Parts ? static_cast<int>(this->Parts->Models.GetPlayback().GetMode()) : ONCE;
}

//------------------------------------------------------------------------------
void vtkHapticPlayback::SetDataTime(double time)
{
  DeviceParts* const parts = this->GetParts();
  if (parts && !std::isfinite(time))
  {
    std::ostringstream error;
    error
      << "The data time has to be a finite number, in the units of the source's time steps, and "
         "is "
      << time << ": it stays " << this->GetDataTime() << ".";
    parts->Orders.ReportError(error.str());
  }
  else if (parts)
  {
    parts->Models.GetPlayback().SetTime(time);
  }
}

//------------------------------------------------------------------------------
double vtkHapticPlayback::GetDataTime()
{
  return this->Parts ? this->Parts->Models.GetPlayback().GetTime() : 0.0;
}

//------------------------------------------------------------------------------
bool vtkHapticPlayback::IsWaitingForData()
{
  return this->Parts && this->Parts->Models.GetPlayback().IsWaiting();
}

//------------------------------------------------------------------------------
void vtkHapticPlayback::SetSpeed(double factor)
{
  constexpr double most = 1e6;
  DeviceParts* const parts = this->GetParts();
  if (parts && !std::isfinite(factor))
  {
    std::ostringstream error;
    error << "The playback speed has to be a finite number, and is " << factor << ": it stays "
          << this->GetSpeed() << ".";
    parts->Orders.ReportError(error.str());
    return;
  }
  const double clamped = std::clamp(factor, -most, most);
  if (parts && clamped != this->GetSpeed())
  {
    parts->Models.GetPlayback().SetSpeed(clamped);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
double vtkHapticPlayback::GetSpeed()
{
  return this->Parts ? this->Parts->Models.GetPlayback().GetSpeed() : 1.0;
}

//------------------------------------------------------------------------------
bool vtkHapticPlayback::HasTimeSteps()
{
  return this->Parts && this->Parts->Models.HasTimeSteps();
}

//------------------------------------------------------------------------------
vtkImageData* vtkHapticPlayback::GetTimeStepImage()
{
  return this->Parts ? this->Parts->Models.GetTimeStepImage() : nullptr;
}

//------------------------------------------------------------------------------
double vtkHapticPlayback::GetTimeStepValue()
{
  return this->Parts ? this->Parts->Models.GetTimeStepValue() : 0.0;
}

//------------------------------------------------------------------------------
void vtkHapticPlayback::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Playing: " << (this->IsPlaying() ? "On" : "Off") << "\n";
  os << indent << "Mode: " << this->GetMode() << "\n";
  os << indent << "Speed: " << this->GetSpeed() << "\n";
  os << indent << "DataTime: " << this->GetDataTime() << "\n";
}

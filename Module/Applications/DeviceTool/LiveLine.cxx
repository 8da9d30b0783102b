// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/LiveLine.h"

#include <vtkHapticDevice.h>

#include <cstdio>
#include <iostream>

#if defined(__unix__)
#include <unistd.h>
#endif

namespace
{

bool IsTerminalStream(const std::ostream& out)
{
#if defined(__unix__)
  return &out == &std::cout && isatty(STDOUT_FILENO) != 0;
#else
  return false;
#endif
}

} // namespace

std::string DescribeState(vtkHapticDevice* device)
{
  const char* const contacts[] = { "free", "sticking", "sliding", "penetrating" };
  const double* const tip = device->GetState()->GetTipPosition();
  const double* const force = device->GetState()->GetForce();
  char text[300];
  std::snprintf(text, sizeof(text),
    "tip %7.1f %7.1f %7.1f mm   force %6.2f %6.2f %6.2f N   %-11s  buttons %02x   %5.0f Hz   "
    "reports every %4.1f ms, round trip %4.1f ms",
    tip[0], tip[1], tip[2], force[0], force[1], force[2],
    contacts[device->GetState()->GetContact()],
    static_cast<unsigned int>(device->GetState()->GetButtons()), device->GetTickRate(),
    1e3 * device->GetReportPeriod(), 1e3 * device->GetRoundTripTime());
  std::string line = text;
  if (device->GetStiffnessCap() > 0.0)
  {
    std::snprintf(text, sizeof(text), "   at most %.0f N/m", device->GetStiffnessCap());
    line += text;
  }
  const bool isUncalibrated = device->GetCalibrationText() == "uncalibrated";
  return isUncalibrated ? line + "   uncalibrated" : line;
}

LiveLine::LiveLine(std::ostream& out)
  : Out(out)
  , IsTerminal(IsTerminalStream(out))
{
}

LiveLine::~LiveLine()
{
  this->End();
}

void LiveLine::Show(const std::string& text)
{
  if (text == this->Shown)
  {
    return;
  }
  if (this->IsTerminal)
  {
    // The escape sequence clears the rest of a longer line.
    this->Out << "\r" << text << "\033[K";
  }
  else
  {
    this->Out << text << "\n";
  }
  this->Out.flush();
  this->Shown = text;
}

void LiveLine::End()
{
  if (this->IsTerminal && !this->Shown.empty())
  {
    this->Out << "\n";
  }
  this->Shown.clear();
}

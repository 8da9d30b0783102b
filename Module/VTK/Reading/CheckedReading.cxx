// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/CheckedReading.h"

#include "VTK/Reading/MessageCapture.h"

#include "vtkAlgorithm.h"

#include <exception>

namespace Explore
{
bool ReadChecked(
  vtkAlgorithm* reader, std::string& detail, const std::function<std::string()>& check)
{
  const MessageCapture capture;
  const auto isGood = [&]
  {
    detail = detail.empty() ? capture.FirstError() : detail;
    return detail.empty() && reader->GetErrorCode() == 0;
  };
  detail.clear();
  try
  {
    reader->UpdateInformation();
    if (isGood() && check)
    {
      detail = check();
    }
    if (isGood())
    {
      reader->Update();
    }
  }
  catch (const std::exception&)
  {
    detail = "there is not enough memory for what its header promises";
  }
  return isGood();
}
} // namespace Explore

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Reading/Dicom/DicomProcess.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Reading/InputError.h"

#if !defined(_WIN32)
#include "Core/Platform/HelperProcess.h"
#include "Core/Platform/SocketBytes.h"

#include <vtksys/SystemTools.hxx>

#include <mutex>

namespace
{
using Explore::DicomAnswer;
using Explore::DicomRequest;
using VolumeHaptics::HelperProcess;
using VolumeHaptics::ReceiveAll;
using VolumeHaptics::SendAll;

bool Ask(HelperProcess& process, const DicomRequest& request, const std::string& path,
  std::uint64_t mostAnswer, DicomAnswer& answer, std::string& bytes)
{
  // Check all that the process sends: a malicious file may have taken it over.
  const int link = process.GetLink();
  bool isRead = SendAll(link, &request, sizeof(request)) &&
    SendAll(link, path.data(), path.size()) && ReceiveAll(link, &answer, sizeof(answer)) &&
    answer.ByteCount <= mostAnswer;
  if (isRead)
  {
    bytes.resize(static_cast<std::size_t>(answer.ByteCount));
    isRead = ReceiveAll(link, &bytes[0], bytes.size());
  }
  if (!isRead)
  {
    process.End();
  }
  return isRead && answer.IsRead != 0;
}
} // namespace
#endif

namespace Explore
{
bool HasDicomMark(const std::string& path)
{
  char mark[4] = {};
  std::ifstream file = VolumeHaptics::OpenStream(path);
  file.seekg(128);
  return file.read(mark, sizeof(mark)) && std::string(mark, sizeof(mark)) == "DICM";
}
#if defined(_WIN32)
bool AskDicom(DicomRequest::Kind, const std::string& path, std::uint64_t, DicomAnswer& answer,
  std::string& bytes)
{
  answer = {};
  bytes.clear();
  if (HasDicomMark(path))
  {
    throw InputError(path, "is DICOM, which is read on Linux only",
      "convert it to NIfTI or NRRD, e.g. with dcm2niix or 3D Slicer");
  }
  return false;
}
#else
bool AskDicom(DicomRequest::Kind what, const std::string& path, std::uint64_t mostBytes,
  DicomAnswer& answer, std::string& bytes)
{
  static HelperProcess process;
  static std::mutex access;
  const std::lock_guard<std::mutex> lock(access);
  answer = {};
  bytes.clear();
  std::string obstacle;
  if (!process.Start("volumehaptics-dicom", reinterpret_cast<const void*>(&AskDicom), obstacle))
  {
    if (HasDicomMark(path))
    {
      throw InputError(path,
        "is DICOM, and the program volumehaptics-dicom that reads it is missing" +
          (obstacle.empty() ? "" : ", or another user could have written it (" + obstacle + ")"),
        "build it with GDCM (package libgdcm-dev)");
    }
    return false;
  }
  DicomRequest request;
  request.What = what;
  request.PathLength = static_cast<std::uint32_t>(path.size());
  request.MostBytes = mostBytes;
  constexpr std::uint64_t least = 1 << 20;
  const std::uint64_t mostAnswer =
    what == DicomRequest::Values ? least + 4 * vtksys::SystemTools::FileLength(path) : mostBytes;
  return Ask(process, request, path, mostAnswer, answer, bytes);
}
#endif
} // namespace Explore

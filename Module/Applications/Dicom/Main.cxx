// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// volumehaptics-dicom: reads DICOM files by GDCM on behalf of the module. It is a separate program,
// because damaged files can make GDCM abort or allocate gigabytes: then only this process ends, and
// neither the window nor the force is affected. It receives requests and sends answers through
// standard input, which is a socket.
#include "Core/Platform/SocketBytes.h"
#include "VTK/Reading/Dicom/DicomMessage.h"

#include <gdcmByteValue.h>
#include <gdcmFragment.h>
#include <gdcmImageReader.h>
#include <gdcmReader.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmSequenceOfItems.h>
#include <gdcmTrace.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
using Explore::DicomAnswer;
using Explore::DicomElement;
using Explore::DicomRequest;
using VolumeHaptics::ReceiveAll;
using VolumeHaptics::SendAll;

constexpr std::uint32_t LONGEST_VALUE = 1024; // bytes of the longest value that is passed on
constexpr std::uint32_t LONGEST_OFFSETS = 65536;
const gdcm::Tag OFFSETS(0x3004, 0x000c);             // byte offset of each frame of a dose
constexpr std::uint32_t REAL_WORLD = 0x00409096;     // RealWorldValueMappingSequence
constexpr std::uint32_t MODALITY_TABLE = 0x00283000; // ModalityLUTSequence
const gdcm::Tag ROWS(0x0028, 0x0010), BEFORE_PIXELS(0x7fe0, 0x0007);
const gdcm::Tag PIXELS(0x7fe0, 0x0010), FLOAT_PIXELS(0x7fe0, 0x0008), DOUBLE_PIXELS(0x7fe0, 0x0009);

std::uint32_t ToNumber(const gdcm::Tag& tag)
{
  return std::uint32_t{ tag.GetGroup() } << 16 | tag.GetElement();
}

/// Limits memory and processor time to what a file and its pixels can need, with a margin for the
/// largest headers and the slowest codec.
void SetLimits(const DicomRequest& request, std::uint64_t fileSize)
{
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) // sanitizers map terabytes
  constexpr std::uint64_t least = 128 << 20;
  rlimit memory = {};
  getrlimit(RLIMIT_AS, &memory);
  memory.rlim_cur = std::min<rlim_t>(memory.rlim_max, least + 4 * (fileSize + request.MostBytes));
  setrlimit(RLIMIT_AS, &memory);
#endif
  constexpr std::uint64_t leastSeconds = 20;
  constexpr std::uint64_t slowest = 2 << 20; // bytes a second
  alarm(static_cast<unsigned>(leastSeconds + (fileSize + request.MostBytes) / slowest));
}

/// Returns whether a file may be DICOM: it has the mark "DICM", or, as in files older than the
/// mark, begins with a data set of group 2 or 8 in either byte order.
bool MayBeDicom(const std::string& path)
{
  char begin[132] = {};
  std::ifstream file(path, std::ios::binary);
  file.read(begin, sizeof(begin));
  const bool hasMark = file.gcount() == sizeof(begin) && std::memcmp(begin + 128, "DICM", 4) == 0;
  const auto isGroup = [](char low, char high) { return (low == 2 || low == 8) && high == 0; };
  return hasMark ||
    (file.gcount() > 8 &&
      ((isGroup(begin[0], begin[1]) && begin[3] == 0) ||
        (isGroup(begin[1], begin[0]) && begin[2] == 0)));
}

void AppendValue(
  const gdcm::DataElement& element, std::uint32_t sequence, int item, std::string& out)
{
  const gdcm::ByteValue* const value = element.GetByteValue();
  const std::uint32_t longest = element.GetTag() == OFFSETS ? LONGEST_OFFSETS : LONGEST_VALUE;
  if (value && value->GetLength() <= longest)
  {
    const DicomElement head{ ToNumber(element.GetTag()), sequence, item, value->GetLength() };
    out.append(reinterpret_cast<const char*>(&head), sizeof(head));
    out.append(value->GetPointer() ? value->GetPointer() : "", head.Length);
  }
}

/// Returns whether a tag is that of a functional group (a sequence of one item) whose values are
/// needed.
bool IsGroup(std::uint32_t tag)
{
  // Groups: spacing of pixels; position; orientation; slope and intercept; the frame's number in
  // time, segment, echo, diffusion and heart phase; the map to real-world values, and the unit in
  // it.
  constexpr std::uint32_t groups[] = { 0x00289110, 0x00209113, 0x00209116, 0x00289145, 0x00209111,
    0x0062000a, 0x00189114, 0x00189117, 0x00189118, REAL_WORLD, 0x004008ea };
  return std::find(std::begin(groups), std::end(groups), tag) != std::end(groups);
}

/// Returns whether the values in a sequence's items are needed: segments, the map to real-world
/// values, positions of detectors, attributes shared by all frames, and attributes of each frame.
bool IsWanted(std::uint32_t tag)
{
  return tag == 0x00620002 || tag == 0x00540022 || tag == REAL_WORLD || tag == 0x52009229 ||
    tag == 0x52009230;
}

/// Appends the values of a data set; within the wanted sequences, also those of functional groups.
void AppendValues(const gdcm::DataSet& set, std::uint32_t sequence, int item, std::string& out)
{
  for (auto at = set.Begin(); at != set.End(); ++at)
  {
    const std::uint32_t tag = ToNumber(at->GetTag());
    if (tag == MODALITY_TABLE) // needed only to know whether the sequence has an item
    {
      const gdcm::SmartPointer<gdcm::SequenceOfItems> tables = at->GetValueAsSQ();
      if (tables ? tables->GetNumberOfItems() == 0 : at->IsEmpty())
      {
        continue;
      }
      const DicomElement head{ tag, sequence, item, 0 };
      out.append(reinterpret_cast<const char*>(&head), sizeof(head));
      continue;
    }
    if (sequence == 0 ? !IsWanted(tag) : !IsGroup(tag))
    {
      AppendValue(*at, sequence, item, out);
      continue;
    }
    const gdcm::SmartPointer<gdcm::SequenceOfItems> items = at->GetValueAsSQ();
    const std::size_t count = items ? items->GetNumberOfItems() : 0;
    for (std::size_t i = 1; i <= count; ++i)
    {
      AppendValues(items->GetItem(i).GetNestedDataSet(), sequence == 0 ? tag : sequence,
        sequence == 0 ? static_cast<int>(i) - 1 : item, out);
    }
  }
}

/// Returns whether all items of compressed pixels are complete in the file, although some writers
/// omit the end marker.
bool AreItemsWhole(std::ifstream& file, std::uint64_t place, std::uint64_t size)
{
  constexpr unsigned char item[] = { 0xfe, 0xff, 0x00, 0xe0 };
  constexpr unsigned char end[] = { 0xfe, 0xff, 0xdd, 0xe0 };
  bool isWhole = place + 16 < size;
  unsigned char head[8];
  while (isWhole && place < size)
  {
    file.clear();
    file.seekg(static_cast<std::streamoff>(place));
    isWhole = static_cast<bool>(file.read(reinterpret_cast<char*>(head), sizeof(head)));
    if (isWhole && std::memcmp(head, end, sizeof(end)) == 0)
    {
      return true;
    }
    const std::uint64_t length = std::uint64_t{ head[4] } | std::uint64_t{ head[5] } << 8 |
      std::uint64_t{ head[6] } << 16 | std::uint64_t{ head[7] } << 24;
    place += sizeof(head) + length;
    isWhole = isWhole && std::memcmp(head, item, sizeof(item)) == 0 && place <= size;
  }
  return isWhole;
}

/// Describes the pixels whose element begins at `place` of the file. Returns false if the header of
/// the element does not end there.
bool FindPixels(
  const std::string& path, std::uint64_t place, std::uint64_t size, DicomAnswer& answer)
{
  // The header of an element: its tag, then its length, or its type and its length.
  unsigned char head[12] = {};
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(place - sizeof(head)));
  if (place < sizeof(head) || place > size ||
    !file.read(reinterpret_cast<char*>(head), sizeof(head)))
  {
    return false;
  }
  const auto number = [&](std::size_t at)
  {
    const unsigned first = head[at], second = head[at + 1];
    return answer.IsBig ? first << 8 | second : second << 8 | first;
  };
  const auto isAt = [&](std::size_t at)
  { return number(at) == PIXELS.GetGroup() && number(at + 2) == PIXELS.GetElement(); };
  if (!(isAt(0) && head[4] == 'O') && !isAt(4))
  {
    return false;
  }
  answer.PixelTag = ToNumber(PIXELS);
  answer.PixelPlace = place;
  answer.PixelLength = size - place;
  answer.AreItems = number(8) == 0xffff && number(10) == 0xffff;
  answer.AreItemsWhole = answer.AreItems && AreItemsWhole(file, place, size);
  return true;
}

/// Returns the pixel data as stored; null if there are none.
const gdcm::DataElement* GetPixels(const gdcm::DataSet& set)
{
  for (const gdcm::Tag& tag : { PIXELS, FLOAT_PIXELS, DOUBLE_PIXELS })
  {
    if (set.FindDataElement(tag))
    {
      return &set.GetDataElement(tag);
    }
  }
  return nullptr;
}

bool ReadValues(
  const std::string& path, std::uint64_t size, DicomAnswer& answer, std::string& bytes)
{
  if (!MayBeDicom(path))
  {
    return false;
  }
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  const bool isRead = reader.ReadUpToTag(PIXELS, { PIXELS, FLOAT_PIXELS, DOUBLE_PIXELS });
  const gdcm::FileMetaInformation& meta = reader.GetFile().GetHeader();
  const gdcm::DataSet& set = reader.GetFile().GetDataSet();
  const gdcm::TransferSyntax syntax = meta.GetDataSetTransferSyntax();
  answer.IsBig = syntax == gdcm::TransferSyntax::ExplicitVRBigEndian;
  answer.IsDeflated = syntax == gdcm::TransferSyntax::DeflatedExplicitVRLittleEndian;
  AppendValues(meta, 0, -1, bytes);
  if (!answer.IsDeflated)
  {
    AppendValues(set, 0, -1, bytes);
    if (!isRead || !set.FindDataElement(ROWS) ||
      FindPixels(path, reader.GetStreamCurrentPosition(), size, answer))
    {
      return meta.Size() + set.Size() > 0; // a file without pixels is valid, too
    }
  }
  // GDCM can't skip deflated pixels, floating-point pixels, or pixels of another transfer syntax
  // than the file declares, so read the whole file.
  gdcm::Reader whole;
  whole.SetFileName(path.c_str());
  const bool isWhole = whole.ReadUpToTag(BEFORE_PIXELS);
  if (answer.IsDeflated)
  {
    AppendValues(whole.GetFile().GetDataSet(), 0, -1, bytes);
  }
  const gdcm::DataElement* const pixels = GetPixels(whole.GetFile().GetDataSet());
  const gdcm::ByteValue* const value = pixels ? pixels->GetByteValue() : nullptr;
  if (isWhole && pixels)
  {
    answer.PixelTag = ToNumber(pixels->GetTag());
    answer.AreItems = answer.AreItemsWhole = pixels->GetSequenceOfFragments() != nullptr;
    answer.PixelLength = value ? std::uint64_t{ value->GetLength() } : 0;
    answer.PixelPlace = whole.GetStreamCurrentPosition() - answer.PixelLength;
  }
  return true;
}

bool ReadStored(const DicomRequest& request, const std::string& path, std::string& bytes)
{
  gdcm::Reader reader;
  reader.SetFileName(path.c_str());
  const gdcm::DataElement* const pixels =
    reader.Read() ? GetPixels(reader.GetFile().GetDataSet()) : nullptr;
  const gdcm::ByteValue* const value = pixels ? pixels->GetByteValue() : nullptr;
  if (value)
  {
    bytes.assign(
      value->GetPointer(), std::min<std::uint64_t>(value->GetLength(), request.MostBytes));
  }
  return value != nullptr;
}

/// Returns whether a JPEG stream stores colours as luminance and colour differences (YCbCr); empty
/// if the stream does not show it. The file's header may wrongly say RGB, as from GDCM's writer.
/// Therefore this function reads the JFIF or Adobe marker, as decoders do, or the components' names
/// if there is no marker.
std::optional<bool> IsYbrStream(const char* bytes, std::size_t size)
{
  const auto* const data = reinterpret_cast<const unsigned char*>(bytes);
  for (std::size_t at = 2; at + 4 <= size && data[at] == 0xff;)
  {
    const unsigned marker = data[at + 1];
    const std::size_t length = 256U * data[at + 2] + data[at + 3];
    const unsigned char* const part = data + at + 4;
    if (length < 2 || at + 2 + length > size)
    {
      break;
    }
    if (marker == 0xe0 && length >= 7 && std::memcmp(part, "JFIF", 5) == 0)
    {
      return true;
    }
    if (marker == 0xee && length >= 14 && std::memcmp(part, "Adobe", 5) == 0)
    {
      return part[11] == 1;
    }
    if (marker >= 0xc0 && marker <= 0xc3 && length >= 17)
    {
      return !(part[6] == 'R' && part[9] == 'G' && part[12] == 'B');
    }
    at += 2 + length;
  }
  return {};
}

/// Returns whether the image that GDCM has decoded is in luminance and colour differences (YCbCr).
bool IsYbr(const gdcm::Image& image)
{
  const gdcm::PhotometricInterpretation meaning = image.GetPhotometricInterpretation();
  const gdcm::TransferSyntax syntax = image.GetTransferSyntax();
  const gdcm::SequenceOfFragments* const fragments =
    image.GetDataElement().GetSequenceOfFragments();
  if ((syntax == gdcm::TransferSyntax::JPEGBaselineProcess1 ||
        syntax == gdcm::TransferSyntax::JPEGExtendedProcess2_4) &&
    fragments && fragments->GetNumberOfFragments() > 0)
  {
    const gdcm::ByteValue* const first = fragments->GetFragment(0).GetByteValue();
    const std::optional<bool> told =
      first ? IsYbrStream(first->GetPointer(), first->GetLength()) : std::nullopt;
    if (told)
    {
      return *told;
    }
  }
  return meaning == gdcm::PhotometricInterpretation::YBR_FULL ||
    meaning == gdcm::PhotometricInterpretation::YBR_FULL_422;
}

/// Joins the fragments of each frame, because GDCM needs exactly one fragment per frame. The start
/// markers of JPEG, JPEG-LS and JPEG 2000 show where a frame begins.
void JoinFragments(gdcm::Image& image)
{
  const gdcm::SequenceOfFragments* const parts = image.GetDataElement().GetSequenceOfFragments();
  const std::size_t frames = image.GetNumberOfDimensions() > 2 ? image.GetDimension(2) : 1;
  if (!parts || frames < 2 || parts->GetNumberOfFragments() <= frames)
  {
    return;
  }
  std::vector<std::string> whole;
  for (std::size_t i = 0; i < parts->GetNumberOfFragments(); ++i)
  {
    const gdcm::ByteValue* const value = parts->GetFragment(i).GetByteValue();
    const std::string bytes =
      value ? std::string(value->GetPointer(), value->GetLength()) : std::string();
    const bool isFirst =
      bytes.compare(0, 2, "\xff\xd8") == 0 || bytes.compare(0, 2, "\xff\x4f") == 0;
    isFirst || whole.empty() ? whole.push_back(bytes) : void(whole.back() += bytes);
  }
  if (whole.size() != frames)
  {
    return; // leaves the fragments unchanged; GDCM then refuses the file
  }
  const auto joined = gdcm::SequenceOfFragments::New();
  for (const std::string& bytes : whole)
  {
    gdcm::Fragment fragment;
    fragment.SetByteValue(bytes.data(), gdcm::VL(static_cast<std::uint32_t>(bytes.size())));
    joined->AddFragment(fragment);
  }
  gdcm::DataElement element(PIXELS);
  element.SetVR(gdcm::VR::OB);
  element.SetValue(*joined);
  image.SetDataElement(element);
}

bool Unpack(
  const DicomRequest& request, const std::string& path, DicomAnswer& answer, std::string& bytes)
{
  gdcm::ImageReader reader;
  reader.SetFileName(path.c_str());
  if (!reader.Read())
  {
    return false;
  }
  gdcm::Image& image = reader.GetImage();
  JoinFragments(image);
  const std::size_t size = image.GetBufferLength();
  if (size == 0 || size > request.MostBytes)
  {
    return false;
  }
  bytes.resize(size);
  if (!image.GetBuffer(&bytes[0]))
  {
    return false;
  }
  const gdcm::PixelFormat& format = image.GetPixelFormat();
  answer.Bits = format.GetBitsAllocated();
  answer.StoredBits = format.GetBitsStored();
  answer.Samples = format.GetSamplesPerPixel();
  answer.ArePlanes = image.GetPlanarConfiguration() == 1;
  answer.IsYbr = answer.Samples == 3 && IsYbr(image);
  return true;
}

/// Answers requests until the socket is closed. `isSending` is set while an answer is sent.
void Serve(volatile bool& isSending)
{
  DicomRequest request;
  while (ReceiveAll(STDIN_FILENO, &request, sizeof(request)))
  {
    std::string path(request.PathLength, '\0');
    if (!ReceiveAll(STDIN_FILENO, &path[0], path.size()))
    {
      return;
    }
    DicomAnswer answer;
    std::string bytes;
    struct stat status = {};
    if (stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode))
    {
      const auto size = static_cast<std::uint64_t>(status.st_size);
      SetLimits(request, size);
      try
      {
        answer.IsRead = request.What == DicomRequest::Values ? ReadValues(path, size, answer, bytes)
          : request.What == DicomRequest::Stored             ? ReadStored(request, path, bytes)
                                                             : Unpack(request, path, answer, bytes);
      }
      catch (...) // GDCM's own exceptions, or too little memory
      {
        answer = {};
      }
      alarm(0);
    }
    bytes.resize(answer.IsRead ? bytes.size() : 0);
    answer.ByteCount = bytes.size();
    isSending = true;
    if (!SendAll(STDIN_FILENO, &answer, sizeof(answer)) ||
      !SendAll(STDIN_FILENO, bytes.data(), bytes.size()))
    {
      return;
    }
    isSending = false;
  }
}
} // namespace

int main()
{
  struct stat input = {};
  if (fstat(STDIN_FILENO, &input) != 0 || !S_ISSOCK(input.st_mode))
  {
    std::fputs("volumehaptics-dicom reads DICOM files for the module, which starts it.\n", stderr);
    return 2;
  }
  gdcm::Trace::WarningOff(); // the requesting process reports errors
  gdcm::Trace::ErrorOff();
  const rlimit none = {};
  setrlimit(RLIMIT_CORE, &none);
  auto* const isSending = static_cast<volatile bool*>(
    mmap(nullptr, sizeof(bool), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  if (isSending == MAP_FAILED)
  {
    return 1;
  }
  // Read in a fork of this process. If a file crashes it, the next fork takes less than a
  // millisecond, whereas a new process would load GDCM's tables for 20 ms.
  while (true)
  {
    const pid_t reader = fork();
    if (reader == 0)
    {
      prctl(PR_SET_PDEATHSIG, SIGKILL);
      Serve(*isSending);
      _exit(0);
    }
    int state = 0;
    const bool hasEnded = reader > 0 && waitpid(reader, &state, 0) == reader;
    const DicomAnswer refusal;
    if (!hasEnded || !WIFSIGNALED(state) || *isSending ||
      !SendAll(STDIN_FILENO, &refusal, sizeof(refusal)))
    {
      return 0;
    }
  }
}

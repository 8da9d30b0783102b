// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Reads DICOM files as they are stored on media: several series in nested folders, in any order,
// each with its own rescale and direction; also unreadable files. The test writes the files
// according to parts 5 and 10 of the standard. Their values are a function of the position in the
// patient.
#include "Applications/Explorer/Options.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "PackDicom.h"
#include "VTK/Reading/Dicom/DicomHeader.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeSeries.h"

#include "vtkImageData.h"
#include "vtkPointData.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <random>
#include <zlib.h>

#include <sys/wait.h>
#include <unistd.h>

namespace
{
constexpr int DICOM_COLUMNS = 7, DICOM_ROWS = 5;
constexpr double COLUMN_STEP = 0.75, ROW_STEP = 0.5, SLICE_STEP = 2.5; // mm between samples
const char* const IMPLICIT = "1.2.840.10008.1.2";
const char* const EXPLICIT = "1.2.840.10008.1.2.1";
const char* const RUN_LENGTH = "1.2.840.10008.1.2.5";

/// Contents of one file of a series: slice number `Slice` along the normal, or `Frames` slices
/// starting there.
struct SliceFile
{
  std::string Series = "1.2.3";
  int SeriesNumber = 1;
  std::string Description = "Thorax";
  int Slice = 0;
  bool IsSagittal = false;
  std::string Modality = "CT";
  std::string Syntax = EXPLICIT;
  std::string Instance = "1.2."; // prefix of the SOP instance UID
  int Columns = DICOM_COLUMNS;
  int Rows = DICOM_ROWS;
  int Frames = 1;
  ///@{
  /// Ways to give the positions in a file with several frames. With a step or with offsets, frame f
  /// is slice Slice + f. With functional groups, which give the position of each frame, it is slice
  /// Slice + Frames - 1 - f.
  bool HasStep = false;
  bool HasOffsets = false;
  bool HasGroups = false;
  ///@}

  int SliceOf(int frame) const
  {
    return this->Slice + (this->HasGroups ? this->Frames - 1 - frame : frame);
  }
};

std::string Bytes(std::uint32_t number, int count)
{
  std::string bytes;
  for (int i = 0; i < count; ++i)
  {
    bytes += static_cast<char>(number >> 8 * i & 0xff);
  }
  return bytes;
}

std::string Part(std::uint32_t tag, const std::string& type, std::string value, bool isExplicit)
{
  const bool isBinary = type == "OW" || type == "SQ";
  value += value.size() % 2 == 0 ? "" : type == "UI" || isBinary ? std::string(1, '\0') : " ";
  const auto length = static_cast<std::uint32_t>(value.size());
  const std::string head = Bytes(tag >> 16, 2) + Bytes(tag & 0xffff, 2);
  if (!isExplicit)
  {
    return head + Bytes(length, 4) + value;
  }
  return head + type + (isBinary ? Bytes(0, 2) + Bytes(length, 4) : Bytes(length, 2)) + value;
}

/// Returns the value (HU) at column i, row j and slice k. The value is even, so that a rescale
/// slope of 2 stores it exactly.
double UnitsAt(int i, int j, int k)
{
  return 2.0 * (i + 10 * j + 60 * k) - 500.0;
}

std::string Encode(const SliceFile& slice)
{
  const bool isExplicit = slice.Syntax != IMPLICIT;
  const auto part = [&](std::uint32_t tag, const std::string& type, const std::string& value)
  { return Part(tag, type, value, isExplicit); };
  const auto number = [&](std::uint32_t tag, int value)
  { return part(tag, "US", Bytes(static_cast<std::uint32_t>(value), 2)); };
  const std::string along = std::to_string(SLICE_STEP * slice.Slice);
  const bool isOneSlope = slice.Frames > 1 && !slice.HasGroups;
  const auto slopeOf = [&](int k) { return k % 2 == 0 || isOneSlope ? 1 : 2; };
  const int slope = slopeOf(slice.Slice);
  std::string pixels;
  for (int frame = 0; frame < slice.Frames; ++frame)
  {
    const int k = slice.SliceOf(frame);
    for (int j = 0; j < slice.Rows; ++j)
    {
      for (int i = 0; i < slice.Columns; ++i)
      {
        const double stored = (UnitsAt(i, j, k) + 1024.0) / slopeOf(k);
        pixels += Bytes(static_cast<std::uint32_t>(stored), 2);
      }
    }
  }
  // Alternate between sequences and items of known length and of unknown length.
  const std::string itemEnd = Bytes(0xfffe, 2) + Bytes(0xe00d, 2) + Bytes(0, 4);
  const std::string sequenceEnd = Bytes(0xfffe, 2) + Bytes(0xe0dd, 2) + Bytes(0, 4);
  const auto itemOf = [&](const std::string& content, bool isKnown)
  {
    return Bytes(0xfffe, 2) + Bytes(0xe000, 2) +
      (isKnown ? Bytes(static_cast<std::uint32_t>(content.size()), 4) + content
               : std::string(4, '\xff') + content + itemEnd);
  };
  const auto sequenceOf = [&](std::uint32_t tag, const std::string& items, bool isKnown)
  {
    return isKnown ? part(tag, "SQ", items)
                   : Bytes(tag >> 16, 2) + Bytes(tag & 0xffff, 2) +
        (isExplicit ? "SQ" + Bytes(0, 2) : std::string()) + std::string(4, '\xff') + items +
        sequenceEnd;
  };
  std::string offsets, groups;
  for (int frame = 0; frame < slice.Frames; ++frame)
  {
    const int k = slice.SliceOf(frame);
    const std::string place = std::to_string(SLICE_STEP * k);
    offsets += (frame > 0 ? "\\" : "") + std::to_string(SLICE_STEP * frame);
    const bool isKnown = frame % 2 == 0;
    groups += itemOf(sequenceOf(0x00209113,
                       itemOf(part(0x00200032, "DS", "-10\\-20\\" + place), isKnown), !isKnown) +
        sequenceOf(0x00289145,
          itemOf(
            part(0x00281052, "DS", "-1024") + part(0x00281053, "DS", std::to_string(slopeOf(k))),
            isKnown),
          isKnown),
      !isKnown);
  }
  const std::string shared =
    itemOf(sequenceOf(0x00209116, itemOf(part(0x00200037, "DS", "1\\0\\0\\0\\1\\0"), false), true) +
        sequenceOf(0x00289110, itemOf(part(0x00280030, "DS", "0.5\\0.75"), true), false),
      true);
  // A preview image precedes the pixels: an item of unknown length in a sequence of unknown length.
  const std::string unknown(4, '\xff');
  const std::string item = Bytes(0xfffe, 2) + Bytes(0xe000, 2) + unknown + number(0x00280010, 64) +
    part(0x7fe00010, "OW", "abcdefgh") + Bytes(0xfffe, 2) + Bytes(0xe00d, 2) + Bytes(0, 4) +
    Bytes(0xfffe, 2) + Bytes(0xe0dd, 2) + Bytes(0, 4);
  const std::string preview = Bytes(0x0088, 2) + Bytes(0x0200, 2) +
    (isExplicit ? "SQ" + Bytes(0, 2) : std::string()) + unknown + item;
  const std::string kind = "1.2.840.10008.5.1.4.1.1.2"; // CT Image Storage
  const std::string meta =
    Part(0x00020002, "UI", kind, true) + Part(0x00020010, "UI", slice.Syntax, true);
  return std::string(128, '\0') + "DICM" +
    Part(0x00020000, "UL", Bytes(static_cast<std::uint32_t>(meta.size()), 4), true) + meta +
    part(0x00080016, "UI", kind) +
    part(0x00080018, "UI", slice.Instance + std::to_string(slice.Slice)) +
    part(0x00080060, "CS", slice.Modality) + part(0x0008103e, "LO", slice.Description) +
    (slice.HasStep ? part(0x00180088, "DS", std::to_string(SLICE_STEP)) : "") +
    part(0x0020000e, "UI", slice.Series) +
    part(0x00200011, "IS", std::to_string(slice.SeriesNumber)) +
    (slice.HasGroups
        ? ""
        : part(0x00200032, "DS", slice.IsSagittal ? along + "\\-20\\30" : "-10\\-20\\" + along) +
          part(0x00200037, "DS", slice.IsSagittal ? "0\\1\\0\\0\\0\\-1" : "1\\0\\0\\0\\1\\0")) +
    number(0x00280002, 1) + part(0x00280004, "CS", "MONOCHROME2") +
    part(0x00280008, "IS", std::to_string(slice.Frames)) + number(0x00280010, slice.Rows) +
    number(0x00280011, slice.Columns) +
    (slice.HasGroups ? "" : part(0x00280030, "DS", "0.5\\0.75")) + number(0x00280100, 16) +
    number(0x00280101, 16) + number(0x00280102, 15) + number(0x00280103, 0) +
    (slice.HasGroups
        ? ""
        : part(0x00281052, "DS", "-1024") + part(0x00281053, "DS", std::to_string(slope))) +
    preview + (slice.HasOffsets ? part(0x3004000c, "DS", offsets) : "") +
    (slice.HasGroups ? sequenceOf(0x52009229, shared, false) + sequenceOf(0x52009230, groups, true)
                     : "") +
    part(0x7fe00010, "OW", pixels);
}

std::string WriteDicom(const std::string& name, const std::string& bytes)
{
  const std::string path = folder + "/" + name;
  vtksys::SystemTools::MakeDirectory(vtksys::SystemTools::GetFilenamePath(path));
  vtksys::ofstream file(path.c_str(), std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return path;
}

/// Writes the slices of a series. The order of the file names is the reverse of the slices' order.
void WriteSlices(const std::string& where, SliceFile slice, int count)
{
  for (slice.Slice = 0; slice.Slice < count; ++slice.Slice)
  {
    WriteDicom(where + "/I" + std::to_string(900 - slice.Slice), Encode(slice));
  }
}

/// Expects each sample's value at the sample's position in the patient.
void ExpectSlices(const std::string& what, const Explore::Volume& volume, int count,
  bool isSagittal, const SliceFile& like = SliceFile())
{
  vtkImageData* const image = volume.Image;
  const vtkIdType points = static_cast<vtkIdType>(count) * like.Rows * like.Columns;
  Expect(image->GetNumberOfPoints() == points, what + " has another number of samples");
  int wrong = 0;
  for (vtkIdType p = 0; p < image->GetNumberOfPoints(); ++p)
  {
    const double* const x = image->GetPoint(p);
    const double across = isSagittal ? x[1] + 20.0 : x[0] + 10.0;
    const double down = isSagittal ? 30.0 - x[2] : x[1] + 20.0;
    const double along = isSagittal ? x[0] : x[2];
    const double place[3] = { across / COLUMN_STEP, down / ROW_STEP, along / SLICE_STEP };
    bool isOnSample = true;
    int index[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      index[axis] = static_cast<int>(std::lround(place[axis]));
      isOnSample = isOnSample && std::abs(place[axis] - index[axis]) < 1e-4;
    }
    const double value = image->GetPointData()->GetScalars()->GetComponent(p, 0);
    const double expected = UnitsAt(index[0], index[1], index[2]);
    wrong += isOnSample && value == expected ? 0 : 1;
  }
  Expect(wrong == 0, what + " has " + std::to_string(wrong) + " samples elsewhere");
}

void ExpectNote(const Explore::Volume& volume, const std::string& text)
{
  std::string all;
  for (const std::string& note : volume.Notes)
  {
    all += note + "\n";
  }
  Expect(all.find(text) != std::string::npos, "'" + text + "' is not among the notes: " + all);
}

void ExpectFault(const std::string& path, int series, const std::string& fault)
{
  std::string message = "nothing";
  try
  {
    Explore::LoadVolumes({ path }, false, series);
  }
  catch (const Explore::InputError& error)
  {
    message = error.what();
  }
  Expect(message.find(fault) != std::string::npos && message.find("Cure: ") != std::string::npos,
    "should say '" + fault + "', but said: " + message);
}

void ExpectSeriesOption()
{
  std::string words[] = { "explore", "folder", "--series", "3" };
  char* arguments[] = { &words[0][0], &words[1][0], &words[2][0], &words[3][0] };
  Expect(Explore::ParseOptions(4, arguments).Series == 3, "--series 3 is another one");
  for (const char* const wrong : { "0", "-1", "1.5", "two", "" })
  {
    words[3] = wrong;
    arguments[3] = &words[3][0];
    bool isRefused = false;
    try
    {
      Explore::ParseOptions(4, arguments);
    }
    catch (const Explore::InputError&)
    {
      isRefused = true;
    }
    Expect(isRefused, std::string("--series takes '") + wrong + "'");
  }
}

/// Returns a slice with run-length encoding by annex G of part 5 of the standard: the high bytes of
/// all samples, then the low bytes, each as one literal run.
std::string EncodeRuns(const std::string& plain, const std::string& pixels)
{
  std::string high, low;
  for (std::size_t i = 0; i < pixels.size(); i += 2)
  {
    low += pixels[i];
    high += pixels[i + 1];
  }
  const auto segment = [](const std::string& bytes)
  {
    std::string run = static_cast<char>(bytes.size() - 1) + bytes;
    return run + std::string(run.size() % 2, '\0');
  };
  const std::string first = segment(high), second = segment(low);
  std::string frame = Bytes(2, 4) + Bytes(64, 4) +
    Bytes(static_cast<std::uint32_t>(64 + first.size()), 4) + std::string(64 - 12, '\0') + first +
    second;
  const std::string item = Bytes(0xfffe, 2) + Bytes(0xe000, 2);
  const std::string header = plain.substr(0, plain.size() - pixels.size() - 12);
  return header + Bytes(0x7fe0, 2) + Bytes(0x0010, 2) + "OB" + Bytes(0, 2) + Bytes(0xffffffff, 4) +
    item + Bytes(0, 4) + item + Bytes(static_cast<std::uint32_t>(frame.size()), 4) + frame +
    Bytes(0xfffe, 2) + Bytes(0xe0dd, 2) + Bytes(0, 4);
}

/// Expects compressed slices to have the values of the uncompressed slices.
void ExpectUnpacked(SliceFile slice)
{
  slice.Syntax = RUN_LENGTH;
  constexpr std::size_t size = 2 * DICOM_COLUMNS * DICOM_ROWS;
  for (slice.Slice = 0; slice.Slice < 5; ++slice.Slice)
  {
    const std::string plain = Encode(slice);
    const std::string pixels = plain.substr(plain.size() - size);
    WriteDicom("runs/I" + std::to_string(900 - slice.Slice), EncodeRuns(plain, pixels));
  }
  slice.Syntax = EXPLICIT;
  ExpectSlices("runs", Explore::LoadVolumes({ folder + "/runs" }), 5, false);
  for (const char* const name : { "lossless", "prediction" })
  {
    for (slice.Slice = 0; slice.Slice < 5; ++slice.Slice)
    {
      const std::string at = std::string(name) + "/I" + std::to_string(900 - slice.Slice);
      const std::string plain = WriteDicom("plain", Encode(slice));
      vtksys::SystemTools::MakeDirectory(folder + "/" + name);
      Expect(PackDicom(plain, folder + "/" + at, name, 0.0), at + " is not written");
    }
    ExpectSlices(name, Explore::LoadVolumes({ folder + "/" + name }), 5, false);
    ExpectFault(folder + "/" + name, 2, "has no series 2");
  }
}

std::string ReadBytes(const std::string& path)
{
  vtksys::ifstream file(path.c_str(), std::ios::binary);
  return { std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>() };
}

/// Tests JPEG 2000, whose images must be larger than a few pixels: slices, a file with several
/// frames, truncated slices, and a damaged slice.
void ExpectWavelets(SliceFile slice)
{
  slice.Columns = slice.Rows = 64;
  const std::string where = folder + "/wavelets";
  vtksys::SystemTools::MakeDirectory(where);
  const auto pack = [&](const std::string& at)
  {
    const std::string plain = WriteDicom("plain", Encode(slice));
    vtksys::SystemTools::MakeDirectory(vtksys::SystemTools::GetFilenamePath(at));
    Expect(PackDicom(plain, at, "wavelets", SLICE_STEP), at + " is not written");
  };
  for (slice.Slice = 0; slice.Slice < 6; ++slice.Slice)
  {
    pack(where + "/I" + std::to_string(900 - slice.Slice));
  }
  ExpectSlices("wavelets", Explore::LoadVolumes({ where }), 6, false, slice);
  const std::string last = where + "/I898";
  const std::string whole = ReadBytes(last);
  Expect(whole.size() < Encode(slice).size() / 2, "wavelets are not packed");
  for (const std::size_t missing : { 10, 100, 200 })
  {
    WriteDicom("wavelets/I898", whole.substr(0, whole.size() - missing));
    ExpectFault(where, 0, "I898");
  }
  std::string damaged = whole;
  std::fill(damaged.end() - 100, damaged.end() - 60, '\0');
  std::fill(damaged.end() - 50, damaged.end() - 20, '\xff');
  WriteDicom("wavelets/I898", damaged);
  try
  {
    Explore::LoadVolumes({ where }); // may succeed with some wrong samples
  }
  catch (const Explore::InputError& error)
  {
    Expect(std::string(error.what()).find("Cure: ") != std::string::npos, error.what());
  }

  slice.Slice = 0;
  slice.Frames = 6;
  slice.HasStep = true;
  pack(folder + "/wavelet-frames/all");
  ExpectSlices(
    "frames of wavelets", Explore::LoadVolumes({ folder + "/wavelet-frames" }), 6, false, slice);
}

/// Tests one file that holds all slices as frames.
void ExpectFrames(SliceFile slice)
{
  slice.Slice = 0;
  slice.Frames = 6;
  for (const char* const syntax : { EXPLICIT, IMPLICIT })
  {
    slice.Syntax = syntax;
    slice.HasStep = true;
    WriteDicom("steps/all", Encode(slice));
    ExpectSlices("frames with a step", Explore::LoadVolumes({ folder + "/steps" }), 6, false);
    slice.HasStep = false;
    slice.HasOffsets = true;
    WriteDicom("offsets/all", Encode(slice));
    ExpectSlices("frames with offsets", Explore::LoadVolumes({ folder + "/offsets" }), 6, false);
    slice.HasOffsets = false;
    slice.HasGroups = true;
    WriteDicom("groups/all", Encode(slice));
    ExpectSlices("frames with groups", Explore::LoadVolumes({ folder + "/groups" }), 6, false);
    ExpectSlices("a file", Explore::LoadVolumes({ folder + "/groups/all" }), 6, false);
    const std::string whole = Encode(slice);
    for (std::size_t length = 0; length < whole.size(); ++length)
    {
      WriteDicom("cut-groups", whole.substr(0, length));
      for (const auto& header : Explore::ReadDicomSlices(folder + "/cut-groups"))
      {
        Expect(!header.IsWhole, "frames cut to " + std::to_string(length) + " bytes are whole");
      }
    }
    slice.HasGroups = false;
  }
}

/// Truncates a file at every length, and expects that its header is refused or that the slice
/// counts as incomplete.
void ExpectCutFiles()
{
  for (const char* const syntax : { EXPLICIT, IMPLICIT })
  {
    SliceFile slice;
    slice.Syntax = syntax;
    const std::string bytes = Encode(slice);
    for (std::size_t length = 0; length < bytes.size(); ++length)
    {
      Explore::DicomHeader header;
      const std::string path = WriteDicom("cut", bytes.substr(0, length));
      Expect(!Explore::ReadDicomHeader(path, header) || !header.IsWhole,
        "a slice cut to " + std::to_string(length) + " bytes is whole");
    }
    Explore::DicomHeader header;
    const std::string path = WriteDicom("cut", bytes);
    Expect(Explore::ReadDicomHeader(path, header) && header.IsWhole, "a slice is not whole");
  }
}

/// Returns the file with its data set compressed by deflate, by section A.5 of part 5 of the
/// standard.
std::string Deflate(const std::string& plain)
{
  // Write a new meta group, because the original group contains the UID of the uncompressed
  // transfer syntax, which has another length.
  const std::size_t begin = plain.find(Part(0x00080016, "UI", "", true).substr(0, 6));
  const std::string kind = "1.2.840.10008.5.1.4.1.1.2";
  const std::string meta =
    Part(0x00020002, "UI", kind, true) + Part(0x00020010, "UI", "1.2.840.10008.1.2.1.99", true);
  const std::string data = plain.substr(begin);
  std::string packed(compressBound(static_cast<uLong>(data.size())) + 64, '\0');
  z_stream stream = {};
  deflateInit2(&stream, 9, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(data.data()));
  stream.avail_in = static_cast<uInt>(data.size());
  stream.next_out = reinterpret_cast<Bytef*>(&packed[0]);
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return std::string(128, '\0') + "DICM" +
    Part(0x00020000, "UL", Bytes(static_cast<std::uint32_t>(meta.size()), 4), true) + meta + packed;
}

/// Changes bytes of files at random. Expects that each file is read, or refused with a message: no
/// other exception is thrown, and no slice declares more pixels than the file has.
void ExpectSpoiltFiles()
{
  SliceFile one, frames, segmentation;
  frames.Frames = segmentation.Frames = 6;
  frames.HasGroups = segmentation.HasGroups = true;
  segmentation.Modality = "SEG";
  SliceFile implicit = frames;
  implicit.Syntax = IMPLICIT;
  const std::string good[] = { Encode(one), Encode(frames), Encode(segmentation), Encode(implicit),
    Deflate(Encode(frames)) };
  constexpr std::size_t head = 132;
  std::mt19937 random(54);
  std::size_t whole = 0;
  for (std::size_t round = 0; round < 1500; ++round)
  {
    std::string bytes = good[round % std::size(good)];
    for (unsigned changes = random() % 5; changes > 0; --changes)
    {
      const std::size_t at = head + random() % (bytes.size() - head);
      bytes[at] = static_cast<char>(random() % 2 == 0 ? random() : bytes[at] + 1);
    }
    bytes.resize(random() % 8 == 0 ? random() % bytes.size() : bytes.size());
    const std::string path = WriteDicom("spoilt/I900", bytes);
    for (const Explore::DicomHeader& slice : Explore::ReadDicomSlices(path))
    {
      const bool isTold = slice.IsWhole && slice.IsPlain() && slice.Bits > 1;
      Expect(!isTold || slice.Pixels + slice.GetSize() <= bytes.size(), "pixels are not there");
    }
    Explore::ReadDicomSegments(path);
    Explore::FindDicomObject(path);
    try
    {
      Explore::LoadVolumes({ path });
      ++whole;
    }
    catch (const Explore::InputError&)
    {
    }
  }
  Expect(whole > 100, "only " + std::to_string(whole) + " are read");
}

/// Changes bytes of compressed pixels at random. Expects that each file is read, or refused with a
/// message.
void ExpectSpoiltPixels()
{
  SliceFile slice;
  slice.Columns = slice.Rows = 64;
  std::mt19937 random(57);
  for (const char* const how : { "lossless", "prediction", "wavelets" })
  {
    const std::string packed = folder + "/spoilt-pixels/packed";
    const std::string plain = WriteDicom("spoilt-pixels/plain", Encode(slice));
    Expect(PackDicom(plain, packed, how, 0.0), packed + " is not written");
    vtksys::SystemTools::RemoveFile(plain);
    const std::string good = ReadBytes(packed);
    for (int round = 0; round < 60; ++round)
    {
      std::string bytes = good;
      for (unsigned changes = 1 + random() % 4; changes > 0; --changes)
      {
        bytes[bytes.size() - 1 - random() % (bytes.size() / 2)] = static_cast<char>(random());
      }
      try
      {
        Explore::LoadVolumes({ WriteDicom("spoilt-pixels/packed", bytes) });
      }
      catch (const Explore::InputError&)
      {
      }
    }
  }
}

/// Lets a forked process and its parent read at the same time. Expects that each gets its own
/// slices, and that the parent can still read after the child's end.
void ExpectForkedReads(SliceFile slice)
{
  WriteSlices("of-parent", slice, 7);
  WriteSlices("of-child", slice, 5);
  const auto areRead = [](const std::string& name, int count)
  {
    const Explore::Volume volume = Explore::LoadVolumes({ folder + name });
    return volume.Image->GetDimensions()[2] == count;
  };
  Expect(areRead("/of-parent", 7), "slices before a fork");
  const pid_t child = fork();
  bool isRead = child >= 0;
  try
  {
    for (int round = 0; isRead && round < 20; ++round)
    {
      isRead = child == 0 ? areRead("/of-child", 5) : areRead("/of-parent", 7);
    }
  }
  catch (const Explore::InputError&)
  {
    isRead = false;
  }
  if (child == 0)
  {
    std::exit(isRead ? EXIT_SUCCESS : EXIT_FAILURE); // exit() runs the handlers
  }
  int status = -1;
  Expect(isRead, "slices of a parent");
  Expect(waitpid(child, &status, 0) == child && status == 0, "slices of a child");
  Expect(areRead("/of-parent", 7), "slices after the child's end");
}
} // namespace

int TestExploreDicom(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "TestExploreDicom");
  vtksys::SystemTools::RemoveADirectory(folder);
  SliceFile thorax;
  thorax.Series = "1.2.30";
  thorax.SeriesNumber = 4;
  SliceFile scout;
  scout.Series = "1.2.31";
  scout.SeriesNumber = 2;
  scout.Description = "Scout";
  scout.Syntax = IMPLICIT;
  scout.IsSagittal = true;
  WriteSlices("disk/PAT0/SE0", thorax, 7);
  WriteSlices("disk/PAT0/SE1", scout, 5);
  const std::string disk = folder + "/disk";
  const std::string content = WriteDicom("disk/DICOMDIR",
    std::string(128, '\0') + "DICM" + Part(0x00020010, "UI", EXPLICIT, true) +
      Part(0x00041130, "CS", "DISK", true));

  const Explore::Volume largest = Explore::LoadVolumes({ disk });
  ExpectSlices("the largest series", largest, 7, false);
  ExpectNote(largest, "series 2 \"Thorax\", CT, 7 slices of 7 x 5");
  ExpectNote(largest, "1 \"Scout\", CT, 5 slices of 7 x 5");
  ExpectSlices("a series by its number", Explore::LoadVolumes({ disk }, false, 1), 5, true);
  ExpectSlices("a medium", Explore::LoadVolumes({ content }), 7, false);
  ExpectSlices("a medium's series", Explore::LoadVolumes({ content }, false, 1), 5, true);
  ExpectFault(disk, 3, "has no series 3");
  ExpectSlices("the folders of two series", Explore::LoadVolumes({ disk + "/PAT0" }), 7, false);

  // With both series in one folder, the named slice decides which series is read.
  WriteSlices("mixed", thorax, 7);
  for (scout.Slice = 0; scout.Slice < 5; ++scout.Slice)
  {
    WriteDicom("mixed/S" + std::to_string(scout.Slice) + ".dcm", Encode(scout));
  }
  const auto oneOf = [](const std::string& name)
  { return Explore::LoadVolumes({ folder + "/mixed/" + name }); };
  ExpectSlices("the series of a slice", oneOf("S1.dcm"), 5, true);
  ExpectSlices("the series of a slice without an ending", oneOf("I900"), 7, false);

  // Two series of the same size at the same positions are read as time steps of a moving volume.
  WriteSlices("beat/at2", thorax, 5);
  thorax.Series = "1.2.32";
  WriteSlices("beat/at10", thorax, 5);
  const Explore::Volume beat = Explore::LoadVolumes({ folder + "/beat" });
  Expect(beat.TimeSteps && beat.TimeSteps->GetNumberOfTimeSteps() == 2, "phases are no time steps");
  ExpectSlices("a phase", Explore::LoadVolumes({ folder + "/beat" }, false, 2), 5, false);

  ExpectUnpacked(thorax);
  ExpectWavelets(thorax);
  ExpectFrames(thorax);
  thorax.Frames = 3;
  WriteSlices("many", thorax, 2);
  ExpectFault(folder + "/many", 0, "with 3 frames");
  thorax.Frames = 1;
  WriteSlices("twice", thorax, 5);
  WriteDicom("twice/copy", Encode(thorax));
  const Explore::Volume once = Explore::LoadVolumes({ folder + "/twice" });
  ExpectSlices("slices with a copy", once, 5, false);
  ExpectNote(once, "1 slice is there twice");
  thorax.Instance = "1.3.";
  WriteDicom("twice/again", Encode(thorax));
  ExpectFault(folder + "/twice", 0, "two slices at the same position");
  WriteSlices("short", thorax, 3);
  const std::string bytes = Encode(thorax);
  WriteDicom("short/I900", bytes.substr(0, bytes.size() - 2));
  ExpectFault(folder + "/short", 0, "truncated slice");
  ExpectCutFiles();
  ExpectSpoiltFiles();
  ExpectSpoiltPixels();
  ExpectForkedReads({});
  ExpectSeriesOption();
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects that a volume read from its file has bitwise the same forces as in memory, in every
// supported format, and that unreadable files cause a message. The files are written byte by byte,
// according to the descriptions of the formats.
#include "Applications/Explorer/Live/TouchScene.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "Rigs/Eventually.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/VolumeSeries.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <vtksys/FStream.hxx>
#include <vtksys/SystemTools.hxx>

#include <sstream>

namespace
{
std::string WriteLarge(const std::string& name, const std::string& content)
{
  const std::string path = folder + "/" + name;
  vtksys::SystemTools::MakeDirectory(vtksys::SystemTools::GetFilenamePath(path));
  vtksys::ofstream(path.c_str(), std::ios::binary) << content;
  return path;
}

/// Returns the samples as 16-bit integers, little endian or big endian (`isBig`).
std::string MakeSamples(vtkImageData* head, bool isBig)
{
  vtkDataArray* const values = head->GetPointData()->GetScalars();
  std::string bytes;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const auto number = static_cast<unsigned int>(static_cast<int>(values->GetComponent(i, 0)));
    const char low = static_cast<char>(number & 255U);
    const char high = static_cast<char>(number >> 8 & 255U);
    bytes += isBig ? high : low;
    bytes += isBig ? low : high;
  }
  return bytes;
}

std::string Three(const double* numbers)
{
  std::ostringstream text;
  text.precision(17);
  text << numbers[0] << " " << numbers[1] << " " << numbers[2];
  return text.str();
}

std::string Sizes(vtkImageData* head, bool isZarr)
{
  const int* const n = head->GetDimensions();
  std::ostringstream text;
  if (isZarr)
  {
    text << "[" << n[2] << "," << n[1] << "," << n[0] << "]";
  }
  else
  {
    text << n[0] << " " << n[1] << " " << n[2];
  }
  return text.str();
}

Explore::Exploration ExploreLarge(const std::string& path)
{
  const Explore::Volume volume = Explore::LoadVolumes({ path }, true);
  Expect(volume.Large, path + " is not large");
  return Explore::ExploreVolume(volume, Explore::Settings());
}

void ExpectSame(
  const Explore::Exploration& large, const Explore::Exploration& small, const std::string& what)
{
  for (const char* const name : { "Force", "Value", "Contact" })
  {
    vtkDataArray* const a = large.Trace->GetPointData()->GetArray(name);
    vtkDataArray* const b = small.Trace->GetPointData()->GetArray(name);
    bool isSame = a->GetNumberOfValues() == b->GetNumberOfValues() && a->GetNumberOfTuples() > 1000;
    for (vtkIdType i = 0; isSame && i < a->GetNumberOfValues(); ++i)
    {
      const int n = a->GetNumberOfComponents();
      isSame = a->GetComponent(i / n, static_cast<int>(i % n)) ==
        b->GetComponent(i / n, static_cast<int>(i % n));
    }
    Expect(isSame, what + " gives another " + name);
  }
}

void ExpectLargeError(const std::string& path, const std::string& fault)
{
  std::string message = "nothing";
  try
  {
    Explore::LoadVolumes({ path }, true);
  }
  catch (const Explore::InputError& error)
  {
    message = error.what();
  }
  Expect(message.find(fault) != std::string::npos && message.find("Cure: ") != std::string::npos,
    "should say '" + fault + "', but said: " + message);
}

/// Expects that samples near a hand on the surface are loaded from the file.
void ExpectFelt(const Explore::Exploration& exploration)
{
  Explore::TouchScene touch;
  Explore::SceneOptions options;
  options.Width = 200;
  options.Height = 150;
  options.Interactive = true;
  options.Mapper = Explore::MapperChoice::CPU;
  Explore::BuildTouchScene(touch, exploration, options, {});
  touch.Device->GetVirtualHand()->SetPosition(
    exploration.Trace->GetPoint(exploration.Trace->GetNumberOfPoints() / 2));
  const bool isFelt = devicetest::Eventually(
    [&]
    {
      touch.Style->UpdateHaptics();
      touch.Device->UpdateState();
      return touch.Device->GetState()->GetResidency() == 1.0;
    });
  Expect(isFelt, "the window gets no samples: " + touch.Device->GetStatusText());
  touch.Device->Close();
}
} // namespace

int TestExploreLarge(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "TestExploreLarge");
  const vtkSmartPointer<vtkImageData> head = LoadHead(argc, argv);
  const std::string little = WriteLarge("head.raw", "junk" + MakeSamples(head, false));
  WriteLarge("head.big", MakeSamples(head, true));
  const std::string meta = "ObjectType = Image\nNDims = 3\nDimSize = " + Sizes(head, false) +
    "\nElementSpacing = " + Three(head->GetSpacing()) + "\nOffset = " + Three(head->GetOrigin()) +
    "\nElementType = MET_SHORT\nElementByteOrderMSB = False\nHeaderSize = -1\n";
  const std::string mhd = WriteLarge("head.mhd", meta + "ElementDataFile = head.raw\n");
  const std::string nrrd = WriteLarge("head.nhdr",
    "NRRD0004\ntype: short\ndimension: 3\nsizes: " + Sizes(head, false) + "\nspacings: " +
      Three(head->GetSpacing()) + "\nendian: big\nencoding: raw\ndata file: head.big\n\n");
  const std::string zarr = "{\"zarr_format\":2,\"shape\":" + Sizes(head, true) +
    ",\"chunks\":" + Sizes(head, true) +
    ",\"dtype\":\"<i2\",\"compressor\":null,\"fill_value\":0,\"order\":\"C\"," +
    "\"filters\":null}";
  WriteLarge("head.zarr/.zarray", zarr);
  WriteLarge("head.zarr/0.0.0", MakeSamples(head, false));

  const Explore::Volume plain = Explore::LoadVolumes({ Argument(argc, argv, "--volume") });
  Expect(!plain.Large, "a small file is large");
  const Explore::Exploration small = Explore::ExploreVolume(plain, Explore::Settings());
  const Explore::Exploration large = ExploreLarge(mhd);
  ExpectSame(large, small, "a MetaImage");
  ExpectFelt(large);
  Expect(!Explore::LoadVolumes({ mhd }).Large, "a small MetaImage is large");
  // The NRRD header has no origin, and Zarr has no spacing either: compare with the head at the
  // origin, and then also with a spacing of 1.
  vtkNew<vtkImageData> moved;
  moved->ShallowCopy(head);
  moved->SetOrigin(0.0, 0.0, 0.0);
  Explore::Volume other = plain;
  other.Image = moved;
  ExpectSame(ExploreLarge(nrrd), Explore::ExploreVolume(other, Explore::Settings()), "a NRRD");
  vtkNew<vtkImageData> plainest;
  plainest->ShallowCopy(moved);
  plainest->SetSpacing(1.0, 1.0, 1.0);
  other.Image = plainest;
  ExpectSame(ExploreLarge(folder + "/head.zarr/"),
    Explore::ExploreVolume(other, Explore::Settings()), "Zarr");

  ExpectLargeError(folder + "/none.zarr", "no such file");
  ExpectLargeError(WriteLarge("bad.vtkhdf", "no HDF5"), "no HDF5 file");
  ExpectLargeError(WriteLarge("lost.mhd", meta + "ElementDataFile = lost.raw\n"),
    "lost.raw, which can't be opened");
  WriteLarge("short.raw", "short");
  ExpectLargeError(WriteLarge("short.mhd", meta + "ElementDataFile = short.raw\n"), "more samples");
  ExpectLargeError(
    WriteLarge("packed.mhd", meta + "CompressedData = True\nElementDataFile = head.raw\n"),
    "compressed");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

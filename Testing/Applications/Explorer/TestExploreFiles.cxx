// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Reads files of types and sizes that VTK's readers do not support, headers that contradict the
// data, and samples that are NaN or infinite. The test writes the files byte by byte: MetaImage by
// "ITK/MetaIO/Documentation" (itk.org), with the sizes of MET_ValueTypeSize in its metaTypes.h,
// where MET_LONG has 4 bytes and MET_LONG_LONG 8; the header is the one that SimpleITK.WriteImage()
// writes for int64. NRRD is written by teem.sourceforge.net/nrrd/format.html, and NIfTI by
// nifti1.h.
#include "Applications/Explorer/Exploration/Inspection.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "VTK/Reading/InputError.h"
#include "VTK/Reading/LabelLoader.h"

#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkXMLImageDataWriter.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

namespace
{
constexpr int SIZE[3] = { 12, 8, 7 };
constexpr int COUNT = SIZE[0] * SIZE[1] * SIZE[2];

/// Returns the value of voxel i. Some values are negative, and neighbours are never equal.
int ValueAt(int i)
{
  return i % 500 - 200;
}

template <typename T>
void Put(std::string& bytes, std::size_t at, T value)
{
  bytes.resize(std::max(bytes.size(), at + sizeof(T)));
  std::memcpy(&bytes[at], &value, sizeof(T));
}

template <typename T>
std::string Samples(int count = COUNT)
{
  std::string bytes;
  for (int i = 0; i < count; ++i)
  {
    Put(bytes, bytes.size(), static_cast<T>(ValueAt(i)));
  }
  return bytes;
}

std::string Meta(const std::string& type, const std::string& sizes = "12 8 7",
  const std::string& more = std::string(), int axes = 3)
{
  const bool isFlat = axes == 3;
  return "ObjectType = Image\nNDims = " + std::to_string(axes) +
    "\nBinaryData = True\nBinaryDataByteOrderMSB = False\n" + more +
    "TransformMatrix = " + (isFlat ? "0 1 0 -1 0 0 0 0 1" : "0 1 0 0 -1 0 0 0 0 0 1 0 0 0 0 1") +
    "\nOffset = 5 6 7" + (isFlat ? "" : " 0") + "\nCenterOfRotation = 0 0 0" +
    (isFlat ? "" : " 0") + "\nAnatomicalOrientation = RAI\nElementSpacing = 0.5 2 4" +
    (isFlat ? "" : " 1") + "\nDimSize = " + sizes + "\nElementType = " + type +
    "\nElementDataFile = LOCAL\n";
}

std::string Nrrd(const std::string& type, const std::string& sizes = "12 8 7")
{
  return "NRRD0004\ntype: " + type +
    "\ndimension: 3\nspace: left-posterior-superior\nsizes: " + sizes +
    "\nspace directions: (0,0.5,0) (-2,0,0) (0,0,4)\nkinds: domain domain domain\nendian: "
    "little\nencoding: raw\nspace origin: (5,6,7)\n\n";
}

/// Returns a NIfTI file with the axes of the other formats, in right-anterior-superior.
std::string Nifti(int datatype, int bits, const short size[3])
{
  std::string header(352, '\0');
  Put(header, 0, std::int32_t{ 348 });
  const short dimensions[8] = { 3, size[0], size[1], size[2], 1, 1, 1, 1 };
  const float spacing[4] = { 1.0F, 0.5F, 2.0F, 4.0F };
  const float rows[12] = { 0, 2, 0, -5, -0.5F, 0, 0, -6, 0, 0, 4, 7 };
  std::memcpy(&header[40], dimensions, sizeof(dimensions));
  Put(header, 70, static_cast<short>(datatype));
  Put(header, 72, static_cast<short>(bits));
  std::memcpy(&header[76], spacing, sizeof(spacing));
  Put(header, 108, 352.0F);
  header[123] = 2;
  Put(header, 254, short{ 1 });
  std::memcpy(&header[280], rows, sizeof(rows));
  std::memcpy(&header[344], "n+1", 4);
  return header;
}

std::string File(const std::string& name, const std::string& content)
{
  const std::string path = folder + "/" + name;
  vtksys::ofstream(path.c_str(), std::ios::binary) << content;
  return path;
}

/// Expects voxel (i, j, k) at (5 - 2 j, 6 + i/2, 7 + 4 k) in left-posterior-superior.
void ExpectVolume(const std::string& path)
{
  try
  {
    const vtkSmartPointer<vtkImageData> image = Explore::LoadVolume(path).Image;
    int wrong = 0;
    for (int k = 0; k < SIZE[2]; ++k)
    {
      for (int j = 0; j < SIZE[1]; ++j)
      {
        for (int i = 0; i < SIZE[0]; ++i)
        {
          const double x[3] = { 5.0 - 2.0 * j, 6.0 + 0.5 * i, 7.0 + 4.0 * k };
          double at[3];
          image->TransformPhysicalPointToContinuousIndex(x, at);
          int index[3];
          bool isWithin = true;
          for (int c = 0; c < 3; ++c)
          {
            index[c] = static_cast<int>(std::lround(at[c]));
            isWithin = isWithin && std::abs(at[c] - index[c]) < 1e-5 && index[c] >= 0 &&
              index[c] < image->GetDimensions()[c];
          }
          const int number = i + SIZE[0] * (j + SIZE[1] * k);
          wrong += isWithin &&
              image->GetScalarComponentAsDouble(index[0], index[1], index[2], 0) == ValueAt(number)
            ? 0
            : 1;
        }
      }
    }
    Expect(wrong == 0, path + " has " + std::to_string(wrong) + " wrong voxels");
  }
  catch (const Explore::InputError& error)
  {
    Expect(false, std::string("it is read: ") + error.what());
  }
}

void ExpectRefusal(const std::string& path, const std::string& fault)
{
  for (const bool areLabels : { false, true })
  {
    std::string message = "nothing";
    try
    {
      Explore::Volume volume;
      areLabels ? Explore::LoadLabels(volume, path, {}) : void(volume = Explore::LoadVolume(path));
    }
    catch (const Explore::InputError& error)
    {
      message = error.what();
    }
    Expect(message.find(fault) != std::string::npos && message.find("Cure: ") != std::string::npos,
      path + " says " + fault + ", but says " + message);
  }
}

/// Writes the head phantom (air: -1000 HU) with some samples set to `bad`, either all around the
/// head or a single one in the middle, and with `added` added to the other samples. Expects that
/// the volume still counts as a CT, that the samples around the head are read as air, and that a
/// note contains `told`.
void ExpectCT(vtkImageData* head, const std::string& name, double bad, bool isAround,
  const std::string& told, double added = 0.0)
{
  vtkNew<vtkImageData> image;
  image->CopyStructure(head);
  image->AllocateScalars(VTK_FLOAT, 1);
  const int* const size = head->GetDimensions();
  for (vtkIdType p = 0; p < head->GetNumberOfPoints(); ++p)
  {
    const auto i = static_cast<double>(p % size[0]), j = static_cast<double>(p / size[0] % size[1]);
    const double r = std::hypot(i - 0.5 * (size[0] - 1), j - 0.5 * (size[1] - 1));
    const bool isBad = isAround ? r > 0.5 * size[0] : p == head->GetNumberOfPoints() / 2;
    image->GetPointData()->GetScalars()->SetComponent(
      p, 0, isBad ? bad : added + head->GetPointData()->GetScalars()->GetComponent(p, 0));
  }
  vtkNew<vtkXMLImageDataWriter> writer;
  const std::string path = folder + "/" + name;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
  const Explore::Exploration explored =
    Explore::ExploreVolume(Explore::LoadVolume(path), Explore::Settings());
  Expect(explored.Values.Kind == Explore::VolumeKind::CT, name + " is no CT");
  vtkImageData* const read = explored.Input.Image;
  Expect(!(isAround || added > 0.0) || read->GetScalarComponentAsDouble(0, 0, 0, 0) == -1000.0,
    name + " has a corner that is not air");
  Expect(explored.Trace->GetPointData()->GetArray("NormalForce")->GetMaxNorm() > 0.5,
    name + " is not felt");
  std::string notes;
  for (const std::string& note : explored.Input.Notes)
  {
    notes += note + "\n";
  }
  Expect(notes.find(told) != std::string::npos, name + " tells only: " + notes);
}
} // namespace

int TestExploreFiles(int argc, char* argv[])
{
  folder = MakeTestFolder(argc, argv, "ExploreFiles");
  ExpectVolume(File("short.mha", Meta("MET_SHORT") + Samples<std::int16_t>()));
  ExpectVolume(File("int64.mha", Meta("MET_LONG_LONG") + Samples<std::int64_t>()));
  ExpectVolume(File("long.mha", Meta("MET_LONG") + Samples<std::int32_t>()));
  ExpectVolume(File("frame.mha", Meta("MET_SHORT", "12 8 7 1", "", 4) + Samples<std::int16_t>()));
  ExpectVolume(File("int64.nrrd", Nrrd("int64") + Samples<std::int64_t>()));
  const short size[3] = { 12, 8, 7 };
  constexpr int int16 = 4, int64 = 1024; // NIFTI_TYPE_INT16, NIFTI_TYPE_INT64
  ExpectVolume(File("short.nii", Nifti(int16, 16, size) + Samples<std::int16_t>()));
  ExpectVolume(File("int64.nii", Nifti(int64, 64, size) + Samples<std::int64_t>()));

  ExpectVolume(
    File("times.mha", Meta("MET_SHORT", "12 8 7 3", "", 4) + Samples<std::int16_t>(3 * COUNT)));
  ExpectRefusal(
    File("packed.mha",
      Meta("MET_LONG_LONG", "12 8 7", "CompressedData = True\nCompressedDataSize = 10\n") +
        "abcdefghij"),
    "compressed");
  ExpectRefusal(File("lying.mha", Meta("MET_SHORT", "12 8 8") + Samples<std::int16_t>()),
    "ends before the last");
  ExpectRefusal(File("huge.mha", Meta("MET_SHORT", "40000 40000 40000") + Samples<std::int16_t>()),
    "announces more voxels than the file has");
  ExpectRefusal(
    File("huge64.mha", Meta("MET_LONG_LONG", "40000 40000 40000") + Samples<std::int64_t>()),
    "more samples than");
  ExpectRefusal(File("type.mha", Meta("MET_STRING") + Samples<std::int16_t>()), "another type");
  const short huge[3] = { 32767, 32767, 32767 };
  ExpectRefusal(
    File("huge.nii", Nifti(int16, 16, huge) + Samples<std::int16_t>()), "announces more voxels");
  ExpectRefusal(
    File("huge.vti",
      "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\"><ImageData "
      "WholeExtent=\"0 30000 0 30000 0 30000\" Origin=\"0 0 0\" Spacing=\"1 1 1\"><Piece "
      "Extent=\"0 "
      "30000 0 30000 0 30000\"><PointData Scalars=\"V\"><DataArray type=\"Int16\" Name=\"V\" "
      "format=\"ascii\">1 2 3</DataArray></PointData></Piece></ImageData></VTKFile>\n"),
    "announces more voxels");
  for (const char* const type : { "short", "int64" })
  {
    std::string message = "nothing";
    try
    {
      Explore::LoadVolume(
        File("huge.nrrd", Nrrd(type, "40000 40000 40000") + Samples<std::int16_t>()));
    }
    catch (const Explore::InputError& error)
    {
      message = error.what();
    }
    Expect(message.find("announces more voxels") != std::string::npos, message);
  }

  const vtkSmartPointer<vtkImageData> head = LoadHead(argc, argv);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  ExpectCT(head, "infinite.vti", infinity, false, "");
  for (const double enormous : { 1e38, -1e38 })
  {
    ExpectCT(head, "enormous.vti", enormous, false, "is taken for \"missing\"");
    ExpectCT(head, "enormous.vti", enormous, false, "Hounsfield units + 1024", 1024.0);
  }
  ExpectCT(head, "masked.vti", std::nan(""), true, "has samples that are no numbers");
  for (const double missing : { -9999.0, -32768.0, 1e37 })
  {
    ExpectCT(head, "missing.vti", missing, true, "is taken for \"missing\"");
  }
  for (const double added : { 1024.0, 1000.0, 32768.0 })
  {
    ExpectCT(head, "stored.vti", added, false,
      "Hounsfield units + " + std::to_string(static_cast<int>(added)), added);
  }

  // Expects that hidden tissue can still be touched, and that a message says so.
  Explore::Volume onTable = Explore::LoadVolume(Argument(argc, argv, "--volume"));
  Expect(Explore::ExploreVolume(onTable, Explore::Settings()).Hidden.empty(),
    "something of the head is hidden");
  const int* const n = onTable.Image->GetDimensions();
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      onTable.Image->SetScalarComponentFromDouble(0, j, k, 0, 100.0);
    }
  }
  // more notes than fit into the window
  onTable.Notes.insert(onTable.Notes.end(), 5, "a note of the file");
  const Explore::Exploration felt = Explore::ExploreVolume(onTable, Explore::Settings());
  Expect(
    felt.Hidden.find("Felt but not shown") == 0, "a table is hidden, and told is: " + felt.Hidden);
  const Explore::Inspection facts(felt.Input, felt.Values, felt.Materials, felt.Filter);
  Expect(facts.ListTold().find(felt.Hidden) != std::string::npos,
    "the window tells: " + facts.ListTold());
  // The list of keys includes all facts that --inspect prints.
  for (const char* const fact : { "format\t", "voxels\t", "size\t", "from\t", "axes\t", "values\t",
         "nearly", "kind\tCT; ", "padding\tnone", "noise\t", "least\tsheets of ",
         "preset\tCT contrast, because ", "\tFelt but not shown" })
  {
    Expect(facts.ListFacts().find(fact) != std::string::npos,
      std::string(fact) + " is not in: " + facts.ListFacts());
  }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

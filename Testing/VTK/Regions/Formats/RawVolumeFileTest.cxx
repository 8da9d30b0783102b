// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests raw files: samples of all types and both byte orders at the positions that the format
 * defines, files that are too short or shrink, paths that are no files, and a sparse file of 40 GB.
 * The tests write the bytes individually.
 */

#include "Rigs/TemporaryFolder.h"
#include "VTK/Regions/LargeRig.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>

#include <fstream>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace largetest;

namespace
{
constexpr Extent Box = { 2, 13, -3, 6, 0, 8 }; // 12 x 10 x 9 samples
constexpr int Header = 37;

double ValueOf(int i, int j, int k)
{
  return (7 * i + 11 * (j + 3) + 13 * k) % 100;
}

template <typename T>
void WriteSample(std::ofstream& file, T value, bool isBig)
{
  unsigned char bytes[sizeof(T)];
  std::copy_n(reinterpret_cast<const unsigned char*>(&value), sizeof(T), bytes);
  const int probe = 1;
  const bool isHostBig = *reinterpret_cast<const char*>(&probe) == 0;
  if (isBig != isHostBig)
  {
    std::reverse(bytes, bytes + sizeof(T));
  }
  file.write(reinterpret_cast<const char*>(bytes), sizeof(T));
}

template <typename T>
void WriteFile(const std::string& name, bool isBig)
{
  std::ofstream file(name, std::ios::binary);
  file << std::string(Header, 'h');
  for (int k = Box[4]; k <= Box[5]; ++k)
  {
    for (int j = Box[2]; j <= Box[3]; ++j)
    {
      for (int i = Box[0]; i <= Box[1]; ++i)
      {
        WriteSample(file, static_cast<T>(ValueOf(i, j, k)), isBig);
      }
    }
  }
}

void WriteFile(const std::string& name, int type, bool isBig)
{
  switch (type)
  {
    vtkTemplateMacro(WriteFile<VTK_TT>(name, isBig));
  }
}

vtkSmartPointer<vtkHapticRegionSource> OpenFile(const std::string& name, int type)
{
  auto source = vtkSmartPointer<vtkHapticRegionSource>::New();
  source->SetFileName(name.c_str());
  source->SetScalarType(type);
  source->SetWholeExtent(Box.data());
  source->SetHeaderSize(Header);
  return source;
}

void ExpectUnread(vtkHapticRegionSource* source, const std::vector<std::string>& words)
{
  const MessageLog log(source);
  vtkNew<vtkImageData> image;
  const int region[6] = { 2, 13, -3, 6, 5, 8 };
  EXPECT_FALSE(source->ReadRegion(region, image));
  ASSERT_EQ(log.Errors.size(), 1U);
  for (const std::string& word : words)
  {
    EXPECT_NE(log.Errors[0].find(word), std::string::npos) << log.Errors[0];
  }
}

/// Returns a memory size in /proc/self/status (MiB).
double StatusOf(const std::string& name)
{
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
  {
    if (line.compare(0, name.size(), name) == 0)
    {
      return std::stod(line.substr(name.size() + 1)) / 1024.0;
    }
  }
  return 0.0;
}
} // namespace

TEST(RawVolumeFile, GivesTheSamplesOfAllTypesAndByteOrders)
{
  const std::string name = TemporaryPath("All.raw");
  for (const int type : { VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT, VTK_UNSIGNED_SHORT,
         VTK_INT, VTK_UNSIGNED_INT, VTK_LONG_LONG, VTK_UNSIGNED_LONG_LONG, VTK_FLOAT, VTK_DOUBLE })
  {
    for (const bool isBig : { false, true })
    {
      SCOPED_TRACE(testing::Message() << type << (isBig ? " big" : " little"));
      WriteFile(name, type, isBig);
      const auto source = OpenFile(name, type);
      isBig ? source->SetByteOrderToBigEndian() : source->SetByteOrderToLittleEndian();
      vtkNew<vtkImageData> image;
      const int region[6] = { 4, 9, 0, 6, 3, 5 };
      ASSERT_TRUE(source->ReadRegion(region, image));
      EXPECT_EQ(image->GetScalarType(), type);
      for (int k = 3; k <= 5; ++k)
      {
        for (int j = 0; j <= 6; ++j)
        {
          for (int i = 4; i <= 9; ++i)
          {
            ASSERT_EQ(image->GetScalarComponentAsDouble(i, j, k, 0), ValueOf(i, j, k));
          }
        }
      }
    }
  }
}

TEST(RawVolumeFile, ThatIsShortIsToldWithTheByte)
{
  const std::string name = TemporaryPath("Short.raw");
  WriteFile(name, VTK_SHORT, false);
  ASSERT_EQ(truncate(name.c_str(), Header + 2 * 12 * 10 * 8 + 10), 0);
  const auto source = OpenFile(name, VTK_SHORT);
  ExpectUnread(source, { "Short.raw", "ends before byte 1968", "whether the file is complete" });
  WriteFile(name, VTK_SHORT, false);
  vtkNew<vtkImageData> image;
  const int region[6] = { 2, 13, -3, 6, 5, 8 };
  EXPECT_TRUE(source->ReadRegion(region, image)) << "the file is read as it is now";
  ASSERT_EQ(truncate(name.c_str(), 100), 0);
  ExpectUnread(source, { "(2 to 13, -3 to 6, 5 to 8)", "ends before byte 1238" });
}

TEST(RawVolumeFile, ThatIsNoneIsToldWithoutHanging)
{
  const std::string pipe = TemporaryPath("Pipe.raw");
  (void)unlink(pipe.c_str());
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  ExpectUnread(OpenFile(pipe, VTK_SHORT), { "no regular file" });
  (void)unlink(pipe.c_str());
  ExpectUnread(OpenFile("/", VTK_SHORT), { "the file /", "no regular file" });
  ExpectUnread(OpenFile("/nowhere/Bone.raw", VTK_SHORT), { "/nowhere/Bone.raw", "No such file" });
}

/// Writes a header, and returns a source that has opened it, or null on failure.
vtkSmartPointer<vtkHapticRegionSource> OpenHeader(
  const std::string& name, const std::string& text, std::string& error)
{
  const std::string path = TemporaryPath(name);
  std::ofstream(path, std::ios::binary) << text;
  auto source = vtkSmartPointer<vtkHapticRegionSource>::New();
  return source->OpenFile(path.c_str(), error) ? source : nullptr;
}

/// Expects all samples in the order of the file, and the sample (1, 2, 3) at the position `corner`.
void ExpectOpened(vtkHapticRegionSource* source, int type, const Point& corner)
{
  ASSERT_TRUE(source);
  const int whole[6] = { 0, 11, 0, 9, 0, 8 };
  ASSERT_TRUE(std::equal(whole, whole + 6, source->GetWholeExtent()));
  vtkNew<vtkImageData> image;
  ASSERT_TRUE(source->ReadRegion(whole, image));
  EXPECT_EQ(image->GetScalarType(), type);
  for (int k = 0; k <= 8; ++k)
  {
    for (int j = 0; j <= 9; ++j)
    {
      for (int i = 0; i <= 11; ++i)
      {
        ASSERT_EQ(image->GetScalarComponentAsDouble(i, j, k, 0), ValueOf(i + 2, j - 3, k));
      }
    }
  }
  double x[3];
  image->TransformIndexToPhysicalPoint(1, 2, 3, x);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(x[c], corner[c], 1e-12);
  }
}

// The positions are computed by hand from the descriptions of the formats. In MetaImage, the
// direction of index axis c is row c of the matrix; in NRRD, the step along axis c is vector c. A
// rotation by 180 degrees about z converts right-anterior-superior to left-posterior-superior.
TEST(RawVolumeFile, IsOpenedByTheHeaderOfAMetaImageOrANrrd)
{
  const std::string meta = "ObjectType = Image\nNDims = 3\nDimSize = 12 10 9\n"
                           "ElementSpacing = 0.5 2 4\nOffset = 10 20 30\n";
  std::string error;
  WriteFile(TemporaryPath("Opened.raw"), VTK_SHORT, false);
  ExpectOpened(OpenHeader("Opened.mhd",
                 meta + "TransformMatrix = 0 1 0 -1 0 0 0 0 1\nElementType = MET_SHORT\n" +
                   "HeaderSize = 37\nElementDataFile = Opened.raw\n",
                 error),
    VTK_SHORT, { 10 - 4, 20 + 0.5, 30 + 12 });
  WriteFile(TemporaryPath("Opened.big"), VTK_FLOAT, true);
  const std::string nrrd = "NRRD0004\n# a comment\ntype: float\ndimension: 3\nsizes: 12 10 9\n"
                           "endian: big\nencoding: raw\nbyte skip: -1\ndata file: Opened.big\n";
  ExpectOpened(OpenHeader("Opened.nhdr",
                 nrrd + "space: right-anterior-superior\nspace origin: (10,20,30)\n" +
                   "space directions: (0,0.5,0) (2,0,0) (0,0,4)\n\n",
                 error),
    VTK_FLOAT, { -14, -20.5, 42 });
  ExpectOpened(
    OpenHeader("Plain.nhdr", nrrd + "spacings: 0.5 2 4\n\n", error), VTK_FLOAT, { 0.5, 4, 12 });
  EXPECT_TRUE(error.empty()) << error;
}

TEST(RawVolumeFile, WhoseHeaderIsNoneOrWrongIsTold)
{
  const std::string meta = "DimSize = 12 10 9\nElementType = MET_SHORT\nElementDataFile = ";
  WriteFile(TemporaryPath("Told.raw"), VTK_SHORT, false);
  const std::pair<std::string, std::string> cases[] = { { meta + "Lost.raw\n",
                                                          "Lost.raw, which can't be opened" },
    { "HeaderSize = 100\n" + meta + "Told.raw\n", "more samples than" },
    { "CompressedData = True\n" + meta + "Told.raw\n", "compressed" },
    { "ElementNumberOfChannels = 3\n" + meta + "Told.raw\n", "another type" },
    { "DimSize = 12 1e300 9\nElementType = MET_SHORT\nElementDataFile = Told.raw\n", "mirrored" },
    { "DimSize = 2147483647 2147483647 2147483647\n" + meta.substr(18) + "Told.raw\n",
      "more samples than" },
    { "DimSize = 12 nan 9\nElementType = MET_SHORT\nElementDataFile = Told.raw\n", "mirrored" },
    { "\x01\x02 junk without a line", "can't be read region by region" }, { "", "can't be read" } };
  for (const auto& [text, why] : cases)
  {
    std::string error;
    EXPECT_FALSE(OpenHeader("Told.mhd", text, error)) << text;
    EXPECT_NE(error.find("Told.mhd can't be opened: "), std::string::npos) << error;
    EXPECT_NE(error.find(why), std::string::npos) << error;
  }
  vtkNew<vtkHapticRegionSource> source;
  std::string error;
  EXPECT_FALSE(source->OpenFile("/nowhere/Bone.nrrd", error));
  EXPECT_NE(error.find("No such file"), std::string::npos) << error;
}

TEST(RawVolumeFile, OfFortyGigabytesIsFeltInALittleMemory)
{
  constexpr int size = 2720;
  constexpr int side = 220;
  constexpr int first = 1250;
  const auto value = [](int i, int j, int k)
  {
    const double r = std::hypot(i - 1360.0, j - 1360.0, k - 1360.0);
    return std::round(1000.0 / (1.0 + std::exp(r - 80.0)));
  };
  const std::string name = TemporaryPath("Sparse.raw");
  (void)unlink(name.c_str());
  const int file = open(name.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  ASSERT_GE(file, 0);
  ASSERT_EQ(ftruncate(file, off_t{ 2 } * size * size * size), 0) << "40 GB, without taking them";
  // Write a ball into the middle of the file, and also into an image that specifies its position in
  // the volume.
  vtkNew<vtkImageData> part;
  part->SetExtent(first, first + side - 1, first, first + side - 1, first, first + side - 1);
  part->AllocateScalars(VTK_SHORT, 1);
  auto* const samples = static_cast<short*>(part->GetScalarPointer());
  for (int k = 0; k < side; ++k)
  {
    for (int j = 0; j < side; ++j)
    {
      short* const row = samples + (k * side + j) * side;
      for (int i = 0; i < side; ++i)
      {
        row[i] = static_cast<short>(value(first + i, first + j, first + k));
      }
      const off_t at = 2 * ((off_t{ first + k } * size + first + j) * size + first);
      ASSERT_EQ(pwrite(file, row, 2 * side, at), 2 * side);
    }
  }
  close(file);
  vtkNew<vtkIntArray> whole;
  whole->SetName("HapticWholeExtent");
  vtkNew<vtkDoubleArray> noise; // the noise is 0, because almost all blocks are zeros
  noise->SetName("HapticNoise");
  noise->InsertNextValue(0.0);
  vtkNew<vtkDoubleArray> border;
  border->SetName("HapticBorderValue");
  border->InsertNextValue(0.0);
  for (int bound = 0; bound < 6; ++bound)
  {
    whole->InsertNextValue(bound % 2 ? size - 1 : 0);
  }
  for (vtkDataArray* const array : { static_cast<vtkDataArray*>(whole),
         static_cast<vtkDataArray*>(noise), static_cast<vtkDataArray*>(border) })
  {
    part->GetFieldData()->AddArray(array);
  }

  std::vector<Point> points;
  for (int t = 0; t < 20000; ++t)
  {
    // The path circles the ball, and moves in and out of it.
    const double angle = 0.0009 * t;
    const double tilt = 0.7 * std::sin(0.0004 * t);
    const double r = 80.0 + 2.0 * std::sin(0.01 * t);
    points.push_back({ 1360.0 + r * std::cos(angle) * std::cos(tilt),
      1360.0 + r * std::sin(angle) * std::cos(tilt), 1360.0 + r * std::sin(tilt) });
  }
  const auto path = MakePath(points);
  vtkNew<vtkVolumeHapticsFilter> felt;
  felt->SetPathData(path);
  felt->SetInputData(0, part);
  felt->Update();
  EXPECT_GT(felt->GetOutput()->GetPointData()->GetArray("Force")->GetMaxNorm(), 0.5);

  vtkNew<vtkHapticRegionSource> source;
  source->SetFileName(name.c_str());
  source->SetWholeExtent(0, size - 1, 0, size - 1, 0, size - 1);
  vtkNew<vtkVolumeHapticsFilter> touch;
  touch->SetPathData(path);
  touch->SetInputConnection(0, source->GetOutputPort());
  const MessageLog log(touch);
  const double before = StatusOf("VmHWM");
  touch->Update();
  const double growth = StatusOf("VmHWM") - before;
  EXPECT_EQ(log.Errors.size(), 0U);
  EXPECT_TRUE(IsSame(felt->GetOutput(), touch->GetOutput()));
  std::cout << "resident memory grew by " << growth << " MiB\n";
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  EXPECT_LT(growth, 300.0);
#endif
  (void)unlink(name.c_str());
}

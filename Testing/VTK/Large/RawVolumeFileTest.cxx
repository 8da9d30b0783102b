// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Raw files: the bytes at the places where a reader of the format expects them, of all types and
 * both byte orders; files that are short, shrink, or are none; and a file of 40 GB, almost all of
 * which is a hole. The tests write the bytes one by one.
 */

#include "LargeRig.h"
#include "Rigs/TemporaryFolder.h"

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
constexpr Extent Box = { 2, 13, -3, 6, 0, 8 }; // 12 x 10 x 9
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

/// A line of /proc/self/status, in MiB.
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
  // A ball in the middle, and the same in an image that says of what it is a part.
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
  vtkNew<vtkDoubleArray> noise; // of blocks that are all zeros
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
    // Around the ball and over it, in and out.
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

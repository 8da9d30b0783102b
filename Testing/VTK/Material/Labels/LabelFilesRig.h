// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture for label files that tests write, and for the tables that are read from them. */
#ifndef LabelFilesRig_h
#define LabelFilesRig_h

#include "Rigs/ApiRig.h"
#include "Rigs/TemporaryFolder.h"

#include <vtkHapticLabelTable.h>

#include <zlib.h>

#include <fstream>
#include <sstream>

namespace labeltest
{
inline void Write(const std::string& file, const std::string& bytes)
{
  std::ofstream(file, std::ios::binary) << bytes;
}

inline std::string Compress(const std::string& bytes)
{
  const std::string file = TemporaryPath("Compressed.gz");
  gzFile out = gzopen(file.c_str(), "wb");
  gzwrite(out, bytes.data(), static_cast<unsigned>(bytes.size()));
  gzclose(out);
  std::ifstream in(file, std::ios::binary);
  std::ostringstream compressed;
  compressed << in.rdbuf();
  return compressed.str();
}

class LabelFiles : public testing::Test
{
protected:
  /// Reads a file with these bytes, and expects success.
  void Read(const std::string& bytes, const std::string& name = "Labels.txt")
  {
    const std::string file = TemporaryPath(name);
    Write(file, bytes);
    EXPECT_TRUE(this->Table->ReadFile(file.c_str()));
    for (const std::string& error : this->Log.Errors)
    {
      ADD_FAILURE() << error;
    }
    this->Log.Errors.clear();
  }

  /// Reads a file with these bytes into a table with entries. Expects one error with the file's
  /// name and all these words, and an unchanged table.
  void Refuse(const std::string& bytes, const std::vector<std::string>& words,
    const std::string& name = "Labels.txt")
  {
    const std::string file = TemporaryPath(name);
    Write(file, bytes);
    this->RefuseFile(file, words);
  }
  void RefuseFile(const std::string& file, const std::vector<std::string>& words)
  {
    this->Table->SetStiffness(77, 7.0);
    const vtkMTimeType before = this->Table->GetMTime();
    const vtkIdType count = this->Table->GetNumberOfLabels();
    EXPECT_FALSE(this->Table->ReadFile(file.c_str()));
    ASSERT_EQ(this->Log.Errors.size(), 1u);
    const std::string& error = this->Log.Errors[0];
    EXPECT_NE(error.find(file), std::string::npos) << error;
    for (const std::string& word : words)
    {
      EXPECT_NE(error.find(word), std::string::npos) << error << "\nlacks: " << word;
    }
    this->Log.Errors.clear();
    EXPECT_EQ(this->Table->GetMTime(), before);
    EXPECT_EQ(this->Table->GetNumberOfLabels(), count);
  }

  void ExpectLabels(const std::vector<int>& labels)
  {
    std::vector<int> found;
    for (vtkIdType i = 0; i < this->Table->GetNumberOfLabels(); ++i)
    {
      found.push_back(this->Table->GetLabel(i));
    }
    EXPECT_EQ(found, labels);
  }
  void ExpectColor(int label, double red, double green, double blue)
  {
    double color[3];
    this->Table->GetColor(label, color);
    EXPECT_TRUE(this->Table->HasColor(label));
    EXPECT_NEAR(color[0], red, 1e-12) << label;
    EXPECT_NEAR(color[1], green, 1e-12) << label;
    EXPECT_NEAR(color[2], blue, 1e-12) << label;
  }

  vtkNew<vtkHapticLabelTable> Table;
  apitest::MessageLog Log{ this->Table };
};
} // namespace labeltest

#endif

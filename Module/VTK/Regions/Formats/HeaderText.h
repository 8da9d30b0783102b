// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Parses the text header of a MetaImage file.
 */
#ifndef HeaderText_h
#define HeaderText_h

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** The lines `key = value` of a header. */
class HeaderText
{
public:
  explicit HeaderText(const std::string& path);

  /** Returns the value of the first of these keys that exists; empty if none does. */
  std::string Value(const std::vector<std::string>& keys) const;

  /**
   * Returns whether a value is true by MetaIO's rule, that is, begins with T, t or 1. Returns
   * `otherwise` if the value is missing.
   */
  bool IsTrue(const std::vector<std::string>& keys, bool otherwise = false) const;

  /** Returns the numbers in a value and skips words. */
  std::vector<double> Numbers(const std::vector<std::string>& keys) const;

  /**
   * Returns the size of the header (bytes), after which samples may begin; 0 if its end was not
   * found.
   */
  std::size_t GetSize() const { return this->Size; }

  /**
   * Returns whether MetaIO can parse the header safely, with the same keys: every line is `key =
   * value`, each key occurs once, and keys and values have at most 254 characters. Otherwise MetaIO
   * may write past the end of its memory, for a long text, or for an array that a second NDims
   * enlarges.
   */
  bool IsPlain() const { return this->Size > 0 && this->HasPlainLines; }

  /** Returns the length (mm) of a MetaImage's DistanceUnits; 1 if it is missing or unknown. */
  double GetMetaUnit() const;

  /** Returns notes on what was assumed, converted or ignored in a MetaImage. */
  std::vector<std::string> DescribeMeta() const;

private:
  bool HasPlainLines = true;
  std::size_t Size = 0;
  std::map<std::string, std::string> Fields;
};

} // namespace VolumeHaptics

#endif

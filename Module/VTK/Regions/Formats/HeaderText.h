// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the text at the beginning of a MetaImage file.
 */
#ifndef HeaderText_h
#define HeaderText_h

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** The lines `key = value` of the text. */
class HeaderText
{
public:
  explicit HeaderText(const std::string& path);

  /** Returns the value of the first of these keys that exists; empty if none does. */
  std::string Value(const std::vector<std::string>& keys) const;

  /**
   * Returns whether a value is true by MetaIO's rule: it begins with T, t or 1. Without a value,
   * returns `otherwise`.
   */
  bool IsTrue(const std::vector<std::string>& keys, bool otherwise = false) const;

  /** Returns the numbers in the value; words are left out. */
  std::vector<double> Numbers(const std::vector<std::string>& keys) const;

  /**
   * Returns the size of the header (bytes), after which samples may begin; 0 if its end was not
   * found.
   */
  std::size_t GetSize() const { return this->Size; }

  /**
   * Returns whether MetaIO finds the same keys in a MetaImage's header, and has room for them:
   * every line is `key = value`, no key comes twice, and neither is longer than 254 letters.
   * Otherwise MetaIO may write past the end of its memory: for a long text, or for an array that a
   * second NDims enlarges.
   */
  bool IsPlain() const { return this->Size > 0 && this->HasPlainLines; }

  /** Returns the length (mm) of a MetaImage's DistanceUnits; 1 if it is not given or not known. */
  double GetMetaUnit() const;

  /** Returns notes on a MetaImage's facts that are assumed, converted or left out. */
  std::vector<std::string> DescribeMeta() const;

private:
  bool HasPlainLines = true;
  std::size_t Size = 0;
  std::map<std::string, std::string> Fields;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Base/HapticSetupNode.h"

#include <cctype>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

std::string StartSentence(std::string text)
{
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text + ".";
}

std::string Describe(const NumberRange& range)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "a number";
  const NumberRange any = AnyNumber();
  if (range.Minimum > any.Minimum && range.Maximum < any.Maximum)
  {
    text << " from " << range.Minimum << " to " << range.Maximum;
  }
  else if (range.Minimum > any.Minimum)
  {
    text << " of " << range.Minimum << " or more";
  }
  return text.str();
}

/** Returns a value of the file as one shortened line of text, for errors. */
std::string Quote(const Json::Value& value)
{
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "";
  builder["useSpecialFloats"] = true;
  builder["precision"] = 6;
  std::string text = Json::writeString(builder, value);
  constexpr std::size_t longest = 60;
  return text.size() > longest ? text.substr(0, longest) + "..." : text;
}

Json::Value ToJson(const NumberRow& row)
{
  Json::Value list(Json::arrayValue);
  for (const double number : row)
  {
    list.append(number);
  }
  return list;
}

} // namespace

//------------------------------------------------------------------------------
Json::Value NewSetupFile(const SetupFileKind& kind)
{
  Json::Value root(Json::objectValue);
  root["Format"] = kind.Format;
  root["Version"] = kind.Version;
  return root;
}

//------------------------------------------------------------------------------
bool ParseSetupFile(
  const std::string& text, const SetupFileKind& kind, Json::Value& root, std::string& error)
{
  if (!ParseJson(text, root, error))
  {
    error += std::string(" Correct it there, or ") + kind.Again + ".";
    return false;
  }
  if (!root.isObject() || !root["Format"].isString() || root["Format"].asString() != kind.Format)
  {
    error = std::string("it is not a ") + kind.Noun + ", which has \"Format\": \"" + kind.Format +
      "\". Choose a file " + kind.Cure + ".";
    return false;
  }
  if (!root["Version"].isInt() || root["Version"].asInt() < 1)
  {
    error = "its Version is not a whole number of 1 or more. " + StartSentence(kind.Again);
    return false;
  }
  if (root["Version"].asInt() > kind.Version)
  {
    error = "its Version is " + std::to_string(root["Version"].asInt()) +
      ", which is newer than this software's " + std::to_string(kind.Version) +
      ". Update VTK Volume Haptics.";
    return false;
  }
  return true;
}

NumberRange AnyNumber()
{
  return { std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max() };
}

NumberRange NotNegative()
{
  return { 0.0, std::numeric_limits<double>::max() };
}

//------------------------------------------------------------------------------
SetupNode::SetupNode(SetupPass& pass, Json::Value* json, std::string path)
  : Pass(pass)
  , Json(json)
  , Path(std::move(path))
{
}

std::string SetupNode::PathOf(const std::string& key) const
{
  return this->Path.empty() ? key : this->Path + "." + key;
}

bool SetupNode::Has(const char* key) const
{
  return this->Json && this->Json->isMember(key);
}

std::vector<std::string> SetupNode::GetKeys() const
{
  return this->Json ? this->Json->getMemberNames() : std::vector<std::string>();
}

const Json::Value* SetupNode::Find(const char* key) const
{
  return !this->Pass.Writing && this->Pass.Error.empty() && this->Has(key) ? &(*this->Json)[key]
                                                                           : nullptr;
}

void SetupNode::Fail(const std::string& path, const Json::Value& found, const std::string& wanted)
{
  if (this->Pass.Error.empty())
  {
    this->Pass.Error = path + " is " + Quote(found) + ", but has to be " + wanted + ".";
  }
}

SetupNode SetupNode::Child(const std::string& key)
{
  const std::string path = this->PathOf(key);
  if (this->Pass.Writing)
  {
    return { this->Pass, &((*this->Json)[key] = Json::Value(Json::objectValue)), path };
  }
  const Json::Value* const found = this->Find(key.c_str());
  if (found && !found->isObject())
  {
    this->Fail(path, *found, "an object in { }");
  }
  return { this->Pass, found && found->isObject() ? &(*this->Json)[key] : nullptr, path };
}

//------------------------------------------------------------------------------
bool SetupNode::ReadNumber(
  const Json::Value& value, const std::string& path, const NumberRange& range, double& number)
{
  number = value.isNumeric() ? value.asDouble() : std::nan("");
  if (number >= range.Minimum && number <= range.Maximum)
  {
    return true;
  }
  this->Fail(path, value, Describe(range));
  return false;
}

void SetupNode::Number(const char* key, const NumberRange& range,
  const std::function<double()>& get, const std::function<void(double)>& set)
{
  double number = 0.0;
  if (this->Pass.Writing)
  {
    (*this->Json)[key] = get();
  }
  else if (const auto* value = this->Find(key);
           value && this->ReadNumber(*value, this->PathOf(key), range, number))
  {
    this->Then([set, number] { set(number); });
  }
}

void SetupNode::Integer(const char* key, int minimum, int maximum, const std::function<int()>& get,
  const std::function<void(int)>& set)
{
  if (this->Pass.Writing)
  {
    (*this->Json)[key] = get();
  }
  else if (const auto* value = this->Find(key))
  {
    const bool good = value->isInt() && value->asInt() >= minimum && value->asInt() <= maximum;
    this->Require(key, good,
      "a whole number from " + std::to_string(minimum) + " to " + std::to_string(maximum));
    const int number = good ? value->asInt() : 0;
    this->Then([set, number] { set(number); });
  }
}

void SetupNode::Flag(
  const char* key, const std::function<bool()>& get, const std::function<void(bool)>& set)
{
  if (this->Pass.Writing)
  {
    (*this->Json)[key] = get();
  }
  else if (const auto* value = this->Find(key))
  {
    this->Require(key, value->isBool(), "true or false");
    const bool flag = value->isBool() && value->asBool();
    this->Then([set, flag] { set(flag); });
  }
}

void SetupNode::Text(const char* key, const std::function<std::string()>& get,
  const std::function<void(const std::string&)>& set,
  const std::function<std::string(const std::string&)>& check)
{
  if (this->Pass.Writing)
  {
    (*this->Json)[key] = get();
  }
  else if (const auto* value = this->Find(key))
  {
    this->Require(key, value->isString(), "a text in quotes");
    const std::string text = value->isString() ? value->asString() : std::string();
    const std::string fault = check ? check(text) : std::string();
    if (!fault.empty() && this->Pass.Error.empty())
    {
      this->Pass.Error = this->PathOf(key) + " can't be set: " + fault;
    }
    this->Then([set, text] { set(text); });
  }
}

int SetupNode::Choice(const char* key, const std::vector<const char*>& names,
  const std::function<int()>& get, const std::function<void(int)>& set)
{
  int chosen = -1;
  if (this->Pass.Writing)
  {
    const auto given = static_cast<std::size_t>(get());
    (*this->Json)[key] = given < names.size() ? names[given] : "unknown";
  }
  else if (const auto* value = this->Find(key))
  {
    std::string wanted = "one of";
    for (std::size_t i = 0; i < names.size(); ++i)
    {
      wanted += std::string(i > 0 ? ", \"" : " \"") + names[i] + "\"";
      chosen = value->isString() && value->asString() == names[i] ? static_cast<int>(i) : chosen;
    }
    this->Require(key, chosen >= 0, wanted);
    this->Then([set, chosen] { set(chosen); });
  }
  return chosen;
}

//------------------------------------------------------------------------------
bool SetupNode::ReadRow(const Json::Value& value, const std::string& path,
  const std::vector<NumberRange>& columns, NumberRow& row)
{
  if (!value.isArray() || value.size() != columns.size())
  {
    this->Fail(path, value, "a list of " + std::to_string(columns.size()) + " numbers");
    return false;
  }
  row.resize(columns.size());
  for (Json::ArrayIndex i = 0; i < value.size(); ++i)
  {
    if (!this->ReadNumber(value[i], path + "[" + std::to_string(i) + "]", columns[i], row[i]))
    {
      return false;
    }
  }
  return true;
}

NumberRow SetupNode::Row(const char* key, std::size_t size, const std::function<NumberRow()>& get,
  const std::function<void(const NumberRow&)>& set)
{
  NumberRow row;
  const std::vector<NumberRange> columns(size, AnyNumber());
  if (this->Pass.Writing)
  {
    (*this->Json)[key] = ToJson(get());
  }
  else if (const auto* value = this->Find(key);
           value && this->ReadRow(*value, this->PathOf(key), columns, row))
  {
    this->Then([set, row] { set(row); });
    return row;
  }
  return {};
}

void SetupNode::Table(const char* key, const std::vector<NumberRange>& columns,
  const std::function<std::vector<NumberRow>()>& get,
  const std::function<void(const std::vector<NumberRow>&)>& set)
{
  if (this->Pass.Writing)
  {
    Json::Value& list = (*this->Json)[key] = Json::Value(Json::arrayValue);
    for (const NumberRow& row : get())
    {
      list.append(ToJson(row));
    }
    return;
  }
  const Json::Value* const value = this->Find(key);
  if (!value)
  {
    return;
  }
  if (!value->isArray())
  {
    this->Fail(this->PathOf(key), *value, "a list of nodes in [ ]");
    return;
  }
  std::vector<NumberRow> rows(value->size());
  for (Json::ArrayIndex i = 0; i < value->size(); ++i)
  {
    const std::string path = this->PathOf(key) + "[" + std::to_string(i) + "]";
    if (!this->ReadRow((*value)[i], path, columns, rows[i]))
    {
      return;
    }
    if (i > 0 && rows[i][0] < rows[i - 1][0])
    {
      this->Fail(path, (*value)[i], "at the same place as the node before it, or behind that");
    }
  }
  this->Then([set, rows] { set(rows); });
}

//------------------------------------------------------------------------------
void SetupNode::Require(const char* key, bool holds, const std::string& wanted)
{
  const Json::Value* const value = this->Find(key);
  if (value && !holds)
  {
    this->Fail(this->PathOf(key), *value, wanted);
  }
}

void SetupNode::Then(std::function<void()> change)
{
  if (!this->Pass.Writing)
  {
    this->Pass.Changes.push_back(std::move(change));
  }
}

} // namespace VolumeHaptics

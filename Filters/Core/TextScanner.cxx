// SPDX-License-Identifier: BSD-3-Clause
#include "TextScanner.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace featurehex
{
namespace
{
bool IsBlank(char c)
{
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

bool IsLineEnd(char c)
{
  return c == '\n' || c == '\r';
}

/// Decimal exponent of the leading digit of a number that std::from_chars found out of range.
/// Only its sign matters: such numbers are beyond 1e+308 or below 1e-308.
std::int64_t Magnitude(std::string_view word)
{
  std::int64_t exponent = 0;
  const std::size_t e = word.find_first_of("eE");
  if (e != std::string_view::npos)
  {
    ParseInteger(word.substr(e + 1), exponent);
    word = word.substr(0, e);
  }
  exponent = std::max<std::int64_t>(-(1ll << 60), std::min<std::int64_t>(1ll << 60, exponent));
  const std::size_t first = word.find_first_of("123456789");
  const std::size_t point = std::min(word.find('.'), word.size());
  if (first == std::string_view::npos)
  {
    return -1;
  }
  const std::int64_t shift = first < point ? static_cast<std::int64_t>(point - first) - 1
                                           : -static_cast<std::int64_t>(first - point);
  return exponent + shift;
}

/// std::from_chars takes no plus sign.
bool DropPlus(std::string_view& word)
{
  if (!word.empty() && word.front() == '+')
  {
    word.remove_prefix(1);
    return !word.empty() && word.front() != '-';
  }
  return !word.empty();
}
} // namespace

bool TextScanner::AtLineEnd(std::size_t offset) const
{
  return offset < this->Text.size() && IsLineEnd(this->Text[offset]);
}

bool TextScanner::AtJoint() const
{
  return this->JoinLines && this->Text[this->Offset] == '\\' && this->AtLineEnd(this->Offset + 1);
}

void TextScanner::PassLineEnd()
{
  const bool carriage = this->Text[this->Offset] == '\r';
  ++this->Offset;
  if (carriage && this->Offset < this->Text.size() && this->Text[this->Offset] == '\n')
  {
    ++this->Offset;
  }
  ++this->LineNumber;
}

bool TextScanner::SkipBlanks()
{
  while (this->Offset < this->Text.size())
  {
    const char c = this->Text[this->Offset];
    if (this->AtJoint())
    {
      ++this->Offset;
      this->PassLineEnd();
    }
    else if (this->Comment != 0 && c == this->Comment)
    {
      while (this->Offset < this->Text.size() && !this->AtLineEnd(this->Offset))
      {
        ++this->Offset;
      }
    }
    else if (IsBlank(c))
    {
      ++this->Offset;
    }
    else
    {
      break;
    }
  }
  return this->Offset < this->Text.size();
}

bool TextScanner::WordOnLine(std::string_view& word)
{
  word = {};
  if (!this->SkipBlanks() || this->AtLineEnd(this->Offset))
  {
    return false;
  }
  const std::size_t begin = this->Offset;
  while (this->Offset < this->Text.size())
  {
    const char c = this->Text[this->Offset];
    if (IsBlank(c) || IsLineEnd(c) || this->AtJoint())
    {
      break;
    }
    ++this->Offset;
  }
  word = this->Text.substr(begin, this->Offset - begin);
  return true;
}

bool TextScanner::Word(std::string_view& word)
{
  while (!this->WordOnLine(word))
  {
    if (this->Offset >= this->Text.size())
    {
      return false;
    }
    this->PassLineEnd();
  }
  return true;
}

bool TextScanner::RealOnLine(double& value)
{
  std::string_view word;
  return this->WordOnLine(word) && ParseReal(word, value);
}

bool TextScanner::IntegerOnLine(std::int64_t& value)
{
  std::string_view word;
  return this->WordOnLine(word) && ParseInteger(word, value);
}

void TextScanner::SkipLine()
{
  std::string_view word;
  while (this->WordOnLine(word))
  {
  }
  if (this->Offset < this->Text.size())
  {
    this->PassLineEnd();
  }
}

bool ParseReal(std::string_view word, double& value)
{
  if (!DropPlus(word))
  {
    return false;
  }
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end)
  {
    value = Magnitude(word) > 0 ? std::numeric_limits<double>::infinity() : 0.0;
    value = word.front() == '-' ? -value : value;
    return true;
  }
  return error == std::errc() && stop == end;
}

bool ParseInteger(std::string_view word, std::int64_t& value)
{
  if (!DropPlus(word))
  {
    return false;
  }
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error == std::errc::result_out_of_range && stop == end)
  {
    value = word.front() == '-' ? std::numeric_limits<std::int64_t>::min()
                                : std::numeric_limits<std::int64_t>::max();
    return true;
  }
  return error == std::errc() && stop == end;
}

void AppendReal(std::string& text, double value)
{
  char buffer[32];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  text.append(buffer, result.ptr);
}

void AppendInteger(std::string& text, std::int64_t value)
{
  char buffer[24];
  const auto result = std::to_chars(buffer, buffer + sizeof(buffer), value);
  text.append(buffer, result.ptr);
}

std::string Quoted(std::string_view word)
{
  constexpr std::size_t longest = 24;
  std::string text = "\"";
  for (char c : word.substr(0, longest))
  {
    text += c >= ' ' && c <= '~' ? c : '?';
  }
  return text + (word.size() > longest ? "...\"" : "\"");
}

bool ReferenceCheck::FirstBeyond(std::int64_t count, std::int64_t& id, std::size_t& where) const
{
  for (const Record& record : this->Records)
  {
    if (record.Id >= count)
    {
      id = record.Id;
      where = record.Where;
      return true;
    }
  }
  return false;
}
} // namespace featurehex

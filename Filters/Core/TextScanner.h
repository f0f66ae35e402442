// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Words, lines and numbers of a text file in memory, independent of the locale.

#ifndef featurehex_TextScanner_h
#define featurehex_TextScanner_h

#include "Types.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace featurehex
{
/// Walks through a text word by word and knows the line. Lines end with LF, CR LF or CR. Any bytes
/// are fine as input.
class TextScanner
{
public:
  /// @a comment starts a comment that reaches to the end of the line, 0: there are none.
  /// @a joinLines: a backslash at the end of a line joins it with the next.
  explicit TextScanner(std::string_view text, char comment = '#', bool joinLines = false)
    : Text(text)
    , Comment(comment)
    , JoinLines(joinLines)
  {
  }

  /// Next word, on this line or a later one. False: end of file.
  bool Word(std::string_view& word);

  /// Next word of this line. False: end of line; the line isn't left.
  bool WordOnLine(std::string_view& word);

  /// Next word of this line as a number; false: there is none, or it isn't one.
  bool RealOnLine(double& value);
  bool IntegerOnLine(std::int64_t& value);

  /// Goes to the start of the next line.
  void SkipLine();

  /// Passes @a count bytes that are no text, at most Remaining().
  void Advance(std::size_t count) { this->Offset += count; }

  /// Line of the last word, from 1.
  std::size_t Line() const { return this->LineNumber; }
  /// Byte offset of what comes next.
  std::size_t Position() const { return this->Offset; }
  std::size_t Remaining() const { return this->Text.size() - this->Offset; }

private:
  bool SkipBlanks();
  bool AtLineEnd(std::size_t offset) const;
  bool AtJoint() const;
  void PassLineEnd();

  std::string_view Text;
  char Comment;
  bool JoinLines;
  std::size_t Offset = 0;
  std::size_t LineNumber = 1;
};

/// The whole word is a decimal real number, nan or inf. Too large a number becomes infinite, too
/// small a one 0.
bool ParseReal(std::string_view word, double& value);

/// The whole word is a decimal integer. Beyond 64 bits: the largest or smallest one.
bool ParseInteger(std::string_view word, std::int64_t& value);

/// Appends the shortest text that reads back as the same bits.
void AppendReal(std::string& text, double value);
void AppendInteger(std::string& text, std::int64_t value);

/// The word for an error message: shortened, in quotes, unprintable bytes as '?'.
std::string Quoted(std::string_view word);

/// Range check of ids that may refer to something further down in the file: only the records of
/// the running maximum are kept, the first of them that is too large is the first error.
class ReferenceCheck
{
public:
  /// @a where: the line or element number that holds @a id, 0-based and not negative.
  void Add(std::int64_t id, std::size_t where)
  {
    if (this->Records.empty() || id > this->Records.back().Id)
    {
      this->Records.push_back({ id, where });
    }
  }

  /// The first id that is not below @a count; false: all are fine.
  bool FirstBeyond(std::int64_t count, std::int64_t& id, std::size_t& where) const;

private:
  struct Record
  {
    std::int64_t Id;
    std::size_t Where;
  };
  std::vector<Record> Records;
};

/// Largest number of points or cells that Index can count.
constexpr std::int64_t MaximumIndex = INT32_MAX;
} // namespace featurehex

#endif

#pragma once

#include <iosfwd>
#include <string>

namespace delassus {

/// True for all but blanks and control characters; bytes of UTF-8 are visible.
inline bool isVisible(char c) { return static_cast<unsigned char>(c) > ' ' && c != 0x7f; }

/// Reads a problem text word by word. If a word is not the expected one, the error says where:
///
///     FILE:LINE: expected WHAT [in entry K of N of 'SECTION'], found WORD
///
/// It does not depend on the locale. Memory grows with the words that are read, never with the
/// counts that the text announces.
class WordReader {
 public:
  WordReader(std::istream& in, std::string source);

  /// The first line, without its line ending. At most `longestWord` characters of it.
  std::string firstLine();

  /// Skips comments, then takes `word`, which opens a section or announces a value.
  void keyword(const char* word, const char* hint = "");
  /// Takes the keyword of a section with `entries` entries.
  void openSection(const char* name, int entries);
  /// The same if the section is there; false if not.
  bool openOptionalSection(const char* name, int entries);
  /// Goes on to the next entry of the open section; errors name it.
  void nextEntry() { ++entry_; }

  std::string word(const char* meaning);
  int integer(const std::string& meaning, long long least, long long most);
  double number();                                     ///< finite
  double numberOr(const char* word, double itsValue);  ///< finite, or exactly `word`
  /// Takes `end`, after which only comments may follow.
  void end();

  /// Throws ProblemTextError about the last word, or about `found` in its place.
  [[noreturn]] void fail(const std::string& expected) const;
  [[noreturn]] void fail(const std::string& expected, const std::string& found) const;

  static constexpr int longestWord = 4096;

 private:
  int peek();
  void skip();      ///< one character
  void readWord();  ///< blanks, then a word; empty at the end of the text
  void readWordAfterComments();
  double finite(const char* expected) const;

  std::streambuf* text_;
  std::string source_;
  std::string word_;
  int line_ = 1;      ///< where the next character stands
  int wordLine_ = 1;  ///< where the last word stands
  bool lineStart_ = true;
  bool wordStartsLine_ = false;
  bool pending_ = false;  ///< the last word was read ahead and not taken
  const char* section_ = nullptr;
  int entry_ = 0, entries_ = 0;
};

}  // namespace delassus

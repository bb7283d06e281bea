#pragma once

#include <iosfwd>
#include <string>

namespace delassus {

/// Neither blank nor a control character; bytes of UTF-8 are.
inline bool isVisible(char c) { return static_cast<unsigned char>(c) > ' ' && c != 0x7f; }

/// Reads a problem text word by word and says where it stands when a word is not the expected one:
///
///     FILE:LINE: expected WHAT [in entry K of N of 'SECTION'], found WORD
///
/// Independent of the locale. Memory grows with the words asked for, never with what the text
/// announces.
class WordReader {
 public:
  WordReader(std::istream& in, std::string source);

  /// The first line, without its line ending. At most `longestWord` characters of it.
  std::string firstLine();

  /// Skips comments, then takes `word`, which opens a section or announces a value.
  void keyword(const char* word);
  /// Takes the keyword of a section with `entries` entries.
  void openSection(const char* name, int entries);
  /// The same if the section is there.
  bool openOptionalSection(const char* name, int entries);
  /// Announces the next entry of the open section; errors name it.
  void nextEntry() { ++entry_; }

  std::string word(const char* meaning);
  int integer(const std::string& meaning, long long least, long long most);
  double number();                                     ///< finite
  double numberOr(const char* word, double itsValue);  ///< finite, or exactly `word`
  /// `end`, and nothing but comments after it.
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

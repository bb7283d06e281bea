#include "delassus/word_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>
#include <streambuf>
#include <utility>

#include "delassus/problem_text.h"

namespace delassus {
namespace {

using Traits = std::char_traits<char>;

bool isBlank(int c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

bool isEnd(int c) { return c == Traits::eof(); }

/// A word for an error message: short, on one line, printable.
std::string quoted(const std::string& word) {
  constexpr std::size_t most = 40;
  constexpr const char* digits = "0123456789abcdef";
  std::string out = "'";
  for (std::size_t i = 0; i < word.size() && i < most; ++i) {
    const unsigned char c = static_cast<unsigned char>(word[i]);
    if (c >= 0x20 && c < 0x7f) {
      out += word[i];
    } else {
      out += "\\x";
      out += digits[c >> 4];
      out += digits[c & 15];
    }
  }
  return out + (word.size() > most ? "...'" : "'");
}

}  // namespace

WordReader::WordReader(std::istream& in, std::string source)
    : text_(in.rdbuf()), source_(std::move(source)) {}

int WordReader::peek() { return text_->sgetc(); }

void WordReader::skip() {
  lineStart_ = text_->sbumpc() == '\n';
  if (lineStart_) ++line_;
}

std::string WordReader::firstLine() {
  word_.clear();
  while (!isEnd(peek()) && peek() != '\n' && static_cast<int>(word_.size()) < longestWord) {
    word_ += Traits::to_char_type(peek());
    skip();
  }
  if (!word_.empty() && word_.back() == '\r') word_.pop_back();
  return word_;
}

void WordReader::readWord() {
  while (isBlank(peek())) skip();
  word_.clear();
  wordLine_ = line_;
  wordStartsLine_ = lineStart_;
  while (!isEnd(peek()) && !isBlank(peek())) {
    if (static_cast<int>(word_.size()) == longestWord) fail("a word of at most 4096 characters");
    word_ += Traits::to_char_type(peek());
    skip();
  }
}

void WordReader::readWordAfterComments() {
  while (isBlank(peek())) skip();
  while (peek() == '#' && lineStart_) {
    while (!isEnd(peek()) && peek() != '\n') skip();
    while (isBlank(peek())) skip();
  }
  readWord();
}

void WordReader::keyword(const char* word, const char* hint) {
  if (!std::exchange(pending_, false)) readWordAfterComments();
  section_ = nullptr;
  if (word_ != word) fail(quoted(word) + hint);
}

void WordReader::openSection(const char* name, int entries) {
  keyword(name);
  section_ = name;
  entry_ = 0;
  entries_ = entries;
}

bool WordReader::openOptionalSection(const char* name, int entries) {
  readWordAfterComments();
  pending_ = true;
  if (word_ != name) return false;
  openSection(name, entries);
  return true;
}

std::string WordReader::word(const char* meaning) {
  readWord();
  if (word_.empty() || !std::all_of(word_.begin(), word_.end(), isVisible))
    fail(std::string(meaning) + " without control characters");
  return word_;
}

int WordReader::integer(const std::string& meaning, long long least, long long most) {
  readWord();
  long long value = 0;
  const char* const end = word_.data() + word_.size();
  const auto [stop, error] = std::from_chars(word_.data(), end, value);
  if (error != std::errc() || stop != end || value < least || value > most)
    fail(meaning + " from " + std::to_string(least) + " to " + std::to_string(most));
  return static_cast<int>(value);
}

double WordReader::number() {
  readWord();
  return finite("a finite number");
}

double WordReader::numberOr(const char* word, double itsValue) {
  readWord();
  if (word_ == word) return itsValue;
  return finite(word[0] == '-' ? "a finite number or -inf" : "a finite number or inf");
}

double WordReader::finite(const char* expected) const {
  double value = 0;
  const char* const end = word_.data() + word_.size();
  // The library knows no plus sign.
  const char* const begin = word_.data() + (word_.size() > 1 && word_[0] == '+' && word_[1] != '-');
  const auto [stop, error] = std::from_chars(begin, end, value);
  if (error == std::errc::result_out_of_range && stop == end)
    fail(std::string(expected) + " within the range of a double");
  if (error != std::errc() || stop != end || !std::isfinite(value)) fail(expected);
  return value;
}

void WordReader::end() {
  keyword("end");
  readWordAfterComments();
  if (!word_.empty()) fail("nothing after 'end'");
}

void WordReader::fail(const std::string& expected) const {
  if (word_.empty())
    fail(expected, isEnd(text_->sgetc()) ? "the end of the text" : "an empty line");
  // A comment inside a list is not allowed; the error says so rather than show its first word.
  if (word_[0] == '#' && wordStartsLine_ && section_)
    fail(expected, "a comment (comments stand only between sections)");
  fail(expected, quoted(word_));
}

void WordReader::fail(const std::string& expected, const std::string& found) const {
  std::string message = source_ + ":" + std::to_string(wordLine_) + ": expected " + expected;
  if (section_)
    message += " in entry " + std::to_string(entry_) + " of " + std::to_string(entries_) + " of '" +
               section_ + "'";
  throw ProblemTextError(message + ", found " + found);
}

}  // namespace delassus

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <istream>
#include <random>
#include <sstream>
#include <string>

#include "delassus/problem_text.h"
#include "tests/support/problem_samples.h"

namespace delassus {
namespace {

using test::complaint;
using test::contactText;
using test::expectSame;
using test::fromText;
using test::rowText;
using test::toText;
using test::withLine;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A line of one of the sample texts made wrong, and the message about it.
struct BadLine {
  const char* base;
  int line;
  const char* replacement;
  const char* message;
};

TEST(ProblemTextErrors, ErrorsNameTheLineAndWhatWasExpected) {
  const BadLine cases[] = {
      // Format and head.
      {contactText, 1, "delassus-problem v2",
       ":1: expected 'delassus-problem v1' or 'lcp v1', found 'delassus-problem v2'"},
      {contactText, 1, " delassus-problem v1",
       ":1: expected 'delassus-problem v1' or 'lcp v1', found"},
      {contactText, 1,
       "\xef\xbb\xbf"
       "delassus-problem v1",
       "found '\\xef\\xbb\\xbfdelassus-problem v1'"},
      {contactText, 3, "nome two", ":3: expected 'name', found 'nome'"},
      {contactText, 3, "name two words",
       ":3: expected 'contacts' after a name of one word, found 'words'"},
      {contactText, 3,
       "name a\x01"
       "b",
       ":3: expected a name without control characters, found 'a\\x01b'"},
      {contactText, 4, "contacts two",
       ":4: expected the number of contacts from 0 to 238609294, found 'two'"},
      {contactText, 4, "contacts -1",
       ":4: expected the number of contacts from 0 to 238609294, found '-1'"},
      {contactText, 4, "contacts 1.0", ", found '1.0'"},
      {contactText, 4, "contacts 99999999999999999999", ", found '99999999999999999999'"},
      {contactText, 4, "size 2", ":4: expected 'contacts' after a name of one word, found 'size'"},
      {contactText, 5, "blocks 1", ":5: expected the number of blocks from 2 to 4, found '1'"},
      {contactText, 5, "blocks 5", ":5: expected the number of blocks from 2 to 4, found '5'"},
      // Lists that are too short, too long, or not numbers.
      {contactText, 4, "contacts 1\nblocks 1", ":6: expected 'mu', found 'blocks'"},
      {contactText, 8, "", ":9: expected a finite number in entry 2 of 2 of 'mu', found 'q'"},
      {contactText, 8, "0\n0", ":9: expected 'q', found '0'"},
      {contactText, 7, "-0.5",
       ":7: expected a friction coefficient of at least 0 in entry 1 of 2 of 'mu', found '-0.5'"},
      {contactText, 7, "nan", ":7: expected a finite number in entry 1 of 2 of 'mu', found 'nan'"},
      {contactText, 10, "-1 inf 0",
       ":10: expected a finite number in entry 1 of 2 of 'q', found 'inf'"},
      {contactText, 10, "-1 1e999 0", ", found '1e999'"},
      {contactText, 10, "-1 0x10 0", ", found '0x10'"},
      {contactText, 10, "-1 0,5 0", ", found '0,5'"},
      {contactText, 10, "-1 1e 0", ", found '1e'"},
      {contactText, 11, "# not here\n1 2 3",
       ":11: expected a finite number in entry 2 of 2 of 'q', found a comment"},
      {contactText, 12, "M", ":12: expected 'W', found 'M'"},
      // Places in the matrix.
      {contactText, 13, "0 2 2 .5 0 .5 1 0 0 0 1",
       ":13: expected a column from 0 to 1 in entry 1 of 3 of 'W', found '2'"},
      {contactText, 14, "-1 0 0 0 0 0 0 0 0 0 1",
       ":14: expected a row from 0 to 1 in entry 2 of 3 of 'W', found '-1'"},
      {contactText, 14, "0 0 0 0 0 0 0 0 0 0 1",
       ":14: expected a place after 0 0, sorted by row, then column, none twice in entry 2 of 3 of "
       "'W', found '0 0'"},
      {contactText, 15, "0 1 1 0 0 0 1 0 0 0 1", ":15: expected a place after 1 0"},
      {contactText, 13, "0 1 2 .5 0 .5 1 0 0 0 1",
       ":13: expected the diagonal place 0 0, present even if zero in entry 1 of 3 of 'W', found "
       "'0 1'"},
      {contactText, 15, "1 0 1 0 0 0 1 0 0 0 1", ":15: expected a place after 1 0"},
      {contactText, 14, "0 1 0 0 0 0 0 0 0 0 1\n1 0 1 1 1 1 1 1 1 1 1\n#",
       ":15: expected the diagonal place 1 1, present even if zero in entry 3 of 3 of 'W', found "
       "the last entry without it"},
      {contactText, 15, "1 1 1 0 0 0 1 0 0 0",
       ":16: expected a finite number in entry 3 of 3 of 'W', found 'end'"},
      {contactText, 15, "1 1 1 0 0 0 1 0 0 0 1 1", ":15: expected 'end', found '1'"},
      {contactText, 15, "1 1 1 0 0 0 1 0 0 0 1e-999",
       ":15: expected a finite number within the range of a double in entry 3 of 3 of 'W'"},
      {contactText, 15, "1 1 1 0 0 0 1 0 0 0 +-1", ", found '+-1'"},
      {contactText, 1, "", ":1: expected 'delassus-problem v1' or 'lcp v1', found an empty line"},
      // The end.
      {contactText, 16, "", ": expected 'end', found the end of the text"},
      {contactText, 16, "end of it", ":16: expected nothing after 'end', found 'of'"},
      // Rows.
      {rowText, 3, "size 99999999999",
       ":3: expected the number of unknowns from 0 to 2147483647, found '99999999999'"},
      {rowText, 6, "inf inf",
       ":6: expected a finite number or -inf in entry 1 of 2 of 'bounds', found 'inf'"},
      {rowText, 6, "-inf -inf",
       ":6: expected a finite number or inf in entry 1 of 2 of 'bounds', found '-inf'"},
      {rowText, 6, "-inf infinity", ", found 'infinity'"},
      {rowText, 7, "nan 2",
       ":7: expected a finite number or -inf in entry 2 of 2 of 'bounds', found 'nan'"},
      {rowText, 7, "3 2",
       ":7: expected an upper bound not below the lower bound in entry 2 of 2 of 'bounds', found "
       "'2'"},
      {rowText, 8, "p", ":8: expected 'q', found 'p'"},
      {rowText, 10, "inf", ":10: expected a finite number in entry 2 of 2 of 'q', found 'inf'"},
      {rowText, 14, "1 1 -inf",
       ":14: expected a finite number in entry 3 of 3 of 'M', found '-inf'"},
  };
  for (const BadLine& bad : cases) {
    const std::string said = complaint(withLine(bad.base, bad.line, bad.replacement));
    EXPECT_THAT(said, StartsWith("text:")) << bad.replacement;
    EXPECT_THAT(said, HasSubstr(bad.message));
    EXPECT_EQ(said.find('\n'), std::string::npos);
  }
}

TEST(ProblemTextErrors, EveryTruncationIsAnError) {
  for (const std::string text : {contactText, rowText}) {
    const std::size_t complete = text.find("end") + 3;
    for (std::size_t length = 0; length < complete; ++length)
      EXPECT_THAT(complaint(text.substr(0, length)), HasSubstr("expected")) << length;
    EXPECT_EQ(complaint(text.substr(0, complete)), "");
  }
}

TEST(ProblemTextErrors, HugeCountsAskForNoMemory) {
  const std::string head =
      "delassus-problem v1\nname n\ncontacts 200000000\nblocks 200000000\nmu\n1\n";
  EXPECT_THAT(complaint(head),
              HasSubstr("in entry 2 of 200000000 of 'mu', found the end of the text"));
  EXPECT_THAT(complaint("lcp v1\nname n\nsize 2000000000\nentries 2147483647\nbounds\n0"),
              HasSubstr("in entry 1 of 2000000000 of 'bounds', found the end of the text"));
  EXPECT_THAT(complaint("lcp v1\nname n\nsize 2000000000\nentries 2147483647\nq\n0"),
              HasSubstr("in entry 2 of 2000000000 of 'q', found the end of the text"));
}

/// A text without an end, and a device that fails after a few characters.
struct Endless : std::streambuf {
  explicit Endless(char c) : c_(c) { setg(&c_, &c_, &c_ + 1); }
  int_type underflow() override {
    setg(&c_, &c_, &c_ + 1);
    return traits_type::to_int_type(c_);
  }
  char c_;
};

struct Failing : std::stringbuf {
  using std::stringbuf::stringbuf;
  int_type underflow() override { throw std::ios_base::failure("device"); }
};

TEST(ProblemTextErrors, EndlessTextsAndFailingDevices) {
  for (const char c : {'\0', 'x'}) {
    Endless buffer(c);
    std::istream in(&buffer);
    EXPECT_THROW(readProblem(in, "endless"), ProblemTextError);
  }
  const std::string longName = "lcp v1\nname " + std::string(5000, 'x');
  EXPECT_THAT(complaint(longName), HasSubstr("text:2: expected a word of at most 4096 characters"));

  Failing buffer("lcp v1\nname n\n", std::ios::in);
  std::istream in(&buffer);
  try {
    readProblem(in, "device");
    FAIL() << "read beyond the failure";
  } catch (const ProblemTextError& error) {
    EXPECT_THAT(error.what(), HasSubstr("expected readable text, found a device error"));
  }
}

/// Whatever happens to a text, it is read, or refused with one clear line. A text that is read can
/// be written.
TEST(ProblemTextErrors, MutatedTextsAreReadOrRefused) {
  std::mt19937_64 random(20);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::string bytes("0123456789+-.eE#infa \n\r\t\0\xff", 26);
  int read = 0;
  for (int k = 0; k < 2000; ++k) {
    std::string text = k % 2 ? contactText : rowText;
    for (std::size_t edits = 1 + below(3); edits > 0 && !text.empty(); --edits) {
      const std::size_t at = below(text.size());
      switch (below(4)) {
        case 0:
          text.erase(at, 1 + below(20));
          break;
        case 1:
          text.insert(at, 1, bytes[below(bytes.size())]);
          break;
        case 2:
          text[at] = bytes[below(bytes.size())];
          break;
        case 3:
          text.insert(at, text.substr(below(text.size()), 1 + below(20)));
          break;
      }
    }
    try {
      const Problem problem = fromText(text);
      expectSame(problem, fromText(toText(problem)));
      ++read;
    } catch (const ProblemTextError& error) {
      EXPECT_THAT(error.what(), StartsWith("text:"));
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    } catch (const std::exception& error) {
      ADD_FAILURE() << error.what() << " for\n" << text;
    }
  }
  EXPECT_GT(read, 50) << "mutations that only ever break the first line test nothing";
  EXPECT_LT(read, 1950);
}

}  // namespace
}  // namespace delassus

#include "delassus/whole_file.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace delassus {
namespace {

namespace fs = std::filesystem;

/// Why it could not be written; empty if it was.
std::string write(const fs::path& file, const std::string& text) {
  errno = 0;
  std::ofstream out(file, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (out) return {};
  return errno ? std::strerror(errno) : "output error";
}

/// The same; the text becomes the file once it is complete beside it.
std::string replace(const fs::path& file, const std::string& text) {
  const fs::path unfinished = file.string() + ".unfinished";
  std::string fault = write(unfinished, text);
  std::error_code error;
  if (fault.empty()) {
    fs::rename(unfinished, file, error);
    if (error) fault = error.message();
  }
  if (!fault.empty()) fs::remove(unfinished, error);
  return fault;
}

}  // namespace

void writeFile(const fs::path& file, const std::string& text) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  const bool isSpecial = fs::exists(status) && !fs::is_regular_file(status);
  // A link stays one, wherever it leads.
  constexpr int mostLinks = 40;  // as in Linux
  fs::path target = file;
  for (int k = 0; k < mostLinks && fs::is_symlink(target, ignored); ++k)
    target = target.parent_path() / fs::read_symlink(target, ignored);
  const std::string fault = isSpecial ? write(file, text) : replace(target, text);
  if (!fault.empty()) throw std::runtime_error(file.string() + ": cannot be written: " + fault);
}

}  // namespace delassus

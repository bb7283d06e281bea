#include "demos/report/part.h"

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "delassus/whole_file.h"
#include "demos/process/interrupt.h"
#include "demos/process/other_command.h"
#include "demos/progress_bar.h"
#include "demos/report/figure.h"
#include "demos/report/read_file.h"
#include "demos/subject.h"

namespace demos::report {

namespace fs = std::filesystem;

namespace {

fs::path fileOf(const fs::path& folder, const Part& part, const Unit& unit) {
  return folder / part.name / (unit.file + ".csv");
}

void makeFolder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw std::runtime_error("cannot make the folder '" + folder.string() +
                             "': " + error.message() + "; name another folder by --out");
}

void removeIfThere(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error)
    throw std::runtime_error("cannot remove '" + file.string() + "': " + error.message() +
                             "; name another folder by --out");
}

}  // namespace

void removeMeasures(const fs::path& folder, const std::vector<Part>& parts) {
  for (const Part& part : parts)
    for (const Unit& unit : part.units) removeIfThere(fileOf(folder, part, unit));
}

void stamp(const fs::path& folder, const std::string& command, bool resume,
           const std::vector<Part>& parts) {
  makeFolder(folder);
  const fs::path file = folder / "command.txt";
  const std::string text = command + "\nin " + precisionName() + " precision\n";
  std::error_code ignored;  // of a folder that cannot be read: nor can it be written
  const std::string made = fs::exists(file, ignored) ? readFile(file) : "";
  if (!made.empty() && made.rfind("delassus report", 0) != 0)
    throw std::runtime_error("'" + file.string() +
                             "' is not of a report: it needs a folder of its own");
  if (resume && !made.empty() && made != text) {
    std::string line = made.substr(0, made.find_last_not_of('\n') + 1);
    std::replace(line.begin(), line.end(), '\n', ' ');
    throw std::runtime_error("'" + folder.string() + "' was begun by '" + line +
                             "': only the same report can go on");
  }
  if (resume && made.empty())
    std::fprintf(stderr, "delassus: '%s' has no report to go on with: this one begins anew\n",
                 folder.string().c_str());
  for (const Part& part : parts) makeFolder(folder / part.name);
  // Measures of an earlier report must not pass for those of this one.
  if (!resume) removeMeasures(folder, parts);
  delassus::writeFile(file, text);
}

int measure(const std::vector<Part>& parts, const fs::path& folder) {
  const InterruptWatch watch;
  if (callCommand({"gnuplot", "--version"}).status == 127)
    std::fprintf(stderr, "delassus: %s\n", noGnuplot);
  int total = 0, done = 0;
  for (const Part& part : parts) total += int(part.units.size());
  for (const Part& part : parts)
    for (const Unit& unit : part.units) {
      const fs::path file = fileOf(folder, part, unit);
      if (!fs::exists(file)) {
        ProgressBar bar(std::to_string(done + 1) + "/" + std::to_string(total) + " " + part.name +
                        " " + unit.file);
        try {
          unit.measure([&bar](double fraction) { bar.show(fraction); }).write(file);
        } catch (const Interrupted&) {
          return total - done;
        }
      }
      ++done;
    }
  return 0;
}

}  // namespace demos::report

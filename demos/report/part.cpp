#include "demos/report/part.h"

#include <stdexcept>

#include "demos/progress_bar.h"
#include "demos/report/child.h"

namespace demos::report {

namespace fs = std::filesystem;

void stamp(const fs::path& folder, const std::string& command, bool resume,
           const std::vector<Part>& parts) {
  const fs::path file = folder / "command.txt";
  const std::string text = command + '\n';
  if (resume && fs::exists(file) && readFile(file) != text) {
    std::string made = readFile(file);
    made.pop_back();
    throw std::runtime_error("'" + folder.string() + "' was begun by '" + made +
                             "': only the same report can go on");
  }
  // Measures of an earlier report must not pass for those of this one.
  if (!resume && fs::exists(file))
    for (const Part& part : parts) fs::remove_all(folder / part.name);
  for (const Part& part : parts) fs::create_directories(folder / part.name);
  writeFile(file, text);
}

int measure(const std::vector<Part>& parts, const fs::path& folder) {
  const InterruptWatch watch;
  int total = 0, done = 0;
  for (const Part& part : parts) total += int(part.units.size());
  for (const Part& part : parts)
    for (const Unit& unit : part.units) {
      const fs::path file = folder / part.name / (unit.file + ".csv");
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

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "demos/progress_bar.h"
#include "demos/report/child.h"
#include "demos/report/machine.h"
#include "demos/report/part.h"

namespace demos::report {

namespace {

namespace fs = std::filesystem;

constexpr const char* stampName = "command.txt";

std::vector<Part> partsOf(const Plan& plan, const std::vector<std::string>& names) {
  std::vector<Part> all{sameProblemPart(plan), persistingPart(plan), ownTrajectoryPart(plan),
                        timeStepPart(plan),    scalingPart(plan),    ablationPart(plan)};
  if (names.empty()) return all;
  std::vector<Part> chosen;
  std::string existing;
  for (const Part& part : all) existing += (existing.empty() ? "" : ", ") + part.name;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&name](const Part& part) { return part.name == name; });
    if (found == all.end())
      throw std::runtime_error("the report has no part '" + name + "'; there are " + existing);
    chosen.push_back(*found);
  }
  return chosen;
}

/// What the data in the folder were made by: what is to go on must be the same report.
void stamp(const ReportArguments& arguments, const std::vector<Part>& parts) {
  const fs::path folder = arguments.out, file = folder / stampName;
  ReportArguments anywhere = arguments;
  anywhere.out = ".";
  const std::string text = anywhere.command() + '\n';
  if (arguments.resume && fs::exists(file) && readFile(file) != text) {
    std::string made = readFile(file);
    made.pop_back();
    throw std::runtime_error("'" + arguments.out + "' was begun by '" + made +
                             "': only the same report can go on");
  }
  // Measures of an earlier report must not pass for those of this one.
  if (!arguments.resume && fs::exists(file))
    for (const Part& part : parts) fs::remove_all(folder / part.name);
  for (const Part& part : parts) fs::create_directories(folder / part.name);
  writeFile(file, text);
}

/// Measures what is missing. Returns the number of units that are still missing, if the user stopped it.
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

void writePage(const ReportArguments& arguments, const std::vector<Part>& parts, int missing) {
  std::string front, body;
  for (const Part& part : parts) {
    const Words words = part.write(arguments.out);
    front += words.front;
    body += words.body;
  }
  std::string page =
      "# Error against run time\n\n    " + arguments.command() + "\n\n" + describeMachine() + '\n';
  if (missing > 0)
    page += "**Not complete**: " + std::to_string(missing) +
            " measures are missing; the same command with `--resume` goes on.\n\n";
  writeFile(fs::path(arguments.out) / "report.md", page + front + body);
}

}  // namespace

bool makeReport(const ReportArguments& arguments) {
  const Plan plan = makePlan(arguments);
  const std::vector<Part> parts = partsOf(plan, arguments.parts);
  stamp(arguments, parts);
  const int missing = measure(parts, arguments.out);
  writePage(arguments, parts, missing);
  return missing == 0;
}

}  // namespace demos::report

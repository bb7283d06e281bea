#include <algorithm>

#include "delassus/whole_file.h"
#include "demos/command.h"
#include "demos/report/machine.h"
#include "demos/report/part.h"

namespace demos::report {

namespace {

namespace fs = std::filesystem;

std::vector<Part> partsOf(const Plan& plan, const std::vector<std::string>& names) {
  std::vector<Part> all{sameProblemPart(plan), persistingPart(plan), ownTrajectoryPart(plan),
                        timeStepPart(plan),    scalingPart(plan),    ablationPart(plan)};
  if (names.empty()) return all;
  std::vector<Part> chosen;
  std::string existing;
  for (const Part& part : all) existing += (existing.empty() ? "" : ", ") + part.name;
  const auto isChosen = [&names](const char* name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  // The part reads the measures of the other one.
  if (isChosen("persisting") && !isChosen("same_problem")) chosen.push_back(all.front());
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&name](const Part& part) { return part.name == name; });
    if (found == all.end())
      throw BadUsage("the report has no part '" + name + "'; there are " + existing);
    chosen.push_back(*found);
  }
  return chosen;
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
  delassus::writeFile(fs::path(arguments.out) / "report.md", page + front + body);
}

}  // namespace

bool makeReport(const ReportArguments& arguments) {
  const Plan plan = makePlan(arguments);
  const std::vector<Part> parts = partsOf(plan, arguments.parts);
  stamp(arguments.out, arguments.commandAnywhere(), arguments.resume, parts);
  const int missing = measure(parts, arguments.out);
  writePage(arguments, parts, missing);
  return missing == 0;
}

}  // namespace demos::report

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "bullet_ext/gather.h"
#include "delassus/contact_form.h"
#include "delassus/island.h"
#include "delassus/problem_text.h"
#include "delassus/word_reader.h"
#include "demos/command.h"
#include "demos/number_checks.h"
#include "demos/progress_bar.h"
#include "demos/scenes/simulate.h"
#include "demos/scenes/solver_decorator.h"
#include "demos/scenes/solvers.h"
#include "demos/standard_output.h"
#include "demos/subject.h"

namespace demos {

using namespace delassus;

namespace {

struct DumpArguments {
  std::string subject;
  double at = 0;
  double hz = 0;  ///< 0: the scene's own
  std::string out;
};

/// Keeps the problems of the groups that pass through while it is switched on.
class ProblemCatcher : public SolverDecorator {
 public:
  using SolverDecorator::SolverDecorator;
  void start() { catching_ = true; }
  const std::vector<Problem>& problems() const { return problems_; }

 protected:
  void beforeGroup(const GroupInput& arguments) override {
    if (!catching_) return;
    bullet::Group group;
    StepReport ignored;
    bullet::gatherGroup(group, arguments, ignored);
    for (const Island& island : splitIslands(group.bodies, group.contacts, group.rows))
      problems_.push_back(assemble(group.bodies, group.contacts, group.rows, island));
  }

 private:
  bool catching_ = false;
  std::vector<Problem> problems_;
};

/// FILE for the only island, else FILE with its number before the suffix.
std::string fileOf(const std::string& out, std::size_t island, std::size_t islands) {
  if (islands == 1) return out;
  const std::filesystem::path path(out);
  const std::string name =
      path.stem().string() + "-" + std::to_string(island) + path.extension().string();
  return (path.parent_path() / name).string();
}

/// A format holds contacts or rows; if a problem has both, its rows are written as contacts.
void writeIsland(const std::string& file, const Problem& problem) {
  const auto write = [&file](const Problem& written) {
    writeTo(file, [&written](auto& out) { writeProblem(out, written); });
  };
  std::FILE* words = wordsAbout(file);
  const int contacts = problem.contacts(), rows = problem.rows();
  if (contacts == 0 || rows == 0) {
    write(problem);
    std::fprintf(words, "%s: %d %s\n", file.c_str(), std::max(contacts, rows),
                 contacts > 0 ? "contacts" : "rows (lcp v1)");
    return;
  }
  const Problem form = contactForm(problem);
  write(form);
  const int bounds = form.contacts() - contacts;
  std::fprintf(words, "%s: %d contacts, %d more for rows with bounds; %d equations put in\n",
               file.c_str(), contacts, bounds, rows - bounds);
}

/// The beginning of the names of the problems of `subject`: a file's name without folder and
/// suffix. It is one word of the format, whatever characters the name has.
std::string problemName(const std::string& subject) {
  std::string name = std::filesystem::path(subject).stem().string();
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !isVisible(c); }, '_');
  return name;
}

/// A problem must not replace a world, least of all the one that is dumped.
void refuseToReplaceAWorld(const std::string& file) {
  // A pipe has nothing to replace, and reading it would wait.
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return;
  constexpr std::size_t length = 6;
  char begin[length + 1] = {};
  std::ifstream(file, std::ios::binary).read(begin, length);
  if (std::string(begin) == "BULLET" || std::filesystem::path(file).extension() == ".bullet")
    throw BadUsage("--out would replace the Bullet world " + file);
}

/// A pipe, a device or standard output cannot have a number in its name.
void refuseToShare(const std::string& file, std::size_t islands) {
  std::error_code ignored;
  const std::filesystem::file_status status = std::filesystem::status(file, ignored);
  if (islands > 1 && (isStandardOutput(file) || is_fifo(status) || is_character_file(status)))
    throw BadUsage("--out " + file + " takes one problem, and that step has " +
                   std::to_string(islands) + ": name a file, and each gets one of its own");
}

/// Files that an earlier dump of more islands has left would pass for some of this step.
void nameOlderFiles(const std::string& out, std::size_t islands) {
  const auto file = [&](std::size_t island) { return fileOf(out, island, islands + 2); };
  const std::size_t first = islands > 1 ? islands : 0;
  std::size_t end = first;
  std::error_code ignored;
  while (std::filesystem::exists(file(end), ignored)) ++end;
  if (end > first)
    std::fprintf(stderr, "delassus: not of this step, but of an earlier dump: %s to %s\n",
                 file(first).c_str(), file(end - 1).c_str());
}

int dumpProblems(const DumpArguments& arguments) {
  refuseToReplaceAWorld(arguments.out);
  Subject subject = openSubject(arguments.subject);
  NamedSolver solver("delassus");
  ProblemCatcher catcher(solver.solver());
  subject.world->setSolver(catcher);

  const double hz = arguments.hz > 0 ? arguments.hz : subject.hz;
  const int steps = stepsIn(arguments.at, hz);
  {
    ProgressBar bar(subject.name);
    for (int i = 0; i < steps; ++i) {
      subject.world->step(1 / hz);
      bar.show(double(i) / double(steps));
    }
    catcher.start();
    subject.world->step(1 / hz);
  }
  const std::size_t islands = catcher.problems().size();
  if (islands == 0)
    throw std::runtime_error("nothing to write: nothing touches and no joint acts in that step");
  refuseToShare(arguments.out, islands);
  for (std::size_t i = 0; i < islands; ++i)
    refuseToReplaceAWorld(fileOf(arguments.out, i, islands));

  const std::string name = problemName(subject.name);
  std::size_t written = 0;
  for (std::size_t i = 0; i < islands; ++i) {
    Problem problem = catcher.problems()[i];
    problem.name = name + "-" + std::to_string(steps) + "-" + std::to_string(i);
    if (!problem.disks.empty()) {
      std::fprintf(stderr,
                   "delassus: island %zu has rolling or spinning friction: no format holds that, "
                   "left out\n",
                   i);
      continue;
    }
    try {
      writeIsland(fileOf(arguments.out, i, islands), problem);
      ++written;
    } catch (const std::invalid_argument& fault) {
      std::fprintf(stderr, "delassus: island %zu left out: %s\n", i, fault.what());
    }
  }
  if (written == 0)
    throw std::runtime_error("nothing to write: no island of that step fits a problem format");
  nameOlderFiles(arguments.out, islands);
  return exitDone;
}

}  // namespace

void addDumpCommand(CLI::App& app, Action& chosen) {
  auto arguments = std::make_shared<DumpArguments>();
  CLI::App* command =
      app.add_subcommand("dump", "writes the problems of one step, an island a file");
  command->add_option("subject", arguments->subject, "a built-in scene or a .bullet file")
      ->required()
      ->type_name("SCENE|FILE.bullet");
  command->add_option("--at", arguments->at, "time of the step, s")->required()->check(atLeastZero);
  command
      ->add_option("--hz", arguments->hz,
                   "steps a second (default: the scene's own, 60 for most and for files)")
      ->check(greaterThanZero);
  command
      ->add_option("--out", arguments->out,
                   "file; several islands get FILE-0, FILE-1 and so on (number before the suffix)")
      ->required()
      ->type_name("FILE")
      ->check(notEmpty);
  command->footer(
      "A problem file has W as entries, and no reactions of a last step. 'solve' may take far "
      "longer\n"
      "over it than the step took in its world. Rows of joints beside contacts are written as "
      "contacts.\n"
      "Islands with rolling or spinning friction are left out: no format holds it.");
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return dumpProblems(*arguments); }; });
}

}  // namespace demos

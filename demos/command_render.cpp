#include <CLI/CLI.hpp>
#include <stdexcept>

#include "demos/command.h"
#include "demos/number_checks.h"

namespace demos {

namespace {

struct RenderArguments {
  std::string subject;
  std::string solvers = "delassus";
  std::vector<double> at;
  bool video = false;
  std::string out = "renders";
};

int renderSubject(const RenderArguments& arguments) {
  throw std::runtime_error("this build was made without the renderer: no pictures of '" +
                           arguments.subject + "'");
}

}  // namespace

void addRenderCommand(CLI::App& app, Action& chosen) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command = app.add_subcommand(
      "render", "headless pictures, side by side when two solvers are named; video");
  command->add_option("subject", arguments->subject, "a built-in scene or a .bullet file")
      ->required()
      ->type_name("SCENE|FILE.bullet");
  command->add_option("--solver", arguments->solvers, "one or two, as in 'run'")
      ->type_name("A[,B]")
      ->capture_default_str();
  command->add_option("--at", arguments->at, "times of the pictures, s")
      ->delimiter(',')
      ->check(atLeastZero)
      ->type_name("T,...");
  command->add_flag("--video", arguments->video, "an mp4 of the whole run");
  command->add_option("--out", arguments->out, "folder for what is made")
      ->type_name("DIR")
      ->capture_default_str();
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return renderSubject(*arguments); }; });
}

}  // namespace demos

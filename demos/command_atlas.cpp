#include <CLI/CLI.hpp>
#include <stdexcept>

#include "demos/command.h"

namespace demos {

namespace {

int drawAtlas(const std::string& out) {
  throw std::runtime_error("this build was made without the atlas: nothing written to '" + out +
                           "'");
}

}  // namespace

void addAtlasCommand(CLI::App& app, Action& chosen) {
  auto out = std::make_shared<std::string>("atlas");
  CLI::App* command = app.add_subcommand(
      "atlas", "the paper's figures, measured: region maps for two and three contacts");
  command->add_option("--out", *out, "folder for what is made")
      ->type_name("DIR")
      ->capture_default_str();
  command->callback([&chosen, out] { chosen = [out] { return drawAtlas(*out); }; });
}

}  // namespace demos

#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>

#include "demos/command.h"
#include "demos/number_checks.h"
#ifdef DELASSUS_RENDER
#include "demos/atlas/figures.h"
#include "demos/progress_bar.h"
#endif

namespace demos {

namespace {

#ifdef DELASSUS_RENDER
int drawAtlas(const std::string& out) {
  using namespace atlas;
  const std::vector<Figure (*)()> figures = {twoContacts, threeContacts, oneRoughContact, intuition,
                                             movingLoad};
  ProgressBar bar("atlas");
  for (std::size_t i = 0; i < figures.size(); ++i) {
    const Figure figure = figures[i]();
    writeFigure(out, figure);
    bar.clear();
    std::printf("%s/%s.{png,svg}: %s\n", out.c_str(), figure.name.c_str(), figure.measured.c_str());
    bar.show(double(i + 1) / double(figures.size()));
  }
  return exitDone;
}
#else
int drawAtlas(const std::string& out) {
  throw std::runtime_error("this build was made without the atlas: nothing written to '" + out +
                           "'");
}
#endif

}  // namespace

void addAtlasCommand(CLI::App& app, Action& chosen) {
  auto out = std::make_shared<std::string>("atlas");
  CLI::App* command = app.add_subcommand(
      "atlas", "the paper's figures, measured: region maps for two and three contacts");
  command->add_option("--out", *out, "folder for the figures")
      ->type_name("DIR")
      ->check(notEmpty)
      ->capture_default_str();
  command->callback([&chosen, out] { chosen = [out] { return drawAtlas(*out); }; });
}

}  // namespace demos

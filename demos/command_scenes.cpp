#include <CLI/CLI.hpp>
#include <cstdio>

#include "demos/command.h"
#include "demos/scenes/catalogue.h"
#include "demos/table.h"

namespace demos {

namespace {

int listScenes() {
  Table table({"scene", "bodies", "contacts", "seconds", "what it is; what is expected"});
  for (const SceneDescription& scene : catalogue()) {
    const auto world = scene.build();
    world->dynamics().performDiscreteCollisionDetection();
    table.add({scene.name, std::to_string(world->movableBodies().size()),
               std::to_string(world->contactCount()), shortNumber(scene.seconds),
               scene.summary + "; " + scene.expectation});
  }
  std::fputs(table.text().c_str(), stdout);
  return exitDone;
}

}  // namespace

void addScenesCommand(CLI::App& app, Action& chosen) {
  CLI::App* command = app.add_subcommand(
      "scenes", "lists the built-in scenes: name, movable bodies, contacts, one line");
  command->callback([&chosen] { chosen = listScenes; });
}

}  // namespace demos

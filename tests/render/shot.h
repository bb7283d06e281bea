#pragma once

#include <memory>
#include <string>
#include <vector>

#include "demos/render/film.h"
#include "demos/render/ground.h"
#include "demos/render/painter.h"
#include "demos/render/view.h"
#include "demos/scenes/catalogue.h"

namespace demos::render {

/// A world, its film of one frame, and what the camera saw of it.
struct Shot {
  NamedSolver solver{"delassus"};  // outlives the world
  std::unique_ptr<World> world;
  Film film;
  Box box;
  View view;
  Drawing drawing{Image({1, 1}), {}, {}};

  Shot(std::unique_ptr<World> built, double time, Size size, const Wish& wish = {})
      : world(std::move(built)) {
    film = record(*world, solver, 60, {time}, [](double) {});
    box = stage({film});
    view = frameView({film}, box, wish, size);
    layPlanes(film, box);
    Painter painter(size);
    drawing = painter.draw(painter.load(film), film, film.frames[0], view, box);
  }
  Shot(const std::string& scene, double time, Size size)
      : Shot(findScene(scene).build(), time, size, wishOf(scene)) {}

  static Wish wishOf(const std::string& scene) {
    const Camera& camera = findScene(scene).camera;
    const btVector3 back = camera.eye - camera.target;
    Wish wish;
    wish.direction = {double(back.x()), double(back.y()), double(back.z())};
    wish.fov = camera.fov;
    return wish;
  }
};

}  // namespace demos::render

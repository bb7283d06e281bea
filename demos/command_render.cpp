#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <tuple>

#include "demos/command.h"
#include "demos/number_checks.h"
#include "demos/process/interrupt.h"
#ifdef DELASSUS_RENDER
#include "demos/progress_bar.h"
#include "demos/render/picture.h"
#include "demos/render/video.h"
#include "demos/scenes/catalogue.h"
#include "demos/scenes/simulate.h"
#include "demos/subject.h"
#endif

namespace demos {

namespace {

struct RenderArguments {
  std::string subject;
  std::string solvers = "delassus";
  std::vector<double> at;
  bool video = false;
  std::string out = "renders";
  std::vector<double> camera, lookAt;  ///< x, y, z, or empty
  std::string size = "1280x720";
  bool plain = false, timing = false;
};

constexpr int longestSide = 8192;  ///< of a picture, pixels

/// "1280x720" as two numbers; {0, 0} if it is not one.
std::pair<int, int> readSize(const std::string& text) {
  int width = 0, height = 0, end = 0;
  if (std::sscanf(text.c_str(), "%5dx%5d%n", &width, &height, &end) != 2 ||
      end != int(text.size()) || std::min(width, height) < 1 ||
      std::max(width, height) > longestSide)
    return {0, 0};
  return {width, height};
}

#ifdef DELASSUS_RENDER

std::optional<Eigen::Vector3d> pointFrom(const std::vector<double>& numbers) {
  if (numbers.empty()) return std::nullopt;
  return Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
}

/// Takes the camera and the texts of a scene from the catalogue.
void describe(const Subject& subject, render::Wish& wish, render::Look& look) {
  look.title = std::filesystem::path(subject.name).filename().string();
  look.summary = std::to_string(subject.world->movableBodies().size()) + " bodies, " +
                 std::to_string(subject.world->dynamics().getNumConstraints()) +
                 " joints, as Bullet saved them";
  for (const SceneDescription& scene : catalogue()) {
    if (scene.name != subject.name) continue;
    look.summary = scene.summary;
    look.expected = scene.expectation;
    const btVector3 back = scene.camera.eye - scene.camera.target;
    wish.direction = {double(back.x()), double(back.y()), double(back.z())};
    wish.fov = scene.camera.fov;
  }
}

/// Makes one film for each solver, all at the same times. A world is freed once its film is made.
std::vector<render::Film> recordAll(const RenderArguments& arguments,
                                    std::vector<NamedSolver>& solvers,
                                    const std::vector<double>& times) {
  std::vector<render::Film> films;
  for (NamedSolver& solver : solvers) {
    Subject subject = openSubject(arguments.subject);
    ProgressBar bar(subject.name + " " + solver.name());
    const auto blame = blameBullet(subject.name, solver);
    films.push_back(render::record(*subject.world, solver, subject.hz, times,
                                   [&bar](double fraction) { bar.show(fraction); }));
  }
  return films;
}

constexpr double framesPerSecond = 30;  // of a video

/// The times of the frames, s, rising. Throws std::runtime_error if there would be no end of them.
std::vector<double> timesOf(const RenderArguments& arguments, const Subject& subject) {
  std::vector<double> times = arguments.at;
  if (times.empty()) times = {subject.seconds};
  std::sort(times.begin(), times.end());
  stepsIn(times.back(), subject.hz);
  if (!arguments.video) return times;
  const int last = stepsIn(times.back(), framesPerSecond);
  times.clear();
  for (int i = 0; i <= last; ++i) times.push_back(i / framesPerSecond);
  return times;
}

/// Throws if no picture of this size can be made; the message says what to do.
void checkSize(const render::Look& look, int films, int columns) {
  try {
    render::Studio::check(look, films, columns);
  } catch (const render::TooSmall& error) {
    throw BadUsage(std::string(error.what()) + "; take a larger --size");
  } catch (const render::TooLarge& error) {
    throw std::runtime_error(std::string(error.what()) + "; take a smaller --size");
  }
}

void say(const std::string& file) { std::printf("%s\n", file.c_str()); }

void makePicture(const RenderArguments& arguments, std::vector<NamedSolver>& solvers,
                 const std::vector<double>& times, const render::Wish& wish,
                 const render::Look& look, const std::string& file) {
  const int count = int(times.size());
  render::Studio studio(recordAll(arguments, solvers, times), wish, look, count);
  std::vector<int> frames;
  for (int i = 0; i < count; ++i) frames.push_back(i);
  render::savePng(file, studio.picture(frames));
  say(file);
}

void makeVideo(const RenderArguments& arguments, std::vector<NamedSolver>& solvers,
               const std::vector<double>& times, const render::Wish& wish, const render::Look& look,
               const std::string& file) {
  render::Studio studio(recordAll(arguments, solvers, times), wish, look, 1);
  ProgressBar bar(look.title + " video");
  const InterruptWatch watch;
  try {
    render::Video video(file, look.size, framesPerSecond);
    for (int i = 0; i < int(times.size()); ++i) {
      InterruptWatch::throwIfAsked();
      video.add(studio.picture({i}));
      bar.show(double(i + 1) / double(times.size()));
    }
    video.finish();
  } catch (const render::OutputError&) {
    InterruptWatch::throwIfAsked();  // Ctrl-C ends ffmpeg, too
    throw;
  }
  bar.clear();
  say(file);
}

int renderSubject(const RenderArguments& arguments) {
  // Everything that can be wrong is checked before the first solver, which may run for minutes.
  std::vector<NamedSolver> solvers;
  for (const std::string& name : splitNames(arguments.solvers)) solvers.emplace_back(name);
  if (!arguments.camera.empty() && arguments.camera == arguments.lookAt)
    throw BadUsage("--camera is where --look-at is: it would look nowhere");
  const Subject subject = openSubject(arguments.subject);
  const std::vector<double> times = timesOf(arguments, subject);
  if (arguments.video) render::requireFfmpeg();

  render::Wish wish;
  render::Look look;
  describe(subject, wish, look);
  wish.eye = pointFrom(arguments.camera);
  wish.lookAt = pointFrom(arguments.lookAt);
  std::tie(look.size.width, look.size.height) = readSize(arguments.size);
  look.plain = arguments.plain;
  look.timing = arguments.timing;
  // H.264 halves the resolution of colours.
  if (arguments.video) look.size = {look.size.width / 2 * 2, look.size.height / 2 * 2};
  checkSize(look, int(solvers.size()), arguments.video ? 1 : int(times.size()));
  render::prepareFolder(arguments.out);

  const std::string stem =
      (std::filesystem::path(arguments.out) / std::filesystem::path(look.title).stem()).string();
  if (arguments.video)
    makeVideo(arguments, solvers, times, wish, look, stem + ".mp4");
  else
    makePicture(arguments, solvers, times, wish, look, stem + ".png");
  return exitDone;
}

#else

int renderSubject(const RenderArguments& arguments) {
  throw std::runtime_error("this build was made without the renderer: no pictures of '" +
                           arguments.subject + "'");
}

#endif

}  // namespace

void addRenderCommand(CLI::App& app, Action& chosen) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command = app.add_subcommand(
      "render", "headless pictures, side by side when several solvers are named; video");
  command->add_option("subject", arguments->subject, "a built-in scene or a .bullet file")
      ->required()
      ->type_name("SCENE|FILE.bullet");
  command
      ->add_option("--solver", arguments->solvers, "one or more with commas between, as in 'run'")
      ->type_name("NAME[,NAME]")
      ->capture_default_str();
  command
      ->add_option("--at", arguments->at,
                   "times of the pictures, s; several make a strip (default: the scene's end)")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(atLeastZero)
      ->type_name("T,...");
  command->add_flag("--video", arguments->video,
                    "an mp4 of the run, to the last of --at if that is given");
  command->add_option("--out", arguments->out, "folder for the pictures")
      ->type_name("DIR")
      ->check(notEmpty)
      ->capture_default_str();
  const auto addPoint = [command](const char* flag, std::vector<double>& point, const char* what) {
    command->add_option(flag, point, what)
        ->delimiter(',')
        ->expected(3)
        ->check(finiteNumber)
        ->type_name("X,Y,Z");
  };
  addPoint("--camera", arguments->camera, "where the camera is, m (default: chosen for the scene)");
  addPoint("--look-at", arguments->lookAt, "the point it looks at, m (default: likewise)");
  command->add_option("--size", arguments->size, "size of the whole picture, pixels")
      ->type_name("WxH")
      ->capture_default_str()
      ->check([](const std::string& text) {
        return readSize(text).first > 0
                   ? std::string()
                   : "'" + text + "' is not a size such as 1280x720, of at most " +
                         std::to_string(longestSide) + " pixels a side";
      });
  CLI::Option* plain =
      command->add_flag("--plain", arguments->plain, "without captions, contacts and reactions");
  command
      ->add_flag("--timing", arguments->timing,
                 "milliseconds a step in the captions (bytes then differ from run to run)")
      ->excludes(plain);
  command->callback(
      [&chosen, arguments] { chosen = [arguments] { return renderSubject(*arguments); }; });
}

}  // namespace demos

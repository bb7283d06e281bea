#include "demos/render/video.h"

#include <csignal>
#include <cstdlib>
#include <utility>

namespace demos::render {

namespace {

/// Quotes a word for a shell command, whatever characters it has.
std::string quoted(const std::string& word) {
  std::string text = "'";
  for (const char letter : word)
    text += letter == '\'' ? std::string("'\\''") : std::string{letter};
  return text + "'";
}

}  // namespace

void requireFfmpeg() {
  if (std::system("command -v ffmpeg >/dev/null 2>&1") != 0)
    throw OutputError("a video needs the program ffmpeg, which is not there (package ffmpeg)");
}

Video::Video(const std::string& file, Size size, double framesPerSecond) : file_(file) {
  requireFfmpeg();
  // If ffmpeg dies, writing to it should fail, not end the program.
  std::signal(SIGPIPE, SIG_IGN);
  char input[128];
  std::snprintf(input, sizeof input, "-f rawvideo -pix_fmt rgb24 -s %dx%d -r %g -i -", size.width,
                size.height, framesPerSecond);
  // Leaves dates and version out of the file: the same pictures give the same bytes.
  const std::string command = std::string("ffmpeg -loglevel error -y ") + input +
                              " -c:v libx264 -crf 22 -preset medium -pix_fmt yuv420p" +
                              " -fflags +bitexact -flags:v +bitexact -movflags +faststart " +
                              quoted(partOf(file));
  pipe_ = popen(command.c_str(), "w");
  if (pipe_ == nullptr) throw OutputError("cannot start ffmpeg");
}

Video::~Video() {
  if (pipe_ == nullptr) return;
  pclose(pipe_);
  std::remove(partOf(file_).c_str());
}

void Video::add(const Image& image) {
  if (std::fwrite(image.rgb.data(), 1, image.rgb.size(), pipe_) != image.rgb.size())
    throw OutputError("ffmpeg gave up on '" + file_ + "'");
}

void Video::finish() {
  if (pclose(std::exchange(pipe_, nullptr)) != 0) {
    std::remove(partOf(file_).c_str());
    throw OutputError("ffmpeg could not write '" + file_ + "'");
  }
  finishPart(file_);
}

}  // namespace demos::render

#pragma once

#include <cstdio>
#include <string>

#include "demos/render/image.h"

namespace demos::render {

/// An mp4 (H.264) that ffmpeg makes from pictures. The file appears when `finish` returns, or not
/// at all.
class Video {
 public:
  /// Throws OutputError where there is no ffmpeg. Width and height must be even.
  Video(const std::string& file, Size size, double framesPerSecond);
  ~Video();
  Video(const Video&) = delete;
  Video& operator=(const Video&) = delete;

  /// Throws OutputError if ffmpeg has given up.
  void add(const Image& image);
  void finish();

 private:
  std::string file_;
  std::FILE* pipe_ = nullptr;
};

/// Throws OutputError, naming the package, where there is no ffmpeg.
void requireFfmpeg();

}  // namespace demos::render

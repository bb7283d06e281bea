#pragma once
/// OpenGL 3.3 core off screen, by OSMesa. That library exports the entry points, too, so that no
/// loader is needed.

#ifndef GL_GLEXT_PROTOTYPES
#define GL_GLEXT_PROTOTYPES
#endif
#include <GL/gl.h>
#include <GL/glext.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace demos::render {

/// No context, or an error from OpenGL; the message says where.
class GlError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// OpenGL lacks the memory for the request.
class GlMemoryError : public GlError {
 public:
  using GlError::GlError;
};

/// Throws GlError, or GlMemoryError, if OpenGL has met an error since the last call; `where` is
/// part of the message.
void checkGl(const char* where);

/// A context without a window, current as long as it lives. One at a time.
class GlContext {
 public:
  /// Throws GlError where OSMesa cannot give one.
  GlContext();
  ~GlContext();
  GlContext(const GlContext&) = delete;
  GlContext& operator=(const GlContext&) = delete;

 private:
  struct Handle;
  std::unique_ptr<Handle> handle_;
};

/// The name of one OpenGL object, deleted with its owner.
class GlObject {
 public:
  using Release = void (*)(GLuint);
  GlObject() = default;
  GlObject(GLuint name, Release release) : name_(name), release_(release) {}
  ~GlObject() {
    if (name_ != 0) release_(name_);
  }
  GlObject(GlObject&& other) noexcept
      : name_(std::exchange(other.name_, 0)), release_(other.release_) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(name_, other.name_);
    std::swap(release_, other.release_);
    return *this;
  }
  operator GLuint() const { return name_; }

 private:
  GLuint name_ = 0;
  Release release_ = nullptr;
};

GlObject makeBuffer();
GlObject makeVertexArray();
/// A two-dimensional texture without mipmaps, clamped at its border.
GlObject makeTexture(GLint internalFormat, int width, int height, GLenum format, GLenum type,
                     GLint filter);
/// A framebuffer that draws into `colours` (attachments 0, 1, ...) and `depth`. 0 stands for none.
GlObject makeFramebuffer(std::initializer_list<GLuint> colours, GLuint depth);
/// Compiles and links. Throws GlError with the driver's log.
GlObject makeProgram(const std::string& vertexSource, const std::string& fragmentSource);

GLint uniform(GLuint program, const char* name);

}  // namespace demos::render

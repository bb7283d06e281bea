#include "demos/render/gl.h"

#include <GL/osmesa.h>

#include <array>
#include <vector>

namespace demos::render {

namespace {

const char* nameOf(GLenum error) {
  switch (error) {
    case GL_INVALID_ENUM:
      return "invalid enum";
    case GL_INVALID_VALUE:
      return "invalid value";
    case GL_INVALID_OPERATION:
      return "invalid operation";
    case GL_INVALID_FRAMEBUFFER_OPERATION:
      return "invalid framebuffer operation";
    case GL_OUT_OF_MEMORY:
      return "out of memory";
    default:
      return "unknown error";
  }
}

GlObject compile(GLenum stage, const std::string& source) {
  GlObject shader(glCreateShader(stage), [](GLuint name) { glDeleteShader(name); });
  const char* text = source.c_str();
  glShaderSource(shader, 1, &text, nullptr);
  glCompileShader(shader);
  GLint good = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &good);
  if (good == GL_TRUE) return shader;
  std::array<char, 2048> log{};
  glGetShaderInfoLog(shader, GLsizei(log.size()), nullptr, log.data());
  throw GlError("OpenGL refuses a shader: " + std::string(log.data()));
}

}  // namespace

void checkGl(const char* where) {
  const GLenum error = glGetError();
  if (error == GL_NO_ERROR) return;
  const std::string what = std::string("OpenGL: ") + nameOf(error) + ", " + where;
  if (error == GL_OUT_OF_MEMORY) throw GlMemoryError(what);
  throw GlError(what);
}

struct GlContext::Handle {
  OSMesaContext context = nullptr;
  // OSMesa wants memory of its own for the default framebuffer, which nothing here draws into.
  std::array<unsigned char, 4> pixel{};

  Handle() = default;
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    OSMesaMakeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    if (context != nullptr) OSMesaDestroyContext(context);
  }
};

GlContext::GlContext() : handle_(std::make_unique<Handle>()) {
  const int attributes[] = {OSMESA_FORMAT,
                            OSMESA_RGBA,
                            OSMESA_PROFILE,
                            OSMESA_CORE_PROFILE,
                            OSMESA_CONTEXT_MAJOR_VERSION,
                            3,
                            OSMESA_CONTEXT_MINOR_VERSION,
                            3,
                            0};
  handle_->context = OSMesaCreateContextAttribs(attributes, nullptr);
  if (handle_->context == nullptr ||
      OSMesaMakeCurrent(handle_->context, handle_->pixel.data(), GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE)
    throw GlError("no OpenGL: OSMesa gives no context of version 3.3 core (package libosmesa6)");
}

GlContext::~GlContext() = default;

GlObject makeBuffer() {
  GLuint name = 0;
  glGenBuffers(1, &name);
  return {name, [](GLuint old) { glDeleteBuffers(1, &old); }};
}

GlObject makeVertexArray() {
  GLuint name = 0;
  glGenVertexArrays(1, &name);
  return {name, [](GLuint old) { glDeleteVertexArrays(1, &old); }};
}

GlObject makeTexture(GLint internalFormat, int width, int height, GLenum format, GLenum type,
                     GLint filter) {
  GLuint name = 0;
  glGenTextures(1, &name);
  glBindTexture(GL_TEXTURE_2D, name);
  glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, width, height, 0, format, type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  checkGl("making a texture");
  return {name, [](GLuint old) { glDeleteTextures(1, &old); }};
}

GlObject makeFramebuffer(std::initializer_list<GLuint> colours, GLuint depth) {
  GLuint name = 0;
  glGenFramebuffers(1, &name);
  GlObject framebuffer(name, [](GLuint old) { glDeleteFramebuffers(1, &old); });
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  std::vector<GLenum> attachments;
  for (const GLuint colour : colours) {
    attachments.push_back(GL_COLOR_ATTACHMENT0 + GLenum(attachments.size()));
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachments.back(), GL_TEXTURE_2D, colour, 0);
  }
  if (depth != 0)
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  if (attachments.empty())
    glDrawBuffer(GL_NONE);
  else
    glDrawBuffers(GLsizei(attachments.size()), attachments.data());
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw GlError("OpenGL: a framebuffer is incomplete");
  checkGl("making a framebuffer");
  return framebuffer;
}

GlObject makeProgram(const std::string& vertexSource, const std::string& fragmentSource) {
  const GlObject vertex = compile(GL_VERTEX_SHADER, vertexSource);
  const GlObject fragment = compile(GL_FRAGMENT_SHADER, fragmentSource);
  GlObject program(glCreateProgram(), [](GLuint name) { glDeleteProgram(name); });
  glAttachShader(program, vertex);
  glAttachShader(program, fragment);
  glLinkProgram(program);
  GLint good = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &good);
  if (good != GL_TRUE) {
    std::array<char, 2048> log{};
    glGetProgramInfoLog(program, GLsizei(log.size()), nullptr, log.data());
    throw GlError("OpenGL refuses a program: " + std::string(log.data()));
  }
  return program;
}

GLint uniform(GLuint program, const char* name) { return glGetUniformLocation(program, name); }

}  // namespace demos::render

#include "demos/render/painter.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "demos/render/gl.h"
#include "demos/render/instances.h"
#include "demos/render/shaders.h"

namespace demos::render {

using Eigen::Matrix4d;
using Eigen::Matrix4f;
using Eigen::Vector3d;
using Eigen::Vector3f;

namespace {

constexpr int samplesPerSide = 2;  // of each pixel
constexpr int shadowSize = 2048;
constexpr std::uint32_t terrainBit = 1u << 31;  // set by the shader
constexpr float outlineDarkness = 0.4f;
const Vector3f skyLow(0.86f, 0.87f, 0.87f), skyHigh(0.72f, 0.77f, 0.82f);  // linear

/// One mesh on the graphics side.
struct Model {
  GlObject array, vertices, triangles;
  GLsizei count = 0;
};

void set(GLuint program, const char* name, const Matrix4f& value) {
  glUniformMatrix4fv(uniform(program, name), 1, GL_FALSE, value.data());
}
void set(GLuint program, const char* name, const Vector3f& value) {
  glUniform3fv(uniform(program, name), 1, value.data());
}
void set(GLuint program, const char* name, float value) {
  glUniform1f(uniform(program, name), value);
}
void set(GLuint program, const char* name, int value) {
  glUniform1i(uniform(program, name), value);
}
void set(GLuint program, const char* name, float x, float y) {
  glUniform2f(uniform(program, name), x, y);
}
void bind(int unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + GLenum(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
}

/// An orthographic view of everything on the stage, along the sun's rays.
struct SunView {
  Matrix4d worldToClip;
  double texel;  ///< m
};

SunView sunView(const Vector3d& sun, const Box& stage) {
  const double radius = 1.5 * stage.radius();
  View view;
  view.target = stage.centre();
  view.eye = view.target + radius * sun;
  view.up = sun.unitOrthogonal();
  Matrix4d scale = Matrix4d::Identity();
  scale(0, 0) = scale(1, 1) = 1 / radius;
  // Deeper than wide: things far up the rays cast shadows, too.
  scale(2, 2) = -1 / (4 * radius);
  return {scale * view.toEye(), 2 * radius / shadowSize};
}

}  // namespace

struct Painter::Gl {
  explicit Gl(Size size);

  Size size, samples;
  GlContext context;  // first made, last gone
  GlObject depthProgram, thingProgram, backgroundProgram, occlusionProgram, blurProgram,
      resolveProgram;
  GlObject shadowMap, depths, rawOcclusion, occlusion, lights, numbers, sampleDepths, pixels;
  GlObject shadowTarget, depthTarget, rawOcclusionTarget, occlusionTarget, sampleTarget,
      pixelTarget;
  GlObject instanceBuffer, emptyArray;
  std::vector<std::vector<Model>> films;
  const std::vector<Model>* models = nullptr;  // of the film that is drawn

  void drawBatches(const std::vector<Batch>& batches) const;
  void castShadows(const Batches& batches, const SunView& sun) const;
  void findOcclusion(const Batches& batches, const View& view, const Box& stage) const;
  void paint(const Batches& batches, const Film& film, const View& view, const Box& stage,
             const Vector3d& sunDirection, const SunView& sun) const;
  void resolve() const;
  void fillScreen() const;
  Drawing readBack() const;
};

Painter::Gl::Gl(Size size)
    : size(size), samples{size.width * samplesPerSide, size.height * samplesPerSide} {
  depthProgram = makeProgram(shaders::thingVertex, shaders::depthFragment);
  thingProgram = makeProgram(shaders::thingVertex, shaders::thingFragment);
  backgroundProgram = makeProgram(shaders::screenVertex, shaders::backgroundFragment);
  occlusionProgram = makeProgram(shaders::screenVertex, shaders::occlusionFragment);
  blurProgram = makeProgram(shaders::screenVertex, shaders::blurFragment);
  resolveProgram = makeProgram(shaders::screenVertex, shaders::resolveFragment);

  const auto depthTexture = [](int width, int height, GLint filter) {
    return makeTexture(GL_DEPTH_COMPONENT32F, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, filter);
  };
  shadowMap = depthTexture(shadowSize, shadowSize, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
  depths = depthTexture(size.width, size.height, GL_NEAREST);
  rawOcclusion = makeTexture(GL_R8, size.width, size.height, GL_RED, GL_UNSIGNED_BYTE, GL_NEAREST);
  occlusion = makeTexture(GL_R8, size.width, size.height, GL_RED, GL_UNSIGNED_BYTE, GL_LINEAR);
  lights = makeTexture(GL_RGBA16F, samples.width, samples.height, GL_RGBA, GL_FLOAT, GL_NEAREST);
  numbers = makeTexture(GL_R32UI, samples.width, samples.height, GL_RED_INTEGER, GL_UNSIGNED_INT,
                        GL_NEAREST);
  sampleDepths = depthTexture(samples.width, samples.height, GL_NEAREST);
  pixels = makeTexture(GL_RGBA8, size.width, size.height, GL_RGBA, GL_UNSIGNED_BYTE, GL_NEAREST);

  shadowTarget = makeFramebuffer({}, shadowMap);
  depthTarget = makeFramebuffer({}, depths);
  rawOcclusionTarget = makeFramebuffer({rawOcclusion}, 0);
  occlusionTarget = makeFramebuffer({occlusion}, 0);
  sampleTarget = makeFramebuffer({lights, numbers}, sampleDepths);
  pixelTarget = makeFramebuffer({pixels}, 0);
  instanceBuffer = makeBuffer();
  emptyArray = makeVertexArray();
}

void Painter::Gl::drawBatches(const std::vector<Batch>& batches) const {
  for (const Batch& batch : batches) {
    const Model& model = (*models)[std::size_t(batch.mesh)];
    glBindVertexArray(model.array);
    glBindBuffer(GL_ARRAY_BUFFER, instanceBuffer);
    const auto at = [&batch](std::size_t offset) {
      return reinterpret_cast<const void*>(batch.first * sizeof(Instance) + offset);
    };
    for (GLuint column = 0; column < 4; ++column)
      glVertexAttribPointer(2 + column, 4, GL_FLOAT, GL_FALSE, sizeof(Instance),
                            at(offsetof(Instance, matrix) + 16 * column));
    glVertexAttribPointer(6, 4, GL_FLOAT, GL_FALSE, sizeof(Instance), at(offsetof(Instance, tint)));
    glVertexAttribIPointer(7, 2, GL_UNSIGNED_INT, sizeof(Instance), at(offsetof(Instance, tag)));
    glDrawElementsInstanced(GL_TRIANGLES, model.count, GL_UNSIGNED_INT, nullptr,
                            GLsizei(batch.count));
  }
}

void Painter::Gl::castShadows(const Batches& batches, const SunView& sun) const {
  glBindFramebuffer(GL_FRAMEBUFFER, shadowTarget);
  glViewport(0, 0, shadowSize, shadowSize);
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5f, 2);
  glUseProgram(depthProgram);
  set(depthProgram, "worldToClip", Matrix4f(sun.worldToClip.cast<float>()));
  drawBatches(batches.solid);
  glDisable(GL_POLYGON_OFFSET_FILL);
  checkGl("drawing the shadows");
}

void Painter::Gl::findOcclusion(const Batches& batches, const View& view, const Box& stage) const {
  const Matrix4d projection = view.projection(double(size.width) / size.height);
  glBindFramebuffer(GL_FRAMEBUFFER, depthTarget);
  glViewport(0, 0, size.width, size.height);
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
  glUseProgram(depthProgram);
  set(depthProgram, "worldToClip", Matrix4f((projection * view.toEye()).cast<float>()));
  drawBatches(batches.solid);

  glDisable(GL_DEPTH_TEST);
  glBindFramebuffer(GL_FRAMEBUFFER, rawOcclusionTarget);
  glUseProgram(occlusionProgram);
  bind(0, depths);
  set(occlusionProgram, "depths", 0);
  set(occlusionProgram, "clipToEye", Matrix4f(projection.inverse().cast<float>()));
  set(occlusionProgram, "radius", float(0.09 * stage.radius()));
  set(occlusionProgram, "pixelsPerMetre", float(projection(1, 1) * size.height / 2));
  fillScreen();

  glBindFramebuffer(GL_FRAMEBUFFER, occlusionTarget);
  glUseProgram(blurProgram);
  bind(1, rawOcclusion);
  set(blurProgram, "depths", 0);
  set(blurProgram, "occlusion", 1);
  set(blurProgram, "nearFar", float(view.near), float(view.far));
  fillScreen();
  checkGl("finding the occlusion");
}

void Painter::Gl::paint(const Batches& batches, const Film& film, const View& view,
                        const Box& stage, const Vector3d& sunDirection, const SunView& sun) const {
  glBindFramebuffer(GL_FRAMEBUFFER, sampleTarget);
  glViewport(0, 0, samples.width, samples.height);
  glClear(GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glUseProgram(backgroundProgram);
  set(backgroundProgram, "skyLow", skyLow);
  set(backgroundProgram, "skyHigh", skyHigh);
  fillScreen();

  Matrix4d toTexture = Matrix4d::Identity();
  toTexture.topLeftCorner<3, 3>() *= 0.5;
  toTexture.topRightCorner<3, 1>().setConstant(0.5);
  const Matrix4d worldToClip = view.projection(double(size.width) / size.height) * view.toEye();
  glEnable(GL_DEPTH_TEST);
  glUseProgram(thingProgram);
  bind(0, shadowMap);
  bind(1, occlusion);
  set(thingProgram, "shadowMap", 0);
  set(thingProgram, "occlusion", 1);
  set(thingProgram, "worldToClip", Matrix4f(worldToClip.cast<float>()));
  set(thingProgram, "worldToShadow", Matrix4f((toTexture * sun.worldToClip).cast<float>()));
  set(thingProgram, "shadowTexel", float(sun.texel));
  set(thingProgram, "sun", Vector3f(sunDirection.cast<float>()));
  set(thingProgram, "eye", Vector3f(view.eye.cast<float>()));
  set(thingProgram, "up", Vector3f(film.up.cast<float>()));
  set(thingProgram, "pixels", float(samples.width), float(samples.height));
  set(thingProgram, "gridSpacing", float(gridSpacing(view, size)));
  set(thingProgram, "stageCentre", Vector3f(stage.centre().cast<float>()));
  set(thingProgram, "stageRadius", float(stage.radius()));
  set(thingProgram, "skyLow", skyLow);
  set(thingProgram, "skyHigh", skyHigh);
  drawBatches(batches.solid);

  // Glass keeps the number and the depth of the things behind it.
  glEnablei(GL_BLEND, 0);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDepthMask(GL_FALSE);
  drawBatches(batches.glass);
  glDepthMask(GL_TRUE);
  glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisablei(GL_BLEND, 0);
  checkGl("drawing the things");
}

void Painter::Gl::resolve() const {
  glBindFramebuffer(GL_FRAMEBUFFER, pixelTarget);
  glViewport(0, 0, size.width, size.height);
  glDisable(GL_DEPTH_TEST);
  glUseProgram(resolveProgram);
  bind(0, lights);
  bind(1, numbers);
  set(resolveProgram, "lights", 0);
  set(resolveProgram, "numbers", 1);
  set(resolveProgram, "perPixel", samplesPerSide);
  set(resolveProgram, "outline", outlineDarkness);
  fillScreen();
  checkGl("resolving the samples");
}

void Painter::Gl::fillScreen() const {
  glBindVertexArray(emptyArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

Drawing Painter::Gl::readBack() const {
  const std::size_t count = std::size_t(size.width) * size.height;
  Drawing drawing{Image(size), std::vector<float>(count), std::vector<std::uint32_t>(count)};
  std::vector<std::uint8_t> rows(3 * count);
  std::vector<float> depthRows(count);
  std::vector<std::uint32_t> sampleNumbers(count * samplesPerSide * samplesPerSide);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glBindFramebuffer(GL_FRAMEBUFFER, pixelTarget);
  glReadPixels(0, 0, size.width, size.height, GL_RGB, GL_UNSIGNED_BYTE, rows.data());
  glBindFramebuffer(GL_FRAMEBUFFER, depthTarget);
  glReadPixels(0, 0, size.width, size.height, GL_DEPTH_COMPONENT, GL_FLOAT, depthRows.data());
  glBindFramebuffer(GL_FRAMEBUFFER, sampleTarget);
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  glReadPixels(0, 0, samples.width, samples.height, GL_RED_INTEGER, GL_UNSIGNED_INT,
               sampleNumbers.data());
  checkGl("reading the picture");

  // OpenGL's rows come from the bottom.
  for (int y = 0; y < size.height; ++y) {
    const std::size_t from = std::size_t(size.height - 1 - y) * size.width,
                      to = std::size_t(y) * size.width;
    std::copy_n(&rows[3 * from], 3 * size.width, drawing.image.pixel(0, y));
    std::copy_n(&depthRows[from], size.width, &drawing.depths[to]);
    const std::uint32_t* numbersRow =
        &sampleNumbers[std::size_t(size.height - 1 - y) * samplesPerSide * samples.width];
    for (int x = 0; x < size.width; ++x)
      drawing.numbers[to + x] = numbersRow[x * samplesPerSide] & ~terrainBit;
  }
  return drawing;
}

Painter::Painter(Size size) : gl_(std::make_unique<Gl>(size)) {}
Painter::~Painter() = default;

int Painter::load(const Film& film) {
  std::vector<Model> models;
  for (const Mesh& mesh : film.meshes) {
    Model model{makeVertexArray(), makeBuffer(), makeBuffer(), GLsizei(mesh.triangles.size())};
    glBindVertexArray(model.array);
    glBindBuffer(GL_ARRAY_BUFFER, model.vertices);
    glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(mesh.vertices.size() * sizeof(Vertex)),
                 mesh.vertices.data(), GL_STATIC_DRAW);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, model.triangles);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER,
                 GLsizeiptr(mesh.triangles.size() * sizeof(mesh.triangles[0])),
                 mesh.triangles.data(), GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex), nullptr);
    glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                          reinterpret_cast<const void*>(offsetof(Vertex, normal)));
    for (GLuint attribute = 0; attribute < 8; ++attribute) {
      glEnableVertexAttribArray(attribute);
      glVertexAttribDivisor(attribute, attribute < 2 ? 0 : 1);
    }
    models.push_back(std::move(model));
  }
  checkGl("loading the meshes");
  gl_->films.push_back(std::move(models));
  return int(gl_->films.size()) - 1;
}

Drawing Painter::draw(int loaded, const Film& film, const Frame& frame, const View& view,
                      const Box& stage) {
  gl_->models = &gl_->films[std::size_t(loaded)];
  const Batches batches = batchesOf(film, frame, view, stage);
  glBindBuffer(GL_ARRAY_BUFFER, gl_->instanceBuffer);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(batches.instances.size() * sizeof(Instance)),
               batches.instances.data(), GL_STREAM_DRAW);

  // The sun stands over the camera's left shoulder.
  const Eigen::Matrix3d toEye = view.toEye().topLeftCorner<3, 3>();
  Vector3d ahead = toEye.row(2);
  ahead -= ahead.dot(film.up) * film.up;
  if (ahead.norm() < 1e-6) ahead = film.up.unitOrthogonal();
  const Vector3d right = toEye.row(0);
  const Vector3d sun = (0.8 * ahead.normalized() - 0.75 * right + 1.5 * film.up).normalized();
  const SunView sunny = sunView(sun, stage);

  gl_->castShadows(batches, sunny);
  gl_->findOcclusion(batches, view, stage);
  gl_->paint(batches, film, view, stage, sun, sunny);
  gl_->resolve();
  return gl_->readBack();
}

double gridSpacing(const View& view, Size size) {
  // In pixels: lines closer than this would look like a grey veil.
  constexpr double closest = 14;
  return std::pow(10, std::ceil(std::log10(closest / view.pixelsPerMetre(size))));
}

}  // namespace demos::render

#pragma once

namespace demos::render::shaders {

extern const char* const thingVertex;    ///< instances of meshes
extern const char* const depthFragment;  ///< depth only
extern const char* const thingFragment;  ///< light, shadow, grid; colour and number of the thing
extern const char* const screenVertex;   ///< one triangle over the whole picture
extern const char* const backgroundFragment;
extern const char* const occlusionFragment;
extern const char* const blurFragment;
extern const char* const resolveFragment;  ///< from samples to pixels: outlines, averages, sRGB

}  // namespace demos::render::shaders

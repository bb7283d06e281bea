#pragma once

#include "demos/render/image.h"

namespace demos::render::palette {

// Marks use the colours of Okabe and Ito, which colour-blind eyes can tell apart; their shapes
// differ, too.
constexpr Colour sticking{0, 114, 178};    ///< blue, disc
constexpr Colour sliding{230, 159, 0};     ///< orange, diamond
constexpr Colour released{255, 255, 255};  ///< white, ring
constexpr Colour joint{0, 158, 115};       ///< bluish green, square
/// Vermilion, darkened so that it stands out in grey as well.
constexpr Colour reaction{176, 36, 24};

constexpr Colour ink{38, 43, 51};
constexpr Colour paleInk{104, 113, 125};
constexpr Colour paper{250, 250, 248};
constexpr Colour rule{214, 217, 221};

// Things have calm colours: four tones of stone and water that differ in lightness, in turn. Heavy
// things are dark.
constexpr Colour bodies[] = {{157, 178, 199}, {224, 206, 172}, {119, 146, 173}, {198, 174, 138}};
constexpr Colour heavy{71, 80, 98};
constexpr Colour fixed{186, 187, 186};
constexpr Colour terrain{206, 206, 202};

}  // namespace demos::render::palette

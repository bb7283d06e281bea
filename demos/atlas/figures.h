#pragma once

#include "demos/atlas/figure_file.h"

/// The figures of Delassus' paper, measured: drawn from W, with real steps of Bullet worlds on top.
namespace demos::atlas {

Figure twoContacts();      ///< §7-§9: the four regions of a bead in an angle
Figure threeContacts();    ///< §11: the eight regions of a bead in a trihedron
Figure oneRoughContact();  ///< released, stuck, sliding: the regions of one contact with friction
Figure intuition();        ///< §10: the two outcomes that contradict the common rule
Figure movingLoad();       ///< §10: leaving a region through a face and through the vertex

}  // namespace demos::atlas

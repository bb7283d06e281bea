#pragma once

/// Names the precision of the Bullet library in use.
///
/// Bullet's own functions that take only pointers mangle alike in both precisions, so that objects
/// of one and a library of the other link and then crash. A solver's constructor takes this tag: a
/// wrong mix ends with an unresolved symbol that says which precision was asked for.
#ifdef BT_USE_DOUBLE_PRECISION
struct btDelassusPrecisionFloat64 {};
using btDelassusPrecision = btDelassusPrecisionFloat64;
#else
struct btDelassusPrecisionFloat32 {};
using btDelassusPrecision = btDelassusPrecisionFloat32;
#endif

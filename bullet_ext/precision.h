#pragma once

/// Names the precision of the Bullet library in use.
///
/// Bullet's functions that take only pointers have the same mangled names in both precisions. So
/// objects of one precision link with a library of the other, and crash. A solver's constructor
/// takes this tag: a wrong mix ends with an unresolved symbol that names the wanted precision.
#ifdef BT_USE_DOUBLE_PRECISION
struct btDelassusPrecisionFloat64 {};
using btDelassusPrecision = btDelassusPrecisionFloat64;
#else
struct btDelassusPrecisionFloat32 {};
using btDelassusPrecision = btDelassusPrecisionFloat32;
#endif

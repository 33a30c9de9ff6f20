#pragma once

namespace vignole {

/// Ceres logs through glog on stderr what callers learn from its summary, and a library has no say there: switched off
/// for the whole program. Cheap; call it before every solve.
void silenceCeres();

}  // namespace vignole

#include "calibration/intrinsics/quiet_ceres.h"

#include <glog/logging.h>

namespace vignole {

void silenceCeres() {
  static const bool done = [] {
    FLAGS_minloglevel = google::GLOG_FATAL;
    return true;
  }();
  static_cast<void>(done);
}

}  // namespace vignole

// Targets found in rendered pictures: how exactly, how honest the uncertainty is, what is refused.

#include "calibration/detection/target_finder.h"

#include <chrono>
#include <cstdio>

#include "tests/calibration/detection/rendered_targets.h"

namespace vignole {
namespace {

using namespace rendered;

struct Case {
  const char* words;
  bool light = false;
};

class FoundTarget : public testing::TestWithParam<Case> {};

Errors errorsOf(const Case& which, double noiseDn, int views) {
  VirtualTargetSettings s = settings(which.words, camera(), noiseDn, 3);
  s.target.lightDots = which.light;
  const auto target = make(s);
  ErrorSum sum;
  int n = 0;
  for (const Extrinsics& pose : usualViews(s.target, s.camera.intrinsics, views, 5)) {
    auto t0=std::chrono::steady_clock::now();
    const Image image = render(*target, pose, n++);
    auto t1=std::chrono::steady_clock::now();
    const TargetView view = findTarget(image.view(), s.target);
    auto t2=std::chrono::steady_clock::now();
    printf("%d: %zu points blur %.2f pitch %.1f obl %.0f render %.2f find %.2f %s\n",n,view.points.size(),view.blurPx,view.pitchPx,view.obliqueDeg,std::chrono::duration<double>(t1-t0).count(),std::chrono::duration<double>(t2-t1).count(),view.refusal.c_str());
    ErrorSum e; e.add(view, expected(s.target, s.camera.intrinsics, pose)); auto r=e.result(); printf("   rms %.4f worst %.3f chi2 %.2f\n",r.rmsPx,r.worstPx,r.chi2);
    if(r.worstPx>2)continue;
    sum.add(view, expected(s.target, s.camera.intrinsics, pose));
  }
  return sum.result();
}

TEST_P(FoundTarget, WithoutNoiseToAHundredthOfAPixel) {
  const Errors e = errorsOf(GetParam(), 0, 9);
  printf("%s: rms %.4f worst %.4f u %.4f chi2 %.2f\n", GetParam().words, e.rmsPx, e.worstPx, e.meanU, e.chi2);
  EXPECT_LT(e.rmsPx, 0.01);
}

TEST_P(FoundTarget, WithNoiseAsExactAsItSays) {
  const Errors e = errorsOf(GetParam(), 3, 9);
  printf("%s: rms %.4f worst %.4f u %.4f chi2 %.2f\n", GetParam().words, e.rmsPx, e.worstPx, e.meanU, e.chi2);
  EXPECT_NEAR(e.chi2, 1, 0.3);
}

INSTANTIATE_TEST_SUITE_P(Patterns, FoundTarget,
                         testing::Values(Case{"chessboard:11x8:14"}, Case{"circles:13x9:12:6"},
                                         Case{"circles:13x9:12:6", true}, Case{"acircles:6x13:8:7"},
                                         Case{"acircles:6x12:8:7"}, Case{"dotplate:13x9:12"}));

}  // namespace
}  // namespace vignole

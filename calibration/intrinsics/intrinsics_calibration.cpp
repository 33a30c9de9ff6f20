#include "calibration/intrinsics/intrinsics_calibration.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "calibration/intrinsics/circle_shift.h"
#include "calibration/intrinsics/information.h"
#include "calibration/intrinsics/intrinsics_verdict.h"
#include "calibration/intrinsics/model_choice.h"
#include "calibration/intrinsics/robust_fit.h"
#include "calibration/intrinsics/target_decision.h"
#include "calibration/intrinsics/target_errors.h"
#include "calibration/intrinsics/target_turns.h"
#include "calibration/intrinsics/view_selection.h"
#include "calibration/parallel_for.h"

namespace vignole {

namespace {

struct ErrorFigures {
  double rmsPx = 0, meanPx = 0;
};

ErrorFigures figures(const std::vector<std::vector<Point2>>& errors) {
  double squares = 0, distances = 0, count = 0;
  for (const auto& view : errors)
    for (const Point2& e : view) {
      squares += e.squaredNorm();
      distances += e.norm();
      count += 1;
    }
  return count > 0 ? ErrorFigures{std::sqrt(squares / count), distances / count} : ErrorFigures{};
}

/// One lens model on its way: its fit to all views and how it does before others.
struct Candidate {
  LensVariant variant;
  TargetFit fit;
  HeldOut heldOut;
};

class Calibrating {
 public:
  Calibrating(const IntrinsicsSettings& settings, const Job& job) : settings_(settings), job_(job) {}

  Expected<IntrinsicsCalibration> run(const std::vector<TargetView>& views, const PlanarTarget& target) {
    const auto began = std::chrono::steady_clock::now();
    result_.camera.serial = settings_.serial;
    result_.correlation.setZero();
    taken_ = takeViews(views, target, settings_, result_.views);
    if (auto done = adjustAll(target); !done) return tl::unexpected<Error>(done.error());
    result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    return std::move(result_);
  }

 private:
  Expected<void> adjustAll(const PlanarTarget& target) {
    if (refuseTooFew(taken_.source.size())) return {};
    job_.report(0.02, "first adjustment");
    auto robust =
        robustFit(taken_.observations, fullest(), taken_.like, settings_.nominalFocalMm, settings_.outliers, job_);
    if (!robust) return tl::unexpected<Error>(robust.error());
    robust_ = std::move(*robust);
    rejectSamePoses(taken_.observations, robust_.fit, names(), settings_.samePosePx, robust_.selection);
    if (refuseTooFew(robust_.selection.usedViews())) {
      reportViews(robust_.fit);
      return {};
    }
    corrected_ = withoutCircleShift(taken_.observations, robust_.fit);
    refine(corrected_, fullest(), {}, settings_.outliers, robust_);
    if (refuseTooFew(robust_.selection.usedViews())) {
      reportViews(robust_.fit);
      return {};
    }
    if (target.pattern != TargetPattern::DotPlate) countPointsAlike();  // that one has a mark
    if (auto done = decideTargetErrors(target.uMm); !done) return done;
    if (auto done = chooseModel(); !done) return done;
    finish();
    return {};
  }

  /// The most general lens that the pictures can carry: what is an outlier is judged by it.
  [[nodiscard]] LensVariant fullest() const {
    constexpr std::size_t kViewsForAll = 5;
    if (taken_.source.size() >= kViewsForAll) return {DistortionModel::Polynomial, 3, true, true};
    return {DistortionModel::Polynomial, 2, false, false};
  }

  bool refuseTooFew(std::size_t usable) {
    const std::string refusal = refusalForViews(usable, settings_);
    if (refusal.empty()) return false;
    result_.refusals.push_back(refusal);
    return true;
  }

  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const std::size_t v : taken_.source) all.push_back(result_.views[v].file);
    return all;
  }

  [[nodiscard]] CrossValidationSettings validation() const { return {settings_.folds, prior_, settings_.confidence}; }

  void takeObservations() {
    used_ = selected(corrected_, robust_.selection);
    weigh(used_, robust_.unexplainedPx);
  }

  void countPointsAlike() {
    takeObservations();
    const std::vector<TargetTurn> turns = turnsOf(used_.points);
    const std::vector<int> turned = turnedViews(used_, robust_.fit, turns);
    for (std::size_t v = 0; v < turned.size(); ++v) {
      if (turned[v] < 0) continue;
      const TargetTurn& by = turns[static_cast<std::size_t>(turned[v])];
      turn(by, taken_.observations.views[v]);
      turn(by, corrected_.views[v]);
      turn(by, robust_.fit.cameraFromTarget[v]);
    }
  }

  Expected<void> decideTargetErrors(double statedMm) {
    job_.report(0.15, "is the target as stated?");
    takeObservations();
    auto prior = decideTarget(used_, fullest(), robust_.fit, statedMm, validation(), job_);
    if (!prior) return tl::unexpected<Error>(prior.error());
    prior_ = *prior;
    if (prior_.free()) {
      AdjustmentSettings free;
      free.target = prior_;
      refine(corrected_, fullest(), free, settings_.outliers, robust_);
      takeObservations();
    }
    // Errors that the finder does not know of are hardly those of single points.
    constexpr double kExplained = 2;
    const double perPoint = chi2OfFinder(robust_.fit) / degreesOfFreedom(fullest(), robust_.fit);
    pointErrors_ = perPoint < kExplained ? PointErrors::Independent : PointErrors::Shared;
    return {};
  }

  Expected<std::vector<Candidate>> tried(const std::vector<LensVariant>& variants) {
    std::vector<TargetFit> fits(variants.size());
    AdjustmentSettings adjustment;
    adjustment.target = prior_;
    parallelFor(variants.size(), [&](std::size_t i) {
      TargetFit start = robust_.fit;
      start.intrinsics = asVariant(start.intrinsics, variants[i]);
      if (!variants[i].aspect) start.intrinsics.pixelHeightMm = taken_.like.pixelHeightMm;
      fits[i] = adjust(used_, variants[i], start, adjustment);
    });
    auto heldOut = crossValidate(used_, variants, fits, validation(), job_);
    if (!heldOut) return tl::unexpected<Error>(heldOut.error());
    std::vector<Candidate> all;
    for (std::size_t i = 0; i < variants.size(); ++i) {
      all.push_back({variants[i], std::move(fits[i]), std::move((*heldOut)[i])});
      result_.variants.push_back(described(all.back()));
    }
    return all;
  }

  [[nodiscard]] VariantResult described(const Candidate& c) const {
    const ErrorFigures f = figures(residuals(used_, c.fit));
    return {c.variant, c.fit.intrinsics, f.rmsPx, f.meanPx, c.heldOut.rmsPx};
  }

  [[nodiscard]] std::optional<Candidate> simplest(const std::vector<Candidate>& among) const {
    if (among.empty()) return {};
    std::vector<LensVariant> variants;
    std::vector<HeldOut> heldOut;
    for (const Candidate& c : among) {
      variants.push_back(c.variant);
      heldOut.push_back(c.heldOut);
    }
    return among[chooseSimplest(variants, heldOut, pointErrors_, settings_.confidence)];
  }

  /// Distortion first, with the pixels' height free; then for the best of each family whether it has to be.
  Expected<void> chooseModel() {
    job_.report(0.3, "lens models");
    const auto all = tried(lensVariants(true));
    if (!all) return tl::unexpected<Error>(all.error());
    std::vector<Candidate> best;
    for (const DistortionModel family : {DistortionModel::Division, DistortionModel::Polynomial}) {
      std::vector<Candidate> members;
      for (const Candidate& c : *all)
        if (c.variant.model == family) members.push_back(c);
      best.push_back(*simplest(members));
    }
    job_.report(0.7, "shape of the pixels");
    std::vector<LensVariant> square;
    for (const Candidate& c : best) {
      square.push_back(c.variant);
      square.back().aspect = false;
    }
    const auto squares = tried(square);
    if (!squares) return tl::unexpected<Error>(squares.error());
    std::vector<Candidate> choice;
    for (std::size_t i = 0; i < best.size(); ++i) {
      best[i] = *simplest({(*squares)[i], best[i]});
      if (!settings_.model || *settings_.model == best[i].variant.model) choice.push_back(best[i]);
    }
    result_.variant = simplest(choice)->variant;
    settle(best[0], result_.division);
    settle(best[1], result_.polynomial);
    return {};
  }

  [[nodiscard]] double degreesOfFreedom(const LensVariant& variant, const TargetFit& fit) const {
    double freedom = -static_cast<double>(freeParameters(variant).size());
    for (const ObservedView& view : used_.views)
      if (!view.empty()) freedom += 2 * static_cast<double>(view.size()) - 6;
    return std::max(1.0, freedom - effectiveParameters(used_, fit, prior_));
  }

  /// The last adjustment of the best of a family: each point weighed by what the residuals of this model say of it.
  void settle(Candidate& candidate, std::optional<VariantResult>& result) {
    AdjustmentSettings adjustment;
    adjustment.target = prior_;
    const double freedom = degreesOfFreedom(candidate.variant, candidate.fit);
    const double chi2PerDof = chi2OfFinder(candidate.fit) / freedom;
    const double unexplainedPx = unexplainedNoise(used_, residuals(used_, candidate.fit), freedom);
    TargetObservations weighed = used_;
    weigh(weighed, unexplainedPx);
    candidate.fit = adjust(weighed, candidate.variant, candidate.fit, adjustment);
    result = described(candidate);
    for (VariantResult& v : result_.variants)
      if (v.variant == candidate.variant) v = *result;
    if (candidate.variant != result_.variant) return;
    result_.chi2PerDof = chi2PerDof;
    result_.unexplainedPx = unexplainedPx;
    chosen_ = std::move(weighed);
    fit_ = candidate.fit;
  }

  /// Covariance, figures, verdict of the chosen one.
  void finish() {
    job_.report(0.9, "uncertainty");
    if (!fit_.converged)
      result_.refusals.emplace_back(
          "refused, because the adjustment does not come to rest; take more pictures, and check the target's size");

    CalibratedIntrinsics& camera = result_.camera;
    camera.intrinsics = fit_.intrinsics;
    camera.covariance = informationOf(chosen_, result_.variant, fit_, prior_).covariance();
    for (int i = 0; i < kIntrinsicParameters; ++i)
      for (int j = 0; j < kIntrinsicParameters; ++j)
        if (const double scale = std::sqrt(camera.covariance(i, i) * camera.covariance(j, j)); scale > 0)
          result_.correlation(i, j) = camera.covariance(i, j) / scale;
    reportTarget();
    reportViews(fit_);
    askOpenCv();
    judgeCalibration(tiltDifferenceDeg(fit_, robust_.selection), settings_, result_);
    job_.report(1, "done");
  }

  [[nodiscard]] double chi2OfFinder(const TargetFit& fit) const {
    double chi2 = 0;
    const auto errors = residuals(used_, fit);
    for (std::size_t v = 0; v < errors.size(); ++v)
      for (std::size_t i = 0; i < errors[v].size(); ++i)
        if (const double u = used_.views[v][i].uPx; u > 0) chi2 += errors[v][i].squaredNorm() / (u * u);
    return chi2;
  }

  void reportTarget() {
    if (!prior_.free()) return;
    result_.targetErrorMm = prior_.inPlaneMm;
    result_.targetBendMm = prior_.outOfPlaneMm;
    for (std::size_t i = 0; i < fit_.points.size(); ++i) {
      result_.targetCorrectionsMm.emplace_back((fit_.points[i] - taken_.observations.points[i]).head<2>());
      if (prior_.outOfPlaneMm > 0) result_.targetHeightsMm.push_back(fit_.points[i].z());
    }
  }

  void askOpenCv() {
    if (!settings_.openCvReference) return;
    const TargetObservations found = selected(taken_.observations, robust_.selection);
    result_.openCv = openCvReference(found, fit_.points, result_.variant, taken_.like);
    if (prior_.free())
      result_.openCvTargetAsStated = openCvReference(found, found.points, result_.variant, taken_.like);
  }

  void reportViews(const TargetFit& fit) {
    const TargetObservations& all = corrected_.views.empty() ? taken_.observations : corrected_;
    const auto errors = residuals(all, fit);
    std::vector<CoveragePoint> covered;
    std::vector<std::vector<Point2>> usedErrors;
    for (std::size_t v = 0; v < all.views.size(); ++v) {
      ViewResult& view = result_.views[taken_.source[v]];
      view.reason = robust_.selection.viewRejection[v];
      view.used = view.reason.empty();
      view.cameraFromTarget = fit.cameraFromTarget[v];
      std::vector<Point2> ofView;
      for (std::size_t i = 0; i < all.views[v].size(); ++i) {
        const bool used = view.used && robust_.selection.points[v][i];
        view.pointResults.push_back({all.views[v][i].point, taken_.observations.views[v][i].px, errors[v][i], used});
        (used ? view.points : view.rejected) += 1;
        if (!used) continue;
        ofView.push_back(errors[v][i]);
        covered.push_back({taken_.observations.views[v][i].px, errors[v][i]});
      }
      const ErrorFigures f = figures({ofView});
      view.rmsPx = f.rmsPx;
      view.meanPx = f.meanPx;
      usedErrors.push_back(std::move(ofView));
    }
    const ErrorFigures f = figures(usedErrors);
    result_.camera.rmsPx = f.rmsPx;
    result_.camera.meanPx = f.meanPx;
    result_.coverage = coverageOf(covered, taken_.like.widthPx, taken_.like.heightPx);
  }

  const IntrinsicsSettings& settings_;
  const Job& job_;
  IntrinsicsCalibration result_;
  TakenViews taken_;
  TargetObservations corrected_;  ///< all, as if distortion shifted no centre of a circle
  TargetObservations used_;       ///< of those what counts, weighed for the choice
  TargetObservations chosen_;     ///< the same, weighed for the chosen model
  RobustFit robust_;
  TargetFit fit_;
  TargetPrior prior_;
  PointErrors pointErrors_ = PointErrors::Independent;
};

}  // namespace

Expected<IntrinsicsCalibration> calibrateIntrinsics(const std::vector<TargetView>& views, const PlanarTarget& target,
                                                    const IntrinsicsSettings& settings, const Job& job) {
  return Calibrating(settings, job).run(views, target);
}

}  // namespace vignole

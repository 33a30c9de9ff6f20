#include "calibration/intrinsics/intrinsics_calibration.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "calibration/intrinsics/circle_shift.h"
#include "calibration/intrinsics/information.h"
#include "calibration/intrinsics/intrinsics_verdict.h"
#include "calibration/intrinsics/model_choice.h"
#include "calibration/intrinsics/robust_fit.h"
#include "calibration/intrinsics/target_errors.h"
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

  [[nodiscard]] CrossValidationSettings validation(double pointSigmaMm) const {
    return {settings_.folds, pointSigmaMm, settings_.standardErrors};
  }

  void takeObservations() {
    used_ = selected(corrected_, robust_.selection);
    weigh(used_, robust_.unexplainedPx);
  }

  /// Stated uncertainties of the target's points are taken at their word; otherwise they are estimated where the views
  /// agree that points are out of place and pictures not seen confirm it.
  Expected<void> decideTargetErrors(double statedMm) {
    takeObservations();
    pointSigmaMm_ = statedMm;
    if (statedMm <= 0) {
      const double suspected = targetErrorMm(used_, robust_.fit);
      if (suspected <= 0) return {};
      job_.report(0.15, "is the target as stated?");
      AdjustmentSettings free;
      free.pointSigmaMm = suspected;
      const std::vector<LensVariant> variant = {fullest()};
      const std::vector<TargetFit> fixedFit = {robust_.fit}, freeFit = {adjust(used_, fullest(), robust_.fit, free)};
      const auto asStated = crossValidate(used_, variant, fixedFit, validation(0), job_);
      if (!asStated) return tl::unexpected<Error>(asStated.error());
      const auto estimated = crossValidate(used_, variant, freeFit, validation(suspected), job_);
      if (!estimated) return tl::unexpected<Error>(estimated.error());
      const PairedDifference gain = difference(asStated->front(), estimated->front());
      if (!(gain.mean > settings_.standardErrors * gain.standardError)) return {};
      pointSigmaMm_ = suspected;
    }
    AdjustmentSettings free;
    free.pointSigmaMm = pointSigmaMm_;
    refine(corrected_, fullest(), free, settings_.outliers, robust_);
    takeObservations();
    return {};
  }

  Expected<std::vector<Candidate>> tried(const std::vector<LensVariant>& variants) {
    std::vector<TargetFit> fits(variants.size());
    AdjustmentSettings adjustment;
    adjustment.pointSigmaMm = pointSigmaMm_;
    parallelFor(variants.size(), [&](std::size_t i) {
      TargetFit start = robust_.fit;
      start.intrinsics = asVariant(start.intrinsics, variants[i]);
      if (!variants[i].aspect) start.intrinsics.pixelHeightMm = taken_.like.pixelHeightMm;
      fits[i] = adjust(used_, variants[i], start, adjustment);
    });
    auto heldOut = crossValidate(used_, variants, fits, validation(pointSigmaMm_), job_);
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
    return among[chooseSimplest(variants, heldOut, settings_.standardErrors)];
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
    result_.division = described(best[0]);
    result_.polynomial = described(best[1]);
    const Candidate chosen = *simplest(choice);
    result_.variant = chosen.variant;
    fit_ = chosen.fit;
    return {};
  }

  [[nodiscard]] double degreesOfFreedom() const {
    double freedom = -static_cast<double>(freeParameters(result_.variant).size());
    for (const ObservedView& view : used_.views)
      if (!view.empty()) freedom += 2 * static_cast<double>(view.size()) - 6;
    return std::max(1.0, freedom - effectiveParameters(used_, fit_, pointSigmaMm_));
  }

  /// The last adjustment, each point weighed by what the residuals say of it; covariance, figures, verdict.
  void finish() {
    job_.report(0.9, "uncertainty");
    AdjustmentSettings adjustment;
    adjustment.pointSigmaMm = pointSigmaMm_;
    result_.chi2PerDof = chi2OfFinder() / degreesOfFreedom();
    result_.unexplainedPx = unexplainedNoise(used_, residuals(used_, fit_), degreesOfFreedom());
    weigh(used_, result_.unexplainedPx);
    fit_ = adjust(used_, result_.variant, fit_, adjustment);
    if (!fit_.converged)
      result_.refusals.emplace_back(
          "refused, because the adjustment does not come to rest; take more pictures, and check the target's size");

    CalibratedIntrinsics& camera = result_.camera;
    camera.intrinsics = fit_.intrinsics;
    camera.covariance = informationOf(used_, result_.variant, fit_, pointSigmaMm_).covariance();
    for (int i = 0; i < kIntrinsicParameters; ++i)
      for (int j = 0; j < kIntrinsicParameters; ++j)
        if (const double scale = std::sqrt(camera.covariance(i, i) * camera.covariance(j, j)); scale > 0)
          result_.correlation(i, j) = camera.covariance(i, j) / scale;
    reportTarget();
    reportViews(fit_);
    if (settings_.openCvReference)
      result_.openCv =
          openCvReference(selected(taken_.observations, robust_.selection), fit_.points, result_.variant, taken_.like);
    judgeCalibration(tiltDifferenceDeg(fit_, robust_.selection), settings_, result_);
    job_.report(1, "done");
  }

  [[nodiscard]] double chi2OfFinder() const {
    double chi2 = 0;
    const auto errors = residuals(used_, fit_);
    for (std::size_t v = 0; v < errors.size(); ++v)
      for (std::size_t i = 0; i < errors[v].size(); ++i)
        if (const double u = used_.views[v][i].uPx; u > 0) chi2 += errors[v][i].squaredNorm() / (u * u);
    return chi2;
  }

  void reportTarget() {
    if (pointSigmaMm_ <= 0) return;
    result_.targetErrorMm = pointSigmaMm_;
    for (std::size_t i = 0; i < fit_.points.size(); ++i)
      result_.targetCorrectionsMm.emplace_back((fit_.points[i] - taken_.observations.points[i]).head<2>());
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
  TargetObservations used_;       ///< of those what counts, with weights
  RobustFit robust_;
  TargetFit fit_;
  double pointSigmaMm_ = 0;
};

}  // namespace

Expected<IntrinsicsCalibration> calibrateIntrinsics(const std::vector<TargetView>& views, const PlanarTarget& target,
                                                    const IntrinsicsSettings& settings, const Job& job) {
  return Calibrating(settings, job).run(views, target);
}

}  // namespace vignole

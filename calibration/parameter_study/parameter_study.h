#pragma once
// A factorial experiment over the settings of a calibration (paper section III-B): runs, what each yields, what
// matters, the best setting and whether it holds. Pure: how a run is done is handed in.

#include <array>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "calibration/job.h"
#include "calibration/parameter_study/analysis_of_variance.h"
#include "calibration/parameter_study/factorial_design.h"

namespace vignole {

/// What is observed. Cd ... PdNominal: means over the pins that a camera used in a placement (paper, Table IV).
enum class Response {
  Success,       ///< 1: the camera was calibrated, 0: it was not
  Association,   ///< pins used over pins of the plate, of a camera in a placement
  Cd,            ///< mm
  Rd,            ///< mm
  Pd,            ///< mm
  PdNominal,     ///< mm, about the stated centres
  Reprojection,  ///< mean, px, of a camera over its placements
  DimensionU,    ///< root mean square of the dimensions' standard uncertainties, mm, of a whole run
  Time           ///< s, of a whole run
};
inline constexpr std::size_t kResponseCount = 9;
inline constexpr std::array<Response, kResponseCount> kResponses{
    Response::Success,   Response::Association,  Response::Cd,         Response::Rd,  Response::Pd,
    Response::PdNominal, Response::Reprojection, Response::DimensionU, Response::Time};
[[nodiscard]] std::string_view name(Response response);  ///< "cd_mm", as in tables and files
[[nodiscard]] std::string_view longName(Response response);
[[nodiscard]] std::optional<Response> responseNamed(std::string_view name);
[[nodiscard]] bool largerIsBetter(Response response);
/// Errors and times are analysed as logarithms: settings act on them by factors, and one that failed badly would drown
/// the others. Their means are then geometric ones.
[[nodiscard]] bool isLogarithmic(Response response);

using ResponseValues = std::array<double, kResponseCount>;
[[nodiscard]] ResponseValues noResponses();  ///< all NaN: not observed

/// What a run says of one camera in one placement, of one camera, or of the whole.
struct StudyUnit {
  int camera = -1;      ///< 0..3; -1: of the whole rig
  int placement = -1;   ///< index; -1: over all
  std::string failure;  ///< empty, or why there is nothing to observe
  ResponseValues values = noResponses();
};

struct StudyRun {
  Combination combination;
  std::string refusal;  ///< empty, or why the whole run is of no use ("refused, because ...")
  std::vector<StudyUnit> units;
  bool confirmation = false;  ///< was not part of the plan: done to check the prediction
  int sameAs = -1;            ///< index of the run that this one repeats: its settings differ in nothing that acts
};

/// Least-squares and raw means on the response's own scale; low and high: one standard error.
struct ScaledMean {
  double mean = 0, low = 0, high = 0;
};

struct BestSetting {
  Combination combination;
  ScaledMean predicted;  ///< by the model from all runs
  std::vector<Combination>
      ties;             ///< within one standard error of the best prediction; the setting is the first of them
  ScaledMean foretold;  ///< by the model from all other runs; NaN where they do not determine it
  double observed = 0;  ///< mean of the run itself; NaN: it failed
  int observations = 0;
  bool confirmed = false;  ///< observed within the 95 % interval of what the other runs foretell
  std::string remark;
};

struct ResponseStudy {
  Response response{};
  bool logarithmic = false;
  int observations = 0;
  std::optional<VarianceAnalysis> analysis;  ///< of logarithms where logarithmic; none: see whyNot
  std::string whyNot;
  std::optional<BestSetting> best;
  /// From the scale of the analysis to the response's.
  [[nodiscard]] ScaledMean scaled(double mean, double standardError) const;
};

struct ParameterStudy {
  FactorialDesign design;
  std::vector<StudyRun> runs;            ///< in the order of the design, then confirmations
  std::vector<ResponseStudy> responses;  ///< those that were observed
  Response primary = Response::Cd;       ///< the one that the best setting is taken by
  int unitsTried = 0, unitsFailed = 0;   ///< cameras in placements, over all runs
  int runsRefused = 0;
  std::map<std::string, int> failures;  ///< reasons, and how often
  std::vector<std::string> remarks;
  [[nodiscard]] const ResponseStudy* of(Response response) const;
};

struct StudySettings {
  Response primary = Response::Cd;
  int order = 2;  ///< 1: main effects only
};

/// Does one run. An error ends the study (the world failed, cancelled); a run that yields no calibration is no error.
using StudyTrial = std::function<Expected<StudyRun>(const Combination& combination, const Job& job)>;

/// All runs of the design in its order, then the confirmation of the best setting if it was not among them.
///
/// Best: among the settings with the fewest failed cameras, the one whose prediction is best; of those within one
/// standard error of it, the one whose levels stand first in the factors (the first factor weighs most): list levels in
/// the order in which you would take them if it did not matter.
[[nodiscard]] Expected<ParameterStudy> runParameterStudy(const FactorialDesign& design, const StudyTrial& trial,
                                                         const StudySettings& settings, const Job& job);

/// Over the settings, without running anything: what runParameterStudy does with its runs.
[[nodiscard]] ParameterStudy analyseStudy(const FactorialDesign& design, std::vector<StudyRun> runs,
                                          const StudySettings& settings);

/// One row a unit: run, the factors, camera, placement, failure, the responses (empty where not observed).
[[nodiscard]] std::string toCsv(const ParameterStudy& study);

}  // namespace vignole

// vignole-cli study: statistics of measurements from CSV files.

#include "cli/study.h"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <memory>

#include "cli/commands.h"
#include "cli/study_text.h"

namespace vignole::cli {

Json numberOrNull(double value) { return std::isfinite(value) ? Json(value) : Json(); }
Json numberOrNull(const std::optional<double>& value) { return value ? numberOrNull(*value) : Json(); }
Json rangeJson(const ValueRange& range) { return Json::array({numberOrNull(range.low), numberOrNull(range.high)}); }

std::optional<double> toleranceWidth(const ToleranceZone& tolerance) {
  if (!tolerance.lower || !tolerance.upper) return {};
  return *tolerance.upper - *tolerance.lower;
}

Json toleranceJson(const ToleranceZone& tolerance) {
  if (!tolerance.lower && !tolerance.upper) return nullptr;
  return Json::array({numberOrNull(tolerance.lower), numberOrNull(tolerance.upper)});
}

std::string shortNumber(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

tl::unexpected<Error> inFile(const std::string& file, const Error& error) {
  return tl::unexpected<Error>({error.where.empty() ? file : file + ", " + error.where, error.what, error.kind});
}

namespace {

using Study = Expected<StudyOutcome> (*)(const StudyOptions&);

/// One limit of LO,HI; empty is none.
std::optional<double> limitFrom(const std::string& text) {
  if (text.empty()) return {};
  double value = 0;
  const char* begin = text.data() + (text.front() == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    throw CLI::ValidationError("--tolerance",
                               "'" + text + "' is not a number; give LO,HI, one of which may be left out");
  return value;
}

ToleranceZone toleranceFrom(const std::string& text) {
  const auto comma = text.find(',');
  if (comma == std::string::npos) throw CLI::ValidationError("--tolerance", "'" + text + "' has no comma; give LO,HI");
  const ToleranceZone zone{limitFrom(text.substr(0, comma)), limitFrom(text.substr(comma + 1))};
  if (zone.lower && zone.upper && !(*zone.lower < *zone.upper))
    throw CLI::ValidationError("--tolerance", "'" + text + "': LO must be below HI");
  return zone;
}

int run(const std::string& name, Study study, const StudyOptions& options) {
  if (!options.plot.empty())
    if (const auto fit = checkPlotFile(options.plot); !fit) return fail(fit.error());
  const auto outcome = study(options);
  if (!outcome) return fail(outcome.error());
  if (!options.plot.empty())
    if (const auto written = writePlot(outcome->charts, options.plot); !written) return fail(written.error());
  if (options.json != "-")
    if (const auto written = writeResult("-", studyText(name, *outcome)); !written) return fail(written.error());
  if (!options.json.empty()) {
    Json document = {{"method", name}, {"options", outcome->options}, {"results", outcome->results}};
    if (!outcome->refused.empty()) document["refused"] = outcome->refused;
    document["formulas"] = outcome->notes.formulas;
    document["constants"] = Json::object();
    for (const auto& [constant, value] : outcome->notes.constants)
      document["constants"][constant] = numberOrNull(value);
    if (const auto written = writeJson(options.json, document); !written) return fail(written.error());
  }
  return outcome->refused.empty() ? kDone : kVerdictFail;
}

/// A study with what all of them have: file, --json, --plot, --quiet; its own options are added by the caller.
class Adder {
 public:
  Adder(CLI::App& parent, int& exitCode, const std::string& name, Study study, const std::string& what,
        const std::string& example)
      : command_(parent.add_subcommand(name, what)), options_(std::make_shared<StudyOptions>()) {
    command_->footer("Example: vignole-cli study " + name + " " + example);
    files_ = command_->add_option("FILE", options_->files, "CSV with a header line")->required()->expected(1);
    command_->add_option("--json", options_->json, "JSON to a file, or - for stdout");
    command_->add_option("--plot", options_->plot, "Plots: .svg or .png");
    command_->add_flag("--quiet", options_->quiet, "Nothing on stderr but errors, as always");
    command_->callback([name, study, options = options_, &exitCode] { exitCode = run(name, study, *options); });
  }
  Adder& severalFiles() {
    files_->expected(1, 1000);
    return *this;
  }
  Adder& methods(const std::vector<std::string>& names, const std::string& fallback, const std::string& what) {
    options_->method = fallback;
    std::string list;
    for (const std::string& n : names) list += (list.empty() ? "" : ", ") + n;
    command_->add_option("--method", options_->method, what + ": " + list)->check(CLI::IsMember(names));
    return *this;
  }
  Adder& alpha(const std::string& what) {
    command_->add_option("--alpha", options_->alpha, what + " (default 0.05)")->check(CLI::Range(1e-6, 0.5));
    return *this;
  }
  Adder& sigmas(const std::string& what) { return number("--sigmas", options_->sigmas, what, 0.1, 100); }
  Adder& k(const std::string& what) { return number("--k", options_->k, what, 1e-3, 1000); }
  Adder& tolerance(const std::string& what) {
    command_->add_option_function<std::string>(
        "--tolerance", [o = options_](const std::string& text) { o->tolerance = toleranceFrom(text); },
        "LO,HI: " + what);
    return *this;
  }
  Adder& number(const std::string& flag, std::optional<double>& target, const std::string& what, double low = -1e12,
                double high = 1e12) {
    command_->add_option(flag, target, what)->check(CLI::Range(low, high));
    return *this;
  }
  Adder& rules(const std::string& fallback) {
    options_->rules = fallback;
    command_->add_option("--rules", options_->rules, "limits, western-electric or nelson (default " + fallback + ")")
        ->check(CLI::IsMember({"limits", "western-electric", "nelson"}));
    command_
        ->add_option("--constants", options_->constants,
                     "table: d2, A2 ... rounded as printed; exact: to double precision (default table)")
        ->check(CLI::IsMember({"table", "exact"}));
    return *this;
  }
  [[nodiscard]] StudyOptions& options() const { return *options_; }
  [[nodiscard]] CLI::App& command() const { return *command_; }

 private:
  CLI::App* command_;
  CLI::Option* files_ = nullptr;
  std::shared_ptr<StudyOptions> options_;
};

void addRuns(CLI::App& study, int& exitCode) {
  Adder repeatability(
      study, exitCode, "repeatability", studyRepeatability,
      "Runs of the same rail: columns run,position_m,<dimension>...; or one file a run, as inspect --csv writes",
      "run1.csv run2.csv run3.csv --dimension FT_r --plot fig9.svg");
  repeatability.severalFiles().alpha("1 - confidence of intervals").tolerance("drawn in the plot");
  repeatability.command()
      .add_option("--section", repeatability.options().sectionM, "Ranges are averaged over this length, m")
      ->check(CLI::Range(0.01, 1000.0))
      ->capture_default_str();
  repeatability.command()
      .add_option("--window", repeatability.options().windowM, "Windows for the averaged figures, m; 0: none")
      ->check(CLI::Range(0.0, 1000.0))
      ->capture_default_str();
  Adder accuracy(
      study, exitCode, "accuracy", studyAccuracy,
      "Against a reference: columns dimension,position_m,run,value,reference and, if known, u_value,u_reference",
      "cmm.csv --json -");
  accuracy.alpha("1 - confidence of intervals").sigmas("Limits of agreement: bias +- this many s (default 1.96)");
  for (const Adder* adder : {&repeatability, &accuracy})
    adder->command().add_option("--dimension", adder->options().dimensions, "Only these dimensions");
  Adder(study, exitCode, "precision", studyPrecision, "ISO 5725: columns group,value and, if there are several, level",
        "laboratories.csv")
      .alpha("1 - confidence of intervals");
}

void addGauge(CLI::App& study, int& exitCode) {
  Adder type1(study, exitCode, "type1", studyType1, "Cg and Cgk on one part of known size: columns sample,x",
              "master.csv --reference 72.000 --tolerance 71.5,72.5");
  type1.k("Share K of the tolerance, % (default 20)").sigmas("Spread of the gauge in s: 6 or 4 (default 6)");
  type1.tolerance("T = HI - LO").alpha("1 - confidence of the interval of the bias");
  type1.command().add_option("--reference", type1.options().reference, "True value of the part")->required();
  Adder linearity(study, exitCode, "linearity", studyLinearity, "Bias over the range: columns reference,value",
                  "masters.csv --variation 6");
  linearity.alpha("1 - confidence of the band").tolerance("process variation, if --variation is not given");
  linearity.number("--variation", linearity.options().variation, "Process variation (6 sigma)", 1e-12);
  Adder(study, exitCode, "grr", studyGrr, "Repeatability and reproducibility: columns part,operator,trial,value",
        "study.csv --method anova --tolerance -4,4")
      .methods({"anova", "average-range", "nested"}, "anova",
               "Crossed by analysis of variance (default) or ranges, or nested")
      .alpha("The interaction is pooled where its p is greater")
      .sigmas("Study variation in s (default 6)")
      .tolerance("T = HI - LO");
  Adder(study, exitCode, "agreement", studyAgreement,
        "Two instruments on the same parts: columns a,b (numbers, or verdicts)", "pms_cmm.csv --plot agreement.svg")
      .methods({"bland-altman", "bland-altman-1986", "exact", "kappa", "kappa-linear", "kappa-quadratic"}, "",
               "Bland-Altman for numbers (default; intervals of the limits after 1999, 1986 or exact), kappa for words")
      .alpha("1 - confidence of intervals")
      .sigmas("Limits of agreement: bias +- this many s (default 1.96; 1986: 2)");
}

void addProcess(CLI::App& study, int& exitCode) {
  Adder chart(study, exitCode, "control-chart", studyControlChart,
              "Columns x, or subgroup,x; the subgroup of rails is the rail",
              "seam.csv --method ewma --lambda 0.2 --rules nelson");
  chart
      .methods({"i-mr", "xbar-r", "xbar-s", "ewma", "cusum"}, "",
               "Default i-mr, with subgroups xbar-r (up to 10) or xbar-s")
      .rules("western-electric")
      .sigmas("Control limits in s (default 3)")
      .k("CUSUM: allowance in s (default 0.5)")
      .number("--h", chart.options().h, "CUSUM: decision interval in s (default 5)", 0.1, 100)
      .number("--reference,--target", chart.options().reference, "Centre line; default the mean")
      .number("--sigma", chart.options().sigma, "s of a single value; default from the data", 1e-12);
  chart.command()
      .add_option("--lambda", chart.options().lambda, "EWMA: weight of the newest (default 0.3)")
      ->check(CLI::Range(0.001, 1.0));
  chart.command()
      .add_option("--limits", chart.options().limits, "EWMA: asymptotic or exact (default asymptotic)")
      ->check(CLI::IsMember({"asymptotic", "exact"}));
  Adder capability(study, exitCode, "capability", studyCapability,
                   "Cp, Cpk, Pp, Ppk where the process is stable: columns x, or subgroup,x",
                   "hw.csv --tolerance 71.5,72.5");
  capability
      .methods({"i-mr", "xbar-r", "xbar-s"}, "",
               "Spread within subgroups: default i-mr, with subgroups xbar-r or xbar-s")
      .rules("limits")
      .tolerance("one may be left out (,0.3)")
      .alpha("1 - confidence of intervals")
      .sigmas("Width of the process in s (default 6)")
      .number("--sigma", capability.options().sigma, "s within subgroups; default from the data", 1e-12);
  capability.command().add_flag("--even-if-unstable", capability.options().evenIfUnstable,
                                "Give the indices all the same");
}

void addBudget(CLI::App& study, int& exitCode) {
  Adder uncertainty(
      study, exitCode, "uncertainty", studyUncertainty,
      "GUM budget: columns symbol,estimate,u,dof,sensitivity_<unit>_per_unit and, if wanted, description,unit,"
      "distribution (normal, t, rectangular, triangular, arcsine)",
      "budget.csv --model \"l_S + d - l_S * (d_alpha * theta + alpha_S * d_theta)\"");
  uncertainty.k("Coverage factor of U (default 2)").tolerance("for Q_MS = 2 U / T");
  StudyOptions& o = uncertainty.options();
  uncertainty.command().add_option("--model", o.model,
                                   "Value from the symbols; default the sum of sensitivity x estimate");
  uncertainty.command().add_option("--measurand", o.measurand, "Its name in the results")->capture_default_str();
  uncertainty.command()
      .add_option("--trials", o.trials, "Monte Carlo trials; 0: none")
      ->check(CLI::Range(0, 20000000))
      ->capture_default_str();
  uncertainty.command().add_option("--seed", o.seed, "Seed of the Monte Carlo")->capture_default_str();
  Adder conform(study, exitCode, "conformity", studyConformity,
                "Verdicts with guard bands, and their risks: columns value,u", "values.csv --tolerance 71.5,72.5");
  conform.tolerance("one may be left out").sigmas("Guard band in u (default 2)");
  conform.number("--process-mean", conform.options().processMean, "Mean of the process (default: of the values)")
      .number("--process-sd", conform.options().processSd, "s of the process (default: of the values less u)", 1e-12);
}

}  // namespace

void addStudy(CLI::App& app, int& exitCode) {
  CLI::App* study = app.add_subcommand("study", "Is the gauge good: statistics of measurements from CSV files");
  study->require_subcommand(1);
  addRuns(*study, exitCode);
  addGauge(*study, exitCode);
  addProcess(*study, exitCode);
  addBudget(*study, exitCode);
}

}  // namespace vignole::cli

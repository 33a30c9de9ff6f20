// vignole-cli bench: times of the stages, rate of the pipeline, accuracy beside its physical limit.

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <set>

#include "cli/bench_accuracy.h"
#include "cli/bench_material.h"
#include "cli/commands.h"
#include "cli/console.h"
#include "cli/core_limit.h"
#include "engine/files/atomic_file.h"

namespace vignole::cli {

namespace {

using Json = nlohmann::ordered_json;

struct Options {
  std::vector<std::string> what;
  std::size_t frames = 224;
  AccuracySettings accuracy;
  int threads = 0;
  std::string json;
  bool quiet = false;
};

std::string machine(int cores) {
  std::string model = "unknown processor";
  if (const auto text = readFile("/proc/cpuinfo")) {
    const auto key = text->find("model name");
    const auto colon = key == std::string::npos ? key : text->find(": ", key);
    if (colon != std::string::npos) model = text->substr(colon + 2, text->find('\n', colon) - colon - 2);
  }
  return model + ", " + std::to_string(cores) + (cores == 1 ? " core" : " cores");
}

/// Nearest rank.
double quantile(const std::vector<double>& sorted, double p) {
  const auto rank = static_cast<std::size_t>(std::ceil(p * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

Json toJson(const BenchSeries& series) {
  std::vector<double> sorted = series.values;
  std::sort(sorted.begin(), sorted.end());
  return {{"name", series.name},
          {"unit", series.unit},
          {"median", sorted.empty() ? Json(nullptr) : Json(quantile(sorted, 0.5))},
          {"min", sorted.empty() ? Json(nullptr) : Json(sorted.front())},
          {"p99", sorted.empty() ? Json(nullptr) : Json(quantile(sorted, 0.99))},
          {"n", sorted.size()}};
}

void printTable(const Json& document) {
  std::printf("%s\n%-24s %12s %12s %12s %8s  %s\n", document["machine"].get<std::string>().c_str(), "benchmark",
              "median", "min", "p99", "n", "unit");
  for (const Json& r : document["results"]) {
    if (r["n"] == 0 || !r.contains("median")) continue;
    std::printf("%-24s %12.4g %12.4g %12.4g %8zu  %s\n", r["name"].get<std::string>().c_str(),
                r["median"].get<double>(), r["min"].get<double>(), r["p99"].get<double>(), r["n"].get<std::size_t>(),
                r["unit"].get<std::string>().c_str());
  }
}

void addJson(const AccuracyRun& run, Json& results) {
  for (const Dimension d : kDimensions) {
    const DimensionAccuracy& a = run.measured.of(d);
    const auto add = [&](const char* what, const char* unit, const std::optional<double>& value) {
      results.push_back({{"name", run.name + "." + std::string(name(d)) + "." + what},
                         {"unit", unit},
                         {"value", value ? Json(*value) : Json(nullptr)},
                         {"n", a.count()}});
    };
    const bool any = a.count() > 0;
    add("bias", "mm", any ? std::optional(a.biasMm()) : std::nullopt);
    add("rms", "mm", any ? std::optional(a.rmsMm()) : std::nullopt);
    add("bound", "mm", run.boundMm[index(d)]);
    add("error_over_u", "1", a.meanSquareErrorOverU());  // mean square
  }
}

void printTable(const AccuracyRun& run) {
  std::printf("%s: %llu profiles, %llu registered\n%-8s %10s %10s %10s %10s %12s\n", run.name.c_str(),
              static_cast<unsigned long long>(run.profiles), static_cast<unsigned long long>(run.registered), "mm",
              "bias", "RMS error", "bound", "RMS/bound", "(error/u)^2");
  for (const Dimension d : kDimensions) {
    const DimensionAccuracy& a = run.measured.of(d);
    const double bound = run.boundMm[index(d)].value_or(NAN);
    std::printf("%-8s %10.4f %10.4f %10.5f %10.2f %12.2f\n", std::string(name(d)).c_str(), a.biasMm(), a.rmsMm(), bound,
                a.rmsMm() / bound, a.meanSquareErrorOverU().value_or(NAN));
  }
}

int bench(const Options& o) {
  const auto limit = CoreLimit::to(o.threads);
  if (!limit) return fail(limit.error());
  const std::set<std::string> chosen(o.what.begin(), o.what.end());
  const auto wanted = [&chosen](const char* name) { return chosen.empty() || chosen.contains(name); };
  Json document = {{"machine", machine(limit->cores())}, {"results", Json::array()}};
  std::vector<AccuracyRun> accuracy;
  if (chosen.contains("accuracy")) {
    Progress progress(o.quiet, "accuracy");
    auto runs = benchAccuracy(o.accuracy, progress);
    if (!runs) return fail(runs.error());
    accuracy = *std::move(runs);
    for (const AccuracyRun& run : accuracy) addJson(run, document["results"]);
  }
  if (chosen.size() != 1 || accuracy.empty()) {
    Progress progress(o.quiet, "benchmark");
    progress.update(0, "rendering frames");
    auto material = renderMaterial(o.frames);
    if (!material) return fail(material.error());
    std::vector<BenchSeries> results;
    if (wanted("simulate")) results.push_back({"simulate.frame", "ms", material->renderMs});
    if (wanted("extract")) benchExtract(*material, results);
    if (wanted("translate") || wanted("assemble") || wanted("register") || wanted("measure")) extractAll(*material);
    if (wanted("translate")) benchTranslate(*material, results);
    if (wanted("assemble")) benchAssemble(*material, results);
    if (wanted("register")) benchRegister(*material, results);
    if (wanted("measure")) benchMeasure(*material, results);
    if (chosen.contains("record")) benchRecord(*material, results);
    if (wanted("pipeline")) benchPipeline(*material, limit->cores(), results);
    for (const BenchSeries& series : results) document["results"].push_back(toJson(series));
  }
  if (!o.json.empty())
    if (const auto written = writeJson(o.json, document); !written) return fail(written.error());
  if (o.json == "-") return kDone;
  for (const AccuracyRun& run : accuracy) printTable(run);
  if (chosen.size() != 1 || accuracy.empty()) printTable(document);
  return kDone;
}

}  // namespace

void addBench(CLI::App& app, int& exitCode) {
  CLI::App* command = app.add_subcommand("bench", "Times of the stages, rate of the pipeline, accuracy");
  const auto o = std::make_shared<Options>();
  command->footer(
      "Frames of the virtual rig with default effects, in memory, independent of each other. Times are wall-clock on\n"
      "one thread; extract.cold and .read are of frames that are in no cache.\n"
      "pipeline.cpu.* is CPU time of a stage's threads a profile, cpu_total that of the process, share.other the part\n"
      "of it that is not extraction; efficiency is the rate over cores / cpu_total; limit.* is what a stage's busiest\n"
      "thread alone would do; model.*cores is the smaller of cores (14 threads at most) / cpu_total and the lowest\n"
      "limit, if memory gives each core what it gives here and nothing else runs. At 66 Hz: latency from the last\n"
      "camera's frame to the dimensions; queue.* how full each stage's fullest queue is when a profile is done,\n"
      "highwater the most that each of them ever held, growth of the second half over the first, one a stage.\n"
      "record: a frame packed and unpacked, its bytes and pixels; rate of the pipeline with and without recording on "
      "a\n"
      "live line (which drops recordings, never profiles), and how many triggers were recorded; the same at 66 Hz.\n"
      "accuracy: errors of single profiles of the virtual rig through the whole pipeline, beside the limit that\n"
      "follows from the light and the noise that were rendered; every effect on, then without speckle.\n"
      "Example: vignole-cli bench extract pipeline --threads 2 --json bench.json\n"
      "         vignole-cli bench accuracy --profiles 2000 --rig-seed 3");
  command
      ->add_option(
          "what", o->what,
          "extract, translate, assemble, register, measure, pipeline, simulate (default: all these), accuracy, "
          "record")
      ->check(CLI::IsMember(
          {"extract", "translate", "assemble", "register", "measure", "pipeline", "simulate", "accuracy", "record"}));
  command->add_option("--frames", o->frames, "frames in memory (1.4 MB each)")
      ->check(CLI::Range(4, 100000))
      ->capture_default_str();
  command->add_option("--profiles", o->accuracy.profiles, "accuracy: profiles a run")
      ->check(CLI::Range(1, 10000000))
      ->capture_default_str();
  command->add_option("--seed", o->accuracy.seed, "accuracy: of the virtual rail and its noise")->capture_default_str();
  command->add_option("--rig-seed", o->accuracy.rigSeed, "accuracy: draws the virtual rig; default: the seed");
  command->add_option("--recipe", o->accuracy.recipe, "accuracy: recipe, as of inspect")->capture_default_str();
  command->add_option("--effect", o->accuracy.effects, "accuracy: NAME=on|off|VALUE of the rig (repeatable)");
  command->add_option("--line-px", o->accuracy.linePx, "accuracy: bound for lines known to that much in every px")
      ->check(CLI::Range(1e-6, 1e3));
  command->add_option("--threads", o->threads, "cores to use; default: all")->check(CLI::Range(1, 1024));
  command->add_option("--json", o->json, "file, or - for stdout");
  command->add_flag("--quiet", o->quiet, "no progress on the terminal");
  command->callback([o, &exitCode] { exitCode = bench(*o); });
}

}  // namespace vignole::cli

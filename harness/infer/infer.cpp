#include "harness/infer/infer.hpp"

#include <algorithm>
#include <chrono>

#include "harness/infer/experiments.hpp"
#include "harness/infer/measure.hpp"
#include "harness/infer/questions.hpp"

namespace rasterdiff::harness {
namespace {

using rasterizer::Choice;
using rasterizer::Rules;

class Inquiry {
 public:
  Inquiry(Subject& subject, const InferOptions& options)
      : subject_(subject), options_(options), start_(std::chrono::steady_clock::now()) {
    result_.driver = subject.name();
    result_.info = subject.info();
    result_.advertisedBits = subject.limits().subPixelPrecisionBits;
  }

  Result<Inference> run() {
    if (const Result<void> done = findSamplesAndTies(); !done) return tl::unexpected(done.error());
    for (const Question& question : furtherQuestions(subject_.limits())) {
      const Result<GroupOutcome> outcome = ask(question);
      if (!outcome) return tl::unexpected(outcome.error());
    }
    close();
    question_ = "values";
    const auto measured = measureValues(subject_, rules(), options_.seed, [this] { count(); });
    if (!measured) return tl::unexpected(measured.error());
    result_.errors = measured->errors;
    result_.valuesDecided = measured->decided;
    result_.valuesOutside = measured->outside;
    result_.choices.valuesOpen = measured->outside > 0;
    result_.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    return std::move(result_);
  }

 private:
  void count() {
    ++result_.scenes;
    if (options_.progress) options_.progress(question_, result_.scenes);
  }

  [[nodiscard]] Rules rules() const { return inferredRules(result_, subject_.limits()); }

  Result<GroupOutcome> ask(const Question& question) {
    question_ = question.what;
    Rules known = rules();
    known.openChoices = 0;  // what is open does not blur the experiments about what is not
    Result<GroupOutcome> outcome = eliminate(subject_, known, question.group, options_.seed, [this] { count(); });
    if (!outcome) return outcome;
    result_.choices = outcome->choices;
    for (const Finding& finding : outcome->findings) result_.findings.push_back(finding);
    return outcome;
  }

  Result<void> findSamplesAndTies() {
    question_ = "sample locations";
    std::vector<SampleSweep> sweeps;
    for (const uint32_t samples : sampleCounts(subject_.limits())) {
      Result<SampleSweep> sweep = sweepSamples(subject_, samples);
      if (!sweep && sweep.error().code == ErrorCode::NotOffered) continue;
      if (!sweep) return tl::unexpected(sweep.error());
      sweeps.push_back(std::move(*sweep));
      count();
    }
    const Result<GroupOutcome> outcome = ask(tieQuestion(subject_.limits(), sweeps));
    if (!outcome) return tl::unexpected(outcome.error());
    for (const SampleSweep& sweep : sweeps) {
      const Result<SampleFinding> finding = weighSamples(rules(), sweep.samples, outcome->observations);
      if (!finding) return tl::unexpected(finding.error());
      result_.samples.push_back(*finding);
    }
    return {};
  }

  // What was not found stays open; choices without a question of their own are not offered.
  void close() {
    for (const rasterizer::ChoiceInfo& row : rasterizer::choiceTable()) {
      if (std::ranges::find(result_.findings, row.choice, &Finding::choice) == result_.findings.end()) {
        Finding missing;
        missing.choice = row.choice;
        result_.findings.push_back(missing);
      }
    }
    std::ranges::sort(result_.findings, {}, &Finding::choice);
    for (const Finding& finding : result_.findings) {
      if (finding.status == Finding::Status::Found) continue;
      if (finding.choice == Choice::ResolveArithmetic) {
        result_.choices.resolveArithmetic = rasterizer::ResolveArithmetic::Any;
      } else {
        result_.openChoices |= rasterizer::bitOf(finding.choice);
      }
    }
  }

  Subject& subject_;
  const InferOptions& options_;
  const std::chrono::steady_clock::time_point start_;
  Inference result_;
  std::string_view question_;
};

}  // namespace

Result<Inference> infer(Subject& subject, const InferOptions& options) { return Inquiry(subject, options).run(); }

Rules inferredRules(const Inference& inference, const Limits& limits) {
  Rules rules;
  rules.name = inference.driver + " (inferred)";
  rules.limits = limits;
  rules.choices = inference.choices;
  rules.openChoices = inference.openChoices;
  return rules;
}

}  // namespace rasterdiff::harness

#include "engine/quality/model_expression.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numbers>

namespace vignole {

namespace {

using Step = ModelExpression::Step;

struct Function {
  std::string_view name;
  double (*apply)(double);
};
constexpr std::array<Function, 7> kFunctions = {{{"sqrt", [](double x) { return std::sqrt(x); }},
                                                 {"exp", [](double x) { return std::exp(x); }},
                                                 {"log", [](double x) { return std::log(x); }},
                                                 {"sin", [](double x) { return std::sin(x); }},
                                                 {"cos", [](double x) { return std::cos(x); }},
                                                 {"tan", [](double x) { return std::tan(x); }},
                                                 {"abs", [](double x) { return std::abs(x); }}}};
constexpr int kDeepest = 200;  // parentheses within parentheses

/// Recursive descent: sum of products of powers of atoms.
class Parser {
 public:
  Parser(std::string_view text, const std::vector<std::string>& symbols) : text_(text), symbols_(symbols) {}

  Expected<std::vector<Step>> parse() {
    sum();
    skipBlanks();
    if (error_.empty() && at_ < text_.size()) refuse("'" + std::string(1, text_[at_]) + "' is not understood here");
    if (!error_.empty()) return inputError("model, character " + std::to_string(errorAt_ + 1), error_);
    return std::move(steps_);
  }

 private:
  void refuse(std::string what) {
    if (!error_.empty()) return;
    error_ = std::move(what);
    errorAt_ = at_;
    at_ = text_.size();
  }
  void skipBlanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_])) != 0) ++at_;
  }
  bool take(char c) {
    skipBlanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void emit(Step::Kind kind, double number = 0, std::size_t index = 0) { steps_.push_back({kind, number, index}); }

  void sum() {
    if (++depth_ > kDeepest) return refuse("too many parentheses within each other");
    product();
    for (;;) {
      if (take('+')) {
        product();
        emit(Step::Kind::Add);
      } else if (take('-')) {
        product();
        emit(Step::Kind::Subtract);
      } else {
        break;
      }
    }
    --depth_;
  }
  void product() {
    signedPower();
    for (;;) {
      if (take('*')) {
        signedPower();
        emit(Step::Kind::Multiply);
      } else if (take('/')) {
        signedPower();
        emit(Step::Kind::Divide);
      } else {
        return;
      }
    }
  }
  void signedPower() {
    bool negative = false;
    for (;;) {
      if (take('-'))
        negative = !negative;
      else if (!take('+'))
        break;
    }
    power();
    if (negative) emit(Step::Kind::Negate);
  }
  /// Binds to the right, and stronger than a sign before it: -x^2 is -(x^2).
  void power() {
    if (++depth_ > kDeepest) return refuse("too many powers of powers");
    atom();
    if (take('^')) {
      signedPower();
      emit(Step::Kind::Power);
    }
    --depth_;
  }
  void atom() {
    skipBlanks();
    if (at_ >= text_.size()) return refuse("the model ends where a number or a symbol is expected");
    if (take('(')) {
      sum();
      if (!take(')')) refuse("')' is missing");
      return;
    }
    const char c = text_[at_];
    if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') return number();
    if (std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_') return word();
    refuse("a number or a symbol is expected, not '" + std::string(1, c) + "'");
  }
  void number() {
    double value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) return refuse("is not a number");
    at_ = static_cast<std::size_t>(end - text_.data());
    emit(Step::Kind::Number, value);
  }
  void word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '_'))
      ++at_;
    const std::string_view name = text_.substr(begin, at_ - begin);
    const auto symbol = std::find(symbols_.begin(), symbols_.end(), name);
    if (symbol != symbols_.end())
      return emit(Step::Kind::Symbol, 0, static_cast<std::size_t>(symbol - symbols_.begin()));
    for (std::size_t f = 0; f < kFunctions.size(); ++f) {
      if (kFunctions.at(f).name != name) continue;
      if (!take('(')) return refuse("'(' is missing after " + std::string(name));
      sum();
      if (!take(')')) return refuse("')' is missing");
      return emit(Step::Kind::Function, 0, f);
    }
    if (name == "pi") return emit(Step::Kind::Number, std::numbers::pi);
    at_ = begin;
    std::string known;
    for (const std::string& s : symbols_) known += (known.empty() ? "" : ", ") + s;
    refuse("'" + std::string(name) + "' is no symbol of the budget; there are " + known);
  }

  std::string_view text_;
  const std::vector<std::string>& symbols_;
  std::vector<Step> steps_;
  std::size_t at_ = 0, errorAt_ = 0;
  int depth_ = 0;
  std::string error_;
};

double combined(Step::Kind kind, double a, double b) {
  switch (kind) {
    case Step::Kind::Add:
      return a + b;
    case Step::Kind::Subtract:
      return a - b;
    case Step::Kind::Multiply:
      return a * b;
    case Step::Kind::Divide:
      return a / b;
    default:
      return std::pow(a, b);
  }
}

}  // namespace

Expected<ModelExpression> ModelExpression::parse(std::string_view text, const std::vector<std::string>& symbols) {
  auto steps = Parser(text, symbols).parse();
  if (!steps) return tl::unexpected(steps.error());
  ModelExpression model;
  model.steps_ = std::move(*steps);
  return model;
}

double ModelExpression::operator()(std::span<const double> values) const {
  std::vector<double> stack;
  for (const Step& step : steps_) {
    switch (step.kind) {
      case Step::Kind::Number:
        stack.push_back(step.number);
        break;
      case Step::Kind::Symbol:
        stack.push_back(values[step.index]);
        break;
      case Step::Kind::Negate:
        stack.back() = -stack.back();
        break;
      case Step::Kind::Function:
        stack.back() = kFunctions.at(step.index).apply(stack.back());
        break;
      default: {
        const double right = stack.back();
        stack.pop_back();
        stack.back() = combined(step.kind, stack.back(), right);
      }
    }
  }
  return stack.back();
}

}  // namespace vignole

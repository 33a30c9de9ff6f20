#pragma once
// The model of a measurement as text, "l_S + d - l_S * (d_alpha * theta + alpha_S * d_theta)": numbers, symbols,
// + - * / ^ ( ), sqrt exp log sin cos tan abs, pi.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/expected.h"

namespace vignole {

class ModelExpression {
 public:
  /// Errors say at which character, and which symbols there are.
  [[nodiscard]] static Expected<ModelExpression> parse(std::string_view text, const std::vector<std::string>& symbols);
  /// One value per symbol, in their order; not finite where the model is not defined.
  [[nodiscard]] double operator()(std::span<const double> values) const;

  /// In postfix order.
  struct Step {
    enum class Kind { Number, Symbol, Add, Subtract, Multiply, Divide, Power, Negate, Function } kind = Kind::Number;
    double number = 0;
    std::size_t index = 0;  ///< of the symbol, or of the function
  };

 private:
  std::vector<Step> steps_;
};

}  // namespace vignole

#pragma once
// A covariance over named parameters as TOML: `parameters` names those that have a variance, `covariance` is the lower
// triangle over them, row by row, in squares and products of their units.

#include <Eigen/Core>
#include <span>
#include <string>

#include "engine/files/toml_reader.h"

namespace vignole {

/// The two keys, without the table's header; empty where nothing has a variance. `names` of all rows.
[[nodiscard]] std::string covarianceToToml(std::span<const std::string> names, const Eigen::MatrixXd& covariance);
/// Over all of `names`, zero where the file has nothing; no rows at all where it lacks the table. Refused in the
/// reader: names unknown or twice, a triangle of another size, variances that are not positive, correlations that no
/// errors can have (not positive semi-definite).
[[nodiscard]] Eigen::MatrixXd readCovariance(TomlReader& toml, const std::string& table,
                                             std::span<const std::string> names);

}  // namespace vignole

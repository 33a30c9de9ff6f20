#pragma once
// One file that proves a rail: its points, all its profiles, recipe, section, calibration, the versions, and what came
// of them. Whoever has this program measures the points again and judges the rail again, to the last bit on the same
// kind of processor. Any tar unpacks it: TOML and JSON for people, points and profiles packed as the archive has them.
// Its digest is in the audit trail of the archive that it was taken from.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/archive/rail_archive.h"

namespace vignole {

/// Who computes.
struct EvidenceBy {
  std::string program;  ///< version
  std::string machine;  ///< SIMD target
};

struct EvidenceCheck {
  std::string digest;              ///< of the pack: the same as the mill's for the same file
  StoredRail rail;                 ///< as the archive had it; not its keys
  std::string packedAt, packedBy;  ///< time, version of the program
  std::uint64_t profiles = 0, profilesWithPoints = 0;
  bool exactPoints = false;                ///< all points to the last bit; else to 10 nm
  bool sameMachine = false;                ///< as the one that packed: then every number must come out to the last bit
  bool lastBit = false;                    ///< and every number did
  Verdict verdict = Verdict::NotMeasured;  ///< of the rail, as it was recomputed
  std::vector<std::string> findings;       ///< empty: proved
};

/// The pack of a stored rail. Refuses a rail without points, and one that this program does not measure again as it was
/// measured (by which version says the error). `progress`: share done.
struct EvidencePack {
  std::string bytes;
  EvidenceCheck check;
};
[[nodiscard]] Expected<EvidencePack> packEvidence(const RailArchive& rails, std::int64_t key, const EvidenceBy& by,
                                                  const std::function<void(double)>& progress = {});

/// Measures and judges again. An Error where the file is no pack, damaged, or changed by a single byte; findings where
/// it is whole and what it says does not come out. Safe with whatever bytes.
[[nodiscard]] Expected<EvidenceCheck> verifyEvidence(std::string_view bytes, const EvidenceBy& by,
                                                     const std::function<void(double)>& progress = {});

}  // namespace vignole

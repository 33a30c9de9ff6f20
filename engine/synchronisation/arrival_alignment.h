#pragma once
// Where a camera's own count stands among the triggers, found by when its frames arrive: for a camera that joins late
// and cannot be asked, or that does not count triggers at all. Several frames in a row must agree, so that one that was
// held up on the way does not decide.

#include <cstdint>
#include <deque>
#include <optional>

namespace vignole {

struct ArrivalAlignmentSettings {
  int agreeing = 6;            ///< frames in a row that must say the same
  double nearestShare = 0.35;  ///< of the trigger period: further from every trigger's arrival, a frame says nothing
};

class ArrivalAlignment {
 public:
  explicit ArrivalAlignment(ArrivalAlignmentSettings settings = {}) : settings_(settings) {}

  /// A frame of the others, of a known trigger; the first of each trigger counts.
  void addReference(std::uint64_t trigger, double arrivedS);
  /// A frame of the camera that joins: trigger = place + the offset returned, once it is certain.
  [[nodiscard]] std::optional<std::int64_t> add(std::int64_t place, double arrivedS);
  void restart() { agreed_ = 0; }

 private:
  struct Arrival {
    std::uint64_t trigger;
    double s;
  };
  [[nodiscard]] std::optional<double> periodS() const;

  ArrivalAlignmentSettings settings_;
  std::deque<Arrival> references_;
  std::int64_t offset_ = 0;
  int agreed_ = 0;
};

}  // namespace vignole

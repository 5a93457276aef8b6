// Bins across the width: which bin a height lies in, and how a contact line is shared among bins.
#pragma once

#include <algorithm>

namespace gpf {

/// Equal bins over 0 <= y <= 1 (the full width, although centres keep d/2 from the walls of a channel).
class Bins {
 public:
  explicit Bins(int count) : count_(count) {}

  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] double width() const { return 1.0 / count_; }
  [[nodiscard]] double centre(int bin) const { return (bin + 0.5) / count_; }
  /// Heights outside belong to the outermost bins.
  [[nodiscard]] int at(double y) const { return std::clamp(static_cast<int>(y * count_), 0, count_ - 1); }

  /// Calls visit(bin, fraction) for every bin that the line from height `from` to `to` crosses, with the fraction of
  /// the line inside; the fractions add up to one. `wrap`: heights are periodic with period 1, else lines end at 0
  /// and 1.
  template <class Visit>
  void share(double from, double to, bool wrap, Visit&& visit) const {
    const double lo = std::min(from, to), hi = std::max(from, to), extent = hi - lo;
    const auto index = [this](double y) { return static_cast<int>(y * count_ + count_) - count_; };  // floor for y > -1
    const int first = index(lo), last = index(hi);
    if (first == last || extent == 0) return visit(inside(first, wrap), 1.0);
    for (int bin = first; bin <= last; ++bin) {
      const double a = std::max(lo, static_cast<double>(bin) / count_), b = std::min(hi, (bin + 1.0) / count_);
      if (b > a) visit(inside(bin, wrap), (b - a) / extent);
    }
  }

 private:
  [[nodiscard]] int inside(int bin, bool wrap) const {
    return wrap ? (bin % count_ + count_) % count_ : std::clamp(bin, 0, count_ - 1);
  }

  int count_;
};

}  // namespace gpf

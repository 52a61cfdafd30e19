#include "motion/tour.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/result.hpp"

namespace amiss::motion {
namespace {

constexpr double kLeast = 1e-9;  // an improvement under this is rounding

using Order = std::vector<std::size_t>;  // of places, the start in front

class Improver {
 public:
  Improver(std::span<const double> lengths, std::size_t n) : lengths_(lengths), n_(n) {}

  [[nodiscard]] double between(std::size_t a, std::size_t b) const { return lengths_[a * n_ + b]; }

  [[nodiscard]] double length(const Order& order) const {
    double sum = 0.0;
    for (std::size_t i = 1; i < order.size(); ++i) sum += between(order[i - 1], order[i]);
    return sum;
  }

  /// Greedy from the start; the first place visited is given.
  [[nodiscard]] Order nearest_neighbour(const Order& places, std::size_t first) const {
    Order rest = places;
    Order order{0, first};
    std::erase(rest, first);
    while (!rest.empty()) {
      const auto nearest = std::min_element(rest.begin(), rest.end(), [&](std::size_t a, std::size_t b) {
        return between(order.back(), a) < between(order.back(), b);
      });
      order.push_back(*nearest);
      rest.erase(nearest);
    }
    return order;
  }

  void improve(Order& order) const {
    while (reverse_a_part(order) || move_a_part(order)) {
    }
  }

 private:
  /// Length of the link that leaves order[i]; an open tour ends without one.
  [[nodiscard]] double link(const Order& order, std::size_t i) const {
    return i + 1 < order.size() ? between(order[i], order[i + 1]) : 0.0;
  }

  /// 2-opt: the first reversal of order[i..j] that shortens the tour.
  bool reverse_a_part(Order& order) const {
    for (std::size_t i = 1; i + 1 < order.size(); ++i) {
      for (std::size_t j = i + 1; j < order.size(); ++j) {
        const double removed = between(order[i - 1], order[i]) + link(order, j);
        double added = between(order[i - 1], order[j]);
        if (j + 1 < order.size()) added += between(order[i], order[j + 1]);
        if (added < removed - kLeast) {
          std::reverse(order.begin() + std::ptrdiff_t(i), order.begin() + std::ptrdiff_t(j) + 1);
          return true;
        }
      }
    }
    return false;
  }

  /// Or-opt: the first move of up to three neighbours, either way round, that shortens the tour.
  bool move_a_part(Order& order) const {
    for (std::size_t count = 1; count <= 3; ++count) {
      for (std::size_t i = 1; i + count <= order.size(); ++i) {
        Order part(order.begin() + std::ptrdiff_t(i), order.begin() + std::ptrdiff_t(i + count));
        Order rest = order;
        rest.erase(rest.begin() + std::ptrdiff_t(i), rest.begin() + std::ptrdiff_t(i + count));
        const double before = length(order) - kLeast;
        const double bare = length(rest) + length(part);
        if (insert_shorter(rest, part, before - bare)) {
          order = std::move(rest);
          return true;
        }
      }
    }
    return false;
  }

  /// Puts the part into the first gap where it costs less than `limit`.
  bool insert_shorter(Order& rest, Order& part, double limit) const {
    for (std::size_t gap = 0; gap < rest.size(); ++gap) {
      for (int turned = 0; turned < 2; ++turned) {
        double cost = between(rest[gap], part.front()) - link(rest, gap);
        if (gap + 1 < rest.size()) cost += between(part.back(), rest[gap + 1]);
        if (cost < limit) {
          rest.insert(rest.begin() + std::ptrdiff_t(gap) + 1, part.begin(), part.end());
          return true;
        }
        std::reverse(part.begin(), part.end());
      }
    }
    return false;
  }

  std::span<const double> lengths_;
  std::size_t n_;
};

}  // namespace

Tour shortest_tour(std::span<const double> lengths_m, std::size_t n) {
  if (n == 0 || lengths_m.size() != n * n) {
    throw ArgumentError("tour: " + std::to_string(lengths_m.size()) + " lengths for " + std::to_string(n) +
                        " places; a square matrix with a row for each place is needed, the start first");
  }
  Order places, unreachable;
  for (std::size_t place = 1; place < n; ++place) {
    (std::isfinite(lengths_m[place]) ? places : unreachable).push_back(place);
  }
  const Improver improver(lengths_m, n);
  Order best{0};
  double best_length = places.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  for (const std::size_t first : places) {
    Order order = improver.nearest_neighbour(places, first);
    improver.improve(order);
    const double length = improver.length(order);
    if (best.size() == 1 || length < best_length - kLeast) {
      best = std::move(order);
      best_length = length;
    }
  }
  Tour tour;
  tour.order.assign(best.begin() + 1, best.end());
  tour.reachable = places.size();
  tour.length_m = best_length;
  tour.order.insert(tour.order.end(), unreachable.begin(), unreachable.end());
  return tour;
}

}  // namespace amiss::motion

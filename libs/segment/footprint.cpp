#include "segment/footprint.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace amiss::segment {

Footprint::Footprint(const std::vector<Eigen::Vector3f>& points, const std::vector<std::uint32_t>& among, float cell_m)
    : cell_m_(cell_m) {
  if (among.empty()) return;
  Eigen::Array2f low = points[among.front()].head<2>(), high = low;
  for (const std::uint32_t i : among) {
    low = low.min(points[i].head<2>().array());
    high = high.max(points[i].head<2>().array());
  }
  *this = blank(cell_of(low.x()), cell_of(low.y()), cell_of(high.x()), cell_of(high.y()));
  for (const std::uint32_t i : among) bits_[index(cell_of(points[i].x()), cell_of(points[i].y()))] = true;
}

int Footprint::cell_of(float v_m) const { return static_cast<int>(std::floor(v_m / cell_m_)); }

Footprint Footprint::blank(int x0, int y0, int x1, int y1) const {
  Footprint out(cell_m_);
  out.x0_ = x0;
  out.y0_ = y0;
  out.width_ = x1 - x0 + 1;
  out.height_ = y1 - y0 + 1;
  out.bits_.assign(static_cast<std::size_t>(out.width_) * static_cast<std::size_t>(out.height_), false);
  return out;
}

template <class Visit>
void Footprint::for_each(Visit visit) const {
  for (int y = y0_; y < y0_ + height_; ++y) {
    for (int x = x0_; x < x0_ + width_; ++x) {
      if (bits_[index(x, y)]) visit(x, y);
    }
  }
}

double Footprint::area_m2() const {
  const double cell = static_cast<double>(cell_m_) * static_cast<double>(cell_m_);
  return cell * static_cast<double>(std::count(bits_.begin(), bits_.end(), true));
}

Footprint Footprint::dilated(int cells) const {
  if (bits_.empty()) return *this;
  Footprint out = blank(x0_ - cells, y0_ - cells, x0_ + width_ - 1 + cells, y0_ + height_ - 1 + cells);
  for_each([&](int x, int y) {
    for (int v = y - cells; v <= y + cells; ++v) {
      for (int u = x - cells; u <= x + cells; ++u) out.bits_[out.index(u, v)] = true;
    }
  });
  return out;
}

Footprint Footprint::filled() const {
  if (bits_.empty()) return *this;
  // What a flood from the border cannot reach is covered or a hole.
  Footprint out = blank(x0_ - 1, y0_ - 1, x0_ + width_, y0_ + height_);
  out.bits_.assign(out.bits_.size(), true);
  std::vector<std::pair<int, int>> flood{{out.x0_, out.y0_}};
  out.bits_[0] = false;
  while (!flood.empty()) {
    const auto [x, y] = flood.back();
    flood.pop_back();
    for (const auto& [u, v] : {std::pair{x + 1, y}, {x - 1, y}, {x, y + 1}, {x, y - 1}}) {
      if (!out.at(u, v) || at(u, v)) continue;
      out.bits_[out.index(u, v)] = false;
      flood.emplace_back(u, v);
    }
  }
  return out;
}

Footprint Footprint::united(const Footprint& other) const {
  assert(cell_m_ == other.cell_m_);
  if (bits_.empty()) return other;
  if (other.bits_.empty()) return *this;
  Footprint out =
      blank(std::min(x0_, other.x0_), std::min(y0_, other.y0_), std::max(x0_ + width_, other.x0_ + other.width_) - 1,
            std::max(y0_ + height_, other.y0_ + other.height_) - 1);
  const auto mark = [&](int x, int y) { out.bits_[out.index(x, y)] = true; };
  for_each(mark);
  other.for_each(mark);
  return out;
}

double Footprint::shared_area_m2(const Footprint& other) const {
  int shared = 0;
  for_each([&](int x, int y) { shared += other.at(x, y) ? 1 : 0; });
  return static_cast<double>(cell_m_) * static_cast<double>(cell_m_) * shared;
}

}  // namespace amiss::segment

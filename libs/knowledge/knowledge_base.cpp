#include "knowledge/knowledge_base.hpp"

#include <algorithm>
#include <cassert>

#include "knowledge/internal/record.hpp"
#include "knowledge/internal/same_region.hpp"

namespace amiss::knowledge {

struct KnowledgeBase::State {
  Params params;
  Knowledge known;
  std::unique_ptr<internal::Record> record;  // null in memory and after close()

  std::vector<RegionChange> changes;     // of the merge that runs
  std::vector<bool> confirmed, touched;  // regions of the merge that runs

  [[nodiscard]] Region& region(int id) { return known.regions.at(static_cast<std::size_t>(id) - 1); }
  void touch(const Region& region) { touched[static_cast<std::size_t>(region.id) - 1] = true; }
  void insert(const Sighting& sighting, Stamp stamp);
  void update(Region& region, const Sighting& sighting, Stamp stamp);
  void absorb(Region& part);
  void place(const Sighting& sighting, Stamp stamp);
  void save_touched();
};

void KnowledgeBase::State::insert(const Sighting& sighting, Stamp stamp) {
  Region region;
  region.id = static_cast<int>(known.regions.size()) + 1;
  region.position_map = sighting.position_map;
  region.cylinder = sighting.cylinder;
  region.voxels = sighting.voxels;
  region.first_seen = region.last_seen = stamp;
  known.regions.push_back(region);
  confirmed.push_back(true);
  touched.push_back(true);
  changes.push_back({region.id, Change::kInserted});
}

/// The sighting confirms the region. Where it is larger, it is what the region is from now on.
void KnowledgeBase::State::update(Region& region, const Sighting& sighting, Stamp stamp) {
  confirmed[static_cast<std::size_t>(region.id) - 1] = true;
  touch(region);
  region.last_seen = stamp;
  const bool returned = region.withdrawn;
  region.withdrawn = false;
  const bool grown = sighting.voxels > region.voxels || sighting.cylinder.radius_m > region.cylinder.radius_m ||
                     sighting.cylinder.z_high_m > region.cylinder.z_high_m;
  if (grown || returned) {
    region.position_map = sighting.position_map;
    region.cylinder = sighting.cylinder;
    region.voxels = sighting.voxels;
  }
  const bool reopened =
      region.examined && internal::grown_noticeably(region.examined_cylinder, region.cylinder, params);
  if (reopened) region.examined = false;
  if (returned) {
    changes.push_back({region.id, Change::kReturned});
  } else if (reopened) {
    changes.push_back({region.id, Change::kReopened});
  } else if (grown) {
    changes.push_back({region.id, Change::kGrown});
  }
}

void KnowledgeBase::State::absorb(Region& part) {
  part.withdrawn = true;
  confirmed[static_cast<std::size_t>(part.id) - 1] = true;
  touch(part);
  changes.push_back({part.id, Change::kAbsorbed});
}

/// One sighting: confirms the oldest region that it is the same as and absorbs the others, or is new.
void KnowledgeBase::State::place(const Sighting& sighting, Stamp stamp) {
  std::vector<int> same, withdrawn;
  for (const Region& region : known.regions) {
    if (!internal::same_region(region.cylinder, sighting.cylinder, params)) continue;
    if (!confirmed[static_cast<std::size_t>(region.id) - 1]) (region.withdrawn ? withdrawn : same).push_back(region.id);
  }
  if (same.empty() && withdrawn.empty()) return insert(sighting, stamp);
  if (same.empty()) return update(region(withdrawn.front()), sighting, stamp);
  update(region(same.front()), sighting, stamp);
  for (std::size_t i = 1; i < same.size(); ++i) absorb(region(same[i]));
}

void KnowledgeBase::State::save_touched() {
  if (!record) return;
  std::vector<Region> rows;
  for (std::size_t i = 0; i < touched.size(); ++i) {
    if (touched[i]) rows.push_back(known.regions[i]);
  }
  if (!rows.empty()) record->save(rows, {}, {});
}

KnowledgeBase::KnowledgeBase(const std::filesystem::path& file, const Params& params) : KnowledgeBase(params) {
  state_->record = std::make_unique<internal::Record>(file);
  state_->known = state_->record->load();
}

KnowledgeBase::KnowledgeBase(const Params& params) : state_(std::make_unique<State>()) { state_->params = params; }
KnowledgeBase::~KnowledgeBase() = default;
KnowledgeBase::KnowledgeBase(KnowledgeBase&&) noexcept = default;
KnowledgeBase& KnowledgeBase::operator=(KnowledgeBase&&) noexcept = default;

const Knowledge& KnowledgeBase::now() const { return state_->known; }

std::vector<Region> KnowledgeBase::open_regions() const {
  std::vector<Region> open;
  const auto& regions = state_->known.regions;
  std::copy_if(regions.begin(), regions.end(), std::back_inserter(open),
               [](const Region& region) { return !region.examined && !region.withdrawn; });
  std::stable_sort(open.begin(), open.end(),
                   [](const Region& a, const Region& b) { return a.first_seen < b.first_seen; });
  return open;
}

std::vector<RegionChange> KnowledgeBase::merge(const std::vector<Sighting>& seen_now,
                                               const std::function<bool(const Region&)>& looked_again, Stamp stamp) {
  State& s = *state_;
  s.changes.clear();
  s.confirmed.assign(s.known.regions.size(), false);
  s.touched.assign(s.known.regions.size(), false);
  for (const Sighting& sighting : internal::joined(seen_now, s.params)) s.place(sighting, stamp);
  for (Region& region : s.known.regions) {
    if (region.withdrawn || s.confirmed[static_cast<std::size_t>(region.id) - 1] || !looked_again(region)) continue;
    region.withdrawn = true;
    s.touch(region);
    s.changes.push_back({region.id, Change::kWithdrawn});
  }
  s.save_touched();
  std::sort(s.changes.begin(), s.changes.end(),
            [](const RegionChange& a, const RegionChange& b) { return a.region < b.region; });
  return s.changes;
}

void KnowledgeBase::mark_examined(int region_id, Stamp stamp) {
  Region& region = state_->region(region_id);
  region.examined = true;
  region.examined_at = stamp;
  region.examined_cylinder = region.cylinder;
  if (state_->record) state_->record->save({region}, {}, {});
}

std::vector<int> KnowledgeBase::add_views(const std::vector<View>& views) {
  std::vector<int> ids;
  std::vector<View> rows = views;
  for (View& view : rows) {
    view.id = static_cast<int>(state_->known.views.size()) + 1;
    state_->known.views.push_back(view);
    ids.push_back(view.id);
  }
  if (state_->record) state_->record->save({}, rows, {});
  return ids;
}

void KnowledgeBase::mark_visited(int view_id, Stamp stamp) {
  View& view = state_->known.views.at(static_cast<std::size_t>(view_id) - 1);
  view.visited_at = stamp;
  if (state_->record) state_->record->save({}, {view}, {});
}

void KnowledgeBase::mark_dropped(int view_id) {
  View& view = state_->known.views.at(static_cast<std::size_t>(view_id) - 1);
  view.dropped = true;
  if (state_->record) state_->record->save({}, {view}, {});
}

int KnowledgeBase::add_object(const Object& object) {
  Object row = object;
  row.id = static_cast<int>(state_->known.objects.size()) + 1;
  state_->known.objects.push_back(row);
  if (state_->record) state_->record->save({}, {}, {row});
  return row.id;
}

void KnowledgeBase::close() { state_->record.reset(); }

}  // namespace amiss::knowledge

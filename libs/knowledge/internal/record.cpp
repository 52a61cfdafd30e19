#include "knowledge/internal/record.hpp"

#include <soci/soci.h>
#include <soci/sqlite3/soci-sqlite3.h>

#include "core/result.hpp"

namespace amiss::knowledge::internal {

namespace {

constexpr int kApplicationId = 0x616D6973;  // "amis"
constexpr int kVersion = 1;

constexpr const char* kTables[] = {
    "CREATE TABLE regions (id INTEGER PRIMARY KEY, x REAL NOT NULL, y REAL NOT NULL, z REAL NOT NULL,"
    " centre_x REAL NOT NULL, centre_y REAL NOT NULL, radius REAL NOT NULL, z_low REAL NOT NULL,"
    " z_high REAL NOT NULL, voxels INTEGER NOT NULL, first_seen_ns INTEGER NOT NULL, last_seen_ns INTEGER NOT NULL,"
    " examined INTEGER NOT NULL, withdrawn INTEGER NOT NULL, examined_at_ns INTEGER, examined_x REAL NOT NULL,"
    " examined_y REAL NOT NULL, examined_radius REAL NOT NULL, examined_z_low REAL NOT NULL,"
    " examined_z_high REAL NOT NULL)",
    "CREATE TABLE views (id INTEGER PRIMARY KEY, x REAL NOT NULL, y REAL NOT NULL, yaw REAL NOT NULL,"
    " angle REAL NOT NULL, height REAL NOT NULL, dropped INTEGER NOT NULL, visited_at_ns INTEGER)",
    "CREATE TABLE objects (id INTEGER PRIMARY KEY, region INTEGER NOT NULL, seen_at_ns INTEGER NOT NULL,"
    " x REAL NOT NULL, y REAL NOT NULL, z REAL NOT NULL, length REAL NOT NULL, width REAL NOT NULL,"
    " height REAL NOT NULL, points INTEGER NOT NULL)"};

long long ns_of(Stamp stamp) { return stamp.time_since_epoch().count(); }
Stamp stamp_of(long long ns) { return Stamp(Duration(ns)); }

/// A row of each table as SOCI binds it.
struct RegionRow {
  int id = 0, voxels = 0, examined = 0, withdrawn = 0;
  double x = 0, y = 0, z = 0, cx = 0, cy = 0, radius = 0, z_low = 0, z_high = 0;
  double ex = 0, ey = 0, e_radius = 0, e_low = 0, e_high = 0;
  long long first_ns = 0, last_ns = 0, examined_ns = 0;
  soci::indicator examined_known = soci::i_null;
};
struct ViewRow {
  int id = 0, dropped = 0;
  double x = 0, y = 0, yaw = 0, angle = 0, height = 0;
  long long visited_ns = 0;
  soci::indicator visited = soci::i_null;
};
struct ObjectRow {
  int id = 0, region = 0, points = 0;
  double x = 0, y = 0, z = 0, length = 0, width = 0, height = 0;
  long long seen_ns = 0;
};

RegionRow row_of(const Region& r) {
  RegionRow row;
  row.id = r.id, row.voxels = r.voxels, row.examined = r.examined ? 1 : 0, row.withdrawn = r.withdrawn ? 1 : 0;
  row.x = r.position_map.x(), row.y = r.position_map.y(), row.z = r.position_map.z();
  row.cx = r.cylinder.centre_map.x(), row.cy = r.cylinder.centre_map.y(), row.radius = r.cylinder.radius_m;
  row.z_low = r.cylinder.z_low_m, row.z_high = r.cylinder.z_high_m;
  row.ex = r.examined_cylinder.centre_map.x(), row.ey = r.examined_cylinder.centre_map.y();
  row.e_radius = r.examined_cylinder.radius_m;
  row.e_low = r.examined_cylinder.z_low_m, row.e_high = r.examined_cylinder.z_high_m;
  row.first_ns = ns_of(r.first_seen), row.last_ns = ns_of(r.last_seen);
  if (r.examined_at) row.examined_ns = ns_of(*r.examined_at);
  row.examined_known = r.examined_at ? soci::i_ok : soci::i_null;
  return row;
}

Region region_of(const RegionRow& row) {
  Region r;
  r.id = row.id, r.voxels = row.voxels, r.examined = row.examined != 0, r.withdrawn = row.withdrawn != 0;
  r.position_map = {row.x, row.y, row.z};
  r.cylinder = {{row.cx, row.cy}, row.radius, row.z_low, row.z_high};
  r.examined_cylinder = {{row.ex, row.ey}, row.e_radius, row.e_low, row.e_high};
  r.first_seen = stamp_of(row.first_ns), r.last_seen = stamp_of(row.last_ns);
  if (row.examined_known == soci::i_ok) r.examined_at = stamp_of(row.examined_ns);
  return r;
}

ViewRow row_of(const View& v) {
  return {v.id,
          v.dropped ? 1 : 0,
          v.T_map_base.x_m,
          v.T_map_base.y_m,
          v.T_map_base.yaw_rad,
          v.angle_rad,
          v.height_m,
          v.visited_at ? ns_of(*v.visited_at) : 0,
          v.visited_at ? soci::i_ok : soci::i_null};
}

View view_of(const ViewRow& row) {
  View v{row.id, {row.x, row.y, row.yaw}, row.angle, row.height, row.dropped != 0, std::nullopt};
  if (row.visited == soci::i_ok) v.visited_at = stamp_of(row.visited_ns);
  return v;
}

ObjectRow row_of(const Object& o) {
  return {o.id,         o.region,     o.points,     o.centre_map.x(), o.centre_map.y(), o.centre_map.z(),
          o.size_m.x(), o.size_m.y(), o.size_m.z(), ns_of(o.seen_at)};
}

Object object_of(const ObjectRow& row) {
  return {row.id,    row.region, stamp_of(row.seen_ns), {row.x, row.y, row.z}, {row.length, row.width, row.height},
          row.points};
}

InputError broken(const std::filesystem::path& file, const std::string& why) {
  return InputError(file.string() + ": cannot be used as a knowledge base (" + why +
                    "); a file that amiss wrote, or a path where it can create one, is needed.");
}

bool has_content(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return false;
  if (!std::filesystem::is_regular_file(file, error)) throw broken(file, "it is not a regular file");
  if (std::filesystem::file_size(file, error) == 0) throw broken(file, "it is empty");
  return true;
}

}  // namespace

struct Record::State {
  explicit State(const std::filesystem::path& where) : file(where) {}

  std::filesystem::path file;
  soci::session sql;
  RegionRow region;
  ViewRow view;
  ObjectRow object;
  std::unique_ptr<soci::statement> put_region, put_view, put_object;

  void open();
  void create();
  void verify();
  void prepare();
};

void Record::State::open() {
  const bool existed = has_content(file);
  try {
    sql.open(*soci::factory_sqlite3(), "db=" + ("\"" + file.string() + "\"") + " timeout=0");
    sql << "PRAGMA locking_mode = EXCLUSIVE";
    sql << "PRAGMA synchronous = OFF";  // safe when the process dies, not when the machine does
    existed ? verify() : create();
    prepare();
  } catch (const soci::soci_error& error) {
    throw broken(file, error.get_error_message());
  }
}

void Record::State::create() {
  soci::transaction all(sql);
  sql << "PRAGMA application_id = " + std::to_string(kApplicationId);
  sql << "PRAGMA user_version = " + std::to_string(kVersion);
  for (const char* table : kTables) sql << table;
  all.commit();
}

void Record::State::verify() {
  int id = 0, version = 0;
  std::string sound;
  sql << "PRAGMA application_id", soci::into(id);
  if (id != kApplicationId) throw broken(file, "another program wrote it");
  sql << "PRAGMA user_version", soci::into(version);
  if (version != kVersion) throw broken(file, "its version is " + std::to_string(version) + ", not 1");
  sql << "PRAGMA quick_check(1)", soci::into(sound);
  if (sound != "ok") throw broken(file, "it is damaged");
}

void Record::State::prepare() {
  using soci::use;
  RegionRow& r = region;
  put_region = std::make_unique<soci::statement>(
      (sql.prepare << "INSERT OR REPLACE INTO regions VALUES (:id, :x, :y, :z, :cx, :cy, :radius, :zl, :zh, :voxels,"
                      " :first, :last, :examined, :withdrawn, :at, :ex, :ey, :er, :el, :eh)",
       use(r.id), use(r.x), use(r.y), use(r.z), use(r.cx), use(r.cy), use(r.radius), use(r.z_low), use(r.z_high),
       use(r.voxels), use(r.first_ns), use(r.last_ns), use(r.examined), use(r.withdrawn),
       use(r.examined_ns, r.examined_known), use(r.ex), use(r.ey), use(r.e_radius), use(r.e_low), use(r.e_high)));
  ViewRow& v = view;
  put_view = std::make_unique<soci::statement>(
      (sql.prepare << "INSERT OR REPLACE INTO views VALUES (:id, :x, :y, :yaw, :angle, :height, :dropped, :visited)",
       use(v.id), use(v.x), use(v.y), use(v.yaw), use(v.angle), use(v.height), use(v.dropped),
       use(v.visited_ns, v.visited)));
  ObjectRow& o = object;
  put_object = std::make_unique<soci::statement>(
      (sql.prepare << "INSERT OR REPLACE INTO objects VALUES (:id, :region, :seen, :x, :y, :z, :l, :w, :h, :points)",
       use(o.id), use(o.region), use(o.seen_ns), use(o.x), use(o.y), use(o.z), use(o.length), use(o.width),
       use(o.height), use(o.points)));
}

Record::Record(const std::filesystem::path& file) : state_(std::make_unique<State>(file)) { state_->open(); }
Record::~Record() = default;

Knowledge Record::load() {
  using soci::into;
  State& s = *state_;
  Knowledge known;
  try {
    RegionRow r;
    soci::statement regions =
        (s.sql.prepare << "SELECT * FROM regions ORDER BY id", into(r.id), into(r.x), into(r.y), into(r.z), into(r.cx),
         into(r.cy), into(r.radius), into(r.z_low), into(r.z_high), into(r.voxels), into(r.first_ns), into(r.last_ns),
         into(r.examined), into(r.withdrawn), into(r.examined_ns, r.examined_known), into(r.ex), into(r.ey),
         into(r.e_radius), into(r.e_low), into(r.e_high));
    for (regions.execute(); regions.fetch();) known.regions.push_back(region_of(r));
    ViewRow v;
    soci::statement views =
        (s.sql.prepare << "SELECT * FROM views ORDER BY id", into(v.id), into(v.x), into(v.y), into(v.yaw),
         into(v.angle), into(v.height), into(v.dropped), into(v.visited_ns, v.visited));
    for (views.execute(); views.fetch();) known.views.push_back(view_of(v));
    ObjectRow o;
    soci::statement objects =
        (s.sql.prepare << "SELECT * FROM objects ORDER BY id", into(o.id), into(o.region), into(o.seen_ns), into(o.x),
         into(o.y), into(o.z), into(o.length), into(o.width), into(o.height), into(o.points));
    for (objects.execute(); objects.fetch();) known.objects.push_back(object_of(o));
  } catch (const soci::soci_error& error) {
    throw broken(s.file, error.get_error_message());
  }
  const auto in_order = [&](const auto& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i].id != static_cast<int>(i) + 1) throw broken(s.file, "rows are missing");
    }
  };
  in_order(known.regions);
  in_order(known.views);
  in_order(known.objects);
  return known;
}

void Record::save(const std::vector<Region>& regions, const std::vector<View>& views,
                  const std::vector<Object>& objects) {
  State& s = *state_;
  try {
    soci::transaction all(s.sql);
    for (const Region& region : regions) {
      s.region = row_of(region);
      s.put_region->execute(true);
    }
    for (const View& view : views) {
      s.view = row_of(view);
      s.put_view->execute(true);
    }
    for (const Object& object : objects) {
      s.object = row_of(object);
      s.put_object->execute(true);
    }
    all.commit();
  } catch (const soci::soci_error& error) {
    throw std::runtime_error(s.file.string() + ": the knowledge base cannot be written (" + error.get_error_message() +
                             ").");
  }
}

}  // namespace amiss::knowledge::internal

#include "evaluate_trials.hpp"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>

#include "core/files.hpp"
#include "core/result.hpp"
#include "dataset/annotation_file.hpp"
#include "detect_output.hpp"
#include "report/top_view.hpp"
#include "resources.hpp"

namespace amiss::app {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using nlohmann::ordered_json;

constexpr Rgb kTrue{255, 20, 160}, kWrong{230, 120, 0}, kNotFound{30, 90, 220};

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

/// Everything that a trial's numbers depend on.
std::string key_of(const Visit& visit, const DetectSettings& settings) {
  std::string all = program_hash() + "\n" + settings.labels.choice + "\n" + settings.as_yaml();
  const auto add = [&](const std::optional<fs::path>& file) {
    all += file ? file->filename().string() + " " + sha256(load_bytes(*file)) + "\n" : "none\n";
  };
  for (const dataset::SceneFiles* scene : {&visit.reference, &visit.current}) {
    add(scene->cloud);
    add(scene->space);
  }
  add(visit.current.annotations);
  const fs::path model = settings.labels.model();
  add(fs::exists(model) ? std::optional(model) : std::nullopt);
  return sha256(all);
}

ordered_json json_of(const TrialResult& r, const std::string& key) {
  return {{"schema", "amiss.trial52.1"}, {"room", r.trial.room},
          {"method", r.trial.method},    {"precision", r.trial.precision},
          {"recall", r.trial.recall},    {"f1", r.trial.f1},
          {"objects", r.objects},        {"missed", r.missed},
          {"clusters", r.clusters},      {"wrong", r.trial.wrong},
          {"labels", r.labels},          {"space", r.space},
          {"wall_s", r.wall_s},          {"key", key}};
}

/// What an earlier call left, if it was made of the same.
std::optional<TrialResult> done_before(const fs::path& file, const std::string& key) {
  if (!fs::exists(file)) return {};
  try {
    const auto json = nlohmann::json::parse(load_bytes(file));
    if (json.at("key") != key) return {};
    TrialResult r;
    r.missed = json.at("missed").get<std::vector<std::string>>();
    r.trial = {json.at("room"),   json.at("method"), json.at("precision"),
               json.at("recall"), json.at("f1"),     static_cast<double>(r.missed.size()),
               json.at("wrong")};
    r.objects = json.at("objects");
    r.clusters = json.at("clusters");
    r.labels = json.at("labels");
    r.space = json.at("space");
    r.wall_s = json.at("wall_s");
    r.done_before = true;
    return r;
  } catch (const nlohmann::json::exception&) {
    return {};  // cut short or of another program: done again
  }
}

/// The room with what was found rightly, what wrongly, and what is missing of the annotated objects.
std::string picture_of(const LoadedScene& current, const std::vector<score::PointSet>& found,
                       const std::vector<dataset::AnnotatedObject>& objects, const score::NovelScore& score) {
  std::vector<report::MarkedPoints> marks;
  for (const auto& object : objects) marks.push_back({object.points, kNotFound, object.name});
  for (std::size_t k = 0; k < found.size(); ++k) {
    const bool wrong = std::find(score.wrong.begin(), score.wrong.end(), k) != score.wrong.end();
    marks.push_back({found[k], wrong ? kWrong : kTrue, wrong ? "wrong" : ""});
  }
  return report::top_view_png(current.file.cloud(), marks);
}

/// The rooms of one visit, loaded when the first trial wants them.
class Rooms {
 public:
  Rooms(const Visit& visit, const DetectSettings& settings)
      : scenes_(load_scenes({visit.reference.cloud, visit.reference.space}, {visit.current.cloud, visit.current.space},
                            settings.labels)),
        objects_(dataset::parse_annotations(load_bytes(*visit.current.annotations), visit.current.annotations->string(),
                                            scenes_.current.file.cloud().points.size())) {
    std::erase_if(objects_, [](const dataset::AnnotatedObject& object) { return object.points.empty(); });
    const auto begin = Clock::now();
    detector_ =
        std::make_unique<change::NovelDetector>(scenes_.reference.scene, scenes_.current.scene, settings.params);
    laid_s_ = seconds_since(begin);
  }

  [[nodiscard]] bool labelled() const { return !scenes_.current.scene.labels.empty(); }

  TrialResult run(const std::string& room, const std::string& method, const fs::path& picture) const {
    check_labels(method, scenes_.current);
    const auto begin = Clock::now();
    const change::Detection detection = detector_->detect(method);
    TrialResult r;
    r.wall_s = laid_s_ + seconds_since(begin);
    const auto found = points_in_file(detection, scenes_.current);
    std::vector<score::PointSet> truth;
    for (const dataset::AnnotatedObject& object : objects_) truth.push_back(object.points);
    const score::NovelScore score = score::score_novel(found, truth);
    for (const std::size_t k : score.missed) r.missed.push_back(objects_[k].name);
    r.trial = {room,
               method,
               score.precision,
               score.recall,
               score.f1,
               static_cast<double>(score.missed.size()),
               static_cast<double>(score.wrong.size())};
    r.objects = objects_.size();
    r.clusters = found.size();
    r.labels = scenes_.current.labels;
    r.space = scenes_.current.space;
    save_atomically(picture, picture_of(scenes_.current, found, objects_, score));
    return r;
  }

 private:
  LoadedScenes scenes_;
  std::vector<dataset::AnnotatedObject> objects_;
  std::unique_ptr<change::NovelDetector> detector_;
  double laid_s_ = 0.0;
};

}  // namespace

VisitList annotated_visits(const fs::path& dataset) {
  VisitList list;
  for (const dataset::RoomFolder& room : dataset::room_folders(dataset)) {
    const dataset::SceneFiles* reference = room.scene(1);
    if (reference == nullptr) {
      list.left_out.push_back(room.name + ": no scene1, the reference");
      continue;
    }
    for (const dataset::SceneFiles& scene : room.scenes) {
      if (scene.number == 1) continue;
      if (scene.annotations) {
        list.visits.push_back({room.name, *reference, scene});
      } else {
        list.left_out.push_back(room.name + "/" + scene.name() + ": no annotations");
      }
    }
  }
  return list;
}

std::vector<TrialResult> run_trials(const Visit& visit, const std::vector<std::string>& methods,
                                    const DetectSettings& settings, bool labelled_only, const fs::path& out) {
  const fs::path folder = out / "trials" / visit.room / visit.current.name();
  fs::create_directories(folder);
  const std::string key = key_of(visit, settings);
  std::vector<TrialResult> results;
  std::unique_ptr<Rooms> rooms;
  for (const std::string& method : methods) {
    const fs::path file = folder / (method + ".json"), picture = folder / (method + ".png");
    if (const auto earlier = done_before(file, key)) {
      results.push_back(*earlier);
    } else {
      if (!rooms) rooms = std::make_unique<Rooms>(visit, settings);
      if (labelled_only && needs_labels(method) && !rooms->labelled()) continue;
      results.push_back(rooms->run(visit.room, method, picture));
      save_atomically(file,
                      json_of(results.back(), key).dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n");
    }
    results.back().scene = visit.current.name();
    results.back().picture = picture;
  }
  return results;
}

}  // namespace amiss::app

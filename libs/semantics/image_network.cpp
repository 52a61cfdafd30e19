#include "semantics/image_network.hpp"

#include <yaml-cpp/yaml.h>

#include <cstring>
#include <limits>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/dnn.hpp>
#include <opencv2/imgproc.hpp>

#include "core/files.hpp"
#include "core/result.hpp"
#include "core/yaml_checks.hpp"

namespace amiss::semantics {

namespace {

constexpr int kLargestInput_px = 4096;
constexpr std::string_view kExample = "{network: FILE.onnx, input: [width, height], classes: [wall, floor, ..]}";

/// OpenCV tells its errors twice, once on the terminal.
class Silence {
 public:
  Silence() : before_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}
  ~Silence() { cv::utils::logging::setLogLevel(before_); }
  Silence(const Silence&) = delete;
  Silence& operator=(const Silence&) = delete;

 private:
  cv::utils::logging::LogLevel before_;
};

/// Runs what OpenCV may throw from; its sentence becomes the end of ours.
template <class F>
auto with_opencv(const std::string& name, const char* what, const F& run) {
  try {
    const Silence silence;
    return run();
  } catch (const cv::Exception& e) {
    throw InputError(name + ": " + what + " (" + e.err.substr(0, e.err.find('\n')) + ")");
  } catch (const std::exception& e) {
    throw InputError(name + ": " + what + " (" + e.what() + ")");
  }
}

std::vector<double> three_numbers(const std::filesystem::path& file, const YAML::Node& root, const char* key,
                                  double fallback) {
  std::vector<double> numbers(3, fallback);
  const YAML::Node node = root[key];
  if (!node) return numbers;
  bool fine = node.IsSequence() && node.size() == 3;
  for (std::size_t i = 0; fine && i < 3; ++i) {
    fine = YAML::convert<double>::decode(node[i], numbers[i]) && std::isfinite(numbers[i]);
  }
  if (!fine || (fallback > 0 && *std::min_element(numbers.begin(), numbers.end()) <= 0)) {
    throw InputError(yaml_place(file, node) + key + " is not three numbers" + (fallback > 0 ? " above 0" : "") +
                     ", for red, green and blue in 0 .. 1");
  }
  return numbers;
}

NetworkInput input_of(const std::filesystem::path& file, const YAML::Node& root) {
  NetworkInput input;
  const YAML::Node size = root["input"];
  const auto fits = [](int edge) { return edge >= 8 && edge <= kLargestInput_px; };
  if (!size.IsSequence() || size.size() != 2 || !YAML::convert<int>::decode(size[0], input.width_px) ||
      !YAML::convert<int>::decode(size[1], input.height_px) || !fits(input.width_px) || !fits(input.height_px)) {
    throw InputError(yaml_place(file, size) + "input is not [width, height] in 8 .. 4096 pixels");
  }
  input.mean = three_numbers(file, root, "mean", 0.0);
  input.deviation = three_numbers(file, root, "deviation", 1.0);
  return input;
}

std::vector<SemanticClass> classes_in(const std::filesystem::path& file, const YAML::Node& list) {
  if (!list.IsSequence() || list.size() == 0)
    throw InputError(yaml_place(file, list) + "classes is not a list of names");
  std::vector<SemanticClass> classes;
  for (const YAML::Node& node : list) {
    const auto value = semantic_class_of(node.as<std::string>(""));
    if (!value) {
      throw InputError(yaml_place(file, node) + "'" + node.as<std::string>("") +
                       "' is no class; ScanNet's names and unlabelled are allowed");
    }
    classes.push_back(*value);
  }
  return classes;
}

}  // namespace

struct ImageNetwork::State {
  cv::dnn::Net net;
  NetworkInput input;
  std::vector<SemanticClass> classes;

  [[nodiscard]] cv::Mat scores(const std::vector<Rgb>& colour, int width, int height, const std::string& name) {
    // OpenCV does not write to what it is given as an input.
    cv::Mat image(height, width, CV_8UC3);
    std::memcpy(image.data, colour.data(), colour.size() * sizeof(Rgb));
    return with_opencv(name, "the network cannot be run", [&] {
      cv::Mat scaled, floats;
      cv::resize(image, scaled, cv::Size(input.width_px, input.height_px), 0, 0, cv::INTER_AREA);
      scaled.convertTo(floats, CV_32FC3, 1.0 / 255.0);
      floats -= cv::Scalar(input.mean[0], input.mean[1], input.mean[2]);
      floats /= cv::Scalar(input.deviation[0], input.deviation[1], input.deviation[2]);
      net.setInput(cv::dnn::blobFromImage(floats));
      return net.forward().clone();
    });
  }

  void check(const cv::Mat& out, const std::string& name) const {
    const int channels = static_cast<int>(classes.size());
    if (out.dims == 4 && out.type() == CV_32F && out.size[0] == 1 && out.size[1] == channels && out.size[2] > 0 &&
        out.size[3] > 0) {
      return;
    }
    std::string shape;
    for (int d = 0; d < out.dims; ++d) shape += (d > 0 ? " x " : "") + std::to_string(out.size[d]);
    throw InputError(name + ": the network gives " + shape + "; 1 x " + std::to_string(channels) +
                     " (classes) x height x width scores are needed");
  }

  [[nodiscard]] SemanticClass best_at(const cv::Mat& out, int u, int v) const {
    std::size_t best = 0;
    float highest = -std::numeric_limits<float>::infinity();
    for (std::size_t c = 0; c < classes.size(); ++c) {
      const int at[] = {0, static_cast<int>(c), v, u};
      const float score = out.at<float>(at);
      if (score <= highest) continue;
      highest = score;
      best = c;
    }
    return std::isfinite(highest) ? classes[best] : SemanticClass::kUnlabelled;
  }
};

ImageNetwork::ImageNetwork(std::string_view onnx_bytes, NetworkInput input, std::vector<SemanticClass> classes,
                           std::string name)
    : state_(std::make_unique<State>()), name_(std::move(name)) {
  if (classes.empty()) throw ArgumentError(name_ + ": a network has one class or more");
  state_->input = std::move(input);
  state_->classes = std::move(classes);
  state_->net = with_opencv(name_, "this is no ONNX network that OpenCV can read", [&] {
    cv::dnn::Net net = cv::dnn::readNetFromONNX(onnx_bytes.data(), onnx_bytes.size());
    if (net.empty()) throw std::runtime_error("it has no layers");
    net.setPreferableBackend(cv::dnn::DNN_BACKEND_OPENCV);
    net.setPreferableTarget(cv::dnn::DNN_TARGET_CPU);
    return net;
  });
  const int w = state_->input.width_px, h = state_->input.height_px;
  const std::vector<Rgb> empty(static_cast<std::size_t>(w) * static_cast<std::size_t>(h));
  state_->check(state_->scores(empty, w, h, name_), name_);
}

ImageNetwork::~ImageNetwork() = default;
ImageNetwork::ImageNetwork(ImageNetwork&&) noexcept = default;
ImageNetwork& ImageNetwork::operator=(ImageNetwork&&) noexcept = default;

std::vector<SemanticClass> ImageNetwork::classes_of(const RgbdFrame& frame) {
  const int width = frame.intrinsics.width, height = frame.intrinsics.height;
  if (width < 1 || height < 1 ||
      frame.colour.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
    throw InputError(name_ + ": a frame without a colour for each of its pixels");
  }
  const cv::Mat out = state_->scores(frame.colour, width, height, name_);
  state_->check(out, name_);
  std::vector<SemanticClass> classes;
  classes.reserve(frame.colour.size());
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      classes.push_back(state_->best_at(out, u * out.size[3] / width, v * out.size[2] / height));
    }
  }
  return classes;
}

ImageNetwork load_image_network(const std::filesystem::path& description) {
  const YAML::Node root = load_yaml(description);
  check_yaml_keys(description, root, {"network", "input", "mean", "deviation", "classes"},
                  {"network", "input", "classes"}, kExample);
  const std::filesystem::path file = description.parent_path() / yaml_text(description, root, "network");
  return {load_bytes(file), input_of(description, root), classes_in(description, root["classes"]), file.string()};
}

}  // namespace amiss::semantics

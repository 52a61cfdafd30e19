#include "page/internal/socket_session.hpp"

#include <nlohmann/json.hpp>

namespace amiss::page {

namespace beast = boost::beast;
namespace websocket = beast::websocket;

namespace {

constexpr std::size_t kMostMessage = 256;  // bytes, of a page
constexpr std::size_t kBatch = std::size_t{1} << 16;
constexpr std::chrono::milliseconds kRest(20);  // between two messages of a page
constexpr double kMostSpeed = 1000.0;           // times real

websocket::stream_base::timeout timeouts() {
  websocket::stream_base::timeout limits{};
  limits.handshake_timeout = std::chrono::seconds(10);
  limits.idle_timeout = std::chrono::seconds(60);
  limits.keep_alive_pings = true;
  return limits;
}

}  // namespace

void Site::send_news() {
  for (auto it = watching.begin(); it != watching.end();) {
    if (const auto session = it->lock()) {
      session->send_news();
      ++it;
    } else {
      it = watching.erase(it);
    }
  }
}

SocketSession::SocketSession(beast::tcp_stream stream, Site& site)
    : socket_(std::move(stream)), site_(site), rest_(site.context), received_(kMostMessage) {
  ++site_.sockets;
  ++site_.connections;
}

SocketSession::~SocketSession() {
  --site_.connections;
  if (--site_.sockets == 0 && site_.pace != nullptr) site_.pace->release();
}

void SocketSession::run(Upgrade request) {
  site_.watching.push_back(weak_from_this());
  beast::get_lowest_layer(socket_).expires_never();
  socket_.set_option(timeouts());
  socket_.read_message_max(kMostMessage);
  const auto kept = std::make_shared<Upgrade>(std::move(request));
  socket_.async_accept(*kept, [self = shared_from_this(), kept](beast::error_code error) {
    if (error) return;
    self->open_ = true;
    self->send_news();
    self->read();
  });
}

std::string SocketSession::pace_line() const {
  if (site_.pace == nullptr)
    return R"({"e":"pace","live":false})"
           "\n";
  const Pace::State state = site_.pace->state();
  const nlohmann::ordered_json json = {{"e", "pace"}, {"live", true}, {"paused", state.paused}, {"speed", state.speed}};
  return json.dump() + "\n";
}

void SocketSession::send_news() {
  if (!open_ || writing_) return;
  const int pace = site_.pace == nullptr ? 0 : site_.pace->state().revision;
  sending_.clear();
  if (pace != told_pace_) {
    told_pace_ = pace;
    sending_ = pace_line();
  }
  History::Batch batch = site_.history.read(next_line_, kBatch);
  next_line_ = batch.next;
  sending_ += batch.text;
  if (sending_.empty()) return;
  writing_ = true;
  socket_.text(true);
  socket_.async_write(boost::asio::buffer(sending_), [self = shared_from_this()](beast::error_code error, std::size_t) {
    self->writing_ = false;
    if (error) {
      self->open_ = false;
    } else {
      self->send_news();
    }
  });
}

void SocketSession::read() {
  received_.clear();
  socket_.async_read(received_,
                     [self = shared_from_this()](beast::error_code error, std::size_t) { self->on_read(error); });
}

void SocketSession::on_read(beast::error_code error) {
  if (error) {
    open_ = false;
    return;
  }
  if (!socket_.got_text() || !obey(beast::buffers_to_string(received_.data()))) return refuse();
  rest_.expires_after(kRest);
  rest_.async_wait([self = shared_from_this()](beast::error_code) { self->read(); });
}

void SocketSession::refuse() {
  open_ = false;
  beast::get_lowest_layer(socket_).close();
}

bool SocketSession::obey(const std::string& message) {
  const auto json = nlohmann::json::parse(message, nullptr, false);
  if (!json.is_object() || json.size() != 1) return false;
  const auto& [key, value] = *json.items().begin();
  const bool speed = key == "speed" && value.is_number();
  const double times_real = speed ? value.get<double>() : 0.0;
  if (speed ? times_real < 0.0 || times_real > kMostSpeed : !value.is_boolean() || (key != "pause" && key != "step")) {
    return false;
  }
  if (site_.pace == nullptr) return true;
  if (speed) {
    site_.pace->set_speed(times_real);
  } else if (key == "step") {
    site_.pace->step();
  } else if (value.get<bool>()) {
    site_.pace->pause();
  } else {
    site_.pace->resume();
  }
  site_.wake();
  return true;
}

}  // namespace amiss::page

#include "page/internal/http_session.hpp"

#include <boost/beast/http/span_body.hpp>
#include <charconv>
#include <fstream>

#include "page/internal/socket_session.hpp"

namespace amiss::page {

namespace beast = boost::beast;
namespace http = beast::http;

namespace {

constexpr std::uint32_t kMostHeader = 8192;  // bytes
constexpr std::size_t kMostSlice = std::size_t{1} << 22;
constexpr std::chrono::seconds kRequestTime(10), kAnswerTime(30);
constexpr const char* kContentPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

/// "bytes=FIRST-LAST", as the page asks; other forms are answered with the whole file.
std::optional<std::pair<std::size_t, std::size_t>> range_of(std::string_view text) {
  constexpr std::string_view kUnit = "bytes=";
  if (!text.starts_with(kUnit)) return std::nullopt;
  text.remove_prefix(kUnit.size());
  std::size_t first = 0, last = 0;
  const char* const end = text.data() + text.size();
  const auto [dash, error] = std::from_chars(text.data(), end, first);
  if (error != std::errc() || dash == end || *dash != '-') return std::nullopt;
  const auto [rest, other] = std::from_chars(dash + 1, end, last);
  if (other != std::errc() || rest != end || last < first) return std::nullopt;
  return std::pair(first, last + 1);
}

template <class Body>
void add_headers(http::response<Body>& response, std::string_view content_type) {
  response.set(http::field::content_type, beast::string_view(content_type.data(), content_type.size()));
  response.set("Content-Security-Policy", kContentPolicy);
  response.set("X-Content-Type-Options", "nosniff");
  response.set("X-Frame-Options", "DENY");
  response.set("Referrer-Policy", "no-referrer");
  response.set("Cross-Origin-Opener-Policy", "same-origin");
  response.set("Cross-Origin-Resource-Policy", "same-origin");
  response.set(http::field::cache_control, "no-store");
}

}  // namespace

HttpSession::HttpSession(boost::asio::ip::tcp::socket socket, Site& site)
    : stream_(std::move(socket)), site_(site), buffer_(2 * kMostHeader) {
  ++site_.connections;
}

HttpSession::~HttpSession() { --site_.connections; }

void HttpSession::drop() { stream_.close(); }

void HttpSession::read() {
  parser_.emplace();
  parser_->header_limit(kMostHeader);
  stream_.expires_after(kRequestTime);
  http::async_read(stream_, buffer_, *parser_, [self = shared_from_this()](beast::error_code error, std::size_t) {
    if (error) {
      self->drop();
    } else {
      self->answer();
    }
  });
}

void HttpSession::answer() {
  const auto& request = parser_->get();
  const auto field = [&](auto name) { return view(request[name]); };
  Request asked{view(request.method_string()),        view(request.target()),  field(http::field::host),
                field(http::field::origin),           field("Sec-Fetch-Site"), field(http::field::cookie),
                beast::websocket::is_upgrade(request)};
  Verdict verdict = judge(asked, site_.policy);
  if (verdict.status == 101 && site_.sockets >= Server::kMostSockets) verdict = {503, "", "too many pages watch"};
  if (verdict.status == 101) {
    std::make_shared<SocketSession>(std::move(stream_), site_)->run(parser_->release());
  } else if (verdict.status != 200) {
    send_refusal(verdict);
  } else if (const auto asset = site_.assets.find(verdict.route); asset != site_.assets.end()) {
    send_asset(asset->second);
  } else {
    send_file(site_.files.at(verdict.route));
  }
}

void HttpSession::send_refusal(const Verdict& verdict) {
  http::response<http::string_body> response;
  response.result(static_cast<unsigned>(verdict.status));
  if (verdict.status == 303) {
    response.set(http::field::location, verdict.route);
    response.set(http::field::set_cookie,
                 std::string(kCookie) + "=" + site_.policy.token + "; HttpOnly; SameSite=Strict; Path=/");
  }
  response.body() = verdict.why + "\n";
  add_headers(response, "text/plain; charset=utf-8");
  response.keep_alive(verdict.status == 303);
  send(std::move(response));
}

void HttpSession::send_asset(const Asset& asset) {
  http::response<http::span_body<const char>> response;
  response.body() = {asset.bytes.data(), asset.bytes.size()};
  add_headers(response, asset.content_type);
  send(std::move(response));
}

void HttpSession::send_file(const ServedFile& file) {
  if (const auto range = range_of(view(parser_->get()[http::field::range]))) {
    return send_slice(file, range->first, range->second);
  }
  http::response<http::file_body> response;
  beast::error_code error;
  response.body().open(file.file.c_str(), beast::file_mode::scan, error);
  if (error) return send_refusal({404, "", "the run has no such file"});
  add_headers(response, file.content_type);
  send(std::move(response));
}

void HttpSession::send_slice(const ServedFile& file, std::size_t begin, std::size_t end) {
  if (end - begin > kMostSlice) return send_refusal({416, "", "less at once"});
  http::response<http::string_body> response;
  response.body().resize(end - begin);
  std::ifstream stream(file.file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(begin));
  stream.read(response.body().data(), static_cast<std::streamsize>(end - begin));
  if (!stream) return send_refusal({416, "", "the file is shorter"});
  response.result(http::status::partial_content);
  response.set(http::field::content_range, "bytes " + std::to_string(begin) + "-" + std::to_string(end - 1) + "/*");
  add_headers(response, file.content_type);
  send(std::move(response));
}

template <class Body>
void HttpSession::send(http::response<Body> response) {
  response.version(11);
  const bool keep = parser_->get().keep_alive() && (response.result_int() < 400);
  response.keep_alive(keep);
  response.prepare_payload();
  const auto kept = std::make_shared<http::response<Body>>(std::move(response));
  const auto writer = std::make_shared<http::response_serializer<Body>>(*kept);
  if (parser_->get().method() == http::verb::head) writer->split(true);
  stream_.expires_after(kAnswerTime);
  const auto sent = [self = shared_from_this(), kept, writer](beast::error_code error, std::size_t) {
    if (error || !kept->keep_alive()) {
      self->drop();
    } else {
      self->read();
    }
  };
  if (parser_->get().method() == http::verb::head) {
    http::async_write_header(stream_, *writer, sent);
  } else {
    http::async_write(stream_, *writer, sent);
  }
}

}  // namespace amiss::page

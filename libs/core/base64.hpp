// Bytes as base64 (RFC 4648), for what must be text.
#pragma once

#include <string>
#include <string_view>

namespace amiss {

[[nodiscard]] std::string base64(std::string_view bytes);
/// Up to the filling, or to what is no digit.
[[nodiscard]] std::string from_base64(std::string_view text);

}  // namespace amiss

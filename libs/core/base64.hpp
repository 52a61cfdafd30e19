// Bytes as base64 (RFC 4648), for what must be text.
#pragma once

#include <string>
#include <string_view>

namespace amiss {

[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace amiss
